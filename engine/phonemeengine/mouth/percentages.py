"""How far each of some states is on, and what becomes of the others when one is set."""

import math
from collections.abc import Hashable, Iterable, Mapping
from enum import StrEnum
from typing import Generic, TypeVar

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.errors import MeshError

MOST_PERCENT = 1000.0
"""Exaggeration has its limits, in both directions."""

Name = TypeVar("Name", bound=Hashable)


class Mode(StrEnum):
    """What becomes of the other states when one is set."""

    NONE = "none"
    """They stay."""
    RESET = "reset"
    """Those that are interactable go to 0."""
    FORCE_RESET = "force_reset"
    """All go to 0."""
    INTERACT = "interact"
    """Those that are interactable shrink by one factor, so that all together are at most 100 %.

    With p the new percentage and S the sum of |percentage| of the other interactable states, each of these is
    multiplied by min(1, max(0, 100 - |p|) / S). A state that is not interactable takes no share: nothing shrinks.
    """


class Percentages(Generic[Name]):
    """Holds how far each of some states is on.

    Parameters
    ----------
    interactable : for each state whether setting others may push it back; all begin at 0 %.
    """

    def __init__(self, interactable: Mapping[Name, bool]) -> None:
        self._places = {name: place for place, name in enumerate(interactable)}
        self._interactable = np.array([*interactable.values()], bool)
        self._percentages = np.zeros(len(self._places))

    def __contains__(self, name: object) -> bool:
        return name in self._places

    def __len__(self) -> int:
        return len(self._places)

    @property
    def names(self) -> tuple[Name, ...]:
        """The names of all states, in order."""
        return tuple(self._places)

    @property
    def percentages(self) -> dict[Name, float]:
        """How far each state is on."""
        return dict(zip(self._places, self._percentages.tolist(), strict=True))

    @property
    def weights(self) -> Float32Array:
        """How far each state is on, in order, float32, 1.0 for 100 %: what a shader wants."""
        return (self._percentages / 100).astype(np.float32)

    def percentage(self, name: Name) -> float:
        """How far a state is on, %; MeshError where there is no such state, here and below."""
        return float(self._percentages[self._place(name)])

    def interactable(self, name: Name) -> bool:
        """Whether setting others may push a state back."""
        return bool(self._interactable[self._place(name)])

    def set_interactable(self, name: Name, interactable: bool) -> None:
        """Return whether setting others may push a state back."""
        self._interactable[self._place(name)] = interactable

    def set_percentage(self, name: Name, percent: float, mode: Mode = Mode.NONE) -> None:
        """Set how far a state is on; beyond 0..100 it exaggerates.

        Raises
        ------
        MeshError : there is no such state, or the percentage is no number or beyond ±1000 %.
        """
        place = self._place(name)
        _check(name, percent)
        others = self._affected(mode)
        others[place] = False
        if mode == Mode.INTERACT:
            self._percentages[others] *= self._shrinking(place, percent, others)
        else:
            self._percentages[others] = 0
        self._percentages[place] = percent

    def set_percentages(self, percentages: Mapping[Name, float]) -> None:
        """Set several states at once; the others stay.

        Raises
        ------
        MeshError : as for one; then none is set.
        """
        places = [self._place(name) for name in percentages]
        for name, percent in percentages.items():
            _check(name, percent)
        self._percentages[places] = list(percentages.values())

    def reset(self, name: Name) -> None:
        """Set a state to 0 %."""
        self._percentages[self._place(name)] = 0

    def reset_all(self, *, force: bool = False) -> None:
        """Set all states to 0 %; those that are not interactable only by force."""
        self._percentages[self._affected(Mode.FORCE_RESET if force else Mode.RESET)] = 0

    def _affected(self, mode: Mode) -> BoolArray:
        if mode == Mode.NONE:
            return np.zeros(len(self), bool)
        return np.ones(len(self), bool) if mode == Mode.FORCE_RESET else self._interactable.copy()

    def _shrinking(self, place: int, percent: float, others: BoolArray) -> float:
        total = float(np.abs(self._percentages[others]).sum())
        if not self._interactable[place] or total == 0:
            return 1.0
        return min(1.0, max(0.0, 100 - abs(percent)) / total)

    def _place(self, name: Name) -> int:
        try:
            return self._places[name]
        except KeyError:
            raise MeshError(f"there is no movestate {str(name)!r}; known are {_listed(self._places)}") from None


def _check(name: Hashable, percent: float) -> None:
    if not (math.isfinite(percent) and abs(percent) <= MOST_PERCENT):
        raise MeshError(
            f"{str(name)!r} goes from {-MOST_PERCENT:g} to {MOST_PERCENT:g} %, got {percent}; choose less"
        )


def _listed(names: Iterable[Hashable]) -> str:
    shown = [str(name) for name in names]
    more = f" and {len(shown) - 8} others" if len(shown) > 8 else ""
    return ", ".join(shown[:8]) + more or "none"
