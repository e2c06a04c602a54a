"""Sound of any rate as sound at 44.1 kHz: the only module that imports soxr."""

import functools
from typing import Any

import numpy as np
import soxr
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import AudioError, check_range
from phonemeengine.settings import SAMPLE_RATE


class Resampler:
    """Brings a stream to 44.1 kHz, block by block; the result does not depend on the cutting.

    Its error lies 120 dB below the sound. Two engines do it. The usual one puts every sample exactly where it
    belongs, but works in bursts: what it holds back swings between 2 and 19 ms at 48 kHz, and between 8 and 58 ms
    at 16 kHz. The steady one holds back the same at any time (5 ms at 48 kHz, 15 ms at 16 kHz) and costs twice as
    much, still a thousandth of real time: it is the one for live sound.

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
    """Return a sound, shape (n,), this many times faster and higher at the same sample rate."""
    return np.asarray(soxr.resample(samples, SAMPLE_RATE * factor, SAMPLE_RATE, quality="MQ"), np.float32)


def resample_whole(samples: Float32Array, from_rate: int, to_rate: int) -> Float32Array:
    """Return a whole sound, shape (n,), at another sample rate."""
    return np.asarray(soxr.resample(samples, from_rate, to_rate, quality="HQ"), np.float32)


# Samples as other programs have them, of any rate, as float32, mono, at 44.1 kHz.

LOWEST_RATE, HIGHEST_RATE = 1_000, 768_000
"""Sample rates that are accepted, Hz."""
MOST_CHANNELS = 64
"""Channels that a block may have."""
LOUDEST = 100.0
"""Full scale is 1; what is so far above it is no sound, but integers that were not scaled."""
_SCALES = {np.dtype(np.int16): 1 << 15, np.dtype(np.int32): 1 << 31, np.dtype(np.float32): 1, np.dtype(float): 1}


class SampleIntake:
    """Takes blocks of samples, and gives them as the engine wants them; what it gives does not depend on the cutting.

    Parameters
    ----------
    rate : of what is pushed, Hz, 1000..768000.
    steady : see `Resampler`; for live sound.

    Raises
    ------
    AudioError : the rate lies outside its range.

    Attributes
    ----------
    n_replaced : samples that were NaN or infinite, and were taken for 0.
    """

    def __init__(self, rate: int, *, steady: bool = False) -> None:
        check_range("the sample rate", rate, (LOWEST_RATE, HIGHEST_RATE, "Hz"), AudioError)
        self.rate = rate
        self.n_replaced = 0
        self._n_in = self._n_out = 0
        self._resampler = Resampler(rate, 1, steady=steady) if rate != SAMPLE_RATE else None

    @property
    def delay(self) -> float:
        """How much the resampler holds back now, seconds."""
        return self._resampler.delay if self._resampler is not None else 0.0

    def take(self, samples: ArrayLike) -> Float32Array:
        """Take the next samples; return what is ready, float32, shape (n,), 44.1 kHz, ±1.

        Parameters
        ----------
        samples : shape (n,), or (n, n_channels), of which the mean is taken; float within ±1, int16 or int32.

        Raises
        ------
        AudioError : they are of another type or shape, or lie far beyond ±1.
        """
        mono = self._mono(np.asarray(samples))
        self._n_in += len(mono)
        if self._resampler is not None:
            mono = self._resampler.resample(mono[:, np.newaxis])[:, 0]
            self._n_out += len(mono)
        return mono

    def finish(self) -> Float32Array:
        """Return the samples that are still held, float32, shape (n,), since the sound has ended."""
        if self._resampler is None:
            return np.zeros(0, np.float32)
        n_missing = max(0, round(self._n_in * SAMPLE_RATE / self.rate) - self._n_out)
        rest = self._resampler.resample(np.zeros((0, 1), np.float32), last=True)[:n_missing, 0]
        return np.pad(rest, (0, n_missing - len(rest)))

    def _mono(self, samples: Any) -> Float32Array:
        scale = _SCALES.get(samples.dtype) if samples.size else 1
        if scale is None:
            raise AudioError(f"samples are float32 within ±1, int16 or int32, got {samples.dtype}; convert them")
        if samples.ndim not in {1, 2} or (samples.ndim == 2 and not 1 <= samples.shape[1] <= MOST_CHANNELS):
            raise AudioError(
                f"samples have the shape (n,), or (n, n_channels) with at most {MOST_CHANNELS} channels, got "
                f"{samples.shape}; turn them, or mix them to one channel"
            )
        block = np.asarray(samples, np.float32) if scale == 1 else (samples / scale).astype(np.float32)
        block = self._finite(block)
        return block if block.ndim == 1 else np.asarray(block.mean(axis=1), np.float32)

    def _finite(self, block: Float32Array) -> Float32Array:
        """Return a block without what is no number."""
        if bool((np.abs(block) <= LOUDEST).all()):  # NaN is not
            return block
        bad = ~np.isfinite(block)
        self.n_replaced += int(bad.sum())
        clean = np.where(bad, np.float32(0), block)
        loudest = float(np.abs(clean).max())
        if loudest > LOUDEST:
            raise AudioError(
                f"samples lie within ±1, found {loudest:g}; give integers as int16 or int32, or divide them by 32768"
            )
        return clean
