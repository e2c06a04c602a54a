# SPDX-License-Identifier: MIT
"""Axes: in files y points upwards and z to the viewer; in Blender z points upwards and the viewer is at -y.

Importers of glTF turn the vertices of a mesh. That of OBJ leaves them, and turns the object instead.
"""

from enum import StrEnum

from phonemeengine.arrays import Float32Array


class Axes(StrEnum):
    """How the vertices of a mesh in Blender lie."""

    Z_UP = "Z_UP"
    Y_UP = "Y_UP"


def to_file(vectors: Float32Array, axes: Axes) -> Float32Array:
    """Return vectors of a mesh, shape (n, 3), as they are in a file."""
    return _turned(vectors, (0, 2, 1), 2) if axes is Axes.Z_UP else vectors


def to_mesh(vectors: Float32Array, axes: Axes) -> Float32Array:
    """Return vectors of a file, shape (n, 3), as they are in a mesh."""
    return _turned(vectors, (0, 2, 1), 1) if axes is Axes.Z_UP else vectors


def _turned(vectors: Float32Array, order: tuple[int, int, int], negated: int) -> Float32Array:
    turned = vectors[:, order]
    turned[:, negated] *= -1
    return turned
