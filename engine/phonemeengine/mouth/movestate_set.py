"""The movestates of one mesh: how far each is on, and the mesh that comes of it."""

from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import Mesh
from phonemeengine.mouth.movestate import Movestate
from phonemeengine.mouth.percentages import Percentages

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
