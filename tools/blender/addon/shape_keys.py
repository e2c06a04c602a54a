# SPDX-License-Identifier: MIT
"""Movestates as shape keys of a mesh, and back."""

from contextlib import suppress
from typing import Any

import bpy
import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphTargets, matched, morph_targets_of
from phonemeengine.mouth.movestate import movestate_of

from .axes import Axes, to_file, to_mesh

LONGEST_NAME = 63
"""Bytes of a shape key's name in Blender."""
UPWARDS = 0.7
"""How far an axis of length 1 rises if it counts as pointing upwards."""


def names_of_keys(face: bpy.types.Object) -> tuple[str, ...]:
    """Return the names of a face's shape keys, but that of rest."""
    keys = face.data.shape_keys
    return () if keys is None else tuple(key.name for key in keys.key_blocks if key != keys.reference_key)


def axes_of(face: bpy.types.Object) -> Axes:
    """Return how the vertices of a face lie: y upwards if the object is turned so that its y axis points upwards."""
    _, rotation, _ = face.matrix_world.decompose()
    return Axes.Y_UP if rotation.to_matrix()[2][1] > UPWARDS else Axes.Z_UP


def add_movestates(face: bpy.types.Object, targets: MorphTargets, tolerance: float) -> None:
    """Add a shape key for each movestate; one of the same name moves anew.

    Raises
    ------
    MeshError : they belong to another mesh, or Blender cannot have such a name; the face stays as it is.
    """
    rest = _rest_of(face)
    axes, fitting = _fitted(targets, rest, tolerance)
    _check_names(face, fitting)
    if face.data.shape_keys is None:
        face.shape_key_add(name="Basis", from_mix=False)
    keys = face.data.shape_keys
    for state in fitting.states:
        key = keys.key_blocks.get(state.name) or _added_key(face, state.name)
        key.relative_key = keys.reference_key
        moved = rest.copy()
        moved[state.numbers] += to_mesh(state.offsets, axes)
        key.data.foreach_set("co", moved.ravel())
    face.data.update()


def movestates_of(face: bpy.types.Object, axes: Axes) -> MorphTargets:
    """Return a face's shape keys as movestates.

    Raises
    ------
    MeshError : there are none, or a name cannot stand in a file.
    """
    names = names_of_keys(face)
    if not names:
        raise MeshError(f"{face.name} has no shape keys; add some, or import them")
    blocks = face.data.shape_keys.key_blocks
    states = [movestate_of(name, to_file(_offsets_of(face, blocks[name]), axes)) for name in names]
    return morph_targets_of(mesh_of(to_file(_rest_of(face), axes)), states)


def _fitted(targets: MorphTargets, rest: Float32Array, tolerance: float) -> tuple[Axes, MorphTargets]:
    """Return the axes in which targets fit a mesh, and the targets with its numbers."""
    refused: list[MeshError] = []
    for axes in Axes:
        try:
            return axes, matched(targets, mesh_of(to_file(rest, axes)), tolerance)
        except MeshError as error:
            refused.append(error)
    raise refused[0]


def _added_key(face: bpy.types.Object, name: str) -> bpy.types.ShapeKey:
    key = face.shape_key_add(name=name, from_mix=False)
    key.value = 0.0  # since Blender 5.0 a new one is wholly shown
    return key


def _check_names(face: bpy.types.Object, targets: MorphTargets) -> None:
    keys = face.data.shape_keys
    rest = "Basis" if keys is None else keys.reference_key.name
    for state in targets.states:
        if len(state.name.encode()) > LONGEST_NAME:
            raise MeshError(
                f"a shape key's name has at most {LONGEST_NAME} bytes, movestate {state.name[:40]!r}... has "
                f"{len(state.name.encode())}; rename it"
            )
        if state.name == rest:
            raise MeshError(f"movestate {state.name!r} is called like the shape at rest; rename one")


def _rest_of(face: bpy.types.Object) -> Float32Array:
    """Return where the vertices are at rest, shape (n, 3)."""
    keys = face.data.shape_keys
    return _positions(face.data.vertices if keys is None else keys.reference_key.data)


def _offsets_of(face: bpy.types.Object, key: bpy.types.ShapeKey) -> Float32Array:
    """Return how far a shape key moves each vertex, shape (n, 3), as its vertex group has it."""
    offsets = _positions(key.data) - _positions(key.relative_key.data)
    group = face.vertex_groups.get(key.vertex_group) if key.vertex_group else None
    if group is not None:
        offsets *= np.array([_share(group, number) for number in range(len(offsets))], np.float32)[:, np.newaxis]
    return offsets


def _share(group: Any, number: int) -> float:
    with suppress(RuntimeError):  # that is how Blender says that a vertex is not in a group
        return float(group.weight(number))
    return 0.0


def _positions(points: Any) -> Float32Array:
    positions = np.empty(3 * len(points), np.float32)
    points.foreach_get("co", positions)
    return positions.reshape(-1, 3)
