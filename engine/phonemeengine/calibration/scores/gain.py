"""Whether a gain on a few seconds of speech is more than chance."""

from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import MOUTH_CODES, N_CODES, SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.phonemes import Phoneme

PairedAnswers = tuple[UInt8Array, UInt8Array, UInt8Array]
"""What was said in the frames of a recording, and the answers before and after, codes, each of shape (n_frames,)."""
N_DRAWS = 2000
CHANCE = 0.025
"""How often chance alone may look like a gain: one end of an interval of 95 %."""


def gains_beyond_chance(recordings: Sequence[PairedAnswers], *, seed: int = 0) -> bool:
    """Return whether macro F1 and the share of right mouth shapes both rose by more than chance.

    Paired bootstrap (B. Efron, R. Tibshirani, An Introduction to the Bootstrap, 1993, section 13.3): phones, whose
    frames are alike, are drawn anew, as many as there are, and both figures are compared on the same ones.
    """
    phones = [phone for recording in recordings for phone in _phones_of(recording)]
    if not phones:
        return False
    before, after = (np.array([_counts(said, answers[k]) for said, *answers in phones]) for k in (0, 1))
    shapes = np.array([_mouths_gained(*phone) for phone in phones])
    chance = np.random.default_rng(seed)
    draws = chance.multinomial(len(phones), np.full(len(phones), 1 / len(phones)), N_DRAWS).astype(float)
    rises = (_macro_f1s(draws @ after) - _macro_f1s(draws @ before), draws @ shapes)
    return all(float(np.mean(rise <= 0)) < CHANCE for rise in rises)


def _phones_of(recording: PairedAnswers) -> list[PairedAnswers]:
    """Cut a recording where what is said changes."""
    said, before, after = recording
    edges = np.flatnonzero(np.diff(said)) + 1
    parts = zip(*(np.split(codes, edges) for codes in (said, before, after)), strict=True)
    return [(truth, one, other) for truth, one, other in parts if len(truth)]


def _counts(said: UInt8Array, answers: UInt8Array) -> Float64Array:
    """Return the confusion matrix of a phone, as macro F1 counts it, flat, shape (121,)."""
    known = said != Phoneme.UNIDENTIFIED
    return confusion_of(said[known], answers[known]).ravel().astype(float)


def _mouths_gained(said: UInt8Array, before: UInt8Array, after: UInt8Array) -> int:
    """Return in how many frames more of a phone the mouth shape is right afterwards."""
    truth = MOUTH_CODES[said]
    return int(np.sum(MOUTH_CODES[after] == truth)) - int(np.sum(MOUTH_CODES[before] == truth))


def _macro_f1s(counts: Float64Array) -> Float64Array:
    """Return the macro F1 of each row of flat confusion matrices; 0 where it has none of the ten classes."""
    whole = counts.astype(np.int64).reshape(-1, N_CODES, N_CODES)
    return np.nan_to_num(macro_f1_of(whole, SCORED_PHONEMES))
