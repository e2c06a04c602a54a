"""Cut a running sound into frames.

Frame k stands for the stretch from 10k to 10k + 10 ms. Its window of 2048 samples is centred on the middle of
that stretch, sample 441k + 220, with silence before the start and after the end of the sound.
"""

import math

import numpy as np
from numpy.typing import NDArray

from engine.settings import HOP, WINDOW

LEAD = WINDOW // 2 - HOP // 2
"""Samples of silence that stand before the first sample, so that frame 0 is centred on sample 220."""


def frame_count(n_samples: int) -> int:
    """Count the frames that cover a sound of `n_samples` samples."""
    return math.ceil(n_samples / HOP)


class Framer:
    """Collects samples and hands out the frames that they complete; remembers the overlap."""

    def __init__(self) -> None:
        self.n_received = 0
        self.n_framed = 0
        self._pending = np.zeros(LEAD, np.float32)

    def push(self, samples: NDArray[np.float32]) -> NDArray[np.float32]:
        """Take the next samples and give the frames that are now complete.

        Parameters
        ----------
        samples : float32, shape (n,), full scale ±1.

        Returns
        -------
        float32, shape (n_frames, 2048): read-only overlapping views of one buffer; n_frames may be 0.
        """
        self.n_received += len(samples)
        return self._frames_of(np.asarray(samples, np.float32))

    def finish(self) -> NDArray[np.float32]:
        """Give the frames that reach beyond the end of the sound, as if silence followed."""
        n_missing = frame_count(self.n_received) - self.n_framed
        n_silent = max(0, (n_missing - 1) * HOP + WINDOW - len(self._pending))
        return self._frames_of(np.zeros(n_silent if n_missing > 0 else 0, np.float32))

    def _frames_of(self, samples: NDArray[np.float32]) -> NDArray[np.float32]:
        buffer = np.concatenate((self._pending, samples))
        n_frames = max(0, (len(buffer) - WINDOW) // HOP + 1)
        self._pending = buffer[n_frames * HOP :]
        self.n_framed += n_frames
        frames = np.ndarray((n_frames, WINDOW), np.float32, buffer, strides=(HOP * 4, 4))
        frames.flags.writeable = False
        return frames
