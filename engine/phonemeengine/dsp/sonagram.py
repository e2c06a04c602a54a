"""A sonagram for eyes: the power of a sound over time and frequency, in decibels below full scale.

It is no part of what is recognised, and knows none of the filters: Hann windows as long as one likes, nothing
normalised, and rows on a linear, a mel or a logarithmic axis. Columns are as wide as the picture needs; one that is
wider than a hop is the mean power of all its windows, so that nothing is left out where hours are seen.
"""

import math
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.mel import frequency_of, mel_of
from phonemeengine.errors import SettingsError, check_range
from phonemeengine.settings import SAMPLE_RATE

WIDE_BAND, NARROW_BAND = 0.006, 0.03
"""Seconds of a window in which the pulses of a voice are seen one by one, and of one that parts its harmonics."""
FLOOR = -120.0
"""Decibels of what is quieter than 24 bits can say."""
LEVELS = (-90.0, -20.0)
"""Decibels that are drawn darkest and brightest, of a file and of a microphone, unless others are chosen."""
ENOUGH_WINDOWS = 6
"""Of a column, a quarter of a window apart; of a longer one they are half a window apart: no click is lost."""
MOST_SAMPLES = 1 << 18
"""Of the windows that are transformed at once."""


class FrequencyAxis(StrEnum):
    """How frequencies are spread over the rows."""

    LINEAR = "linear"
    MEL = "mel"
    LOGARITHMIC = "logarithmic"


@dataclass(frozen=True)
class SonagramSettings:
    """How a sonagram is measured and laid out.

    Parameters
    ----------
    window : seconds of the Hann window, 0.002..0.2.
    axis : how frequencies are spread over the rows.
    low, high : Hz of the lowest and the highest row; a logarithmic axis begins at 20 Hz at least.
    n_rows : of the picture.

    Raises
    ------
    SettingsError : a value lies outside its range.
    """

    window: float = 0.02
    axis: FrequencyAxis = FrequencyAxis.LINEAR
    low: float = 0.0
    high: float = 8000.0
    n_rows: int = 256

    def __post_init__(self) -> None:
        check_range("the window", self.window, (0.002, 0.2, "s"))
        if not 0 <= self.low < self.high <= SAMPLE_RATE / 2:
            raise SettingsError(
                f"a sonagram must rise within 0..{SAMPLE_RATE / 2:g} Hz, got {self.low:g} to {self.high:g}; "
                "choose other limits"
            )
        check_range("the number of rows", self.n_rows, (2, 4096, ""))

    @property
    def n_samples(self) -> int:
        """Samples of a window."""
        return round(self.window * SAMPLE_RATE)

    @property
    def hop(self) -> int:
        """Samples from one window to the next, a quarter of a window."""
        return max(1, self.n_samples // 4)

    @property
    def frequencies(self) -> Float64Array:
        """Hz of the rows, rising, shape (n_rows,)."""
        return row_frequencies(self.axis, self.n_rows, self.low, self.high)


def row_frequencies(axis: FrequencyAxis, n_rows: int, low: float, high: float) -> Float64Array:
    """Return the frequencies of rows that are equally far apart on an axis, Hz, shape (n_rows,)."""
    if axis is FrequencyAxis.MEL:
        return frequency_of(np.linspace(float(mel_of(low)), float(mel_of(high)), n_rows))
    if axis is FrequencyAxis.LOGARITHMIC:
        return np.asarray(np.geomspace(max(low, 20.0), high, n_rows))
    return np.asarray(np.linspace(low, high, n_rows))


def sonagram_of(
    samples: Float32Array, settings: SonagramSettings, first: float, n_columns: int, period: float
) -> Float32Array:
    """Return the levels of a section of sound, dB below full scale, float32, shape (n_columns, n_rows).

    Full scale is a sine of amplitude 1. Beyond the sound there is silence, `FLOOR`.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz.
    settings : how it is measured.
    first : the sample at which the first column begins; may lie before the sound.
    n_columns : how many.
    period : samples from one column to the next; a column is the mean of the windows in it.
    """
    n, hop = settings.n_samples, settings.hop
    # Windows a quarter of themselves apart add up to an even weight (Hann); over wide columns half is enough for
    # every sample to count, at half the price.
    per_column = max(1, round(period / hop))
    if per_column > ENOUGH_WINDOWS:
        per_column = max(ENOUGH_WINDOWS, math.ceil(period / (n // 2)))
    offsets = (np.arange(per_column) + 0.5) / per_column * period
    middles = first + np.arange(n_columns)[:, np.newaxis] * period + offsets
    starts = np.round(middles.ravel() - n / 2).astype(np.int64)
    power = np.zeros((n_columns, settings.n_rows), np.float32)
    weights = _row_weights(settings)
    at_once = max(1, MOST_SAMPLES // (n * per_column))
    for k in range(0, n_columns, at_once):
        windows = _windows_at(samples, starts[k * per_column : (k + at_once) * per_column], n)
        # Powers are averaged, not decibels: a click in one of many windows keeps its energy, and the mean is that of
        # the sound (P. Welch, 1967).
        bins = _power_of(windows).reshape(-1, per_column, len(weights)).mean(axis=1)
        power[k : k + at_once] = bins @ weights
    return np.asarray(np.maximum(10 * np.log10(np.maximum(power, 1e-30)), FLOOR), np.float32)


def _windows_at(samples: Float32Array, starts: np.ndarray[tuple[int], np.dtype[np.int64]], n: int) -> Float32Array:
    """Return sections of n samples, with silence beyond the sound, shape (n_windows, n)."""
    if not len(samples):
        return np.zeros((len(starts), n), np.float32)
    if starts[0] >= 0 and starts[-1] + n <= len(samples):
        return np.lib.stride_tricks.sliding_window_view(samples, n)[starts]
    places = starts[:, np.newaxis] + np.arange(n)
    inside = (places >= 0) & (places < len(samples))
    return np.asarray(np.where(inside, samples[np.clip(places, 0, len(samples) - 1)], 0), np.float32)


def _power_of(windows: Float32Array) -> Float32Array:
    """Return the power of each bin; that of a sine of amplitude 1 is 1 at its peak."""
    from scipy.fft import rfft  # noqa: PLC0415 - half a second that a window should not wait for

    weights = np.hanning(windows.shape[1] + 1)[:-1].astype(np.float32)
    bins = rfft(windows * weights, axis=1)
    return np.asarray((bins.real**2 + bins.imag**2) * (2 / weights.sum()) ** 2, np.float32)


@lru_cache(maxsize=8)
def _row_weights(settings: SonagramSettings) -> Float32Array:
    """Return what each bin gives to each row, shape (n_bins, n_rows).

    A row that is wider than a bin is the mean of those within it, a narrower one lies on the straight line between
    the two bins beside it.
    """
    n_bins, width = settings.n_samples // 2 + 1, SAMPLE_RATE / settings.n_samples
    centres = settings.frequencies
    edges = np.concatenate(([centres[0]], (centres[1:] + centres[:-1]) / 2, [centres[-1]]))
    bins = np.arange(n_bins) * width
    weights = np.zeros((n_bins, len(centres)), np.float32)
    for k, centre in enumerate(centres):
        within = np.flatnonzero((bins >= edges[k]) & (bins < edges[k + 1]))
        if len(within) > 1:
            weights[within, k] = 1 / len(within)
            continue
        below = min(int(centre / width), n_bins - 2)
        share = centre / width - below
        weights[below, k], weights[below + 1, k] = 1 - share, share
    return weights
