"""The head that ships with the program: CC0, with the 52 blend shapes of ARKit.

Its origin is where it turns on the neck; a unit is a decimetre. Made by `python -m tools.head`.
"""

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import movestate_of
from phonemeengine.storage.npz import read_npz

HEAD = Path(__file__).with_name("head.npz")
LARGEST = 64 << 20
"""Bytes of all its arrays at most."""
OWN_LIFE = ("eye", "brow")
"""States whose names begin so are not interactable: the mouth does not push eyes and brows back."""


def load_head(path: str | os.PathLike[str] = HEAD) -> MorphMesh:
    """Load the head and its movestates, whose names are those of ARKit.

    Raises
    ------
    MeshError : the program's own file is missing or damaged.
    """
    path = Path(path)
    try:
        return _morph_mesh_of(read_npz(path, LARGEST))
    except (OSError, ValueError, KeyError) as error:
        raise MeshError(f"{path.name}: the program's own head cannot be read; install the program again") from error


def _morph_mesh_of(arrays: dict[str, NDArray[Any]]) -> MorphMesh:
    colours = (arrays["colours"] / 255).astype(np.float32)
    mesh = mesh_of(arrays["positions"], arrays["triangles"], name="head", colours=colours)
    names = [str(name) for name in arrays["names"]]
    return MorphMesh(
        mesh,
        tuple(
            movestate_of(name, offsets.astype(np.float32), interactable=not name.startswith(OWN_LIFE))
            for name, offsets in zip(names, arrays["offsets"], strict=True)
        ),
    )
