"""The search for units, in a table of two sentences that fits on paper: "ma.ma tu" and "mi"."""

import pytest

from phonemeengine.performance.choice import Inventory, likest, notes_on, placed_units
from phonemeengine.performance.recording import SILENCE, Performance, PerformedPhone
from phonemeengine.performance.units import UnitKind, units_of
from tests.engine.performance.sentences import performance_of, phones_in


def inventory_of(*performances: Performance) -> Inventory:
    """Give the phones of all units of some performances."""
    units = [unit for performance in performances for unit in units_of(performance.phones)]
    return {kind: frozenset(unit.names for unit in units if unit.kind is kind) for kind in UnitKind}


TABLE = inventory_of(performance_of("ma.ma tu"), performance_of("mi"))


def covers(words: str) -> list[tuple[str, str, int, int]]:
    """Give the set, the phones and the halves of each unit of a sentence of words."""
    found = placed_units(phones_in(words), TABLE)
    return [(p.kind, "".join(p.names), p.unit.first, p.unit.last) for p in found]


def test_a_word_that_was_recorded_is_taken_whole_and_diphones_fill_the_seams() -> None:
    # silence 0 1 | m 2 3 | a 4 5 | m 6 7 | a 8 9 | t 10 11 | u 12 13 | silence 14 15
    assert covers("ma.ma tu") == [
        ("left-half", SILENCE, 0, 1),
        ("boundary-diphone", SILENCE + "m", 1, 3),
        ("word", "mama", 3, 9),
        ("diphone", "at", 9, 11),
        ("syllable", "tu", 11, 13),
        ("boundary-diphone", "u" + SILENCE, 13, 15),
        ("right-half", SILENCE, 15, 16),
    ]


def test_syllables_serve_where_nobody_said_the_word() -> None:
    assert covers("mi.ma")[1:5] == [
        ("boundary-diphone", SILENCE + "m", 1, 3),
        ("syllable", "mi", 3, 5),
        ("right-half", "i", 5, 6),  # nobody went from i to m
        ("left-half", "m", 6, 7),
    ]


def test_a_triphone_goes_before_diphones() -> None:
    # nobody said the syllable "mat", but "mama tu" goes from m through a to t
    assert covers("mat") == [
        ("left-half", SILENCE, 0, 1),
        ("boundary-diphone", SILENCE + "m", 1, 3),
        ("vowel-triphone", "mat", 3, 7),
        ("right-half", "t", 7, 8),
        ("left-half", SILENCE, 8, 9),
        ("right-half", SILENCE, 9, 10),
    ]


def test_every_half_is_covered_once_whatever_is_said() -> None:
    for words in ("ma.ma tu", "ox", "mi mi mi", "pi.ka.pi", "a"):
        halves = [half for _, _, first, last in covers(words) for half in range(first, last)]
        assert halves == [*range(2 * len(phones_in(words)))]


def test_a_pause_within_a_sentence_is_as_one_at_its_end() -> None:
    phones = list(phones_in("ma mi"))
    pause = PerformedPhone(0.3, 0.35, 0.4, SILENCE)
    later = [
        PerformedPhone(p.start + 0.1, p.middle + 0.1, p.end + 0.1, p.name, p.word, p.syllable) for p in phones[3:]
    ]
    found = placed_units([*phones[:3], pause, *later], TABLE)
    assert (UnitKind.BOUNDARY_DIPHONE, (SILENCE, "m")) in [(p.kind, p.names) for p in found if p.unit.first == 7]


@pytest.mark.parametrize(
    ("phone", "like"), [("n", "t"), ("b", "m"), ("o", "u"), ("e", "i"), ("ɑ", "a"), ("y", "u"), ("aɪ", "a")]
)
def test_what_nobody_said_looks_like_a_sound_of_the_same_place(phone: str, like: str) -> None:
    assert likest(phone, TABLE, UnitKind.LEFT_HALF) == like


def test_the_right_half_of_a_diphthong_is_like_its_last_vowel() -> None:
    assert likest("aɪ", TABLE, UnitKind.RIGHT_HALF) == "i"
    assert [*notes_on(phones_in("m"), TABLE)] == []
    assert [*notes_on([PerformedPhone(0, 0.1, 0.2, "aɪ")], TABLE)] == [
        "the recordings have no [aɪ], so it looks like [a] and [i]"
    ]


@pytest.mark.parametrize(("vowel", "like"), [("æ", "ɛ"), ("a", "ɛ"), ("i", "ɪ"), ("ɐ", "ɛ")])
def test_a_vowel_that_nobody_said_looks_like_the_one_that_is_as_open(vowel: str, like: str) -> None:
    table = inventory_of(performance_of("tɪt tet tɛt"))
    assert likest(vowel, table, UnitKind.LEFT_HALF) == like


def test_what_is_no_dental_shows_no_tongue() -> None:
    table = inventory_of(performance_of("θaɹa sana"))
    assert likest("ʁ", table, UnitKind.LEFT_HALF) == "ɹ"
    assert likest("ð", table, UnitKind.LEFT_HALF) == "θ"


def test_a_sound_of_the_lips_is_never_taken_for_one_of_the_tongue() -> None:
    table = inventory_of(performance_of("mana ka"))
    assert likest("ŋ", table, UnitKind.LEFT_HALF) == "k"  # m is a nasal too, but its lips are shut
    assert likest("p", table, UnitKind.LEFT_HALF) == "m"
