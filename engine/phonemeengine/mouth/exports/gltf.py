"""A face's GLB with an animation: a file, or the program's own head, with movement added.

Its morph weights say the speech and blink, its nodes turn the head, and its bones jaw and eyes.

Everything else in the file stays what it is. See section 3.11 of the glTF 2.0 specification.
"""

from collections.abc import Sequence
from dataclasses import replace
from mimetypes import guess_type
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import ExportError, MeshError
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import BONE
from phonemeengine.mouth.exports.export import Export
from phonemeengine.mouth.files import gltf_document
from phonemeengine.mouth.files.gltf_writing import GENERATOR, format_glb
from phonemeengine.mouth.files.io import MESH_SUFFIXES, files_beside, load_morph_mesh
from phonemeengine.mouth.files.skin import bone_angles
from phonemeengine.mouth.files.vrm import expressions_of, faces_back
from phonemeengine.mouth.morph_mesh import USUAL_HEAD, Head, load_head
from phonemeengine.mouth.movestate import combinations_of, combined
from phonemeengine.storage.files import printable_name, read_file

BINARY = (".glb", ".vrm")
"""Endings of files that are GLB as they are."""
LARGEST_FILE, LARGEST_JSON = 1 << 30, 64 << 20
"""Bytes; scenes with much else in them are welcome."""


class Glb:
    """A GLB file in memory.

    Parameters
    ----------
    content : the file as it is.
    name : of the file, for people.

    Raises
    ------
    ExportError : it is no GLB, is damaged, or has its bytes elsewhere.
    """

    def __init__(self, content: bytes, name: str) -> None:
        self._name = name
        if not content.startswith(gltf_document.MAGIC):
            raise ExportError(
                f"{name}: this is no face that can be moved; name a .glb, .vrm or .gltf (glTF 2.0), .obj or .x"
            )
        try:
            text, binary = gltf_document.chunks_of(content)
            self.document: gltf_document.Table = gltf_document.document_of(text, LARGEST_JSON)
        except MeshError as error:
            raise ExportError(f"{name}: {error}") from error
        self._check_buffers(bool(binary))
        self._parts = [bytes(binary)]
        self._length = len(binary)

    def list_of(self, name: str) -> list[Any]:
        """Return a list of the document, such as ``accessors``; it is made where it is missing."""
        found: list[Any] = self.document.setdefault(name, [])
        if not isinstance(found, list):
            raise self._refusal(f"its {name} are no list")
        return found

    def append(self, content: bytes) -> int:
        """Add bytes to the buffer, and give the place where they begin."""
        padding = -self._length % 4
        start = self._length + padding
        self._parts += [b"\0" * padding, content]
        self._length = start + len(content)
        return start

    def content(self) -> bytes:
        """Return the whole file."""
        self.document["buffers"][0]["byteLength"] = self._length
        return gltf_document.glb_of(self.document, self._parts)

    def _check_buffers(self, any_bytes: bool) -> None:
        buffers = self.list_of("buffers")
        if any_bytes and not (buffers and isinstance(buffers[0], dict) and "uri" not in buffers[0]):
            raise self._refusal("its first buffer lies outside it")
        if not any_bytes and buffers:
            raise self._refusal("its buffers lie outside it")
        if not buffers:
            buffers.append({"byteLength": 0})

    def _refusal(self, fault: str) -> ExportError:
        return ExportError(f"{self._name}: {fault}; save the face as one GLB file with everything in it")


def shipped_glb(head: Head = USUAL_HEAD) -> Glb:
    """Return a head that ships with the program, with its movestates as morph targets."""
    return Glb(format_glb(load_head(head), sparse=True), head.path.name)


def read_face(path: Path) -> Glb:
    """Read a face: a `Head` by its name, .glb, .gltf with what is beside it, or a mesh with morph targets in it.

    Of a .glb and a .gltf everything stays, such as skeletons and pictures.

    Raises
    ------
    ExportError : it cannot be read, is damaged, or has no morph targets.
    """
    if str(path) in {*Head}:
        return shipped_glb(Head(str(path)))
    name, kind = printable_name(path), path.suffix.lower()
    try:
        if kind == ".gltf":
            content = packed(read_file(path, LARGEST_FILE, "a face", ExportError), files_beside(path.parent))
        elif kind in MESH_SUFFIXES and kind not in BINARY:
            content = _glb_of_mesh(path)
        else:
            content = read_file(path, LARGEST_FILE, "a face", ExportError)
    except MeshError as error:
        words = str(error)
        raise ExportError(words if words.startswith(name) else f"{name}: {words}") from error
    return Glb(content, name)


