"""Small faces as GLB files: a triangle with morph targets."""

import json
import struct
from collections.abc import Sequence

import numpy as np


def face_with_targets(names: Sequence[str] | None, n_targets: int | None = None) -> bytes:
    """Give a GLB of one triangle; each target moves it by its number upwards.

    None gives targets without names.
    """
    n_targets = len(names or ()) if n_targets is None else n_targets
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")
    blocks = [corners, *(np.full((3, 3), (0, k + 1, 0), "<f4") for k in range(n_targets))]
    views = [{"buffer": 0, "byteOffset": 36 * k, "byteLength": 36} for k in range(len(blocks))]
    accessors = [
        {
            "bufferView": k,
            "componentType": 5126,
            "count": 3,
            "type": "VEC3",
            "min": block.min(0).tolist(),
            "max": block.max(0).tolist(),
        }
        for k, block in enumerate(blocks)
    ]
    mesh = {
        "primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": k + 1} for k in range(n_targets)]}],
        "weights": [0.0] * n_targets,
    }
    if names is not None:
        mesh["extras"] = {"targetNames": list(names)}
    document = {
        "asset": {"version": "2.0", "generator": "tests"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "head", "mesh": 0}],
        "meshes": [mesh],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": 36 * len(blocks)}],
    }
    return glb_of(document, b"".join(block.tobytes() for block in blocks))


def glb_of(document: object, binary: bytes) -> bytes:
    """Put a document and its bytes into a GLB."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks
