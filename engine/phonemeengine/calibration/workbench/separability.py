"""How well a number tells phonemes apart.

The measure is the chance that of two frames, one of each phoneme, the one of the first has the larger value (equal
ones count half): the area under the ROC curve, which is the Mann-Whitney U statistic over the number of pairs,
``AUC = U / (n1 n2)`` (Hanley and McNeil, Radiology 143, 1982). Which of the two is larger does not matter here, so
the separation of two phonemes is ``max(AUC, 1 - AUC)``: 0.5 where the number says nothing about them, 1 where one
threshold parts them all. Of several phonemes it is the mean over all pairs (Hand and Till, Machine Learning 45,
2001).
"""

from collections.abc import Iterable
from itertools import combinations

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.scores.scoring import N_CODES
from phonemeengine.phonemes import Phoneme


def separability(values: Float32Array, others: Float32Array) -> float:
    """Return how well a threshold can part two sets of values, 0.5..1; NaN where one is empty."""
    if not (len(values) and len(others)):
        return float("nan")
    ordered = np.sort(others)
    below = np.searchsorted(ordered, values, side="left").sum(dtype=float)
    up_to = np.searchsorted(ordered, values, side="right").sum(dtype=float)
    larger = (below + up_to) / (2 * len(values) * len(others))
    return float(max(larger, 1 - larger))


def separabilities(values: Float32Array, phonemes: UInt8Array) -> Float64Array:
    """Return how well a threshold can part each pair of phonemes.

    Parameters
    ----------
    values : shape (n_frames,).
    phonemes : codes of `Phoneme`, shape (n_frames,).

    Returns
    -------
    shape (11, 11), 0.5..1; NaN where a phoneme has no frames, and for each with itself.
    """
    order = np.argsort(values)
    ordered, codes = values[order], phonemes[order]
    groups = np.concatenate(([True], ordered[1:] != ordered[:-1])) if len(ordered) else np.zeros(0, bool)
    firsts = np.flatnonzero(groups)
    sizes = np.diff(firsts, append=len(ordered))
    counts = np.bincount(codes, minlength=N_CODES)
    larger = np.empty((N_CODES, N_CODES))
    for other in Phoneme:
        up_to = np.cumsum(codes == other)[firsts + sizes - 1]
        below = np.concatenate(([0], up_to[:-1]))[: len(up_to)]
        larger[:, other] = np.bincount(codes, np.repeat((below + up_to) / 2, sizes), minlength=N_CODES)
    with np.errstate(invalid="ignore", divide="ignore"):
        larger /= np.outer(counts, counts)
    np.fill_diagonal(larger, np.nan)
    separations = np.maximum(larger, 1 - larger)
    return np.maximum(separations, separations.T)  # equal but for rounding


def mean_separability(separations: Float64Array, phonemes: Iterable[Phoneme]) -> float:
    """Return the mean over all pairs of phonemes of which there are frames; NaN where there is no such pair."""
    pairs = np.array([separations[p, q] for p, q in combinations(phonemes, 2)])
    known = pairs[~np.isnan(pairs)]
    return float(known.mean()) if len(known) else float("nan")


def best_threshold(values: Float32Array, others: Float32Array) -> float:
    """Return the threshold that parts two sets best, in the middle of the gap where it lies.

    Best is where the shares of both that lie on their own side are largest together (Youden, Cancer 3, 1950); of
    several equal ones the middle one. Neither may be empty.
    """
    both = np.concatenate((values, others))
    order = np.argsort(both, kind="stable")
    ordered = both[order]
    own = order < len(values)
    shares = np.cumsum(np.where(own, 1 / len(values), -1 / len(others)))
    cuts = np.flatnonzero(ordered[1:] > ordered[:-1])
    if not len(cuts):
        return float(ordered[0])
    gains = np.abs(shares[cuts])
    best = cuts[gains >= gains.max() - 1e-9]
    cut = best[len(best) // 2]
    return float((float(ordered[cut]) + float(ordered[cut + 1])) / 2)
