"""Frames become amplitude spectra, and the filters: on waveforms (pre-emphasis) and on spectra (all others).

Every filter takes and gives float32 blocks of shape (n_frames, n_bins) and leaves its input as it is; denoise and
normalise take a single spectrum of shape (n_bins,) as well.

`scipy.fft` is imported at the first use, since it costs half a second that a window should not wait for.
"""

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import SettingsError
from phonemeengine.settings import AnalysisSettings, Decimation, Filter, WindowFunction

# Close above the smallest normal float32 (1.2e-38): a silent spectrum divided by it stays 0, without a branch, a
# division by zero or slow subnormal numbers.
TINY: Float32Array = np.array(1e-37, np.float32)


def pre_emphasis(waves: Float32Array, a: float) -> Float32Array:
    """Raise high frequencies: ``x[n] - a x[n-1]``, with x[-1] = x[0] so that a constant gives no edge."""
    # The gain is 1 - a at 0 Hz and 1 + a at half the rate: it counters the fall of voiced speech of about 6 dB an
    # octave.
    out = waves.copy()
    out[:, 1:] -= np.float32(a) * waves[:, :-1]
    out[:, 0] -= np.float32(a) * waves[:, 0]
    return out


class FrequencyShaper:
    """Scales, blurs over frequency and applies the ramps of the pass filters, in one go.

    All are linear in the spectrum, so together they are one weight for a bin and one for each neighbour.
    At blur strength 0 nothing is blurred, at 1 every bin is the mean of three; the border repeats, so a flat
    spectrum stays flat.

    Parameters
    ----------
    strength : of the blur, 0..1.
    gains : of the ramps, shape (n_bins,).
    scale : what each bin is multiplied with before all else, shape (n_bins,); nothing where it is not given.

    Attributes
    ----------
    centre : weight of each bin, float32, shape (1, n_bins).
    below, above : of its neighbours, float32, shape (n_bins - 1,): of bin k for bin k + 1, and of k + 1 for k.
    blurs : whether those count.
    """

    def __init__(self, strength: float, gains: Float32Array, scale: Float32Array | None = None) -> None:
        scale = np.ones_like(gains) if scale is None else scale
        # The kernel is (s/3, 1 - 2s/3, s/3). Scales belong to the bin that is read, gains to the bin that is written,
        # as if the three steps followed each other.
        side = strength / 3
        centre = np.full(len(gains), 1 - 2 * side)
        centre[[0, -1]] += side
        self.centre = (centre * gains * scale).astype(np.float32)[np.newaxis]
        self.below = (side * gains[1:] * scale[:-1]).astype(np.float32)
        self.above = (side * gains[:-1] * scale[1:]).astype(np.float32)
        self.blurs = strength > 0

    def shape(self, spectra: Float32Array, out: Float32Array | None = None) -> Float32Array:
        """Return the shaped spectra, written to `out` where it is given; the input stays as it is."""
        shaped: Float32Array = np.multiply(spectra, self.centre, out=out)
        if self.blurs:
            shaped[:, 1:] += self.below * spectra[:, :-1]
            shaped[:, :-1] += self.above * spectra[:, 1:]
        return shaped


class TimeSmoother:
    """Blurs each spectrum with the blurred one before it: ``y[k] = strength y[k-1] + (1 - strength) x[k]``.

    The sound begins after silence, so the first y is ``(1 - strength) x``. A block is smoothed by doubling: every
    pass adds what lies 1, 2, 4, 8... frames back, until float32 cannot hold its weight: normalising shows even the
    faintest rest of a sound, so nothing may be left out earlier.
    """

    def __init__(self, strength: float) -> None:
        self._last: Float32Array | None = None
        self._strength = strength

    def smooth(self, spectra: Float32Array) -> Float32Array:
        """Smooth the next spectra; at strength 0 they are given back as they are."""
        if self._strength == 0:
            self._last = spectra[-1]
            return spectra
        # The recursive filter 1 / (1 - s/z) is the product of (1 + s/z), (1 + s²/z²), (1 + s⁴/z⁴) and so on, so a
        # block of n frames takes log2(n) passes over whole arrays instead of n steps in Python.
        out = spectra * np.float32(1 - self._strength)
        if self._last is not None and len(self._last) == spectra.shape[1]:
            # what the last block left behind enters as if it were part of the first frame; the passes carry it on
            out[0] += np.float32(self._strength) * self._last
        reach, weight = 1, self._strength
        while reach < len(out) and np.float32(weight) > 0:
            # the product is a new array, so the overlapping parts are read before they are written
            out[reach:] += np.float32(weight) * out[:-reach]
            reach, weight = 2 * reach, weight * weight
        self._last = out[-1]
        return out

    def resume(self, other: "TimeSmoother") -> None:
        """Go on from where another one stopped."""
        self._last = other._last