def packed(content: bytes, beside: gltf_document.Beside) -> bytes:
    """Return a .gltf as a .glb: its buffers and pictures in one block of bytes.

    Parameters
    ----------
    beside : finds the files that it names.

    Raises
    ------
    MeshError : it is no glTF, or what it names is not there.
    """
    document, root = gltf_document.Document(content, beside), gltf_document.document_of(content, LARGEST_JSON)
    parts: list[bytes] = []
    begins = [_appended(parts, bytes(document.buffer(k))) for k in range(len(document.list_of("buffers")))]
    views = [_moved(view, begins) for view in document.list_of("bufferViews")]
    for image in gltf_document.tables_of(root, "images"):
        uri = unquote(str(image.get("uri", "")))
        if uri and not uri.startswith("data:") and (picture := beside(uri)) is not None:
            views.append({"buffer": 0, "byteOffset": _appended(parts, picture), "byteLength": len(picture)})
            image |= {"bufferView": len(views) - 1, "mimeType": guess_type(uri)[0] or "image/png"}
            del image["uri"]
    if parts:
        root |= {"buffers": [{"byteLength": sum(map(len, parts))}], "bufferViews": views}
    return gltf_document.glb_of(root, parts)


def _appended(parts: list[bytes], content: bytes) -> int:
    """Add bytes at a place that is a multiple of four, which is returned."""
    parts.append(bytes(-sum(map(len, parts)) % 4))
    start = sum(map(len, parts))
    parts.append(content)
    return start


def _moved(view: gltf_document.Table, begins: list[int]) -> gltf_document.Table:
    """Return a view of a buffer as one of the buffer that holds all."""
    buffer = gltf_document.whole_of(view, "buffer")
    if buffer >= len(begins):
        raise MeshError(f"it names number {buffer} of its buffers, and there are {len(begins)}; export it again")
    return view | {"buffer": 0, "byteOffset": begins[buffer] + gltf_document.whole_of(view, "byteOffset", 0)}


def _glb_of_mesh(path: Path) -> bytes:
    mesh = load_morph_mesh(path)
    if not mesh.states:
        raise MeshError(
            "there are no morph targets in it; put them into one file first, with: phonemeanalyser movestates export "
            f"{printable_name(path)} TARGET... -o face.glb"
        )
    return format_glb(mesh)


FLOAT = 5126
"""glTF's code for float32."""
FORMS = {"weights": "SCALAR", "rotation": "VEC4", "translation": "VEC3"}
"""What values of each property are."""
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
"""Numbers of a value, by its form."""
NAME, EXTRAS = "speech", {"generator": GENERATOR}
"""The animation that is added, and what it tells of itself."""


def owns(content: bytes) -> bool:
    """Return whether the content of a file is a GLB to which a movement was added here, the last one in it."""
    try:
        newest = gltf_document.document_of(gltf_document.chunks_of(content)[0], LARGEST_JSON)["animations"][-1]
        return bool(newest["extras"] == EXTRAS)
    except (MeshError, TypeError, KeyError, IndexError):
        return False


def write(export: Export) -> bytes:
    """Return the GLB with one more animation.

    Raises
    ------
    ExportError : the mesh cannot be read, or has none of the table's movestates.
    """
    glb = shipped_glb() if export.mesh is None else read_face(export.mesh)
    faces = _faces_of(glb.document)
    known = {name for _, names in faces for name in names}
    face = (export.mesh or USUAL_HEAD.path).name
    try:
        document = gltf_document.Document(glb.content(), lambda _name: None)
        animation = _of_targets(export.face_animation, document, faces)
        movestates = animation.movestates
        columns = dict(zip(movestates, animation.weights.T, strict=True))
        bones = bone_angles(document, _for_bones(columns, known))
        back = faces_back(document)
    except MeshError as error:
        raise ExportError(f"{face}: {error}") from error
    if not (bones or known & set(movestates)):
        wanted = ", ".join(movestates[:3])
        raise ExportError(
            f"{face}: it has no morph target of the table {export.table.name!r} ({wanted}, ...); choose "
            "a table for its names with --table, or name the targets in your modelling program"
        )
    samplers = _Samplers(glb, animation)
    _move(faces, animation, samplers)
    meshes = [number for number, node in enumerate(document.list_of("nodes")) if "mesh" in node]
    _turn([node for node, _ in faces] or meshes, animation, bones, samplers, back=back)
    glb.list_of("animations").append({"name": NAME, **samplers.lists(), "extras": EXTRAS})
    return glb.content()


def _of_targets(
    animation: Animation, document: gltf_document.Document, faces: Sequence[tuple[int, Sequence[str]]]
) -> Animation:
    """Return an animation of morph targets: an expression of an avatar is those that it moves."""
    expressions = expressions_of(document)
    if not expressions:
        return animation
    nodes = document.list_of("nodes")
    names = {nodes[node]["mesh"]: targets for node, targets in faces}
    own = {name for targets in names.values() for name in targets}
    weights: dict[str, Float32Array] = {}
    for name, column in zip(animation.movestates, animation.weights.T, strict=True):
        binds = expressions.get(name, ()) if name not in own else ()
        shares = {names[b.mesh][b.target]: b.weight for b in binds if b.target < len(names.get(b.mesh, ()))}
        for target, share in (shares or {name: 1.0}).items():
            weights[target] = weights.get(target, np.float32(0)) + np.float32(share) * column
    return replace(animation, movestates=tuple(weights), weights=np.stack([*weights.values()], axis=1))


