"""A movestate: a morph target, stored as what differs from the mesh; and all those of a mesh, each on by so much.

Combination shapes correct what others look like together, such as ``mouthSmile_jawOpen``.
"""

import math
from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import FARTHEST, MOST_VERTICES, Mesh

LEAST_MOVE = 0.0001
"""A vertex that moves no farther than this is left out, in units of the mesh."""
LONGEST_NAME = 255
"""Bytes of UTF-8."""


@dataclass(frozen=True, eq=False)
class Movestate:
    """A shape that a mesh can be moved towards; make one with `movestate_of` or `movestate_at`.

    Attributes
    ----------
    name : what it is called.
    numbers : uint32, shape (n,), the vertices that move, ascending.
    offsets : float32, shape (n, 3), how far each of them moves at 100 %.
    interactable : whether setting others may push it back, until `Percentages.set_interactable` says otherwise; a
        blink does not care about the mouth.
    """

    name: str
    numbers: UInt32Array
    offsets: Float32Array
    interactable: bool = True

    def __len__(self) -> int:
        return len(self.numbers)

    @property
    def reach(self) -> float:
        """How far the vertex that moves farthest moves."""
        return float(np.linalg.norm(self.offsets, axis=1).max(initial=0.0))


def movestate_of(name: str, offsets: ArrayLike, *, interactable: bool = True) -> Movestate:
    """Make a movestate of the offsets of all vertices of a mesh, shape (n_vertices, 3).

    Raises
    ------
    MeshError : a bad name, or an offset that is no number.
    """
    with np.errstate(over="ignore"):
        dense = np.asarray(offsets, np.float32).reshape(-1, 3)
    # A NaN stays in, so that it is refused below.
    moving = np.flatnonzero(~(np.sqrt(np.square(dense.astype(np.float64)).sum(axis=1)) <= LEAST_MOVE))
    return movestate_at(name, moving, dense[moving], interactable=interactable)


def movestate_at(name: str, numbers: ArrayLike, offsets: ArrayLike, *, interactable: bool = True) -> Movestate:
    """Make a movestate of the vertices that move, and their offsets.

    Raises
    ------
    MeshError : a bad name, a vertex that is named twice or beyond any mesh, or an offset that is no number.
    """
    check_name(name)
    where = np.asarray(numbers).reshape(-1)
    far = np.asarray(offsets, np.float32).reshape(-1, 3)
    if len(where) != len(far):
        raise MeshError(f"movestate {name!r} has {len(where)} vertices and {len(far)} offsets; export it again")
    where, far = _sorted(name, where, far)
    if len(far) and not np.abs(far).max() <= FARTHEST:
        raise MeshError(f"movestate {name!r} holds an offset that is no finite number; export it again")
    where.setflags(write=False)
    far.setflags(write=False)
    return Movestate(name, where, far, interactable)


def check_name(name: str) -> None:
    """Look at the name of a movestate.

    Raises
    ------
    MeshError : it is empty, too long, or cannot be printed on one line.
    """
    if not name.strip() == name != "" or not name.isprintable() or len(name.encode(errors="replace")) > LONGEST_NAME:
        raise MeshError(
            f"the name of a movestate is 1..{LONGEST_NAME} bytes of printable text, got {name[:40]!r}; rename it"
        )


def _sorted(name: str, numbers: NDArray[np.generic], offsets: Float32Array) -> tuple[UInt32Array, Float32Array]:
    """Return the numbers ascending, after looking whether each is a vertex and comes once."""
    if len(numbers) and not 0 <= int(numbers.min()) <= int(numbers.max()) < MOST_VERTICES:
        raise MeshError(
            f"movestate {name!r} names vertex {int(numbers.max())}, and a mesh has at most {MOST_VERTICES}; "
            "export it again"
        )
    where = np.array(numbers, np.uint32)
    if len(where) > 1 and not np.all(where[1:] > where[:-1]):
        order = np.argsort(where, kind="stable")
        where, offsets = where[order], offsets[order]
        if not np.all(where[1:] > where[:-1]):
            twice = int(where[np.argmin(where[1:] > where[:-1])])
            raise MeshError(f"movestate {name!r} names vertex {twice} twice; export it again")
    return where, np.array(offsets, order="C")


# The movestates of one mesh: how far each is on, and the mesh that comes of it.

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
        """Let setting others push a state back, or not."""
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
            raise MeshError(f"there is no movestate {str(name)!r}; choose one of {_listed(self._places)}") from None


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
"""A state is stored without gaps, which is faster, if its vertices lie among at most this multiple of them."""


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
        self._combinations = {self._place(n): parts for n, parts in combinations_of([*self._places]).items()}
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
        percentages = self._corrected()
        for place in np.flatnonzero(percentages).tolist():
            mover = self._movers[place]
            if mover is None:
                mover = self._movers[place] = _mover_of(self.states[place])
            mover.add(out, np.float32(percentages[place] / 100), self._room)
        return out

    def _corrected(self) -> Float64Array:
        """Return the percentages, where combination shapes follow their parts unless they are moved themselves."""
        if not self._combinations:
            return self._percentages
        shares = dict(zip(self._places, self.weights, strict=True))
        percentages = self._percentages.copy()
        for place, parts in self._combinations.items():
            if not percentages[place]:
                percentages[place] = 100 * combined(parts, shares)
        return percentages

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


Parts = tuple[tuple[str, ...], ...]
"""The shapes that a combination is made of; one without a side is both of its sides."""


def combinations_of(names: Collection[str]) -> dict[str, Parts]:
    """Return the shapes whose names are those of two or more others, joined by underscores, each with these.

    ``mouthSmile_jawOpen`` is of both sides of ``mouthSmile`` and of ``jawOpen``, where the former has two sides.
    """
    known = {*names}
    found = {name: _parts_of(name.split("_"), known - {name}) for name in names if "_" in name}
    return {name: parts for name, parts in found.items() if len(parts) > 1}


def combined(parts: Parts, weights: Mapping[str, ArrayLike]) -> Float32Array:
    """Return how far a combination moves: the product of its parts, 0..1 each, of which both sides are the mean.

    Parameters
    ----------
    weights : of all shapes by name, 1 for the whole movement, in arrays of one form.
    """
    means = [np.array([weights[name] for name in shapes], np.float32).mean(axis=0) for shapes in parts]
    shares: Float32Array = np.prod(np.clip(means, 0, 1), axis=0)
    return shares


def _parts_of(words: list[str], known: Collection[str]) -> Parts:
    """Return the shapes of which words are made, the longest first; none where a word is left over."""
    for n in range(len(words), 0, -1):
        name = "_".join(words[:n])
        sides = (f"{name}Left", f"{name}Right")
        first = (name,) if name in known else sides if all(side in known for side in sides) else ()
        rest = _parts_of(words[n:], known) if first and n < len(words) else ()
        if first and (rest or n == len(words)):
            return (first, *rest)
    return ()
