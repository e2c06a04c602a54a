"""A mesh and its movestates, what of both a .3dm file holds, and the heads that ship with the program.

`python -m tools.head` makes the heads. Six movestates of the tongue, named by `TONGUE`, are added when a head is
loaded, from where the vertices of its tongue lie. A head turns about its origin, on the neck; a unit is a decimetre.
"""

import itertools
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, IndexArray, ShortRepr, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import FARTHEST, MOST_VERTICES, Mesh, mesh_of
from phonemeengine.mouth.movestate import Movestate, movestate_at, movestate_of
from phonemeengine.storage.files import read_npz

MOST_STATES = 1024
TOLERANCE = 0.0001
"""How far apart two vertices may be and still be the same one, in units of the mesh."""
N_NAMED = 8
MOST_NEAR = 1 << 22
NARROWEST = 1e-9
CELL_STEPS = (1.0, 1618.03398875, 2718281.82846)
"""By how much the number of a cell differs from that of the next one along each axis."""


@dataclass(frozen=True, eq=False, repr=False)
class MorphMesh(ShortRepr):
    """A mesh and its movestates.

    Attributes
    ----------
    mesh, states : the states move the mesh's vertices.
    neck : where the head turns on the neck, the head's bone, x, y, z; None where there are no bones.
    """

    mesh: Mesh
    states: tuple[Movestate, ...] = ()
    neck: tuple[float, float, float] | None = None


BELOW, ASIDE = 1.2, 1.4
"""How far a bust reaches below its neck, and to both sides of it, in heights of the head."""


def bust_of(morph_mesh: MorphMesh) -> MorphMesh:
    """Return head, neck and shoulders of a whole body, with the origin where the head turns on the neck.

    A face without bones stays as it is.
    """
    mesh, neck = morph_mesh.mesh, morph_mesh.neck
    if neck is None:
        return morph_mesh
    points = mesh.positions - np.array(neck, np.float32)
    height = float(points[:, 1].max())
    points.setflags(write=False)
    centred = MorphMesh(replace(mesh, positions=points), morph_mesh.states, (0.0, 0.0, 0.0))
    if height <= 0 or float(points[:, 1].min()) > -2 * BELOW * height:
        return centred
    near = (points[:, 1] > -BELOW * height) & (np.abs(points[:, 0]) < ASIDE * height)
    kept = near[mesh.triangles].all(axis=1)
    used = np.zeros(len(mesh), bool)
    used[mesh.triangles[kept].ravel()] = True
    if not used.any():
        return centred
    numbers = np.cumsum(used) - 1
    bust = mesh_of(
        points[used],
        numbers[mesh.triangles[kept]],
        name=mesh.name,
        normals=mesh.normals[used],
        colours=mesh.colours[used],
        materials=mesh.materials,
        material_of=mesh.material_of[kept],
        uvs=mesh.uvs[used],
    )
    return MorphMesh(bust, tuple(_among(state, used, numbers) for state in morph_mesh.states), (0.0, 0.0, 0.0))


def _among(state: Movestate, used: BoolArray, numbers: IndexArray) -> Movestate:
    """Return what a movestate moves of the vertices that are used, with their new numbers."""
    kept = used[state.numbers]
    return movestate_at(
        state.name, numbers[state.numbers[kept]], state.offsets[kept], interactable=state.interactable
    )


@dataclass(frozen=True, eq=False, repr=False)
class MorphTargets(ShortRepr):
    """Movestates, and where the vertices that they move are in the mesh: what a .3dm file holds.

    Attributes
    ----------
    states : each has a name of its own.
    numbers : uint32, shape (n,), all vertices that move, ascending.
    positions : float32, shape (n, 3), where they are in the mesh.
    """

    states: tuple[Movestate, ...]
    numbers: UInt32Array
    positions: Float32Array


def morph_targets_of(mesh: Mesh, states: Sequence[Movestate]) -> MorphTargets:
    """Return what a .3dm file holds of a mesh and its movestates.

    Raises
    ------
    MeshError : two states of one name, or one that moves a vertex which the mesh does not have.
    """
    moving = np.zeros(MOST_VERTICES, bool)
    for state in states:
        moving[state.numbers] = True
    numbers = np.flatnonzero(moving).astype(np.uint32)
    if len(numbers) and numbers[-1] >= len(mesh):
        raise MeshError(
            f"the movestates move vertex {numbers[-1]}, and the mesh has {len(mesh)}; choose the mesh of theirs"
        )
    return checked(MorphTargets(tuple(states), numbers, mesh.positions[numbers]))


