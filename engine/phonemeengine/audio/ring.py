"""A ring of samples between two threads: one writes, one reads, neither ever waits.

Both ends count samples since the beginning; the counts only grow, so each side may look at the other's at any
time. The reader is usually the sound card's callback, which must not lock, so nothing here does.
"""

import numpy as np

from phonemeengine.arrays import Float32Array


class Ring:
    """Holds up to `capacity` samples per channel.

    Attributes
    ----------
    n_written, n_read : samples per channel since the beginning.
    """

    def __init__(self, capacity: int, n_channels: int) -> None:
        self.n_written = 0
        self.n_read = 0
        self._skip_to = 0
        self._samples = np.zeros((capacity, n_channels), np.float32)

    @property
    def room(self) -> int:
        """Samples per channel that can be written now."""
        return len(self._samples) - (self.n_written - max(self.n_read, self._skip_to))

    def write(self, block: Float32Array) -> None:
        """Append a block, shape (n, n_channels); the writer makes sure that n is at most `room`."""
        start = self.n_written % len(self._samples)
        head = min(len(block), len(self._samples) - start)
        self._samples[start : start + head] = block[:head]
        self._samples[: len(block) - head] = block[head:]
        self.n_written += len(block)

    def read_into(self, out: Float32Array) -> int:
        """Fill `out`, shape (n, n_channels), with the oldest samples, then silence; returns how many were there."""
        self.n_read = max(self.n_read, self._skip_to)
        n = min(len(out), self.n_written - self.n_read)
        start = self.n_read % len(self._samples)
        head = min(n, len(self._samples) - start)
        out[:head] = self._samples[start : start + head]
        out[head:n] = self._samples[: n - head]
        out[n:] = 0
        self.n_read += n
        return n

    def skip(self) -> None:
        """Have the reader pass over everything written so far; called by the writer."""
        self._skip_to = self.n_written