def _for_bones(weights: dict[str, Float32Array], targets: set[str]) -> dict[str, Float32Array]:
    """Return weights by movestates, which also turn bones where no morph target has their name."""
    turned = {f"{BONE}{name}": column for name, column in weights.items() if name not in targets}
    return turned | weights


class _Samplers:
    """What moves with time: samplers, each with the channel that says what it moves."""

    def __init__(self, glb: Glb, animation: Animation) -> None:
        self.document = glb.document
        self._glb = glb
        times = animation.times.astype("<f4")
        limits = {"min": [float(times[0])], "max": [float(times[-1])]}
        self._input = _accessor(glb, times, "SCALAR", limits)
        self._samplers: list[dict[str, Any]] = []
        self._channels: list[dict[str, Any]] = []

    def add_channel(self, node: int, path: str, values: NDArray[Any]) -> None:
        """Have a property of a node, such as ``rotation``, take values one after the other."""
        output = _accessor(self._glb, values.astype("<f4"), FORMS[path], {})
        self._channels.append({"sampler": len(self._samplers), "target": {"node": node, "path": path}})
        self._samplers.append({"input": self._input, "output": output, "interpolation": "LINEAR"})

    def lists(self) -> dict[str, Any]:
        """Return both as an animation has them."""
        return {"samplers": self._samplers, "channels": self._channels}


def _move(faces: Sequence[tuple[int, Sequence[str]]], animation: Animation, samplers: _Samplers) -> None:
    for node, names in faces:
        weights = _weights_for(names, animation)
        if weights is not None:
            samplers.add_channel(node, "weights", weights)


def _turn(
    nodes: Sequence[int], animation: Animation, bones: dict[int, Float64Array], samplers: _Samplers, *, back: bool
) -> None:
    if not (bones or animation.head.any()):
        return
    from phonemeengine.mouth.exports.gltf_rotation import rotations_of, turnings_of  # noqa: PLC0415 - scipy is slow

    turns = rotations_of(animation.head) if animation.head.any() else None
    for turning in turnings_of(samplers.document, nodes, turns, bones, back=back):
        for path, values in turning.tracks().items():
            samplers.add_channel(turning.node, path, values)


def _weights_for(names: Sequence[str], animation: Animation) -> Float32Array | None:
    """Return the weights of a mesh's targets, shape (n_frames, n_targets); None where none of them moves."""
    columns = {name: k for k, name in enumerate(animation.movestates)}
    if not columns.keys() & set(names):
        return None
    weights = np.zeros((len(animation.weights), len(names)), "<f4")
    for target, name in enumerate(names):
        if name in columns:
            weights[:, target] = animation.weights[:, columns[name]]
    moved = dict(zip(names, weights.T, strict=True))
    for name, parts in combinations_of(names).items():
        if name not in columns:
            weights[:, names.index(name)] = combined(parts, moved)
    return weights


def _accessor(glb: Glb, values: Float32Array, form: str, limits: dict[str, Any]) -> int:
    views, accessors = glb.list_of("bufferViews"), glb.list_of("accessors")
    offset = glb.append(values.tobytes())
    views.append({"buffer": 0, "byteOffset": offset, "byteLength": values.nbytes})
    accessors.append(
        {"bufferView": len(views) - 1, "componentType": FLOAT, "count": values.size // WIDTHS[form], "type": form}
        | limits
    )
    return len(accessors) - 1


def _faces_of(document: dict[str, Any]) -> list[tuple[int, list[str]]]:
    """Return the nodes whose meshes have morph targets with names, and those names."""
    try:
        meshes = document.get("meshes", [])
        named = [_targets_of(mesh) for mesh in meshes]
        return [
            (number, named[node["mesh"]])
            for number, node in enumerate(document.get("nodes", []))
            if "mesh" in node and named[node["mesh"]]
        ]
    except (TypeError, KeyError, IndexError, AttributeError) as error:
        raise ExportError("the mesh is a damaged glTF file; export it anew from your modelling program") from error


def _targets_of(mesh: dict[str, Any]) -> list[str]:
    """Return the names of a mesh's targets; exporters write them as extras, since glTF itself has none."""
    n_targets = min((len(primitive.get("targets", [])) for primitive in mesh["primitives"]), default=0)
    extras = mesh.get("extras")
    names = extras.get("targetNames", []) if isinstance(extras, dict) else []
    names = [name if isinstance(name, str) else "" for name in names][:n_targets]
    return names + [""] * (n_targets - len(names)) if names else []
