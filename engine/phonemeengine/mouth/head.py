"""The heads that ship with the program, a woman's and a man's: CC0, with the 52 blend shapes of ARKit.

Six more move the tongue as `TONGUE` names them; they are made of where its vertices lie when a head is loaded.
The origin is where a head turns on its neck; a unit is a decimetre. Made by `python -m tools.head`.
"""

import os
from collections.abc import Iterator
from enum import StrEnum
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import Movestate, movestate_of
from phonemeengine.storage.npz import read_npz

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
