"""Frames become amplitude spectra.

`scipy.fft` is imported at the first use, since it costs half a second that a window should not wait for.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.filters import pre_emphasis
from phonemeengine.settings import AnalysisSettings, Decimation, Filter, WindowFunction

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
