"""Fundamental frequency by autocorrelation.

The method is that of P. Boersma, "Accurate short-term analysis of the fundamental frequency and the
harmonics-to-noise ratio of a sampled sound", IFA Proceedings 17 (1993): the autocorrelation of the windowed
frame is divided by that of the window, and its highest peak, with a small bonus for short lags, is the period.
It is the method behind Praat's pitch, here without the path search, since a live frame knows no future, and on
the sound below 1.5 kHz only, at an eighth of the rate.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from engine.settings import SAMPLE_RATE, WINDOW

LOWEST = 60.0
HIGHEST = 500.0
VOICING_THRESHOLD = 0.55
SILENCE_LEVEL = 0.001
OCTAVE_BONUS = 0.04
PASSED, STOPPED = 1500.0, 2000.0
"""Between these frequencies (Hz) the sound fades out; what decimating folds down lies above them."""

_STEP = 8
_FINE = 2
_PADDED = 384  # 256 samples and the longest lag, so that nothing wraps around
_LAG_RATE = SAMPLE_RATE / _STEP * _FINE
_LAGS = np.arange(int(_LAG_RATE / HIGHEST), int(_LAG_RATE / LOWEST) + 2)


@lru_cache(maxsize=1)
def _window() -> NDArray[np.float32]:
    return np.hanning(WINDOW // _STEP + 2)[1:-1].astype(np.float32)


@lru_cache(maxsize=1)
def _inverse_transform() -> NDArray[np.float32]:
    """Give the cosines that turn power into the autocorrelation at lag 0 and at `_LAGS`, as a matrix.

    Lags finer than a sample interpolate exactly, since the power is band-limited. All but lag 0 are already
    divided by the autocorrelation of the window; power above `PASSED` fades out.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - half a second that a window should not wait for

    bins = np.arange(_PADDED // 2 + 1)
    weights = np.where((bins == 0) | (bins == _PADDED // 2), 1, 2)[:, None]
    lags = np.concatenate(([0], _LAGS)) / (_PADDED * _FINE)
    cosines = weights * np.cos(2 * np.pi * np.outer(bins, lags))
    of_window = np.abs(rfft(_window().astype(float), _PADDED)) ** 2 @ cosines
    frequencies = bins[:, None] * (SAMPLE_RATE / _STEP / _PADDED)
    kept = np.clip((STOPPED - frequencies) / (STOPPED - PASSED), 0, 1)
    return np.asarray(kept * cosines / (of_window / of_window[0]), np.float32)


_BONUS = (OCTAVE_BONUS * np.log2(_LAGS[-1] / _LAGS)).astype(np.float32)


def fundamental_of(frames: NDArray[np.float32]) -> NDArray[np.float32]:
    """Measure the fundamental frequency of raw frames.

    Parameters
    ----------
    frames : float32, shape (n_frames, 2048), full scale ±1, at 44.1 kHz.

    Returns
    -------
    float32, shape (n_frames,): 60..500 Hz, or 0 where the frame is unvoiced or nearly silent.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - half a second that a window should not wait for

    slow = _halve(_halve(_halve(frames)))
    slow -= np.add.reduce(slow, axis=1, keepdims=True) / np.float32(slow.shape[1])
    loud = np.maximum.reduce(slow, axis=1) > SILENCE_LEVEL
    bins = rfft(slow * _window(), _PADDED, axis=1)
    correlation = (bins.real**2 + bins.imag**2) @ _inverse_transform()
    zero_lag = np.maximum(correlation[:, :1], np.finfo(np.float32).tiny)
    return _best_peak(correlation[:, 1:] / zero_lag, loud)


def _halve(waves: NDArray[np.float32]) -> NDArray[np.float32]:
    """Halve the rate behind the low-pass 1 3 3 1, whose threefold zero lies where the folds would hurt."""
    even, odd = waves[:, ::2], waves[:, 1::2]
    out = np.float32(3 / 8) * (even + odd)
    out[:, 1:] += np.float32(1 / 8) * odd[:, :-1]
    out[:, :-1] += np.float32(1 / 8) * even[:, 1:]
    return out


def _best_peak(strength: NDArray[np.float32], loud: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Choose the strongest inner peak of each row and give its frequency, 0 where there is none."""
    score = strength[:, 1:-1] + _BONUS[1:-1]
    score[(strength[:, 1:-1] < strength[:, :-2]) | (strength[:, 1:-1] < strength[:, 2:])] = -1
    best = score.argmax(axis=1) + 1
    rows = np.arange(len(strength))
    left, top, right = strength[rows, best - 1], strength[rows, best], strength[rows, best + 1]
    curvature = np.minimum(left - 2 * top + right, -np.finfo(np.float32).eps)
    lag = _LAGS[0] + best + 0.5 * (left - right) / curvature
    voiced = loud & (top > VOICING_THRESHOLD) & (score[rows, best - 1] > 0)
    return np.where(voiced, _LAG_RATE / lag, 0).astype(np.float32)
