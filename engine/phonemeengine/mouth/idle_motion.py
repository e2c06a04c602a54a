"""What a face does by itself: small movements of the head, and blinks."""

import math
import random
from collections import deque
from typing import NamedTuple

from phonemeengine.mouth.morpher import LowPass

# Small movements of the head that go with speech.
#
# The head rises with the voice's pitch and nods with its loudness (Yehia, Kuratate and Vatikiotis-Bateson 2002,
# "Linking facial animation, head motion and speech acoustics"), and never stands quite still.

PER_SEMITONE = 0.5
"""Degrees that the head rises when the pitch lies a semitone above the usual one."""
MOST_SEMITONES = 7.0
NOD = 2.5
"""Degrees that it sinks at full loudness."""
SWAY = (1.6, 1.0, 0.9)
"""Degrees that it wanders by itself in yaw, pitch and roll: half of it in silence."""
PERIODS = ((7.3, 4.1), (6.1, 3.3), (9.7, 5.3))
"""Seconds of the slow swings that make up the wandering, in yaw, pitch and roll."""
FOLLOWING, USUAL = 0.18, 4.0
"""Time constants with which it follows the voice, and learns the usual pitch, seconds."""


class HeadPose(NamedTuple):
    """How the head is turned, degrees: yaw to its left, pitch upwards, roll to its left shoulder."""

    yaw: float = 0.0
    pitch: float = 0.0
    roll: float = 0.0


class HeadMotion:
    """Follows loudness and pitch, and gives the pose of the head at any time after; equal seeds sway alike."""

    def __init__(self, seed: int = 0) -> None:
        chance = random.Random(seed)  # noqa: S311 - nothing secret depends on it
        self._phases = [[chance.uniform(0, 2 * math.pi) for _ in periods] for periods in PERIODS]
        self._loudness, self._rise = LowPass(FOLLOWING), LowPass(FOLLOWING)
        self._speaking = LowPass(1.0)
        self._usual: LowPass | None = None

    def hear(self, time: float, intensity: float, f0: float = 0.0) -> None:
        """Take loudness, 0..1, and fundamental frequency, Hz (0 where there is none), from a time on, seconds."""
        self._loudness.set_target(time, min(max(intensity, 0.0), 1.0))
        self._speaking.set_target(time, 1.0 if intensity > 0.05 else 0.0)
        if f0 > 0.0:
            pitch = 12.0 * math.log2(f0)
            if self._usual is None:
                self._usual = LowPass(USUAL, pitch)
            rise = pitch - self._usual.at(time)
            self._usual.set_target(time, pitch)
            self._rise.set_target(time, min(max(rise, -MOST_SEMITONES), MOST_SEMITONES))
        else:
            self._rise.set_target(time, 0.0)

    def pose(self, time: float) -> HeadPose:
        """Return the pose at a time; times never go back."""
        still = 0.5 + 0.5 * self._speaking.at(time)
        turned = 2 * math.pi * time
        yaw, pitch, roll = [
            width * still * (math.sin(turned / p + phase) + math.sin(turned / q + other)) / 2
            for width, (p, q), (phase, other) in zip(SWAY, PERIODS, self._phases, strict=True)
        ]
        voice = PER_SEMITONE * self._rise.at(time) - NOD * self._loudness.at(time)
        return HeadPose(yaw, pitch + voice, roll)


# Blinks at human intervals.
#
# People blink about every three to four seconds, at irregular times, now and then twice in a row; the lids close
# faster than they open (Stern, Walrath and Goldstein 1984, "The endogenous eyeblink").

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
