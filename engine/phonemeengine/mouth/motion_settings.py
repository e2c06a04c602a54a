"""How a mouth moves between its shapes: how fast for which sound, how far, and how much it varies."""

import math
from dataclasses import dataclass, fields
from typing import Any

from phonemeengine.errors import MouthError

# name: (lowest, highest, unit)
LIMITS: dict[str, tuple[float, float, str]] = {
    "attack": (0.005, 1.0, "s"),
    "release": (0.005, 1.0, "s"),
    "loudness": (0.0, 1.0, "s"),
    "minimum_opening": (0.0, 1.0, ""),
    "randomness": (0.0, 0.5, ""),
}
NEARLY = 0.9
"""The share of its way that a movement has gone after an attack or a release."""
PART = math.acos(1 - 2 * NEARLY) / math.pi
"""The share of its time that a movement along half a cosine takes for that: 0.795."""


@dataclass(frozen=True)
class TransitionTimes:
    """How fast the mouth is for one sound.

    Parameters
    ----------
    attack : time in which the mouth has gone nine tenths of the way to the sound's shape, seconds.
    release : time in which it has gone nine tenths of the way back, when silence follows the sound, seconds.

    Raises
    ------
    MouthError : a time lies outside 0.005..1 s.
    """

    attack: float
    release: float

    def __post_init__(self) -> None:
        _check(self)

    @property
    def to_shape(self) -> float:
        """The whole time of the movement to the sound's shape, seconds."""
        return self.attack / PART

    @property
    def to_rest(self) -> float:
        """The whole time of the movement back, seconds."""
        return self.release / PART

    def scaled(self, attack: float, release: float) -> "TransitionTimes":
        """Return both times multiplied by factors above 0, as far as their limits allow."""
        return TransitionTimes(_limited("attack", attack * self.attack), _limited("release", release * self.release))


@dataclass(frozen=True)
class MotionSettings:
    """The ways of one mouth.

    Parameters
    ----------
    loudness : time constant with which it follows the loudness, seconds.
    minimum_opening : share of a shape that the faintest speech keeps, 0..1.
    randomness : by how much shapes and times vary from one phoneme to the next, 0..0.5; 0 is a machine.

    Raises
    ------
    MouthError : a value lies outside its range.
    """

    loudness: float = 0.05
    minimum_opening: float = 0.4
    randomness: float = 0.1

    def __post_init__(self) -> None:
        _check(self)


def _check(values: Any) -> None:
    for field in fields(values):
        low, high, unit = LIMITS[field.name]
        value = getattr(values, field.name)
        if not (math.isfinite(value) and low <= value <= high):
            limits = f"{low:g}..{high:g} {unit}".rstrip()
            raise MouthError(f"{field.name} must lie in {limits}, got {value:g}; correct it")


def _limited(name: str, seconds: float) -> float:
    low, high, _ = LIMITS[name]
    return min(max(seconds, low), high)
