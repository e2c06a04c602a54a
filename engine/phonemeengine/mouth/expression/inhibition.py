"""How much speech holds expressions back."""

import math
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class InhibitionTimes:
    """How speech begins and ends to hold expressions back.

    Attributes
    ----------
    onset : seconds from the start of speech until expressions are held back wholly.
    release : seconds from its end until they are free.
    pause : silences that are shorter, seconds, do not end speech.
    """

    onset: float = 0.1
    release: float = 0.5
    pause: float = 0.5


class Inhibition:
    """Follows speech: 0 in silence, 1 while somebody speaks, along half a cosine from wherever it stands.

    Times are seconds of one clock, and never go back.

    Parameters
    ----------
    times : how fast it is.
    """

    def __init__(self, times: InhibitionTimes | None = None) -> None:
        self._times = times or InhibitionTimes()
        self._coming: deque[tuple[float, float]] = deque()
        self._from = self._to = 0.0
        self._since = -math.inf
        self._speaks, self._silent_since, self._knows_all = False, -math.inf, False

    def expect(self, speech: Iterable[tuple[float, float]]) -> None:
        """Take all speech that there will be, as start and end of what is said, in order: it ends when it ends.

        What is heard from then on says nothing new.
        """
        joined: list[list[float]] = []
        for start, end in speech:
            if joined and start - joined[-1][1] < self._times.pause:
                joined[-1][1] = end
            else:
                joined.append([start, end])
        self._knows_all = True
        self._coming = deque((time, goal) for start, end in joined for time, goal in ((start, 1.0), (end, 0.0)))

    def hear(self, time: float, *, speaks: bool) -> None:
        """Take whether somebody speaks from a time on: speech has ended once nobody has spoken for a pause."""
        if self._knows_all:
            return
        if speaks:
            if not self._speaks:
                self._coming.append((time, 1.0))
            self._speaks, self._silent_since = True, math.inf
        elif self._speaks:
            self._silent_since = min(self._silent_since, time)
            if time - self._silent_since >= self._times.pause:
                self._coming.append((time, 0.0))
                self._speaks = False

    def at(self, time: float) -> float:
        """Return how far expressions are held back, 0..1."""
        if self._speaks and time - self._silent_since >= self._times.pause:
            self._coming.append((self._silent_since + self._times.pause, 0.0))
            self._speaks = False
        while self._coming and self._coming[0][0] <= time:
            begin, goal = self._coming.popleft()
            self._from, self._to, self._since = self._value(begin), goal, begin
        return self._value(time)

    def _value(self, time: float) -> float:
        lasts = self._times.onset if self._to else self._times.release
        share = min(1.0, (time - self._since) / lasts) if lasts > 0 else 1.0
        return self._from + (self._to - self._from) * (1 - math.cos(math.pi * share)) / 2
