"""Avatars as VRM 0 and 1 have them, made of the head that ships with the program."""

import json
import struct
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.mouth.files.gltf_document import chunks_of, document_of, glb_of
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.morph_mesh import load_head

HIPS, HEAD, JAW, LEFT_EYE, RIGHT_EYE = range(1, 6)
"""Nodes; node 0 has the mesh."""
HEIGHT = 1.5
"""Where the head's bone is above the ground."""
Vector = tuple[float, float, float]


def eye_at(side: int) -> Vector:
    """Where the left (1) or right (-1) eye of the head is: amid what its look downwards moves."""
    head = load_head()
    state = next(s for s in head.states if s.name == ("eyeLookDownLeft" if side > 0 else "eyeLookDownRight"))
    x, y, z = head.mesh.positions[state.numbers].mean(axis=0).tolist()
    return x, y, z


def avatar(
    version: int,
    *,
    rename: Mapping[str, str] | None = None,
    only: tuple[str, ...] | None = None,
    picture: bytes | None = None,
    filling: int = 0,
    change: Any = None,
) -> bytes:
    """Give a VRM of the head with bones for head, jaw and eyes, in metres above the ground.

    Parameters
    ----------
    version : 0 faces along -z, 1 along z.
    rename : what its shapes are called; names that are not in it stay.
    only : the shapes that it keeps; all, where it is None.
    picture : a texture of its skin.
    filling : bytes of something else that it carries.
    change : is given the document before it is written.
    """
    text, binary = chunks_of(format_glb(load_head()))
    document = document_of(text, 1 << 26)
    parts = [bytes(binary)]
    head = load_head()
    points = head.mesh.positions
    primitive = document["meshes"][0]["primitives"][0]
    names: list[str] = document["meshes"][0]["extras"]["targetNames"]
    kept = [k for k, name in enumerate(names) if only is None or name in only]
    primitive["targets"] = [primitive["targets"][k] for k in kept]
    shown = [(rename or {}).get(names[k], names[k]) for k in kept]
    document["meshes"][0]["extras"]["targetNames"] = shown
    document["meshes"][0]["weights"] = [0.0] * len(kept)
    eyes = [np.linalg.norm(points - np.array(eye_at(side)), axis=1) < 0.18 for side in (1, -1)]
    opening = next(state for state in head.states if state.name == "jawOpen")
    jaw = np.zeros(len(points))
    jaw[opening.numbers] = np.linalg.norm(opening.offsets, axis=1) / opening.reach
    weights = np.zeros((len(points), 4), np.float32)
    weights[:, 1] = np.where(eyes[0] | eyes[1], 0, jaw)
    weights[:, 2], weights[:, 3] = eyes
    weights[:, 0] = 1 - weights[:, 1:].sum(axis=1)
    bones = np.tile(np.array([0, 1, 2, 3], np.uint8), (len(points), 1))
    turn = np.diag([1.0, 1, 1, 1]) if version else np.diag([-1.0, 1, -1, 1])
    joints = [(0.0, 0.0, 0.0), (0.0, -0.1, 0.1), eye_at(1), eye_at(-1)]
    inverses = np.array([_moved([-x for x in joint]) @ turn for joint in joints], "<f4").transpose(0, 2, 1)
    accessors = {
        "JOINTS_0": _append(document, parts, bones, 5121, "VEC4"),
        "WEIGHTS_0": _append(document, parts, weights, 5126, "VEC4"),
        "TEXCOORD_0": _append(document, parts, _places(points), 5126, "VEC2"),
    }
    primitive["attributes"] |= accessors
    turned = turn[:3, :3]
    for accessor in (primitive["attributes"]["POSITION"], primitive["attributes"]["NORMAL"], *_targets(primitive)):
        _turn(document, parts, accessor, turned)
    document["skins"] = [
        {
            "joints": [HEAD, JAW, LEFT_EYE, RIGHT_EYE],
            "inverseBindMatrices": _append(document, parts, inverses.reshape(-1, 16), 5126, "MAT4"),
        }
    ]
    document["nodes"] = [
        {"mesh": 0, "skin": 0},
        {"name": "hips", "children": [HEAD], "translation": [0, 1.0, 0]},
        {
            "name": "C_head",
            "children": [JAW, LEFT_EYE, RIGHT_EYE],
            "translation": [0, HEIGHT - 1.0, 0],
            "rotation": [0, 0, 0, 1] if version else [0, 1, 0, 0],
        },
        *({"name": f"b{k}", "translation": list(joint)} for k, joint in enumerate(joints[1:])),
    ]
    document["scenes"] = [{"nodes": [0, HIPS]}]
    document["extensions"] = _extension(version, shown)
    document["extensionsUsed"] = [*document["extensions"]]
    if picture is not None:
        _paint(document, parts, picture)
    if filling:
        _append(document, parts, np.zeros(filling, np.uint8).reshape(-1, 1), 5121, "SCALAR")
    document["buffers"] = [{"byteLength": sum(map(len, parts))}]
    if change is not None:
        change(document)
    return glb_of(document, parts)


