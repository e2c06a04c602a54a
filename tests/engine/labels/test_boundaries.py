"""Boundaries that are moved by hand: what touches moves along, and all else stays."""

import pytest

from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import LabelUnit, Phone, Syllable, Utterance, Word, spans_of, with_boundary
from phonemeengine.phonemes import Phoneme

MAMA = Word(
    "mama",
    (
        Syllable((Phone(1.0, 1.1, "m", Phoneme.M, 0.1), Phone(1.1, 1.2, "a", Phoneme.A, 0.1)), 1),
        Syllable((Phone(1.2, 1.3, "m", Phoneme.M, 0.1), Phone(1.3, 1.4, "a", Phoneme.A, 0.1))),
    ),
)
OH = Word("oh", (Syllable((Phone(1.4, 1.6, "o", Phoneme.O, 0.2),)),))
SEA = Word("sea", (Syllable((Phone(2.0, 2.1, "s", Phoneme.SZ, 0.3), Phone(2.1, 2.3, "i", Phoneme.I, 0.3))),))
SAID = Utterance((MAMA, OH, SEA), 3.0, "en-us")


def times(utterance: Utterance, unit: LabelUnit) -> list[tuple[float, float]]:
    return [(round(start, 6), round(end, 6)) for start, end in spans_of(utterance, unit)]


def test_an_utterance_is_made_of_words_syllables_and_phones():
    assert times(SAID, LabelUnit.WORD) == [(1.0, 1.4), (1.4, 1.6), (2.0, 2.3)]
    assert times(SAID, LabelUnit.SYLLABLE) == [(1.0, 1.2), (1.2, 1.4), (1.4, 1.6), (2.0, 2.3)]
    assert len(times(SAID, LabelUnit.PHONE)) == 7


def test_a_boundary_between_two_phones_moves_both():
    moved = with_boundary(SAID, LabelUnit.PHONE, 2, 1.15)
    assert times(moved, LabelUnit.PHONE)[:3] == [(1.0, 1.15), (1.15, 1.2), (1.2, 1.3)]
    assert times(moved, LabelUnit.PHONE)[3:] == times(SAID, LabelUnit.PHONE)[3:]


def test_the_phones_of_a_word_become_longer_by_one_factor_and_those_of_its_neighbour_shorter():
    moved = with_boundary(SAID, LabelUnit.WORD, 2, 1.5)
    assert times(moved, LabelUnit.PHONE)[:5] == [(1.0, 1.125), (1.125, 1.25), (1.25, 1.375), (1.375, 1.5), (1.5, 1.6)]
    assert times(moved, LabelUnit.WORD)[2] == (2.0, 2.3)


def test_a_word_after_a_pause_begins_earlier_alone():
    moved = with_boundary(SAID, LabelUnit.WORD, 4, 1.7)
    assert times(moved, LabelUnit.WORD) == [(1.0, 1.4), (1.4, 1.6), (1.7, 2.3)]


def test_the_end_of_a_word_moves_alone_before_a_pause():
    moved = with_boundary(SAID, LabelUnit.WORD, 3, 1.8)
    assert times(moved, LabelUnit.WORD) == [(1.0, 1.4), (1.4, 1.8), (2.0, 2.3)]


def test_what_was_moved_by_hand_has_no_score_and_all_else_keeps_its_own():
    moved = with_boundary(SAID, LabelUnit.PHONE, 8, 1.45)
    assert [phone.score for phone in moved.phones] == [0.1, 0.1, 0.1, None, None, 0.3, 0.3]


def test_text_stress_and_language_stay():
    moved = with_boundary(SAID, LabelUnit.SYLLABLE, 2, 1.25)
    assert [word.text for word in moved.words] == ["mama", "oh", "sea"]
    assert [syllable.stress for syllable in moved.words[0].syllables] == [1, 0]
    assert (moved.language, moved.duration) == ("en-us", 3.0)


@pytest.mark.parametrize(("boundary", "seconds"), [(0, 1.4), (2, 1.0), (3, 2.05), (5, 3.1), (6, 1.0), (-1, 1.0)])
def test_a_boundary_that_leaves_nothing_of_a_word_or_lies_in_another_one_is_refused(boundary, seconds):
    with pytest.raises(CorpusError):
        with_boundary(SAID, LabelUnit.WORD, boundary, seconds)
