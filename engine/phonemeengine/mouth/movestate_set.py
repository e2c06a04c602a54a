"""The movestates of one mesh: how far each is on, and the mesh that comes of it."""

import math
from collections.abc import Hashable, Iterable, Mapping, Sequence
from enum import StrEnum
from typing import Generic, TypeVar

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import Mesh
from phonemeengine.mouth.movestate import Movestate

# How far each of some states is on, and what becomes of the others when one is set.

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


SPREAD = 4
"""A state whose vertices lie among at most so many times as many is stored without gaps, which is faster."""


class MovestateSet(Percentages[str]):
    """Holds the percentage of each movestate of a mesh, and morphs the mesh.

    Parameters
    ----------
    mesh : what is morphed; it stays as it is.
    states : its movestates, each with a name of its own; all begin at 0 %, and interactable or not as they say.

    Raises
    ------
    MeshError : two states of one name, or a state with a vertex that the mesh does not have.
    """

    def __init__(self, mesh: Mesh, states: Sequence[Movestate]) -> None:
        super().__init__({state.name: state.interactable for state in states})
        self.mesh = mesh
        self.states = tuple(states)
        self._look_at_states()
        self._movers: list[_Run | _Scattered | None] = [None] * len(self.states)
        self._morphed = mesh.positions.copy()
        self._room = np.empty_like(mesh.positions)

    def __getitem__(self, name: str) -> Movestate:
        return self.states[self._place(name)]

    def morphed(self) -> Float32Array:
        """Return the mesh's positions, each moved by its share of every state.

        Returns
        -------
        float32, shape (n_vertices, 3); the array is used again by the next call.
        """
        out = self._morphed
        np.copyto(out, self.mesh.positions)
        for place in np.flatnonzero(self._percentages).tolist():
            mover = self._movers[place]
            if mover is None:
                mover = self._movers[place] = _mover_of(self.states[place])
            mover.add(out, np.float32(self._percentages[place] / 100), self._room)
        return out

    def _look_at_states(self) -> None:
        if len(self._places) < len(self.states):
            names = [state.name for state in self.states]
            twice = next(name for name in names if names.count(name) > 1)
            raise MeshError(f"there are two movestates {twice!r}; rename one")
        for state in self.states:
            if len(state) and state.numbers[-1] >= len(self.mesh):
                raise MeshError(
                    f"movestate {state.name!r} moves vertex {state.numbers[-1]}, and the mesh has {len(self.mesh)}; "
                    "choose the mesh that it was made for"
                )


class _Run:
    """Moves vertices that lie side by side."""

    def __init__(self, state: Movestate) -> None:
        first, last = int(state.numbers[0]), int(state.numbers[-1])
        self._where = slice(first, last + 1)
        self._offsets = np.zeros((last + 1 - first, 3), np.float32)
        self._offsets[state.numbers - np.uint32(first)] = state.offsets

    def add(self, out: Float32Array, weight: np.float32, room: Float32Array) -> None:
        part, moved = out[self._where], room[: len(self._offsets)]
        np.multiply(self._offsets, weight, out=moved)
        np.add(part, moved, out=part)


class _Scattered:
    """Moves a few vertices here and there."""

    def __init__(self, state: Movestate) -> None:
        self._where = state.numbers.astype(np.intp)
        self._offsets = state.offsets

    def add(self, out: Float32Array, weight: np.float32, room: Float32Array) -> None:
        moved = room[: len(self._offsets)]
        np.multiply(self._offsets, weight, out=moved)
        moved += out[self._where]
        out[self._where] = moved


def _mover_of(state: Movestate) -> _Run | _Scattered:
    if len(state) and int(state.numbers[-1]) - int(state.numbers[0]) < SPREAD * len(state):
        return _Run(state)
    return _Scattered(state)
