"""Scores: how likely each phoneme is, as recognisers measure it who name the likeliest one.

They become columns of the features, one for each phoneme, and all that such a recogniser says is read from them.
"""

import numpy as np
from numpy.typing import NDArray

from engine.features.measure import Features
from engine.features.variables import SCORES
from engine.phonemes import Phoneme
from engine.recognition.trace import Comparison, Trace

__all__ = ["SCORES", "scores_in", "shortfalls_of_scores", "trace_of_scores"]

N_NEAREST = 5
"""How many phonemes a trace compares."""


def scores_in(features: Features) -> NDArray[np.float32] | None:
    """Give the columns of the scores, shape (n_frames, n_phonemes), or None where nobody has measured them yet."""
    if SCORES[0] not in features.names:
        return None
    first = features.names.index(SCORES[0])
    return features.values[:, first : first + len(SCORES)]


def shortfalls_of_scores(features: Features) -> NDArray[np.float32] | None:
    """Say by how much each phoneme is less likely than the likeliest, shape (n_frames, n_phonemes)."""
    scores = scores_in(features)
    if scores is None:
        return None
    shortfalls: NDArray[np.float32] = scores.max(axis=1, keepdims=True) - scores
    return shortfalls


def trace_of_scores(features: Features, k: int) -> Trace:
    """Say why frame `k` of a block is recognised as it is: the likeliest phonemes, the best one first.

    The best is compared with the second, all others with the best. Frames that nobody has scored are unidentified.
    """
    scores = scores_in(features)
    if scores is None:
        return Trace(Phoneme.UNIDENTIFIED, Phoneme.UNIDENTIFIED.label, ())
    row = scores[k]
    order = [Phoneme(int(code)) for code in np.argsort(-row, kind="stable")[:N_NEAREST]]
    best = order[0]
    return Trace(best, best.label, tuple(_compared(row, p, order[1] if p is best else best) for p in order))


def _compared(row: NDArray[np.float32], phoneme: Phoneme, rival: Phoneme) -> Comparison:
    value, limit = float(row[phoneme]), float(row[rival])
    return Comparison(phoneme.label, SCORES[phoneme], value, ">", SCORES[rival], limit, value - limit)
