"""How strongly a phoneme is spoken, from the loudness of its frame."""

from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array

ONE = np.ones((), np.float32)


def intensities_of(levels: Float32Array, low: float, high: float) -> Float32Array:
    """Map peak levels (0..1) to intensities: 0 at `low` dB below full scale, 1 at `high`, linear in dB."""
    gain, slope = line_of(low, high)
    # the greater of level and limit comes before the logarithm, so silence has no logarithm of 0
    intensities: Float32Array = np.minimum(np.log10(np.maximum(levels * gain, ONE)) * slope, ONE)
    return intensities


@lru_cache(maxsize=8)
def line_of(low: float, high: float) -> tuple[Float32Array, Float32Array]:
    """Return what a level is multiplied with, and what its logarithm is, so that 1 is `high` dB below full scale."""
    # level x gain is 1 at `low`, where its logarithm is 0; 20 log10 makes decibels, and 1 / (high - low) the line
    gain, slope = 10 ** (-low / 20), 20 / max(high - low, 1e-6)
    return np.array(gain, np.float32), np.array(slope, np.float32)
