"""Movements along half a cosine, laid over each other: of each mouth that goes from shape to shape.

A movement begins wherever the mouth is going to, so neither the weights nor their speed jump, however fast movements
follow each other, and no weight leaves the range of the shapes that it lies between.
"""

import math
from collections.abc import Reversible
from dataclasses import dataclass
from typing import TypeVar

# Following a value that holds between its changes.


class LowPass:
    """Approaches a target by the exact answer of a low-pass of first order: it does not matter how often one looks.

    Parameters
    ----------
    time_constant : seconds after which 63 % of a change is followed; 0 follows at once.
    value : where it begins.
    """

    def __init__(self, time_constant: float, value: float = 0.0) -> None:
        self._time_constant = time_constant
        self._time, self._value, self._target = 0.0, value, value

    def set_target(self, time: float, target: float) -> None:
        """Set another target from a time on, seconds; times never go back."""
        if target != self._target:
            self._value = self.at(time)
            self._time, self._target = time, target

    def at(self, time: float) -> float:
        """Return the value at a time."""
        if self._time_constant <= 0.0 or self._value == self._target:
            return self._target
        passed = max(time - self._time, 0.0)
        return self._target + (self._value - self._target) * math.exp(-passed / self._time_constant)


@dataclass(slots=True)
class EasedMovement:
    """A movement of the mouth: when it begins, how long it takes, both in seconds, and the number of its shape."""

    start: float
    duration: float
    row: int


M = TypeVar("M", bound=EasedMovement)


def shares_of(movements: Reversible[M], time: float) -> list[tuple[M, float]]:
    """Return the movements that make the mouth at a time, the newest first, each with its share; these sum to 1.

    Parameters
    ----------
    movements : in the order in which they begin; the first one has ended, or the shares sum to less.
    time : seconds.
    """
    mixed, left = [], 1.0
    for movement in reversed(movements):
        progress = (time - movement.start) / movement.duration if movement.duration else 1.0
        if progress <= 0.0:
            continue
        ease = 1.0 if progress >= 1.0 else 0.5 - 0.5 * math.cos(math.pi * progress)
        mixed.append((movement, left * ease))
        left *= 1.0 - ease
        if left <= 0.0:
            break
    return mixed
