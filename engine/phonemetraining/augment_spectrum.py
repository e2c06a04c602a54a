"""Speech as a microphone might hear it: other levels, colours, noise, band limits, a noise floor.

All of it is done on mel powers, where sounds add up.
"""

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.log_mel import FLOOR, HIGHEST, LOWEST, N_BANDS, SHORT
from phonemeengine.dsp.mel import mel_edges
from phonemeengine.settings import SAMPLE_RATE

GAINS = (-18.0, 8.0)
"""Other levels, dB."""
COLOUR = 6.0
"""Unevenness of microphones and rooms over frequency, dB."""
TILT = 4.0
"""Slope from the lowest to the middle band, standard deviation, dB."""
SNRS = (0.0, 30.0)
"""Level of the loudest third of the speech above added noise, dB."""
FLOORS = (-120.0, -70.0)
"""Level of the microphone's own noise in each band, dB below full scale."""
NOISY, FLOORED, NARROW, BASSLESS, HIDDEN = 0.5, 0.85, 0.15, 0.1, 0.4
"""Shares of the recordings with noise, with a floor, without the highest bands, the lowest bands, some others."""
STEADY = 0.5
"""Share of the noise that is steady; the rest is babble, three others who speak at once."""

_BANDS = np.linspace(-1, 1, N_BANDS, dtype=np.float32)


def augment_spectra(powers: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Disturb a batch.

    Parameters
    ----------
    powers : mel powers, float32, shape (n_batch, n_frames, 40); a full-scale sine has 1.

    Returns
    -------
    base-10 logarithms of the disturbed powers, same shape.
    """
    n = len(powers)
    decibels = _curves(n, COLOUR, generator) + _tilts(n, TILT, generator) + generator.uniform(*GAINS, (n, 1, 1))
    noisy = powers * _powers(decibels)
    noisy += _noise(noisy, generator)
    noisy *= _limits(n, generator)
    floors = generator.uniform(*FLOORS, (n, 1, 1)) + _tilts(n, 5.0, generator)
    floored = generator.random((n, 1, 1)) < FLOORED
    noisy += _powers(floors) * _flicker(noisy.shape, generator) * floored
    logarithms: Float32Array = np.log10(noisy + np.float32(FLOOR), dtype=np.float32)
    _hide(logarithms, generator)
    return logarithms


def _noise(noisy: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Return steady coloured noise, or babble, at a drawn level below the speech, or none."""
    n = len(noisy)
    steady = _powers(_tilts(n, 8.0, generator) + _curves(n, COLOUR, generator)) * _flicker(noisy.shape, generator)
    babble = sum(noisy[generator.permutation(n)] for _ in range(3))
    noise = np.where(generator.random((n, 1, 1)) < STEADY, steady, babble)
    noise /= noise.mean(axis=(1, 2), keepdims=True) + np.float32(1e-20)
    loudest = np.sort(noisy.mean(axis=2), axis=1)[:, -noisy.shape[1] // 3 :].mean(axis=1)[:, None, None]
    wanted = loudest * _powers(-generator.uniform(*SNRS, (n, 1, 1)))
    return np.asarray(noise * wanted * (generator.random((n, 1, 1)) < NOISY), np.float32)


def _limits(n: int, generator: np.random.Generator) -> Float32Array:
    """Return factors that take the highest or the lowest bands away, shape (n, 1, 40)."""
    bands = np.arange(N_BANDS)
    highest = np.where(generator.random(n) < NARROW, generator.integers(24, 38, n), N_BANDS)
    lowest = np.where(generator.random(n) < BASSLESS, generator.integers(1, 5, n), 0)
    high = np.where(bands >= highest[:, None], 1e-7, 1.0)
    low = np.where(bands < lowest[:, None], 1e-5, 1.0)
    return np.asarray(high * low, np.float32)[:, np.newaxis]


def _hide(logarithms: Float32Array, generator: np.random.Generator) -> None:
    """Put the mean into a few neighbouring bands (D. Park et al., "SpecAugment", arXiv:1904.08779)."""
    for recording in logarithms:
        if generator.random() < HIDDEN:
            first, width = generator.integers(0, N_BANDS - 4), generator.integers(1, 6)
            recording[:, first : first + width] = recording.mean()


def _curves(n: int, most: float, generator: np.random.Generator) -> Float32Array:
    """Draw smooth curves over the bands, dB, shape (n, 1, 40)."""
    orders = np.arange(1, 5, dtype=np.float32)[:, None]
    phases = generator.random((n, 4, 1)) * 2 * np.pi
    waves = generator.standard_normal((n, 4, 1)) / orders * np.cos(orders * np.pi / 2 * (_BANDS + 1) + phases)
    return np.asarray(waves.sum(axis=1) * most * generator.random((n, 1)), np.float32)[:, np.newaxis]


def _tilts(n: int, spread: float, generator: np.random.Generator) -> Float32Array:
    return np.asarray(_BANDS * generator.standard_normal((n, 1, 1)) * spread, np.float32)


def _flicker(shape: tuple[int, ...], generator: np.random.Generator) -> Float32Array:
    """Draw how noise varies from frame to frame in each band: a wide band is steadier; the mean is 1."""
    return generator.standard_gamma(np.broadcast_to(_DEGREES, shape), dtype=np.float32) / _DEGREES


def _powers(decibels: NDArray[np.floating]) -> Float32Array:
    return np.asarray(10 ** (decibels / 10), np.float32)


def _degrees_of_freedom() -> Float32Array:
    edges = mel_edges(N_BANDS, HIGHEST, LOWEST)
    bins = (edges[2:] - edges[:-2]) / 2 * SHORT / SAMPLE_RATE
    return np.maximum(1, 0.8 * bins).astype(np.float32)


_DEGREES = _degrees_of_freedom()
