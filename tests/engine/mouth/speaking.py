"""Speech that is known beforehand, for what is written of it: as phonemes, or as phones."""

from dataclasses import replace

import numpy as np

from phonemeengine.labels.phone_sets import phone_classes_in
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.transcript import Transcript, transcript_of_utterance
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment
from phonemeengine.settings import FRAME_PERIOD

PARTS = (
    (Phoneme.SILENCE, 0.30),
    (Phoneme.M, 0.09),
    (Phoneme.A, 0.21),
    (Phoneme.SZ, 0.02),
    (Phoneme.A, 0.12),
    (Phoneme.P, 0.07),
    (Phoneme.O, 0.25),
    (Phoneme.SCH, 0.11),
    (Phoneme.UNIDENTIFIED, 0.08),
    (Phoneme.I, 0.19),
    (Phoneme.SILENCE, 0.41),
    (Phoneme.SZ, 0.10),
    (Phoneme.E, 0.15),
    (Phoneme.U, 0.20),
    (Phoneme.SILENCE, 0.205),
)
DURATION = sum(length for _, length in PARTS)


def speech(name: str = "masapo.wav") -> Transcript:
    """A few syllables of 2.5 s, which rise and fall in pitch."""
    runs, at = [], 0.0
    for phoneme, length in PARTS:
        runs.append(Segment(round(at, 6), round(at + length, 6), phoneme, 0.0 if phoneme == Phoneme.SILENCE else 0.7))
        at += length
    times = np.arange(round(DURATION / FRAME_PERIOD)) * FRAME_PERIOD
    ends = np.array([run.end for run in runs])
    loud = np.array([run.intensity for run in runs], np.float32)[
        np.minimum(np.searchsorted(ends, times, "right"), 14)
    ]
    return Transcript(name, DURATION, tuple(runs), loud, np.where(loud > 0, 120 + 40 * times, 0).astype(np.float32))


def utterance_of(*phones: tuple[str, float], start: float = 0.3, after: float = 0.3) -> Utterance:
    """One word of phones that last so many seconds, between two silences."""
    said, at = [], start
    for ipa, length in phones:
        phone_class = phone_classes_in(ipa)[1]
        assert phone_class is not None
        said.append(Phone(round(at, 6), round(at + length, 6), ipa, phone_class.phoneme))
        at += length
    return Utterance((Word("word", (Syllable(tuple(said)),)),), round(at + after, 6))


def words_said(*words: tuple[str, float, tuple[tuple[str, float], ...]], duration: float) -> Transcript:
    """Words, each with its text, its start in seconds and its phones with their lengths, as a mouth needs them."""
    said = [replace(utterance_of(*phones, start=start).words[0], text=text) for text, start, phones in words]
    utterance = Utterance(tuple(said), duration)
    loud = np.full(round(duration / FRAME_PERIOD), 0.7, np.float32)
    return transcript_of_utterance(utterance, loud, np.zeros(len(loud), np.float32), "words.wav")


def phones_said(*phones: tuple[str, float], loudness: float = 0.7) -> Transcript:
    """The same, as a mouth needs it."""
    utterance = utterance_of(*phones)
    loud = np.full(round(utterance.duration / FRAME_PERIOD), loudness, np.float32)
    return transcript_of_utterance(utterance, loud, np.zeros(len(loud), np.float32), "word.wav")
