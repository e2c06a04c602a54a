"""Faces as GLB files to which more can be added."""

from mimetypes import guess_type
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from phonemeengine.errors import ExportError, MeshError
from phonemeengine.mouth.files.gltf_document import (
    MAGIC,
    Beside,
    Document,
    Table,
    chunks_of,
    document_of,
    glb_of,
    tables_of,
    whole_of,
)
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.files.io import MESH_SUFFIXES, files_beside, load_morph_mesh
from phonemeengine.mouth.head import USUAL_HEAD, Head, load_head
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
        if not content.startswith(MAGIC):
            raise ExportError(
                f"{name}: this is no face that can be moved; name a .glb, .vrm or .gltf (glTF 2.0), .obj or .x"
            )
        try:
            text, binary = chunks_of(content)
            self.document: Table = document_of(text, LARGEST_JSON)
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
        return glb_of(self.document, self._parts)

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


def packed(content: bytes, beside: Beside) -> bytes:
    """Return a .gltf as a .glb: its buffers and pictures in one block of bytes.

    Parameters
    ----------
    beside : finds the files that it names.

    Raises
    ------
    MeshError : it is no glTF, or what it names is not there.
    """
    document, root = Document(content, beside), document_of(content, LARGEST_JSON)
    parts: list[bytes] = []
    begins = [_appended(parts, bytes(document.buffer(k))) for k in range(len(document.list_of("buffers")))]
    views = [_moved(view, begins) for view in document.list_of("bufferViews")]
    for image in tables_of(root, "images"):
        uri = unquote(str(image.get("uri", "")))
        if uri and not uri.startswith("data:") and (picture := beside(uri)) is not None:
            views.append({"buffer": 0, "byteOffset": _appended(parts, picture), "byteLength": len(picture)})
            image |= {"bufferView": len(views) - 1, "mimeType": guess_type(uri)[0] or "image/png"}
            del image["uri"]
    if parts:
        root |= {"buffers": [{"byteLength": sum(map(len, parts))}], "bufferViews": views}
    return glb_of(root, parts)


def _appended(parts: list[bytes], content: bytes) -> int:
    """Add bytes at a place that is a multiple of four, which is returned."""
    parts.append(bytes(-sum(map(len, parts)) % 4))
    start = sum(map(len, parts))
    parts.append(content)
    return start


def _moved(view: Table, begins: list[int]) -> Table:
    """Return a view of a buffer as one of the buffer that holds all."""
    buffer = whole_of(view, "buffer")
    if buffer >= len(begins):
        raise MeshError(f"it names number {buffer} of its buffers, and there are {len(begins)}; export it again")
    return view | {"buffer": 0, "byteOffset": begins[buffer] + whole_of(view, "byteOffset", 0)}


def _glb_of_mesh(path: Path) -> bytes:
    mesh = load_morph_mesh(path)
    if not mesh.states:
        raise MeshError(
            "there are no morph targets in it; put them into one file first, with: phonemeanalyser movestates export "
            f"{printable_name(path)} TARGET... -o face.glb"
        )
    return format_glb(mesh)