def checked(targets: MorphTargets) -> MorphTargets:
    """Return targets after looking at whether their parts fit together.

    Raises
    ------
    MeshError : too many states, two of one name, a position that is no number, or a state that moves a vertex
        which is not among those that move.
    """
    if len(targets.states) > MOST_STATES:
        raise MeshError(
            f"a face has at most {MOST_STATES} movestates, this has {len(targets.states)}; leave some out"
        )
    names = [state.name for state in targets.states]
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise MeshError(f"two movestates are called {twice!r}; rename one")
    if len(targets.positions) and not np.abs(targets.positions).max() <= FARTHEST:
        raise MeshError("a vertex that moves has no finite position; export it again")
    known = np.zeros(MOST_VERTICES, bool)
    known[targets.numbers] = True
    for state in targets.states:
        if not known[state.numbers].all():
            missing = int(state.numbers[~known[state.numbers]][0])
            raise MeshError(
                f"movestate {state.name!r} moves vertex {missing}, which the list of all lacks; export it again"
            )
    return targets


def matched(targets: MorphTargets, mesh: Mesh, tolerance: float = TOLERANCE) -> MorphTargets:
    """Return targets with the numbers of a mesh: as they are where they fit it, else remapped.

    Raises
    ------
    MeshError : vertices of the targets are nowhere in the mesh; names them.
    """
    if not len(targets.numbers):
        return targets
    if int(targets.numbers[-1]) < len(mesh):
        apart = np.linalg.norm(mesh.positions[targets.numbers] - targets.positions, axis=1)
        if float(apart.max()) <= tolerance:
            return targets
    return remap_vertices(targets, mesh, tolerance)


def remap_vertices(targets: MorphTargets, mesh: Mesh, tolerance: float = TOLERANCE) -> MorphTargets:
    """Renumber the vertices of targets by where they are, for a mesh whose exporter changed their order.

    A vertex that the exporter split moves in all its copies. Of several vertices at one place the first becomes the
    first, and so on; where the mesh has fewer, the last ones are dropped.

    Raises
    ------
    MeshError : vertices of the targets are nowhere in the mesh; names them.
    """
    near = _near(targets, mesh, tolerance)
    by_place: list[list[int]] = [[] for _ in targets.numbers]
    for old, new in _pairs(near):
        by_place[old].append(new)
    places = {int(number): place for place, number in enumerate(targets.numbers)}
    return morph_targets_of(
        mesh, [_renumbered(state, [by_place[places[n]] for n in state.numbers.tolist()]) for state in targets.states]
    )


def _near(targets: MorphTargets, mesh: Mesh, tolerance: float) -> list[list[int]]:
    """Return the vertices of the mesh that are where each vertex of the targets was."""
    olds, news = _pairs_within(targets.positions, mesh.positions, tolerance)
    counts = np.bincount(olds, minlength=len(targets.numbers))
    if lost := targets.numbers[counts == 0].tolist():
        more = f" and {len(lost) - N_NAMED} others" if len(lost) > N_NAMED else ""
        raise MeshError(
            f"{len(lost)} of the {len(counts)} vertices that move are not in the mesh within {tolerance:g}: "
            f"{', '.join(map(str, lost[:N_NAMED]))}{more}; choose the mesh of theirs, or a larger tolerance"
        )
    every, ends = news.tolist(), np.cumsum(counts).tolist()
    return [every[end - count : end] for count, end in zip(counts.tolist(), ends, strict=True)]


def _pairs_within(points: Float32Array, others: Float32Array, distance: float) -> tuple[IndexArray, IndexArray]:
    """Return which points, shape (n, 3), lie within a distance of which others; two arrays of numbers, ascending.

    Space is cut into cells twice as wide as the distance, so that what is near a point lies in at most eight of them:
    those of the corners of a cube about it.
    """
    reach = max(1.001 * distance, NARROWEST)  # a little farther, so that rounding loses none
    cells = _cells_at(others, reach)
    order = np.argsort(cells, kind="stable")
    found = [np.empty(0, np.intp)]
    for corner in itertools.product((-reach, reach), repeat=3):
        asked = _cells_at(points + np.array(corner), reach)
        first, last = (np.searchsorted(cells[order], asked, side) for side in ("left", "right"))
        counts = last - first
        if counts.sum() > MOST_NEAR:
            raise MeshError(f"too many vertices are within {distance:g} of each other; choose a smaller tolerance")
        olds = np.repeat(np.arange(len(points)), counts)
        news = order[np.arange(len(olds)) + np.repeat(first - (np.cumsum(counts) - counts), counts)]
        near = np.linalg.norm(points[olds].astype(np.float64) - others[news], axis=1) <= distance
        found.append(olds[near] * len(others) + news[near])
    return np.divmod(np.unique(np.concatenate(found)), len(others))


