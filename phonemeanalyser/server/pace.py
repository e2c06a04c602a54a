"""How fast a stream is read: as fast as it is spoken some times over, and a little ahead at any time."""

import time
from collections.abc import Callable


class Pace:
    """Says how long to wait before more is read (a token bucket, whose tokens are seconds of sound).

    Parameters
    ----------
    speed : seconds of sound for each second.
    ahead : seconds of sound that may come at once.
    clock : gives seconds.
    """

    def __init__(self, speed: float, ahead: float, clock: Callable[[], float] = time.monotonic) -> None:
        self._speed, self._ahead, self._clock = speed, ahead, clock
        self._left, self._looked = ahead, clock()

    def wait_after(self, seconds: float) -> float:
        """Take so much sound; return how long nothing more may be taken, seconds."""
        now = self._clock()
        self._left = min(self._ahead, self._left + (now - self._looked) * self._speed) - seconds
        self._looked = now
        return max(0.0, -self._left / self._speed)