def _ramp(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    frequencies = np.arange(n_bins) * bin_width
    if end <= start:
        return np.asarray(frequencies >= start, np.float32)
    return np.asarray(np.clip((frequencies - start) / (end - start), 0, 1), np.float32)


def high_pass_gains(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    """Return a gain per bin, shape (n_bins,), that rises from 0 at `start` to 1 at `end` (Hz)."""
    return _ramp(n_bins, bin_width, start, end)


def low_pass_gains(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    """Return a gain per bin, shape (n_bins,), that falls from 1 at `start` to 0 at `end` (Hz)."""
    return 1 - _ramp(n_bins, bin_width, start, end)


def denoise(spectra: Float32Array, threshold: float | Float32Array) -> Float32Array:
    """Set amplitudes below `threshold` (0..1) to 0."""
    kept: Float32Array = spectra * (spectra >= threshold)
    return kept


def normalise(spectra: Float32Array, maximum: float = 1.0, *, peaks: Float32Array | None = None) -> Float32Array:
    """Scale each spectrum so that its largest amplitude becomes `maximum`; a silent one stays 0.

    Parameters
    ----------
    spectra : shape (n_frames, n_bins), or (n_bins,).
    maximum : above 0.
    peaks : the largest amplitudes, shape (n_frames, 1), where they are known already.

    Raises
    ------
    SettingsError : the maximum is no number above 0.
    """
    if not 0 < maximum < math.inf:
        raise SettingsError(f"the maximum of a normalised spectrum must be above 0, got {maximum:g}; choose another")
    if peaks is None:
        peaks = np.maximum.reduce(spectra, axis=-1, keepdims=True)
    divisors: Float32Array = np.maximum(peaks / np.float32(maximum), TINY)
    return spectra / divisors


# Window functions, symmetric, float32.

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


def decimate(frames: Float32Array, step: int, kind: Decimation) -> Float32Array:
    """Keep every `step`-th sample of each frame.

    Parameters
    ----------
    frames : float32, shape (n_frames, n_samples).
    step : 1, 2 or 4.
    kind : ``plain`` keeps the samples as they are, so frequencies above the new half rate fold down;
        ``anti_aliased`` first removes them: the frame is rebuilt from the lowest bins of its own Fourier
        transform, so every bin that is left reads the same as without decimation.

    Returns
    -------
    float32, shape (n_frames, n_samples / step); a view where the samples stay as they are.
    """
    if step == 1:
        return frames
    if kind is Decimation.PLAIN:
        return frames[:, ::step]
    from scipy.fft import irfft, rfft  # noqa: PLC0415 - see the module's docstring

    n = frames.shape[1] // step
    bins = rfft(frames, axis=1)[:, : n // 2 + 1]
    bins[:, -1] = 0
    return np.asarray(irfft(bins, n, axis=1), np.float32) / np.float32(step)


class SpectrumAnalyser:
    """Turns raw frames into waveforms, and those into amplitude spectra.

    Parameters
    ----------
    settings : the filters of the time domain: quantise, pre-emphasis, window function.

    Attributes
    ----------
    scale : float32, shape (1, n_bins): what turns a bin's magnitude into an amplitude, so that a full-scale sine on
        a bin, or a full-scale constant on bin 0, reads 1.0.
    """

    def __init__(self, settings: AnalysisSettings) -> None:
        self._step, self._decimation = settings.step, settings.decimation
        self._emphasis = settings.pre_emphasis if settings.has(Filter.PRE_EMPHASIS) else 0.0
        self._windows = settings.window_in_force is not WindowFunction.RECTANGLE
        self._window = window_of(settings.window_in_force, settings.n_samples)
        self._n_bins = settings.n_bins
        # A sine of amplitude A gives a bin of A times half the sum of the window, since its other half lies at the
        # negative frequency; bin 0 has no such half.
        self.scale = np.full((1, self._n_bins), 2 / self._window.sum(), np.float32)
        self.scale[0, 0] /= 2

    def waveforms_of(self, frames: Float32Array) -> Float32Array:
        """Apply the filters of the time domain; returns float32, shape (n_frames, 2048 / step)."""
        waves = decimate(frames, self._step, self._decimation)
        if self._emphasis:
            waves = pre_emphasis(waves, self._emphasis)
        return waves * self._window if self._windows else waves

    def magnitudes_of(self, waves: Float32Array) -> Float32Array:
        """Transform waveforms, already weighted by the window function; times `scale` they are amplitudes.

        Returns
        -------
        float32, shape (n_frames, n_bins).
        """
        magnitudes: Float32Array = np.abs(rfft()(waves)[:, : self._n_bins])
        return magnitudes


@lru_cache(maxsize=1)
def rfft() -> Callable[..., NDArray[np.complex64]]:
    """Return `scipy.fft.rfft`, which is imported at the first call."""
    from scipy.fft import rfft  # noqa: PLC0415 - see the module's docstring

    function: Callable[..., NDArray[np.complex64]] = rfft
    return function
