"""The heads that ship with the program, a woman's and a man's: CC0, with the 52 blend shapes of ARKit.

The origin is where a head turns on its neck; a unit is a decimetre. Made by `python -m tools.head`.
"""

import os
from enum import StrEnum
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import movestate_of
from phonemeengine.storage.npz import read_npz

HEADS = Path(__file__).with_name("heads")
LARGEST = 64 << 20
"""Bytes of all its arrays at most."""
OFFSET_STEP = 1 / 4096
"""What offsets are stored in, decimetres."""
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
    """Load a head and its movestates, whose names are those of ARKit.

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
    return MorphMesh(
        mesh,
        tuple(
            movestate_of(name, offsets * np.float32(OFFSET_STEP), interactable=not name.startswith(OWN_LIFE))
            for name, offsets in zip(names, arrays["offsets"], strict=True)
        ),
    )
