"""The log-mel spectrogram that Whisper's encoder takes (A. Radford et al., arXiv:2212.04356, section 2.2)."""

from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array

ENCODER_RATE = 16_000
"""Samples a second."""
N_MELS = 80
N_FFT, MEL_HOP = 400, 160
"""Samples of a frame, and from one to the next: 25 and 10 ms."""
DYNAMIC_RANGE = 8.0
"""What lies farther below the loudest band counts as that far, base-10 logarithm of powers."""
LINEAR_UP_TO, MELS_UP_TO, FACTOR, STEPS = 1000.0, 15.0, 6.4, 27
"""M. Slaney's scale (Auditory Toolbox, 1998): linear up to 1 kHz, which is 15 mel; then 27 mel a factor of 6.4."""


def log_mel_spectrogram(samples: Float32Array) -> Float32Array:
    """Return what the encoder takes, float32, shape (80, n // 160).

    Parameters
    ----------
    samples : of a sound at 16 kHz, ±1, shape (n,), at least 400.
    """
    from scipy.fft import rfft  # noqa: PLC0415 - it costs half a second at the start

    padded = np.pad(samples, N_FFT // 2, mode="reflect")
    frames = np.lib.stride_tricks.sliding_window_view(padded, N_FFT)[::MEL_HOP][:-1]
    powers = np.abs(rfft(frames * np.hanning(N_FFT + 1)[:-1])) ** 2
    logarithms = np.log10(np.maximum(slaney_bank() @ powers.T, 1e-10))
    return np.asarray((np.maximum(logarithms, logarithms.max() - DYNAMIC_RANGE) + 4) / 4, np.float32)


@lru_cache(maxsize=1)
def slaney_bank() -> Float64Array:
    """Return the weights of the triangular filters, each of the area 1, shape (80, 201)."""
    mels = np.linspace(0, MELS_UP_TO + STEPS * np.log(ENCODER_RATE / 2 / LINEAR_UP_TO) / np.log(FACTOR), N_MELS + 2)
    linear = mels * LINEAR_UP_TO / MELS_UP_TO
    corners = np.where(mels < MELS_UP_TO, linear, LINEAR_UP_TO * FACTOR ** ((mels - MELS_UP_TO) / STEPS))
    frequencies = np.linspace(0, ENCODER_RATE / 2, N_FFT // 2 + 1)
    low, peak, high = (corners[k : k + N_MELS, np.newaxis] for k in range(3))
    triangles = np.minimum((frequencies - low) / (peak - low), (high - frequencies) / (high - peak))
    return np.asarray(np.maximum(0, triangles) * 2 / (high - low))
