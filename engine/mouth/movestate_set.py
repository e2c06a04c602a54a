"""The movestates of one mesh: how far each is on, and the mesh that comes of it."""

import math
from collections.abc import Mapping, Sequence
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from engine.errors import MeshError
from engine.mouth.mesh import Mesh, Vectors
from engine.mouth.movestate import Movestate

MOST_PERCENT = 1000.0
"""Exaggeration has its limits, in both directions."""
SPREAD = 4
"""A state whose vertices lie among at most so many times as many is stored without gaps, which is faster."""


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


class MovestateSet:
    """Holds the percentage of each movestate of a mesh, and morphs the mesh.

    Parameters
    ----------
    mesh : what is morphed; it stays as it is.
    states : its movestates, each with a name of its own; all begin at 0 %.

    Raises
    ------
    MeshError : two states of one name, or a state with a vertex that the mesh does not have.
    """

    def __init__(self, mesh: Mesh, states: Sequence[Movestate]) -> None:
        self.mesh = mesh
        self.states = tuple(states)
        self._places = {state.name: place for place, state in enumerate(self.states)}
        self._look_at_states()
        self._percentages = np.zeros(len(self.states))
        self._interactable = np.array([state.interactable for state in self.states], bool)
        self._movers: list[_Run | _Scattered | None] = [None] * len(self.states)
        self._morphed = mesh.positions.copy()
        self._room = np.empty_like(mesh.positions)

    def __getitem__(self, name: str) -> Movestate:
        return self.states[self._place(name)]

    def __contains__(self, name: object) -> bool:
        return name in self._places

    def __len__(self) -> int:
        return len(self.states)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all states, in order."""
        return tuple(self._places)

    @property
    def percentages(self) -> dict[str, float]:
        """How far each state is on."""
        return dict(zip(self._places, self._percentages.tolist(), strict=True))

    @property
    def weights(self) -> Vectors:
        """How far each state is on, in the order of `states`, float32, 1.0 for 100 %: what a shader wants."""
        return (self._percentages / 100).astype(np.float32)

    def percentage(self, name: str) -> float:
        """How far a state is on, %."""
        return float(self._percentages[self._place(name)])

    def set_percentage(self, name: str, percent: float, mode: Mode = Mode.NONE) -> None:
        """Set how far a state is on; beyond 0..100 it exaggerates.

        Raises
        ------
        MeshError : there is no such state, or the percentage is no number or beyond ±1000 %.
        """
        place = self._place(name)
        _check(name, percent)
        others = self._affected(mode)
        others[place] = False
        if mode is Mode.INTERACT:
            self._percentages[others] *= self._shrinking(place, percent, others)
        else:
            self._percentages[others] = 0
        self._percentages[place] = percent

    def set_percentages(self, percentages: Mapping[str, float]) -> None:
        """Set several states at once; the others stay.

        Raises
        ------
        MeshError : as for one; then none is set.
        """
        places = [self._place(name) for name in percentages]
        for name, percent in percentages.items():
            _check(name, percent)
        self._percentages[places] = list(percentages.values())

    def reset(self, name: str) -> None:
        """Set a state to 0 %."""
        self._percentages[self._place(name)] = 0

    def reset_all(self, *, force: bool = False) -> None:
        """Set all states to 0 %; those that are not interactable only by force."""
        self._percentages[self._affected(Mode.FORCE_RESET if force else Mode.RESET)] = 0

    def morphed(self) -> Vectors:
        """Give the mesh's positions, each moved by its share of every state.

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

    def _affected(self, mode: Mode) -> NDArray[np.bool_]:
        if mode is Mode.NONE:
            return np.zeros(len(self.states), bool)
        return np.ones(len(self.states), bool) if mode is Mode.FORCE_RESET else self._interactable.copy()

    def _shrinking(self, place: int, percent: float, others: NDArray[np.bool_]) -> float:
        total = float(np.abs(self._percentages[others]).sum())
        if not self._interactable[place] or total == 0:
            return 1.0
        return min(1.0, max(0.0, 100 - abs(percent)) / total)

    def _place(self, name: str) -> int:
        try:
            return self._places[name]
        except KeyError:
            raise MeshError(f"there is no movestate {name!r}; known are {_listed(self._places)}") from None

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

    def add(self, out: Vectors, weight: np.float32, room: Vectors) -> None:
        part, moved = out[self._where], room[: len(self._offsets)]
        np.multiply(self._offsets, weight, out=moved)
        np.add(part, moved, out=part)


class _Scattered:
    """Moves a few vertices here and there."""

    def __init__(self, state: Movestate) -> None:
        self._where = state.numbers.astype(np.intp)
        self._offsets = state.offsets

    def add(self, out: Vectors, weight: np.float32, room: Vectors) -> None:
        moved = room[: len(self._offsets)]
        np.multiply(self._offsets, weight, out=moved)
        moved += out[self._where]
        out[self._where] = moved


def _mover_of(state: Movestate) -> _Run | _Scattered:
    if len(state) and int(state.numbers[-1]) - int(state.numbers[0]) < SPREAD * len(state):
        return _Run(state)
    return _Scattered(state)


def _check(name: str, percent: float) -> None:
    if not (math.isfinite(percent) and abs(percent) <= MOST_PERCENT):
        raise MeshError(f"{name!r} goes from {-MOST_PERCENT:g} to {MOST_PERCENT:g} %, got {percent}; choose less")


def _listed(names: Mapping[str, int]) -> str:
    shown = list(names)[:8]
    return ", ".join(shown) + (f" and {len(names) - len(shown)} others" if len(names) > len(shown) else "") or "none"
