import numpy as np
import pytest

from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.units import performed_phones, sentences_in
from phonemeengine.phonemes import Phoneme

DURATION = 2.0


def said(*words: tuple[float, float]) -> Utterance:
    """Give words "pa" from one time to another."""
    return Utterance(
        tuple(
            Word("pa", (Syllable((Phone(a, a + 0.1, "p", Phoneme.P), Phone(a + 0.1, b, "aː", Phoneme.A)), 1),))
            for a, b in words
        ),
        DURATION,
    )


def heard(loud: float = 0.0, pitch: float = 0.0) -> Transcript:
    n = round(DURATION * 100)
    intensities, pitches = np.zeros(n, np.float32), np.zeros(n, np.float32)
    intensities[60:80], pitches[60:80] = loud, pitch
    return Transcript("", DURATION, (), intensities, pitches)


def test_silence_stands_before_and_after_what_is_said_and_in_pauses() -> None:
    phones = performed_phones(said((0.5, 0.8), (0.9, 1.2)), heard())
    assert [phone.name for phone in phones] == [SILENCE, "p", "a", SILENCE, "p", "a", SILENCE]
    assert [(phone.word, phone.syllable) for phone in phones[1:5]] == [(0, 0), (0, 0), (-1, -1), (1, 1)]
    assert [phone.start for phone in phones] == pytest.approx([0, 0.5, 0.6, 0.8, 0.9, 1.0, 1.2])
    assert phones[-1].end == DURATION


def test_each_phone_is_as_loud_and_high_as_its_frames() -> None:
    p, a = performed_phones(said((0.5, 0.8)), heard(loud=1.0, pitch=140.0))[1:3]
    assert (p.energy, p.pitch) == pytest.approx((-45, 0))
    assert (a.energy, a.pitch) == pytest.approx((-3, 140))


def test_a_sound_that_nobody_measured_is_as_loud_everywhere() -> None:
    phones = performed_phones(said((0.5, 0.8)), Transcript("", DURATION))
    assert {(phone.energy, phone.pitch) for phone in phones} == {(0.0, 0.0)}


def test_long_pauses_part_sentences_and_belong_to_both() -> None:
    phones = performed_phones(said((0.3, 0.6), (0.7, 1.0), (1.3, 1.6)), heard())
    first, second = sentences_in(phones)
    assert [phone.name for phone in first] == [SILENCE, "p", "a", SILENCE, "p", "a", SILENCE]
    assert first[-1] is second[0]
    assert second[0].duration == pytest.approx(0.3)
    assert sentences_in(phones[:1]) == (phones[:1],)
