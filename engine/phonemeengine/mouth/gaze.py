"""Where the eyes of an idle face look: at the camera mostly, with small jumps aside now and then.

Eyes rest for a second or two and jump in between, the longer the farther: 2.2 ms for each degree and 21 ms (Carpenter
1988, "Movements of the Eyes"). While the head turns they stay on what they look at.
"""

import math
import random
from typing import NamedTuple

from phonemeengine.mouth.idle_motion import HeadPose

RESTING, SPREAD = 1.5, 0.6
"""The middle of the times for which eyes rest, seconds, and the standard deviation of their logarithm."""
SHORTEST, LONGEST = 0.35, 5.0
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
EYES = tuple(
    f"eyeLook{way}{side}" for side in ("Left", "Right") for way in ("Up", "Down", "In", "Out")
)  # fmt: skip
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
        return min(max(self._random.lognormvariate(math.log(RESTING), SPREAD), SHORTEST), LONGEST)

    def _next(self) -> GazeDirection:
        if self._random.random() >= ASIDE:
            return GazeDirection()
        return GazeDirection(self._random.uniform(-WIDE, WIDE), self._random.uniform(-HIGH, HIGH))


def gaze_weights(gaze: GazeDirection, pose: HeadPose | None = None) -> dict[str, float]:
    """Return the weights of the movestates that turn the eyes, 0..1, by name; see `EYES`.

    Parameters
    ----------
    gaze : where they look in the room.
    pose : how the head is turned meanwhile; None for straight ahead.
    """
    pose = pose or HeadPose()
    yaw, pitch = (
        min(max(wanted - turned, -FARTHEST), FARTHEST)
        for wanted, turned in ((gaze.yaw, pose.yaw), (gaze.pitch, pose.pitch))
    )
    left, right, up, down = (
        max(0.0, value) for value in (yaw / SIDEWAYS, -yaw / SIDEWAYS, pitch / UP, -pitch / DOWN)
    )
    up, down = min(up, 1.0), min(down, 1.0)
    return {
        "eyeLookUpLeft": up, "eyeLookDownLeft": down, "eyeLookInLeft": right, "eyeLookOutLeft": left,
        "eyeLookUpRight": up, "eyeLookDownRight": down, "eyeLookInRight": left, "eyeLookOutRight": right,
    }  # fmt: skip
