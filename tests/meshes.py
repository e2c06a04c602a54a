"""Meshes whose shape is known: a cube of edge 2 about the origin, in every format."""

import base64
import json

import numpy as np
from numpy.typing import NDArray

from phonemeengine.mouth.mesh import Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import movestate_of

CORNERS = np.array([(x, y, z) for z in (1, -1) for y in (1, -1) for x in (-1, 1)], np.float32)
"""Top left in front, top right, bottom left, bottom right; then the same behind."""
QUADS = ((0, 2, 3, 1), (5, 7, 6, 4), (4, 0, 1, 5), (2, 6, 7, 3), (1, 3, 7, 5), (4, 6, 2, 0))
"""Front, back, top, bottom, right, left; counter-clockwise as seen from outside."""
TRIANGLES = np.array([triangle for a, b, c, d in QUADS for triangle in ((a, b, c), (a, c, d))])


def cube() -> Mesh:
    """The cube."""
    return mesh_of(CORNERS, TRIANGLES, name="cube")


def moved_by(numbers: tuple[int, ...], offset: tuple[float, float, float]) -> NDArray[np.float32]:
    """Offsets of the cube's vertices, of which some move alike."""
    offsets = np.zeros((8, 3), np.float32)
    offsets[list(numbers)] = offset
    return offsets


def morph_mesh_of_cube() -> MorphMesh:
    """The cube, with a lid that rises, a side that widens, and a state that moves nothing."""
    return MorphMesh(
        cube(),
        (
            movestate_of("lid up", moved_by((0, 1, 4, 5), (0, 0.5, 0.25))),
            movestate_of("größer", moved_by((1, 3), (0.1, 0, 0))),
            movestate_of("still", moved_by((), (0, 0, 0))),
        ),
    )


def volume(mesh: Mesh) -> float:
    """The volume inside a mesh; negative if its triangles are seen from inside."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(float) for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


LIBRARY = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n"
CUBE_OBJ = (
    b"# a cube\nmtllib cube.mtl\no cube\n"
    + b"".join(b"v %d %d %d\n" % tuple(corner) for corner in CORNERS.astype(int).tolist())
    + b"vn 0 0 1\nvt 0 0\nusemtl red\nf 1/1/1 3/1/1 4/1/1 2/1/1\nusemtl blue\n"
    + b"".join(b"f %d %d %d %d\n" % tuple(n + 1 for n in quad) for quad in QUADS[1:])
)

_HEADER = (
    "xof 0302txt 0032\ntemplate Vector {\n <3D82AB5E-62DA-11cf-AB39-0020AF71E433>\n FLOAT x; FLOAT y; FLOAT z;\n}\n"
)
_MESH = (
    "Mesh cube {\n 8; // vertices\n"
    + ",\n".join(f" {x:g};{y:g};{-z:g};" for x, y, z in CORNERS.tolist())
    + ";\n 6;\n"
    + ",\n".join(f" 4;{d},{c},{b},{a};" for a, b, c, d in QUADS)
    + ";\n"
)
CUBE_X = (
    _HEADER
    + _MESH
    + " MeshMaterialList {\n 2;\n 6;\n 0,1,1,1,1,1;\n"
    + ' Material red {\n 1.0;0.0;0.0;1.0;;\n 5.0;\n 1;1;1;;\n 0;0;0;;\n TextureFilename { "skin.png"; }\n }\n'
    + " Material {\n 0.0;0.0;1.0;1.0;;\n 5.0;\n 1;1;1;;\n 0;0;0;;\n }\n }\n"
    + " MeshNormals {\n 6;\n 0;0;-1;, 0;0;1;, 0;1;0;, 0;-1;0;, 1;0;0;, -1;0;0;;\n 6;\n"
    + ",\n".join(f" 4;{k},{k},{k},{k};" for k in range(6))
    + ";\n }\n}\n"
).encode()
FRAMES_X = (
    _HEADER
    + "Material shared { 0;1;0;1;; 5; 1;1;1;; 0;0;0;; }\n"
    + "Frame outer {\n FrameTransformMatrix { 2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1;; }\n"
    + " Frame inner {\n  FrameTransformMatrix { 1,0,0,0, 0,1,0,0, 0,0,1,0, 10,0,5,1;; }\n  "
    + _MESH
    + " MeshMaterialList { 1; 6; 0,0,0,0,0,0; { shared } }\n }\n }\n}\n"
).encode()

_POINTS = CORNERS.astype("<f4").tobytes()
_INDICES = TRIANGLES.astype("<u2").tobytes()
_SPARSE = np.array([0, 1, 4, 5], "<u1").tobytes() + np.tile(np.array([0, 0.5, 0.25], "<f4"), 4).tobytes()
_INTERLEAVED = np.column_stack((moved_by((1, 3), (0.1, 0, 0)), np.full((8, 1), 7))).astype("<f4").tobytes()
_BUFFER = _POINTS + _INDICES + _SPARSE + _INTERLEAVED
_AT = (0, 96, 96 + 72, 96 + 72 + 4, 96 + 72 + 52)
GLTF: dict = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"children": [1], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [5, 0, 0]}],
    "meshes": [
        {
            "name": "cube",
            "extras": {"targetNames": ["lid up", "wide"]},
            "primitives": [
                {
                    "attributes": {"POSITION": 0},
                    "indices": 1,
                    "material": 0,
                    "targets": [{"POSITION": 2}, {"POSITION": 3}],
                }
            ],
        }
    ],
    "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        {
            "componentType": 5126,
            "count": 8,
            "type": "VEC3",
            "sparse": {"count": 4, "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 3}},
        },
        {"bufferView": 4, "componentType": 5126, "count": 8, "type": "VEC3"},
    ],
    "bufferViews": [
        {"buffer": 0, "byteOffset": _AT[0], "byteLength": 96},
        {"buffer": 0, "byteOffset": _AT[1], "byteLength": 72},
        {"buffer": 0, "byteOffset": _AT[2], "byteLength": 4},
        {"buffer": 0, "byteOffset": _AT[3], "byteLength": 48},
        {"buffer": 0, "byteOffset": _AT[4], "byteLength": 128, "byteStride": 16},
    ],
    "buffers": [
        {"byteLength": len(_BUFFER), "uri": "data:application/gltf;base64," + base64.b64encode(_BUFFER).decode()}
    ],
}
"""The cube, twice as large and 10 to the right, with a sparse and an interleaved morph target."""
GLTF_TEXT = json.dumps(GLTF).encode()


def format_obj(mesh: Mesh) -> bytes:
    """The positions, normals and triangles of a mesh as an .obj file."""
    lines = [f"o {mesh.name or 'mesh'}"]
    lines += [f"v {x!s} {y!s} {z!s}" for x, y, z in mesh.positions]
    lines += [f"vn {x!s} {y!s} {z!s}" for x, y, z in mesh.normals]
    lines += [f"f {a}//{a} {b}//{b} {c}//{c}" for a, b, c in (mesh.triangles + np.uint32(1)).tolist()]
    return "\n".join([*lines, ""]).encode()