def png(width: int, height: int, colour: tuple[int, int, int] = (180, 120, 90)) -> bytes:
    """Give a picture of one colour."""
    rows = zlib.compress(b"".join(b"\0" + bytes(colour) * width for _ in range(height)), 1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", rows), (b"IEND", b""))
    parts = (struct.pack(">I", len(c)) + k + c + struct.pack(">I", zlib.crc32(k + c)) for k, c in chunks)
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _extension(version: int, names: list[str]) -> dict[str, Any]:
    bones = {"hips": HIPS, "head": HEAD, "jaw": JAW, "leftEye": LEFT_EYE, "rightEye": RIGHT_EYE}
    moves = {"A": {0: 1.0}, "I": {1: 0.5}, "Blink_L": {2: 1.0}}
    if version:
        called = {"A": "aa", "I": "ih", "Blink_L": "blinkLeft"}
        preset = {
            called[name]: {"morphTargetBinds": [{"node": 0, "index": k, "weight": w} for k, w in binds.items()]}
            for name, binds in moves.items()
        }
        human = {name: {"node": node} for name, node in bones.items()}
        return {
            "VRMC_vrm": {"specVersion": "1.0", "humanoid": {"humanBones": human}, "expressions": {"preset": preset}}
        }
    groups = [
        {
            "name": name,
            "presetName": name.lower(),
            "binds": [{"mesh": 0, "index": k, "weight": 100 * weight} for k, weight in binds.items()],
        }
        for name, binds in moves.items()
    ]
    listed = [{"bone": name, "node": node} for name, node in bones.items()]
    return {"VRM": {"humanoid": {"humanBones": listed}, "blendShapeMaster": {"blendShapeGroups": groups}}}


def _paint(document: dict[str, Any], parts: list[bytes], picture: bytes) -> None:
    document["bufferViews"].append({"buffer": 0, "byteOffset": sum(map(len, parts)), "byteLength": len(picture)})
    parts.append(picture + b"\0" * (-len(picture) % 4))
    document["images"] = [{"name": "skin", "bufferView": len(document["bufferViews"]) - 1, "mimeType": "image/png"}]
    document["textures"] = [{"source": 0}]
    document["materials"] = [
        {
            "name": "skin",
            "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 0.4},
            "alphaMode": "MASK",
            "doubleSided": True,
        }
    ]


def _places(points: NDArray[np.float32]) -> NDArray[np.float32]:
    low, high = points.min(axis=0), points.max(axis=0)
    return ((points - low) / (high - low))[:, :2].astype(np.float32)


def _targets(primitive: dict[str, Any]) -> list[int]:
    return [target["POSITION"] for target in primitive["targets"]]


def _turn(document: dict[str, Any], parts: list[bytes], accessor: int, turn: NDArray[Any]) -> None:
    view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
    old = np.frombuffer(parts[0], "<f4", view["byteLength"] // 4, view["byteOffset"]).reshape(-1, 3)
    document["accessors"][accessor] = document["accessors"][_append(document, parts, old @ turn, 5126, "VEC3")]


def _append(document: dict[str, Any], parts: list[bytes], array: NDArray[Any], kind: int, form: str) -> int:
    content = np.ascontiguousarray(array, {5121: "u1", 5126: "<f4"}[kind]).tobytes()
    document["bufferViews"].append({"buffer": 0, "byteOffset": sum(map(len, parts)), "byteLength": len(content)})
    parts.append(content + b"\0" * (-len(content) % 4))
    entry = {"bufferView": len(document["bufferViews"]) - 1, "componentType": kind, "type": form, "count": len(array)}
    document["accessors"].append(json.loads(json.dumps(entry)))
    return len(document["accessors"]) - 1


def _moved(offset: Any) -> NDArray[np.float64]:
    made = np.eye(4)
    made[:3, 3] = offset
    return made
