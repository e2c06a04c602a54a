"""What a face does by itself: small movements of the head, and blinks."""

import math
import random
from collections import deque
from typing import NamedTuple

from phonemeengine.mouth.morpher import LowPass
from phonemeengine.mouth.style_numbers import GestureNumbers

# Small movements of the head that go with speech.
#
# The head rises with the voice's pitch and nods with its loudness (Yehia, Kuratate and Vatikiotis-Bateson 2002,
# "Linking facial animation, head motion and speech acoustics"), and never stands quite still.

MOST_SEMITONES = 7.0
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
    """Follows loudness and pitch, and gives the pose of the head at any time after; equal seeds sway alike.

    Attributes
    ----------
    gestures : how far it goes.
    """

    def __init__(self, seed: int = 0, gestures: GestureNumbers | None = None) -> None:
        self.gestures = gestures or GestureNumbers()
        chance = random.Random(seed)  # noqa: S311 - nothing secret depends on it
        self._phases = [[chance.uniform(0, 2 * math.pi) for _ in periods] for periods in PERIODS]
        self._loudness, self._rise = LowPass(FOLLOWING), LowPass(FOLLOWING)
        self._speaking = LowPass(1.0)
        self._usual: LowPass | None = None

    def add(self, time: float, intensity: float, f0: float = 0.0) -> None:
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
        moved = self.gestures
        sway = moved.sway_yaw, moved.sway_pitch, moved.sway_roll
        still = 0.5 + 0.5 * self._speaking.at(time)
        turned = 2 * math.pi * time
        yaw, pitch, roll = [
            width * still * (math.sin(turned / p + phase) + math.sin(turned / q + other)) / 2
            for width, (p, q), (phase, other) in zip(sway, PERIODS, self._phases, strict=True)
        ]
        voice = moved.rise * self._rise.at(time) - moved.nod * self._loudness.at(time)
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


# Where the eyes of an idle face look: at the camera mostly, with small jumps aside now and then.
#
# Eyes rest for a second or two and jump in between, the longer the farther: 2.2 ms for each degree and 21 ms
# (Carpenter 1988, "Movements of the Eyes"). While the head turns they stay on what they look at.

RESTING, REST_SPREAD = 1.5, 0.6
"""The middle of the times for which eyes rest, seconds, and the standard deviation of their logarithm."""
SHORTEST_REST, LONGEST_REST = 0.35, 5.0
"""Of these times, seconds."""
ASIDE = 0.35
"""Share of the rests that look aside, not at the camera."""
WIDE, HIGH = 7.0, 3.0
"""How far aside they look at most, degrees to either side, and up or down."""
PER_DEGREE, LEAST = 0.0022, 0.021
"""Seconds that a jump takes for each degree, and besides."""
FARTHEST = 25.0
"""Degrees by which eyes turn in the head at most."""
SIDEWAYS, DOWN, UP = 32.5, 27.0, 17.5
"""Degrees by which the movestates of ARKit turn an eye where they are whole, as the program's own head has it."""
EYES = tuple(f"eyeLook{way}{side}" for side in ("Left", "Right") for way in ("Up", "Down", "In", "Out"))
"""The movestates that turn eyes."""


class GazeDirection(NamedTuple):
    """Where eyes look, degrees: yaw to the face's left, pitch upwards."""

    yaw: float = 0.0
    pitch: float = 0.0


class Gaze:
    """Looks at the camera, and aside now and then; the same seed looks at the same places at the same times."""

    def __init__(self, seed: int = 0) -> None:
        self._random = random.Random(seed)  # noqa: S311 - nothing secret depends on it
        self._before = self._now = GazeDirection()
        self._since = 0.0
        self._until = self._rest()

    def at(self, time: float) -> GazeDirection:
        """Return where the eyes look at a time, seconds; times never go back."""
        while self._until <= time:
            self._before, self._now = self._now, self._next()
            self._since, self._until = self._until, self._until + self._rest()
        far = math.dist(self._before, self._now)
        share = min(1.0, (time - self._since) / (LEAST + PER_DEGREE * far)) if far else 1.0
        share = 0.5 - 0.5 * math.cos(math.pi * max(0.0, share))
        return GazeDirection(*(a + share * (b - a) for a, b in zip(self._before, self._now, strict=True)))

    def _rest(self) -> float:
        return min(max(self._random.lognormvariate(math.log(RESTING), REST_SPREAD), SHORTEST_REST), LONGEST_REST)

    def _next(self) -> GazeDirection:
        if self._random.random() >= ASIDE:
            return GazeDirection()
        return GazeDirection(self._random.uniform(-WIDE, WIDE), self._random.uniform(-HIGH, HIGH))


def eyes_in_head(gaze: GazeDirection, pose: HeadPose | None = None) -> GazeDirection:
    """Return how far the eyes are turned in a head that is turned itself, so that they look where they should."""
    pose = pose or HeadPose()
    yaw, pitch = (
        min(max(wanted - turned, -FARTHEST), FARTHEST)
        for wanted, turned in ((gaze.yaw, pose.yaw), (gaze.pitch, pose.pitch))
    )
    return GazeDirection(yaw, pitch)


def gaze_weights(gaze: GazeDirection, pose: HeadPose | None = None) -> dict[str, float]:
    """Return the weights of the movestates that turn the eyes, 0..1, by name; see `EYES`.

    Parameters
    ----------
    gaze : where they look in the room.
    pose : how the head is turned meanwhile; None for straight ahead.
    """
    yaw, pitch = eyes_in_head(gaze, pose)
    left, right, up, down = (
        max(0.0, value) for value in (yaw / SIDEWAYS, -yaw / SIDEWAYS, pitch / UP, -pitch / DOWN)
    )
    up, down = min(up, 1.0), min(down, 1.0)
    return {
        "eyeLookUpLeft": up,
        "eyeLookDownLeft": down,
        "eyeLookInLeft": right,
        "eyeLookOutLeft": left,
        "eyeLookUpRight": up,
        "eyeLookDownRight": down,
        "eyeLookInRight": left,
        "eyeLookOutRight": right,
    }
