"""Sound of any rate as sound at 44.1 kHz: the only door to soxr."""

import functools
from typing import Any

import numpy as np
import soxr

from phonemeengine.arrays import Float32Array
from phonemeengine.settings import SAMPLE_RATE


class Resampler:
    """Brings a stream to 44.1 kHz, block by block; the result does not depend on the cutting.

    Its error lies 120 dB below the sound. Two engines do it. The usual one puts every sample exactly where it
    belongs, but works in bursts: what it holds back swings between 2 and 19 ms at 48 kHz, and between 8 and 58 ms
    at 16 kHz. The steady one holds back the same at any time (5 ms at 48 kHz, 15 ms at 16 kHz) and costs twice as
    much, still a thousandth of real time: it is the one for what is heard now.

    Parameters
    ----------
    from_rate : rate of what is pushed, Hz.
    n_channels : channels of it.
    steady : whether to hold back the same at any time.
    """

    def __init__(self, from_rate: int, n_channels: int, *, steady: bool = False) -> None:
        self.from_rate = from_rate
        self.n_channels = n_channels
        self._stream = _stream(from_rate, n_channels, steady)
        self._shift = _shift(from_rate) if steady else 0.0
        self._n_in = self._n_out = 0

    @property
    def delay(self) -> float:
        """Time from the newest sample that came out to the newest that went in, seconds of sound, now."""
        return max(0.0, self._n_in / self.from_rate - (self._n_out - self._shift) / SAMPLE_RATE)

    def resample(self, block: Float32Array, last: bool = False) -> Float32Array:
        """Take a block, shape (n, n_channels), and give what has become ready; after the last block all of it.

        Returns
        -------
        float32, shape (m, n_channels).
        """
        out: Float32Array = self._stream.resample_chunk(np.asarray(block, np.float32), last=last)
        self._n_in += len(block)
        self._n_out += len(out)
        return out


def _stream(from_rate: int, n_channels: int, steady: bool) -> Any:
    return soxr.ResampleStream(from_rate, SAMPLE_RATE, n_channels, dtype="float32", quality="HQ", vr=steady)


@functools.cache
def _shift(from_rate: int) -> float:
    """Measure how many samples later than it should the steady engine puts a click: a slow tone's phase tells."""
    frequency = from_rate / 80
    n_in = from_rate // 4
    sound = np.sin(2 * np.pi * frequency / from_rate * np.arange(n_in)).astype(np.float32)
    out = _stream(from_rate, 1, steady=True).resample_chunk(sound[:, np.newaxis])[:, 0]
    middle = np.arange(len(out) // 4, len(out) * 3 // 4)
    turns = 2 * np.pi * frequency / SAMPLE_RATE * middle
    (sine, cosine), *_ = np.linalg.lstsq(np.stack([np.sin(turns), np.cos(turns)], axis=1), out[middle])
    return float(-np.arctan2(cosine, sine) / (2 * np.pi * frequency) * SAMPLE_RATE)


def change_speed(samples: Float32Array, factor: float) -> Float32Array:
    """Return a sound, shape (n,), that is so many times faster and higher at the same sample rate."""
    return np.asarray(soxr.resample(samples, SAMPLE_RATE * factor, SAMPLE_RATE, quality="MQ"), np.float32)


def resample_whole(samples: Float32Array, from_rate: int, to_rate: int) -> Float32Array:
    """Return a whole sound, shape (n,), at another sample rate."""
    return np.asarray(soxr.resample(samples, from_rate, to_rate, quality="HQ"), np.float32)
