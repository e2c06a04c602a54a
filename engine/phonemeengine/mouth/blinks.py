"""Blinks at human intervals.

People blink about every three to four seconds, at irregular times, now and then twice in a row; the lids close faster
than they open (Stern, Walrath and Goldstein 1984, "The endogenous eyeblink").
"""

import math
import random
from collections import deque

INTERVAL = 3.4
"""The middle of the times from one blink to the next, seconds."""
SPREAD = 0.5
"""By how much those times vary: the standard deviation of their logarithm."""
SHORTEST, LONGEST = 0.9, 11.0
"""Seconds from one blink to the next, unless it is a double one."""
DOUBLE = 0.12
"""Share of blinks that another one follows at once."""
CLOSING, OPENING = 0.08, 0.16
"""Seconds in which the lids close and open again."""


class Blinker:
    """Closes the lids now and then; the same seed blinks at the same times."""

    def __init__(self, seed: int = 0) -> None:
        self._random = random.Random(seed)  # noqa: S311 - nothing secret depends on it
        self._blinks = deque([self._random.uniform(0.5, INTERVAL)])

    def closure(self, time: float) -> float:
        """Return how far the lids are closed at a time, 0..1; times never go back."""
        while self._blinks[-1] <= time:
            self._blinks.append(self._blinks[-1] + self._pause())
        while len(self._blinks) > 1 and self._blinks[1] <= time:
            self._blinks.popleft()
        return _lids(time - self._blinks[0])

    def _pause(self) -> float:
        if self._random.random() < DOUBLE:
            return CLOSING + OPENING + 0.05
        return min(max(self._random.lognormvariate(math.log(INTERVAL), SPREAD), SHORTEST), LONGEST)


def _lids(since: float) -> float:
    """Return how far the lids are closed so long after a blink began."""
    if 0.0 < since < CLOSING:
        return 0.5 - 0.5 * math.cos(math.pi * since / CLOSING)
    if CLOSING <= since < CLOSING + OPENING:
        return 0.5 + 0.5 * math.cos(math.pi * (since - CLOSING) / OPENING)
    return 0.0
