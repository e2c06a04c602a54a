from itertools import pairwise

import pytest

from phonemeengine.performance.units import PhraseIndex, PhraseMatch, PhraseMatchKind, phrases_of
from tests.engine.performance.rhythms import said


def _index(*rhythms: str, length: float = 0.2) -> PhraseIndex:
    return PhraseIndex((k, said(rhythm, length)) for k, rhythm in enumerate(rhythms))


def _found(
    index: PhraseIndex, rhythm: str, conjunctions: set[int] | None = None, length: float = 0.2
) -> list[PhraseMatch]:
    (phrase,) = phrases_of(said(rhythm, length))
    return [*index.matches(phrase, conjunctions or set())]


def _outline(matches: list[PhraseMatch]) -> list[tuple[int, int, PhraseMatchKind]]:
    """Give for each match its syllables, its recording and how it was found."""
    return [(len(match.phrase), match.recording, match.kind) for match in matches]


def test_pauses_part_phrases_that_are_counted_in_syllables() -> None:
    first, second = phrases_of(said("da.DA da, DA da.da.da"))
    assert (len(first), len(second)) == (3, 4)
    assert (first.stresses, second.stresses) == ((0, 1, 0), (1, 0, 0, 0))
    assert (first.start, first.end) == pytest.approx((0.3, 0.9))
    assert first.times == pytest.approx((0.3, 0.5, 0.7, 0.9))
    assert first.words == (0, 0, 1)
    assert first.beats == pytest.approx((0.6,))


def test_a_silence_that_is_no_pause_belongs_to_the_syllable_before_it() -> None:
    (phrase,) = phrases_of(said("da da, da", pause=0.05))
    assert phrase.times == pytest.approx((0.05, 0.25, 0.5, 0.7))


def test_silence_has_no_phrase_and_an_empty_table_none_for_any() -> None:
    assert [*phrases_of(said(""))] == []
    assert _found(_index(), "da DA") == []


def test_a_phrase_of_equal_syllables_is_found() -> None:
    index = _index("da", "da da DA", "da da da DA")
    assert _outline(_found(index, "DA da da")) == [(3, 1, PhraseMatchKind.SYLLABLES)]


def test_of_equal_numbers_of_syllables_the_likest_stresses_count() -> None:
    index = _index("DA da da", "da da DA", "da DA da")
    assert _found(index, "da.da DA")[0].recording == 1
    assert _found(index, "da.DA da")[0].recording == 2


def test_of_equally_stressed_phrases_the_nearest_duration_counts() -> None:
    index = PhraseIndex((k, said("da DA da", length)) for k, length in enumerate((0.1, 0.2, 0.3)))
    assert [_found(index, "da DA da", length=length)[0].recording for length in (0.12, 0.19, 0.4)] == [0, 1, 2]


def test_a_phrase_without_a_match_is_split_beside_its_conjunctions() -> None:
    index = _index("da da DA", "DA da da da")
    matches = _found(index, "da da DA and DA da da", {3})
    assert _outline(matches) == [(3, 0, PhraseMatchKind.SYLLABLES), (4, 1, PhraseMatchKind.SYLLABLES)]
    assert matches[1].phrase.words == (3, 4, 5, 6)


def test_the_conjunction_nearest_the_middle_splits_first() -> None:
    index = _index("da", "da da da da")
    matches = _found(index, "da and da da da and da da da", {1, 5})
    assert [len(match.phrase) for match in matches] == [1, 4, 4]


def test_a_conjunction_is_left_alone_where_the_whole_phrase_is_found() -> None:
    index = _index("da da DA da da", "da da", "da da da")
    assert _outline(_found(index, "da da and da da", {2})) == [(5, 0, PhraseMatchKind.SYLLABLES)]


def test_a_conjunction_that_begins_a_phrase_splits_nothing() -> None:
    index = _index("DA da DA da da")
    assert _outline(_found(index, "and DA da DA", {0})) == [(4, 0, PhraseMatchKind.STRESSES)]


def test_without_a_conjunction_the_number_of_stresses_counts_alone() -> None:
    index = _index("da DA da DA da DA", "da DA da da da DA da", "DA")
    assert _outline(_found(index, "DA da da da da da da DA")) == [(8, 1, PhraseMatchKind.STRESSES)]


def test_stresses_alone_find_nothing_that_is_more_than_twice_as_long() -> None:
    index = _index("DA da da da da da da da da da da")
    assert _outline(_found(index, "da DA")) == [(1, 0, PhraseMatchKind.PIECE)] * 2


def test_where_nothing_is_found_the_word_boundary_nearest_the_middle_splits() -> None:
    index = _index("da da", "da da da da")
    matches = _found(index, "da.da da.da.da.da")
    assert _outline(matches) == [(2, 0, PhraseMatchKind.SYLLABLES), (4, 1, PhraseMatchKind.SYLLABLES)]


def test_a_word_that_none_matches_takes_the_beginning_of_the_next_longer_phrase() -> None:
    index = _index("da da", "DA da DA da", "da DA da DA")
    (match,) = _found(index, "da.DA.da")
    assert (match.recording, match.kind, len(match.example)) == (2, PhraseMatchKind.PIECE, 3)


def test_a_word_that_is_longer_than_all_phrases_takes_the_longest_one() -> None:
    (match,) = _found(_index("da", "da da"), "da.da.da.da.da")
    assert (match.recording, match.kind, len(match.example)) == (1, PhraseMatchKind.PIECE, 2)


@pytest.mark.parametrize("rhythm", ["DA", "da.DA.da da", "da and DA da.da.DA da and da.DA da", "da " * 200])
def test_what_is_found_covers_a_phrase_without_gaps(rhythm: str) -> None:
    index = _index("da da DA", "da DA da da da DA da da DA")
    matches = _found(index, rhythm, {k for k, word in enumerate(rhythm.split()) if word == "and"})
    (phrase,) = phrases_of(said(rhythm))
    assert matches[0].phrase.start == phrase.start
    assert matches[-1].phrase.end == phrase.end
    assert all(a.phrase.end == b.phrase.start for a, b in pairwise(matches))
    assert sum(len(match.phrase) for match in matches) == len(phrase)
