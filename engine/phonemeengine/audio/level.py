"""How loud a microphone is, as a meter shows it."""

from collections import deque
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array

HOLD = 1.5
"""Seconds for which the highest peak stays to be read."""
FALL = 20.0
"""How fast the peak falls when it grows quieter, dB a second."""
FULL = 0.9999
"""From here on a sample counts as clipped: the largest value that 16 bits hold is 0.99997."""

MOST_UNREAD = 1000
"""Blocks that are kept for the next reading at most: older ones have no say any more."""


@dataclass(frozen=True)
class Level:
    """A meter's reading: amplitudes 0..1, and how long ago a sample was clipped (None: never)."""

    peak: float = 0.0
    held: float = 0.0
    clipped_ago: float | None = None


class PeakMeter:
    """Follows the peak level, holds the highest for a while, and remembers clipping.

    It works when it is read, so that it costs nothing where it is not read.
    """

    def __init__(self) -> None:
        self._unread: deque[tuple[float, Float32Array]] = deque(maxlen=MOST_UNREAD)
        self._peak = self._held = 0.0
        self._seen = self._held_at = -np.inf
        self._clipped_at: float | None = None

    def add_samples(self, block: Float32Array, now: float) -> None:
        """Take a block of any shape; `now` in seconds."""
        self._unread.append((now, block))

    def read(self, now: float) -> Level:
        """Return the reading at a time in seconds."""
        while self._unread:
            self._follow(*self._unread.popleft())
        peak = self._fallen(now)
        held = self._held if now - self._held_at <= HOLD else peak
        return Level(peak, max(held, peak), None if self._clipped_at is None else now - self._clipped_at)

    def _follow(self, now: float, block: Float32Array) -> None:
        loudest = float(np.abs(block).max()) if block.size else 0.0
        self._peak = max(loudest, self._fallen(now))
        self._seen = now
        if loudest >= self._held or now - self._held_at > HOLD:
            self._held, self._held_at = self._peak, now
        if loudest >= FULL:
            self._clipped_at = now

    def _fallen(self, now: float) -> float:
        return float(self._peak * 10 ** (-FALL / 20 * max(0.0, min(now - self._seen, 60.0))))
