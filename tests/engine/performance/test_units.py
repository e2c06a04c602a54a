from dataclasses import replace

import pytest

from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.units import STRINGS, Unit, UnitKind, boundary_at, duration_of, units_of
from tests.engine.performance.sentences import phones_in

MAMI_TU = "ma.mi tu"
"""sil m a m i t u sil: phones 0..7, halves 0..15."""
NAMES = ("sil", "m", "a", "m", "i", "t", "u", "sil")


def _named(kind: UnitKind, words: str = MAMI_TU) -> list[tuple[str, int, int]]:
    return [(" ".join(u.names), u.first, u.last) for u in units_of(phones_in(words)) if u.kind is kind]


@pytest.mark.parametrize(
    ("kind", "units"),
    [
        (UnitKind.WORD, [("m a m i", 3, 9)]),
        (UnitKind.SYLLABLE, [("m a", 3, 5), ("m i", 7, 9), ("t u", 11, 13)]),
        (UnitKind.VOWEL_TRIPHONE, [("m a m", 3, 7), ("m i t", 7, 11)]),
        (UnitKind.CONSONANT_TRIPHONE, [("a m i", 5, 9), ("i t u", 9, 13)]),
        (UnitKind.BOUNDARY_TRIPHONE, [("sil m a", 1, 5), ("t u sil", 11, 15)]),
        (UnitKind.DIPHONE, [("m a", 3, 5), ("a m", 5, 7), ("m i", 7, 9), ("i t", 9, 11), ("t u", 11, 13)]),
        (UnitKind.BOUNDARY_DIPHONE, [("sil m", 1, 3), ("u sil", 13, 15)]),
        (UnitKind.RIGHT_HALF, [(name, 2 * k + 1, 2 * k + 2) for k, name in enumerate(NAMES)]),
        (UnitKind.LEFT_HALF, [(name, 2 * k, 2 * k + 1) for k, name in enumerate(NAMES)]),
    ],
)
def test_a_sentence_has_the_units_that_stand_on_paper(kind: UnitKind, units: list[tuple[str, int, int]]) -> None:
    assert _named(kind) == units


def test_the_sets_come_in_the_order_of_their_search() -> None:
    kinds = [unit.kind for unit in units_of(phones_in(MAMI_TU))]
    assert list(dict.fromkeys(kinds)) == [kind for kind in UnitKind if kind not in STRINGS]


def test_a_syllable_of_one_phone_is_the_whole_phone() -> None:
    assert _named(UnitKind.SYLLABLE, "a.ma") == [("a", 2, 4), ("m a", 5, 7)]


def test_a_word_of_syllables_of_one_phone_begins_and_ends_in_their_middles() -> None:
    assert _named(UnitKind.WORD, "a.i") == [("a i", 3, 5)]


def test_the_first_and_last_triphone_of_a_sentence_of_one_phone_are_the_same() -> None:
    assert _named(UnitKind.BOUNDARY_TRIPHONE, "a") == [("sil a sil", 1, 5)]


def test_a_sentence_without_a_word_is_halves_and_a_join() -> None:
    phones = phones_in("")
    assert [unit.kind for unit in units_of(phones)] == [
        UnitKind.BOUNDARY_DIPHONE,
        *[UnitKind.RIGHT_HALF] * 2,
        *[UnitKind.LEFT_HALF] * 2,
    ]
    assert [*units_of(phones[:1])] == [
        Unit(UnitKind.RIGHT_HALF, (SILENCE,), 1, 2),
        Unit(UnitKind.LEFT_HALF, (SILENCE,), 0, 1),
    ]


def test_a_pause_within_a_sentence_is_no_boundary() -> None:
    phones = list(phones_in("ma t mi"))
    phones[3] = replace(phones[3], name=SILENCE, word=-1, syllable=-1)
    kinds = {unit.names: unit.kind for unit in units_of(phones) if SILENCE in unit.names and len(unit.names) > 1}
    assert kinds[("a", SILENCE)] is UnitKind.DIPHONE
    assert kinds[("m", "a", SILENCE)] is UnitKind.VOWEL_TRIPHONE
    assert kinds[("a", SILENCE, "m")] is UnitKind.CONSONANT_TRIPHONE


def test_every_half_lies_in_a_unit_of_halves_and_units_last_as_long_as_their_halves() -> None:
    phones = phones_in(MAMI_TU)
    halves = [u.first for u in units_of(phones) if u.kind in {UnitKind.LEFT_HALF, UnitKind.RIGHT_HALF}]
    assert sorted(halves) == [*range(16)]
    assert boundary_at(16, phones) == pytest.approx(0.8)
    for unit in units_of(phones):
        assert duration_of(unit, phones) == pytest.approx(0.05 * (unit.last - unit.first))
