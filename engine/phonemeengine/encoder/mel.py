"""The mel bands that Whisper's encoder takes, straight from the windows of the analysis at 44.1 kHz."""

from functools import lru_cache

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.framing import LEAD
from phonemeengine.encoder.whisper import DYNAMIC_RANGE, N_FFT, slaney_bank

LENGTH = 1102
"""Samples of a frame, 25 ms at 44.1 kHz: bins are 40.02 Hz apart, 40 Hz in Whisper's frames of 400 at 16 kHz. Its
factors are small, which 1103, nearer to 25 ms, has none of: a Fourier transform of that takes four times as long."""
LEAST_POWER = 1e-10
LEAST_PEAK, PEAK_FALL = -2.0, 0.002
"""Of the running peak, base-10 logarithms of powers: its least, and by how much it falls each frame of 10 ms."""
SILENT = (LEAST_PEAK - DYNAMIC_RANGE + 4) / 4
"""What silence is, scaled for the encoder."""
_FRAME = slice(LEAD - LENGTH // 2, LEAD + LENGTH // 2)


def whisper_log_mels(windows: Float32Array, warp: float = 1.0) -> Float32Array:
    """Return base-10 logarithms of the powers in Whisper's 80 mel bands, before any floor, shape (n_frames, 80).

    Frame k is centred on the beginning of its 10 ms, as Whisper's are. No resampler is needed, and so no delay.

    Parameters
    ----------
    windows : of the analysis, shape (n_frames, 2048), full scale ±1.
    warp : what lies at a frequency f is looked for at f x warp, as if the vocal tract were shorter (above 1).
    """
    from scipy.fft import rfft  # noqa: PLC0415 - it costs half a second at the start

    bins = rfft(windows[:, _FRAME] * _window(), axis=1)[:, : N_FFT // 2 + 1]
    powers = bins.real * bins.real
    powers += bins.imag * bins.imag
    return np.asarray(np.log10(np.maximum(powers @ _bank(warp), np.float32(LEAST_POWER))), np.float32)


class RunningScale:
    """Scales the logarithms of a running sound for the encoder, which cuts off what is far below the loudest band.

    Whisper takes the loudest band of the whole sound; here it is that of what came, and falls by 2 dB a second.
    """

    def __init__(self) -> None:
        self._peak = LEAST_PEAK

    def scale(self, logarithms: Float32Array) -> Float32Array:
        """Return the next frames as the encoder takes them, shape (n_frames, 80)."""
        # frame by frame, so that the numbers are the same however the sound is cut
        floors = np.empty((len(logarithms), 1), np.float32)
        for k, loudest in enumerate(logarithms.max(axis=1, initial=LEAST_PEAK).tolist()):
            self._peak = max(loudest, self._peak - PEAK_FALL, LEAST_PEAK)
            floors[k] = self._peak - DYNAMIC_RANGE
        return (np.maximum(logarithms, floors) + np.float32(4)) / np.float32(4)


@lru_cache(maxsize=1)
def _window() -> Float32Array:
    # Hann, periodic, scaled so that a sine reads what it does in 400 samples: bins grow with the length of the frame.
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(LENGTH) / LENGTH)
    return np.asarray(window * N_FFT / LENGTH, np.float32)


@lru_cache(maxsize=64)
def _bank(warp: float) -> Float32Array:
    bank = slaney_bank()
    if warp != 1:
        # each filter looks at the bins at its frequencies times the warp, as `warped_mel_bank` does up to its knee
        places = np.arange(bank.shape[1])
        bank = np.stack([np.interp(places / warp, places, row, right=0.0) for row in bank]) / warp
    return np.ascontiguousarray(bank.T, np.float32)
