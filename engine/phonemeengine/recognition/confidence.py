"""The confidence of an answer: of frames with a confidence of 0.8, eight in ten are right.

The probabilities of a recogniser are not that: they are too high, and what is named is smoothed besides. A
rising curve, found by isotonic regression on speakers who took no part in the training, turns the one into the other.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.errors import PresetError

MOST_POINTS = 16
"""Of a curve."""
LEAST_STEP = 0.001
"""Between the scores of two points."""
N_BINS = 10
"""In which confidences are compared with the shares that are right."""
LEAST_SHARE = 0.01
"""Of all frames, that a bin must hold for its gap to count."""


@dataclass(frozen=True)
class ConfidenceCurve:
    """Shares of right answers by the score of what is named; straight lines between its points.

    Attributes
    ----------
    scores : rising, 0..1.
    shares : not falling, 0..1; one alone holds for all scores.

    Raises
    ------
    PresetError : they are not as said, or not equally many.
    """

    scores: tuple[float, ...] = (0.0, 1.0)
    shares: tuple[float, ...] = (0.0, 1.0)

    def __post_init__(self) -> None:
        scores, shares = np.array(self.scores), np.array(self.shares)
        fits = 0 < len(scores) == len(shares) <= MOST_POINTS and (np.diff(scores) > 0).all()
        inside = all(np.isfinite(a).all() and (a >= 0).all() and (a <= 1).all() for a in (scores, shares))
        if not (fits and inside and (np.diff(shares) >= 0).all()):
            raise PresetError(
                f"a confidence has 1..{MOST_POINTS} rising scores and as many shares that do not fall, all of 0..1; "
                "fit it again"
            )

    def of(self, scores: Float32Array) -> Float32Array:
        """Return the confidence of answers with these scores, 0..1, same shape."""
        return np.interp(scores, *self._points).astype(np.float32)

    @cached_property
    def _points(self) -> tuple[Float64Array, Float64Array]:
        return np.array(self.scores, np.float64), np.array(self.shares, np.float64)


UNFITTED = ConfidenceCurve()
"""Takes a score for what it is."""


def fit_confidence(scores: Float32Array, right: BoolArray) -> ConfidenceCurve:
    """Return the rising curve that is nearest to what was right, least squares.

    Isotonic regression by pooling adjacent violators (M. Ayer et al., Ann. Math. Stat. 26(4), 1955), of the means of
    equally many frames each.

    Parameters
    ----------
    scores : of what was named, shape (n,), at least one.
    right : whether it was, shape (n,).
    """
    # Equally many frames for each point, so that all are known equally well, also where scores crowd near 1.
    order = np.argsort(scores, kind="stable")
    parts = np.array_split(order, min(MOST_POINTS, len(order)))
    heights = [float(right[part].mean()) for part in parts]
    middles = [float(scores[part].mean()) for part in parts]
    pools: list[tuple[float, float, int]] = []
    for middle, height in zip(middles, heights, strict=True):
        pool = (middle, height, 1)
        # A pool that does not rise above the one before it is joined with it, and the joined one is compared again:
        # what is left rises, and is the best rising fit (least squares). Points too close in score join too.
        while pools and (pools[-1][1] >= pool[1] or pools[-1][0] + LEAST_STEP > pool[0]):
            before = pools.pop()
            n = before[2] + pool[2]
            pool = (
                (before[0] * before[2] + pool[0] * pool[2]) / n,
                (before[1] * before[2] + pool[1] * pool[2]) / n,
                n,
            )
        pools.append(pool)
    return ConfidenceCurve(
        tuple(round(middle, 4) for middle, _, _ in pools), tuple(round(height, 4) for _, height, _ in pools)
    )


def calibration_errors(confidences: Float32Array, right: BoolArray) -> tuple[float, float]:
    """Return the expected calibration error (C. Guo et al., arXiv:1706.04599), and the largest gap of a bin.

    NaN where there is no frame.
    """
    # a confidence of exactly 1 belongs to the last bin
    bins = np.minimum((confidences * N_BINS).astype(int), N_BINS - 1)
    counts = np.bincount(bins, minlength=N_BINS)
    if not len(bins):
        return float("nan"), float("nan")
    # the mean of differences is the difference of means, so the sums of each bin are enough
    gaps = np.abs(_sums(bins, confidences) - _sums(bins, right.astype(np.float32))) / np.maximum(counts, 1)
    full = counts >= LEAST_SHARE * len(bins)
    return float((gaps * counts).sum() / len(bins)), float(gaps[full].max())


def _sums(bins: np.ndarray[tuple[int], np.dtype[np.int64]], values: Float32Array) -> Float64Array:
    return np.asarray(np.bincount(bins, values, N_BINS), np.float64)
