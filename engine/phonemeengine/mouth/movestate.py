"""A movestate: a morph target, stored as what differs from the mesh."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from phonemeengine.arrays import Float32Array, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import FARTHEST, MOST_VERTICES

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
    interactable : whether setting others may push it back, until `MovestateSet.set_interactable` says otherwise; a
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
