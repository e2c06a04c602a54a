"""Sentences that are to be performed: what is said in a sound, with how loud and how high each phone is."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.transcript import Prosody, Transcript
from phonemeengine.performance.recording import SILENCE, PerformedPhone, phones_of
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings

PAUSE = 0.25
"""Seconds of silence that part sentences; what is shorter is a pause within one."""

Sentence = tuple[PerformedPhone, ...]
"""Phones in order of time, without gaps; the first and the last are silence."""


def performed_phones(utterance: Utterance, speech: Prosody | Transcript) -> Sentence:
    """Return the phones of an utterance, with silence before and after them and in pauses.

    Parameters
    ----------
    utterance : what is said; p and b begin where the lips close, as voices and alignments have it.
    speech : how loud and high it is. Levels are as if its preset had the usual range of intensities.
    """
    first = speech.first if isinstance(speech, Prosody) else 0
    intensities, pitches = speech.intensities, speech.pitches
    return tuple(
        replace(
            phone,
            energy=_level(_frames_of(phone, intensities, first)),
            pitch=_middle(_frames_of(phone, pitches, first)),
        )
        for phone in phones_of(utterance)
    )


def sentences_in(phones: Sentence) -> tuple[Sentence, ...]:
    """Part phones at long pauses; neighbours share the pause, so that one may go over into the other there."""
    pauses = [k for k, phone in enumerate(phones) if phone.name == SILENCE and phone.duration >= PAUSE]
    bounds = sorted({0, len(phones) - 1, *pauses})
    return tuple(phones[first : last + 1] for first, last in pairwise(bounds)) or (phones,)


def joined(sentences: Sequence[Sentence]) -> Sentence:
    """Return sentences as one; neighbours share a pause."""
    return sentences[0] + tuple(phone for sentence in sentences[1:] for phone in sentence[1:])


def _frames_of(phone: PerformedPhone, values: Float32Array, first: int) -> Float32Array:
    """Return the frames of a phone, of values whose first frame has a number."""
    start = max(0, int(phone.start / FRAME_PERIOD) - first)
    return values[start : max(start + 1, round(phone.end / FRAME_PERIOD) - first)]


def _level(intensities: Float32Array) -> float:
    """Return the mean level of frames, dB; 0 where nobody measured it."""
    low, high = AnalysisSettings.intensity_low, AnalysisSettings.intensity_high
    return low + (high - low) * float(intensities.mean()) if len(intensities) else 0.0


def _middle(pitches: Float32Array) -> float:
    """Return the median pitch of frames, Hz; 0 where fewer than half of them are voiced."""
    return float(np.median(pitches)) if len(pitches) else 0.0
