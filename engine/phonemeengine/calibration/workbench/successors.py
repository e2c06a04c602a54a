"""Count the table of successors: what a frame truly is where the rules say nothing, after each phoneme."""

import numpy as np
from numpy.typing import NDArray

from phonemeengine.calibration.scores.scoring import N_CODES, TEN, Codes
from phonemeengine.phonemes import Phoneme

PRIOR = 50
"""The table begins as if so many frames had been seen after each phoneme, spread as all unidentified frames are; so
a phoneme after which few were seen gets what is likeliest after any."""

Table = NDArray[np.uint8]
"""Codes of `Phoneme`, shape (11,): the successor of each."""


def last_identified(answers: Codes, first: NDArray[np.bool_]) -> Codes:
    """Give for each frame the newest phoneme that the rules named, itself included.

    Parameters
    ----------
    answers : codes of `Phoneme`, shape (n_frames,), with unidentified frames.
    first : bool, shape (n_frames,): where a recording begins; before it was silence.
    """
    named = answers != Phoneme.UNIDENTIFIED
    told = named | first
    told[:1] = True
    places = np.flatnonzero(told)
    newest = np.where(named[places], answers[places], np.uint8(Phoneme.SILENCE))
    return np.repeat(newest, np.diff(places, append=len(answers)))


def counted_table(last: Codes, truth: NDArray[np.int64], totals: NDArray[np.int64]) -> Table:
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
    shares = np.where(np.isin(np.arange(N_CODES), TEN), seen / np.maximum(totals, 1), -1)
    table: Table = shares.argmax(axis=1).astype(np.uint8)
    return table


def successors_of(table: Table) -> dict[Phoneme, Phoneme]:
    """Write a table as presets have it."""
    return {Phoneme(p): Phoneme(q) for p, q in enumerate(table.tolist())}
