"""Writes .glb files: one mesh, its colours, and its movestates as morph targets."""

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf import NUMBER, TRIANGLES
from phonemeengine.mouth.files.gltf_document import LARGEST_BUFFER, Table, glb_of
from phonemeengine.mouth.files.gltf_materials import linear_of
from phonemeengine.mouth.mesh import Mesh
from phonemeengine.mouth.morph_mesh import MorphMesh, MorphTargets
from phonemeengine.mouth.movestate import Movestate

POINTS = 0
FLOAT, WHOLE = 5126, 5125
VERTICES, CORNERS = 34962, 34963
GENERATOR = "PhonemeAnalyser"


def format_glb(morph_mesh: MorphMesh, *, sparse: bool = False) -> bytes:
    """Write a mesh and its movestates as a .glb file; each movestate is a morph target of its name.

    Parameters
    ----------
    sparse : whether targets hold the vertices alone that move, which makes a quarter of the head that ships.

    Raises
    ------
    MeshError : the file would be larger than any that is read.
    """
    mesh, buffer = morph_mesh.mesh, _Buffer()
    attributes = {
        "POSITION": buffer.append(mesh.positions, bounded=True),
        "NORMAL": buffer.append(mesh.normals),
        "COLOR_0": buffer.append(linear_of(mesh.colours)),
    }
    primitive: Table = {"attributes": attributes, "mode": TRIANGLES, "material": 0}
    if len(mesh.triangles):
        primitive["indices"] = buffer.append(mesh.triangles.reshape(-1, 1))
    else:
        primitive["mode"] = POINTS
    _push_targets(primitive, morph_mesh.states, len(mesh), buffer, sparse=sparse)
    return _glb(primitive, morph_mesh.states, mesh, buffer)


def format_points(targets: MorphTargets) -> bytes:
    """Write the vertices of a face as points with morph targets, where its mesh is not known.

    The attribute ``_VERTEX`` keeps their numbers, so that reading the file gives the same movestates.

    Raises
    ------
    MeshError : no vertex moves, or the file would be larger than any that is read.
    """
    if not len(targets.numbers):
        raise MeshError("no vertex moves, so there is nothing to show; name its mesh with --mesh")
    buffer = _Buffer()
    attributes = {
        "POSITION": buffer.append(targets.positions, bounded=True),
        NUMBER: buffer.append(targets.numbers.astype(np.float32).reshape(-1, 1)),
    }
    primitive: Table = {"attributes": attributes, "mode": POINTS}
    within = [
        Movestate(s.name, np.searchsorted(targets.numbers, s.numbers).astype(np.uint32), s.offsets)
        for s in targets.states
    ]
    _push_targets(primitive, within, len(targets.numbers), buffer)
    return _glb(primitive, targets.states, None, buffer)


class _Buffer:
    """Gathers arrays, and the tables that say where they are."""

    def __init__(self) -> None:
        self.views: list[Table] = []
        self.accessors: list[Table] = []
        self.parts: list[bytes] = []
        self.size = 0

    def append(self, array: NDArray[np.generic], *, bounded: bool = False) -> int:
        """Append an array of float32 or uint32, shape (n, width); gives its accessor's number."""
        whole = array.dtype.kind == "u"
        view = {"bufferView": self._view(array, target=CORNERS if whole else VERTICES)}
        return self._accessor(array, view, bounded=bounded)

    def append_sparse(self, offsets: Float32Array) -> int:
        """Append vectors of which most are 0, shape (n, 3): the others, and their numbers."""
        moved = np.flatnonzero(offsets.any(axis=1))
        if not len(moved):
            return self._accessor(offsets, {}, bounded=True)
        indices = {"bufferView": self._view(moved.astype(np.uint32)), "componentType": WHOLE}
        sparse = {"count": len(moved), "indices": indices, "values": {"bufferView": self._view(offsets[moved])}}
        return self._accessor(offsets, {"sparse": sparse}, bounded=True)

    def _view(self, array: NDArray[np.generic], **more: int) -> int:
        content = array.astype("<u4" if array.dtype.kind == "u" else "<f4").tobytes()
        if self.size + len(content) > LARGEST_BUFFER:
            raise MeshError(f"the .glb would be larger than {LARGEST_BUFFER >> 20} MB; leave out some movestates")
        self.views.append({"buffer": 0, "byteOffset": self.size, "byteLength": len(content), **more})
        self.parts.append(content)
        self.size += len(content)
        return len(self.views) - 1

    def _accessor(self, array: NDArray[np.generic], source: Table, *, bounded: bool) -> int:
        accessor: Table = {
            **source,
            "componentType": WHOLE if array.dtype.kind == "u" else FLOAT,
            "count": len(array),
            "type": "VEC3" if array.shape[1] == 3 else "SCALAR",
        }
        if bounded:
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def _push_targets(
    primitive: Table,
    states: tuple[Movestate, ...] | list[Movestate],
    n: int,
    buffer: _Buffer,
    *,
    sparse: bool = False,
) -> None:
    if states:
        dense = (_dense(state, n) for state in states)
        places = (buffer.append_sparse(of) if sparse else buffer.append(of, bounded=True) for of in dense)
        primitive["targets"] = [{"POSITION": place} for place in places]


def _dense(state: Movestate, n: int) -> Float32Array:
    offsets = np.zeros((n, 3), np.float32)
    offsets[state.numbers] = state.offsets
    return offsets


def _glb(primitive: Table, states: tuple[Movestate, ...], mesh: Mesh | None, buffer: _Buffer) -> bytes:
    shape: Table = {"primitives": [primitive], "extras": {"targetNames": [state.name for state in states]}}
    if states:
        shape["weights"] = [0.0] * len(states)
    if mesh is not None and mesh.name:
        shape["name"] = mesh.name
    root: Table = {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [shape],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": buffer.size}],
    }
    if mesh is not None:
        root["materials"] = [
            {"name": "face", "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.7}}
        ]
    return glb_of(root, buffer.parts)
