"""Frames become amplitude spectra.

`scipy.fft` is imported at the first use, since it costs half a second that a window should not wait for.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from engine.dsp.filters import pre_emphasis
from engine.dsp.windows import window_of
from engine.settings import AnalysisSettings, Decimation, Filter, WindowFunction

Block = NDArray[np.float32]


def decimate(frames: Block, step: int, kind: Decimation) -> Block:
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
    float32, shape (n_frames, n_samples / step).
    """
    if step == 1:
        return frames
    if kind is Decimation.PLAIN:
        return np.ascontiguousarray(frames[:, ::step])
    from scipy.fft import irfft, rfft  # noqa: PLC0415 - see the module's docstring

    n = frames.shape[1] // step
    bins = rfft(frames, axis=1)[:, : n // 2 + 1]
    bins[:, -1] = 0
    return np.asarray(irfft(bins, n, axis=1), np.float32) / np.float32(step)


def waveforms_of(frames: Block, settings: AnalysisSettings) -> Block:
    """Apply the filters of the time domain: quantise, pre-emphasis, window function.

    Returns float32, shape (n_frames, 2048 / settings.step).
    """
    waves = decimate(frames, settings.step, settings.decimation)
    if settings.has(Filter.PRE_EMPHASIS):
        waves = pre_emphasis(waves, settings.pre_emphasis)
    if settings.window_in_force is not WindowFunction.RECTANGLE:
        waves = waves * window_of(settings.window_function, waves.shape[1])
    return waves


@lru_cache(maxsize=32)
def _scale_of(function: WindowFunction, n: int) -> NDArray[np.float32]:
    scale = np.full(n // 2, 2 / window_of(function, n).sum(), np.float32)
    scale[0] /= 2
    return scale


def amplitudes_of(waves: Block, function: WindowFunction = WindowFunction.RECTANGLE) -> Block:
    """Transform waveforms to amplitude spectra.

    Parameters
    ----------
    waves : float32, shape (n_frames, n_samples), already weighted by the window function.
    function : that window function, whose gain is divided out.

    Returns
    -------
    float32, shape (n_frames, n_samples / 2): amplitudes, scaled so that a full-scale sine on a bin, or a
    full-scale constant on bin 0, reads 1.0.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - see the module's docstring

    n = waves.shape[1]
    spectra: Block = np.abs(rfft(waves, axis=1)[:, : n // 2])
    spectra *= _scale_of(function, n)
    return spectra
