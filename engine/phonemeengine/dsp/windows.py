"""Window functions, symmetric, float32."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import WindowFunction

BLACKMAN_HARRIS = (0.35875, -0.48829, 0.14128, -0.01168)
"""Four-term coefficients of F. J. Harris, Proc. IEEE 66 (1978)."""


def _blackman_harris(n: int) -> Float64Array:
    phase = 2 * np.pi * np.arange(n) / (n - 1)
    return sum((a * np.cos(k * phase) for k, a in enumerate(BLACKMAN_HARRIS)), np.zeros(n))


_SHAPES: dict[WindowFunction, Callable[[int], Float64Array]] = {
    WindowFunction.RECTANGLE: np.ones,
    WindowFunction.BARTLETT: np.bartlett,
    WindowFunction.HANN: np.hanning,
    WindowFunction.HAMMING: np.hamming,
    WindowFunction.BLACKMAN_HARRIS: _blackman_harris,
}


@lru_cache(maxsize=32)
def window_of(function: WindowFunction, n: int) -> Float32Array:
    """Return the weights of a window function over `n` samples, shape (n,), 0..1; shared, so read-only."""
    weights = np.asarray(_SHAPES[function](n), np.float32)
    weights.flags.writeable = False
    return weights
