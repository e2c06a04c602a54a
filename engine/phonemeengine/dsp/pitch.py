"""Fundamental frequency by autocorrelation.

The method is that of P. Boersma, "Accurate short-term analysis of the fundamental frequency and the
harmonics-to-noise ratio of a sampled sound", IFA Proceedings 17 (1993): the autocorrelation of the windowed
frame is divided by that of the window, and its highest peak, with a small bonus for short lags, is the period.
It is the method behind Praat's pitch, here without the path search, since a live frame knows no future, and on
the sound below 1.5 kHz only, at an eighth of the rate.

A tone above the range of voices repeats after every multiple of its period too, and so seems to be a voice an octave
or more below itself. Periods shorter than a voice's are therefore searched as well: where one of them is the best,
there is no voice.
"""

import math
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.settings import HOP, SAMPLE_RATE

LOWEST = 60.0
HIGHEST = 500.0
VOICING_THRESHOLD = 0.55
SILENCE_LEVEL = 0.001
OCTAVE_BONUS = 0.04
TOLERANCE = 0.003
"""Share by which a period may lie outside of the range: it is measured no better than that."""
PASSED, STOPPED = 1500.0, 2000.0
"""Between these frequencies (Hz) the sound fades out; what decimating folds down lies above them."""

# Decimation leaves 5512.5 Hz, enough for three harmonics of the highest voice. The window of 46 ms holds 2.8 periods
# of 60 Hz; Boersma asks for three of the lowest voice. Padded, so that the circular autocorrelation by the Fourier
# transform equals the linear one up to the longest lag, 93 samples.
_STEP = 8
_FINE = 2
_LENGTH = 254  # samples of a frame at an eighth of the rate
_PADDED = 384  # those and the longest lag, so that nothing wraps around
_KEPT = math.ceil(STOPPED / (SAMPLE_RATE / _STEP / _PADDED))  # bins that do not fade out entirely
_LAG_RATE = SAMPLE_RATE / _STEP * _FINE
_LAGS = np.arange(int(_LAG_RATE / STOPPED) - 1, int(_LAG_RATE / LOWEST) + 3)  # down to the lowest pitch


@lru_cache(maxsize=1)
def _window() -> Float32Array:
    return np.hanning(_LENGTH + 2)[1:-1].astype(np.float32)


@lru_cache(maxsize=1)
def _inverse_transform() -> Float32Array:
    """Return the cosines that turn power into the autocorrelation at lag 0 and at `_LAGS`, as a matrix.

    Lags finer than a sample interpolate exactly, since the power is band-limited. All but lag 0 are already
    divided by the autocorrelation of the window; power above `PASSED` fades out.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - half a second that a window should not wait for

    # Wiener and Khinchin: r(τ) is the cosine transform of the power. All bins but the first and the last stand for
    # two, as real sounds have a spectrum that is mirrored.
    bins = np.arange(_PADDED // 2 + 1)
    weights = np.where((bins == 0) | (bins == _PADDED // 2), 1, 2)[:, None]
    lags = np.concatenate(([0], _LAGS)) / (_PADDED * _FINE)
    cosines = weights * np.cos(2 * np.pi * np.outer(bins, lags))
    # Boersma's normalisation, r_x(τ) = r_a(τ) / r_w(τ): a window takes from long lags more than from short ones, and
    # undivided the peak of a perfect period would sink with its length, so that high voices win. The window's own
    # autocorrelation, 1 at lag 0, is the right measure of that loss.
    of_window = np.abs(rfft(_window().astype(float), _PADDED)) ** 2 @ cosines
    frequencies = bins[:, None] * (SAMPLE_RATE / _STEP / _PADDED)
    kept = np.clip((STOPPED - frequencies) / (STOPPED - PASSED), 0, 1)
    return np.asarray((kept * cosines / (of_window / of_window[0]))[:_KEPT], np.float32)


# Boersma's octave cost: all multiples of a period are equally high peaks in a steady voice; a little more for each
# octave up lets the shortest of them win.
_BONUS = (OCTAVE_BONUS * np.log2(_LAGS[-1] / _LAGS[1:-1])).astype(np.float32)


def fundamental_of(frames: Float32Array, silence: float = SILENCE_LEVEL) -> Float32Array:
    """Measure the fundamental frequency of consecutive raw frames.

    Parameters
    ----------
    frames : float32, shape (n_frames, 2048), full scale ±1, at 44.1 kHz.
    silence : amplitude, 0..1, below which a frame is nearly silent.

    Returns
    -------
    float32, shape (n_frames,): 60..500 Hz, or 0 where the frame is unvoiced, nearly silent, or a tone beyond that.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - half a second that a window should not wait for

    decimated = _decimated(frames)
    mean: Float32Array = np.add.reduce(decimated, axis=1, keepdims=True)
    mean /= np.float32(_LENGTH)
    slow = decimated - mean
    loud = np.maximum.reduce(slow, axis=1) > silence
    bins = rfft(slow * _window(), _PADDED)[:, :_KEPT]
    # One matrix for the few lags and bins that matter is cheaper than an inverse transform of all.
    correlation = (bins.real**2 + bins.imag**2) @ _inverse_transform()
    zero_lag = np.maximum(correlation[:, :1], np.finfo(np.float32).tiny)
    return _best_peak(correlation[:, 1:] / zero_lag, loud)


