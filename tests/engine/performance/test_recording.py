from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.performance.recording import LEAST_SILENCE, SILENCE, phones_of
from phonemeengine.phonemes import Phoneme


def _utterance(*words: list[tuple[float, float]], duration: float) -> Utterance:
    """Words of vowels that last from when to when, a syllable a word."""
    return Utterance(
        tuple(Word("a", (Syllable(tuple(Phone(a, b, "aː", Phoneme.A) for a, b in spans)),)) for spans in words),
        duration,
    )


def test_a_pause_between_words_is_silence_and_a_gap_within_one_belongs_to_the_phone_before_it() -> None:
    said = _utterance([(0.1, 0.2), (0.3, 0.4)], [(0.6, 0.7)], duration=1.0)
    found = [(phone.name, phone.start, phone.end) for phone in phones_of(said)]
    assert found == [
        (SILENCE, 0, 0.1),
        ("a", 0.1, 0.3),
        ("a", 0.3, 0.4),
        (SILENCE, 0.4, 0.6),
        ("a", 0.6, 0.7),
        (SILENCE, 0.7, 1.0),
    ]


def test_what_nobody_says_is_silence_alone() -> None:
    (phone,) = phones_of(_utterance(duration=1.0))
    assert (phone.name, phone.start, phone.middle, phone.end, phone.word) == (SILENCE, 0, 0.5, 1.0, -1)


@given(st.lists(st.lists(st.integers(0, 300), min_size=1, max_size=4), min_size=1, max_size=5), st.data())
def test_phones_fill_a_sentence_without_gaps_between_silence(lengths: list[list[int]], data: st.DataObject) -> None:
    at, words = data.draw(st.integers(0, 50)), []
    for word in lengths:
        spans = []
        for length in word:
            spans.append((at / 1000, (at + length) / 1000))
            at += length
        words.append(spans)
        at += data.draw(st.integers(0, 50))
    duration = max(at / 1000 + 0.001, LEAST_SILENCE)
    phones = phones_of(_utterance(*words, duration=duration))
    assert {phones[0].name, phones[-1].name} == {SILENCE}
    assert (phones[0].start, phones[-1].end) == (0, pytest.approx(duration))
    assert all(a.end == b.start for a, b in pairwise(phones))
    assert all(phone.start < phone.middle < phone.end for phone in phones)
