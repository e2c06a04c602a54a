"""Count the table of successors: what a frame truly is where the rules say nothing, after each phoneme."""

import numpy as np

from phonemeengine.arrays import BoolArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme

PRIOR = 50
"""The table begins as if so many frames had been seen after each phoneme, spread as all unidentified frames are; so
a phoneme after which few were seen gets what is likeliest after any."""


def last_identified(answers: UInt8Array, first: BoolArray) -> UInt8Array:
    """Return for each frame the newest phoneme that the rules named, itself included.

    Parameters
    ----------
    answers : codes of `Phoneme`, shape (n_frames,), with unidentified frames.
    first : bool, shape (n_frames,): where a recording begins; before it was silence.
    """
    named = answers != Phoneme.UNIDENTIFIED
    settled = named | first
    settled[:1] = True
    places = np.flatnonzero(settled)
    newest = np.where(named[places], answers[places], np.uint8(Phoneme.SILENCE))
    return np.repeat(newest, np.diff(places, append=len(answers)))


def counted_table(last: UInt8Array, truth: Int64Array, totals: Int64Array) -> UInt8Array:
    """Choose for each phoneme the successor that finds the largest share of its own class's frames.

    A share of the class, not a count of frames, since a macro F1 weighs all classes alike.

    Parameters
    ----------
    last : the last identified phoneme before each unidentified frame, shape (n_unidentified,).
    truth : the labels of these frames.
    totals : how many frames of each class there are at all, shape (11,).
    """
    counts = np.bincount(last * np.int64(N_CODES) + truth, minlength=N_CODES**2).reshape(N_CODES, N_CODES)
    anywhere = counts.sum(axis=0) + 1e-3 * totals
    seen = counts + PRIOR * anywhere / max(anywhere.sum(), 1e-9)
    shares = np.where(np.isin(np.arange(N_CODES), SCORED_PHONEMES), seen / np.maximum(totals, 1), -1)
    table: UInt8Array = shares.argmax(axis=1).astype(np.uint8)
    return table


def successors_of(table: UInt8Array) -> dict[Phoneme, Phoneme]:
    """Write a table as presets have it."""
    return {Phoneme(p): Phoneme(q) for p, q in enumerate(table.tolist())}