def _decimated(frames: Float32Array) -> Float32Array:
    """Return the sound of consecutive frames at an eighth of the rate, shape (n_frames, 254).

    Three times the rate is halved behind the low-pass 1 3 3 1, whose threefold zero lies where the folds would hurt.
    Filtering goes before framing, since most of a frame lies in its neighbours too.
    """
    sound = np.concatenate((frames[:-1, :HOP].ravel(), frames[-1]))
    # (1 + 1/z)³ is 1 3 3 1: three additions and no multiplication. The zeros of the three stages lie at 22.05 kHz,
    # 11.025 kHz and 5.5125 kHz and its odd multiple: on all that decimating by 8 folds onto 0 Hz.
    for lag in (1, 2, 4):
        for _ in range(3):
            sound = sound[lag:] + sound[:-lag]
    sound *= np.float32(1 / 8**3)
    strides = (HOP * sound.itemsize, _STEP * sound.itemsize)
    return np.ndarray((len(frames), _LENGTH), np.float32, sound, 0, strides)


def _best_peak(strength: Float32Array, loud: BoolArray) -> Float32Array:
    """Choose the strongest inner peak of each row and give its frequency, 0 where there is none.

    A peak is as high as the parabola through it and its neighbours, so that none gains by lying on a whole lag. What
    stands above 1 is mirrored at 1, as Praat does: nothing resembles itself by more than wholly.
    """
    left, top, right = strength[:, :-2], strength[:, 1:-1], strength[:, 2:]
    # The parabola through (-1, left), (0, top), (1, right) peaks at tilt / (4 top - 2 left - 2 right). The clamp
    # keeps places that are no peaks finite; they lose their score two lines below.
    tilt = right - left
    shift = tilt / np.maximum(4 * top - 2 * (left + right), np.finfo(np.float32).eps)
    height = top + tilt * shift / 4
    # dividing by the window's autocorrelation can lift a peak a little above 1, which no correlation exceeds
    height = np.minimum(height, 1 / np.maximum(height, 1))
    score = np.where((top >= left) & (top >= right), height + _BONUS, np.float32(-1))
    best = score.argmax(axis=1)
    chosen = (np.arange(len(strength)), best)
    frequency = _LAG_RATE / np.maximum(_LAGS[1] + best + shift[chosen], _LAGS[0])
    in_range = (frequency > LOWEST * (1 - TOLERANCE)) & (frequency < HIGHEST * (1 + TOLERANCE))
    voiced = loud & in_range & (height[chosen] > VOICING_THRESHOLD) & (score[chosen] > 0)
    return np.where(voiced, np.minimum(np.maximum(frequency, LOWEST), HIGHEST), 0).astype(np.float32)
