"""Monotone cubic interpolation of many curves at once.

The slopes are those of F. Fritsch and J. Butland, A method for constructing local monotone piecewise cubic
interpolants (1984), without their weights: the harmonic mean of both neighbouring secants, 0 where these differ in
sign; at the ends, the secant. Beyond its ends a curve goes on straight.
"""

import numpy as np

from phonemeengine.arrays import Float64Array, IndexArray

FAR = 1e4
"""More than any curve is long."""


class MonotoneCubics:
    """Curves through points, evaluated together.

    Parameters
    ----------
    xs : float64, shape (n,): of the points of all curves one after the other; of each, increasing.
    ys : float64, shape (n,).
    starts : shape (n_curves,): the number of each curve's first point; every curve has two points or more.
    """

    def __init__(self, xs: Float64Array, ys: Float64Array, starts: IndexArray) -> None:
        ends = np.append(starts[1:], len(xs))
        curves = np.repeat(np.arange(len(starts)), ends - starts)
        self._first, self._last = starts, ends - 2  # the numbers of their first and last pieces
        self._xs, self._ys, self._shifted = xs, ys, xs + FAR * curves
        self._widths = np.diff(xs)
        self._widths[starts[1:] - 1] = 1.0  # from one curve to the next: of no piece
        secants = np.diff(ys) / self._widths
        before, after = secants[:-1], secants[1:]
        agree = before * after > 0
        total = np.where(agree, before + after, 1.0)
        self._slopes = np.empty(len(xs))
        self._slopes[1:-1] = np.where(agree, 2 * before * after / total, 0.0)
        self._slopes[starts], self._slopes[ends - 1] = secants[starts], secants[ends - 2]

    def at(self, xs: Float64Array, curves: IndexArray) -> Float64Array:
        """Return the values of some curves at some places, both of shape (n,)."""
        found = np.searchsorted(self._shifted, xs + FAR * curves, "right") - 1
        k = np.clip(found, self._first[curves], self._last[curves])
        width, rise = self._widths[k], self._ys[k + 1] - self._ys[k]
        share = (xs - self._xs[k]) / width
        beyond = np.where(
            share < 0, share * self._slopes[k], np.where(share > 1, (share - 1) * self._slopes[k + 1], 0.0)
        )
        s = np.clip(share, 0.0, 1.0)
        bent = s * (1 - s) * ((1 - s) * (self._slopes[k] * width - rise) + s * (rise - self._slopes[k + 1] * width))
        values: Float64Array = self._ys[k] + s * rise + bent + beyond * width
        return values