def _cells_at(points: NDArray[np.floating], reach: float) -> Float64Array:
    """Return a number for the cell of each point; distant cells may share one, which costs time and nothing else."""
    x, y, z = np.floor(points.astype(np.float64) / (2 * reach)).T
    cells: Float64Array = CELL_STEPS[0] * x + CELL_STEPS[1] * y + CELL_STEPS[2] * z
    return cells


def _renumbered(state: Movestate, new: Sequence[Sequence[int]]) -> Movestate:
    rows = [row for row, numbers in enumerate(new) for _ in numbers]
    where = [number for numbers in new for number in numbers]
    return movestate_at(state.name, np.array(where, np.int64), state.offsets[rows], interactable=state.interactable)


def _pairs(near: Sequence[Sequence[int]]) -> Iterator[tuple[int, int]]:
    """Pair the places of old vertices with new ones; `near` says which new ones are where each old one was."""
    together: dict[tuple[int, ...], list[int]] = {}
    for old, found in enumerate(near):
        together.setdefault(tuple(found), []).append(old)
    taken: set[int] = set()
    for found, olds in together.items():
        for k, new in enumerate(found):
            if new not in taken:
                taken.add(new)
                yield olds[min(k, len(olds) - 1)], new


HEADS = Path(__file__).with_name("heads")
LARGEST = 64 << 20
"""Bytes of all its arrays at most."""
OFFSET_STEP = 1 / 4096
"""What offsets are stored in, decimetres."""
TONGUE_PART = 4
"""The number of the tongue among the parts of a stored head."""
TONGUE_MOVES: dict[str, tuple[float, float, float, float]] = {
    "tongueTipInterdental": (1.0, 0.3, -0.02, 0.02),
    "tongueTipAlveolar": (1.0, 0.25, 0.02, 0.01),
    "tongueFrontDorsalPalate": (0.75, 0.2, 0.12, 0.0),
    "tongueMidDorsalPalate": (0.5, 0.2, 0.12, 0.0),
    "tongueBackDorsalVelar": (0.2, 0.2, 0.12, 0.0),
    "tongueRetreat": (1.0, 1.0, 0.0, -0.1),
}
"""Where each movement of the tongue is largest, from 0 at its root to 1 at its tip; how far along it reaches; and by
how much it goes up and forward there, decimetres."""
OWN_LIFE = ("eye", "brow")
"""States whose names begin so are not interactable: the mouth does not push eyes and brows back."""


class Head(StrEnum):
    """A head that ships with the program."""

    WOMAN = "woman"
    MAN = "man"

    @property
    def path(self) -> Path:
        """Where it is stored."""
        return HEADS / f"{self}.npz"


USUAL_HEAD = Head.WOMAN


class Framing(StrEnum):
    """How much of a person is in the picture."""

    MOUTH = "mouth"
    FACE = "face"
    BUST = "bust"


def load_head(head: Head | str | os.PathLike[str] = USUAL_HEAD) -> MorphMesh:
    """Load a head and its movestates, whose names are those of `ARKIT` and `TONGUE`.

    Parameters
    ----------
    head : ``"woman"``, ``"man"``, or the path of a head that `tools.head` wrote.

    Raises
    ------
    MeshError : the program's own file is missing or damaged.
    """
    path = Head(str(head)).path if str(head) in {*Head} else Path(head)
    try:
        return _morph_mesh_of(read_npz(path, LARGEST), path.stem)
    except (OSError, ValueError, KeyError) as error:
        raise MeshError(f"{path.name}: the program's own head cannot be read; install the program again") from error


def _morph_mesh_of(arrays: dict[str, NDArray[Any]], name: str) -> MorphMesh:
    colours = (arrays["colours"] / 255).astype(np.float32)
    mesh = mesh_of(arrays["positions"], arrays["triangles"], name=name, colours=colours)
    names = [str(name) for name in arrays["names"]]
    states = [
        movestate_of(name, offsets * np.float32(OFFSET_STEP), interactable=not name.startswith(OWN_LIFE))
        for name, offsets in zip(names, arrays["offsets"], strict=True)
    ]
    return MorphMesh(mesh, (*states, *_tongue_of(mesh.positions, arrays["part"] == TONGUE_PART)))


def _tongue_of(points: Float32Array, part: BoolArray) -> Iterator[Movestate]:
    """Return the movestates of a tongue, whose root lies behind and whose tip in front."""
    depth = points[part, 2]
    along = (depth - depth.min()) / np.ptp(depth)
    for name, (place, reach, up, forward) in TONGUE_MOVES.items():
        offsets = np.zeros_like(points)
        offsets[part] = np.exp(-(((along - place) / reach) ** 2))[:, None] * np.array((0.0, up, forward))
        yield movestate_of(name, offsets)
