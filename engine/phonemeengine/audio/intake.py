"""Samples as other programs have them, of any rate, as float32, mono, at 44.1 kHz."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.resampling import Resampler
from phonemeengine.errors import AudioError
from phonemeengine.settings import SAMPLE_RATE

LOWEST_RATE, HIGHEST_RATE = 1_000, 768_000
"""Sample rates that are accepted, Hz."""
MOST_CHANNELS = 64
"""Channels that a block may have."""
LOUDEST = 100.0
"""Full scale is 1; what is so far above it is no sound, but integers that were not scaled."""
_SCALES = {"int16": 1 << 15, "int32": 1 << 31, "float32": 1, "float64": 1}


class SampleIntake:
    """Takes blocks of samples, and gives them as the engine wants them; what it gives does not depend on the cutting.

    Parameters
    ----------
    rate : of what is pushed, Hz, 1000..768000.
    steady : see `Resampler`; for what is heard now.

    Raises
    ------
    AudioError : the rate lies outside its range.

    Attributes
    ----------
    n_replaced : samples that were NaN or infinite, and were taken for 0.
    """

    def __init__(self, rate: int, *, steady: bool = False) -> None:
        if not LOWEST_RATE <= rate <= HIGHEST_RATE:
            raise AudioError(f"the sample rate must lie in {LOWEST_RATE}..{HIGHEST_RATE} Hz, got {rate}")
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
        """Return what was held back, float32, shape (n,), since the sound has ended."""
        if self._resampler is None:
            return np.zeros(0, np.float32)
        n_missing = max(0, round(self._n_in * SAMPLE_RATE / self.rate) - self._n_out)
        rest = self._resampler.resample(np.zeros((0, 1), np.float32), last=True)[:n_missing, 0]
        return np.pad(rest, (0, n_missing - len(rest)))

    def _mono(self, samples: Any) -> Float32Array:
        scale = _SCALES.get(str(samples.dtype)) if samples.size else 1
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
