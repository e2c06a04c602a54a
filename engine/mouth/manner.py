"""How a mouth moves between its shapes: how fast, how far, and how much it varies."""

import math
from dataclasses import dataclass

from engine.errors import MouthError

# name: (lowest, highest, unit)
LIMITS: dict[str, tuple[float, float, str]] = {
    "attack": (0.005, 1.0, "s"),
    "release": (0.005, 1.0, "s"),
    "closing": (0.005, 1.0, "s"),
    "loudness": (0.0, 1.0, "s"),
    "quiet": (0.0, 1.0, ""),
    "randomness": (0.0, 0.5, ""),
}


@dataclass(frozen=True)
class Manner:
    """The ways of one mouth.

    Parameters
    ----------
    attack : time in which it reaches an open shape, seconds.
    release : time in which it closes when there is silence, seconds.
    closing : time in which the lips meet for m and p, seconds.
    loudness : time constant with which it follows the loudness, seconds.
    quiet : share of a shape that the faintest speech keeps, 0..1.
    randomness : by how much shapes and times vary from one phoneme to the next, 0..0.5; 0 is a machine.

    Raises
    ------
    MouthError : a value lies outside its range.
    """

    attack: float = 0.09
    release: float = 0.16
    closing: float = 0.05
    loudness: float = 0.05
    quiet: float = 0.4
    randomness: float = 0.1

    def __post_init__(self) -> None:
        for name, (low, high, unit) in LIMITS.items():
            value = getattr(self, name)
            if not (math.isfinite(value) and low <= value <= high):
                limits = f"{low:g}..{high:g} {unit}".rstrip()
                raise MouthError(f"{name} must lie in {limits}, got {value:g}; correct it")
