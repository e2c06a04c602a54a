"""Cut a running sound into frames.

Frame k stands for the interval from 10k to 10k + 10 ms. Its window of 2048 samples is centred on the middle of
that interval, sample 441k + 220, with silence before the start and after the end of the sound.
"""

import math

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.settings import HOP, WINDOW

FLOAT = np.dtype(np.float32)
STRIDES = (HOP * FLOAT.itemsize, FLOAT.itemsize)
ROOM = 64 * HOP
"""Samples that a buffer holds at least, so that the overlap is copied seldom where samples come a few at a time."""
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
        self._first, self._last = 0, LEAD
        self._buffer = np.zeros(ROOM, FLOAT)
        self._seen = _read_only(self._buffer)

    def cut_frames(self, samples: Float32Array) -> Float32Array:
        """Take the next samples and give the frames that are now complete.

        Parameters
        ----------
        samples : float32, shape (n,), full scale ±1.

        Returns
        -------
        float32, shape (n_frames, 2048): read-only overlapping views of a buffer that never changes
        under them; n_frames may be 0.
        """
        self.n_received += len(samples)
        return self._frames_of(samples)

    def finish(self) -> Float32Array:
        """Return the frames that reach beyond the end of the sound, as if silence followed."""
        n_missing = frame_count(self.n_received) - self.n_framed
        n_silent = max(0, (n_missing - 1) * HOP + WINDOW - (self._last - self._first))
        return self._frames_of(np.zeros(n_silent if n_missing > 0 else 0, np.float32))

    def _frames_of(self, samples: Float32Array) -> Float32Array:
        # Samples are only ever written behind those that frames have seen, so views that were handed out never
        # change.
        if self._last + len(samples) > len(self._buffer):
            self._renew(len(samples))
        last = self._last + len(samples)
        self._buffer[self._last : last] = samples
        n_frames = max(0, (last - self._first - WINDOW) // HOP + 1)
        # Frames overlap by 79 %: as views they cost nothing, as copies 4.6 times the sound. `numpy.ndarray` builds
        # one with less overhead than as_strided.
        frames = np.ndarray((n_frames, WINDOW), FLOAT, self._seen, self._first * FLOAT.itemsize, STRIDES)
        self._first, self._last = self._first + n_frames * HOP, last
        self.n_framed += n_frames
        return frames

    def _renew(self, n: int) -> None:
        """Go on in a new buffer with room for `n` samples, since frames that were handed out look at the old one."""
        pending = self._buffer[self._first : self._last]
        self._buffer = np.zeros(max(ROOM, len(pending) + n), FLOAT)
        self._buffer[: len(pending)] = pending
        self._first, self._last = 0, len(pending)
        self._seen = _read_only(self._buffer)


def _read_only(samples: Float32Array) -> Float32Array:
    view = samples.view()
    view.flags.writeable = False
    return view
