"""What a microphone hears while somebody wants its samples: the sound of a take."""

import threading

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import mono_of
from phonemeengine.audio.resampling import Resampler
from phonemeengine.settings import SAMPLE_RATE, Channel

LONGEST = 30.0
"""Seconds that are caught at most; what comes later is left out."""


class SampleCapture:
    """Keeps what comes between `begin` and `end`; blocks may come from another thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._blocks: list[Float32Array] = []
        self._mono: list[Float32Array] = []
        self._rate = 0
        self._n = 0
        self._open = False

    @property
    def open(self) -> bool:
        """Whether what comes is kept."""
        return self._open

    @property
    def seconds(self) -> float:
        """How much was caught."""
        return self._n / self._rate if self._rate else 0.0

    @property
    def full(self) -> bool:
        """Whether nothing more is kept."""
        return self.seconds >= LONGEST

    def add_samples(self, block: Float32Array, rate: int) -> None:
        """Take a block, shape (n, n_channels); one in another form than those before begins anew."""
        with self._lock:
            if not self._open or self.full:
                return
            if rate != self._rate or (self._blocks and self._blocks[0].shape[1] != block.shape[1]):
                self._forget()
                self._rate = rate
            self._blocks.append(block)
            self._mono.append(mono_of(block, Channel.MIX))
            self._n += len(block)

    def begin(self) -> None:
        """Keep what comes from now on."""
        with self._lock:
            self._forget()
            self._open = True

    def end(self) -> tuple[Float32Array, int]:
        """Keep no more; gives what was caught, shape (n, n_channels), and its rate in Hz."""
        with self._lock:
            self._open = False
            caught = np.concatenate(self._blocks) if self._blocks else np.zeros((0, 1), np.float32)
            rate = self._rate or SAMPLE_RATE
            self._forget()
        return caught, rate

    def heard(self) -> tuple[Float32Array, int]:
        """Return what was caught so far as one channel, shape (n,), and its rate in Hz."""
        with self._lock:
            if len(self._mono) > 1:
                self._mono = [np.concatenate(self._mono)]
            return (self._mono[0] if self._mono else np.zeros(0, np.float32)), self._rate or SAMPLE_RATE

    def _forget(self) -> None:
        self._blocks, self._mono, self._n = [], [], 0


def to_mono_44k(samples: Float32Array, rate: int) -> Float32Array:
    """Return a sound, shape (n, n_channels), as one channel at 44.1 kHz, shape (m,)."""
    if rate != SAMPLE_RATE and len(samples):
        samples = Resampler(rate, samples.shape[1]).resample(samples, last=True)
    return mono_of(samples, Channel.MIX)
