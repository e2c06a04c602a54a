"""Faces as GLB files to which more can be added."""

from pathlib import Path
from typing import Any

from phonemeengine.errors import ExportError, MeshError
from phonemeengine.files import printable_name, read_file
from phonemeengine.mouth.files.glb import MAGIC, Table, chunks_of, document_of, glb_of
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.head import HEAD, load_head

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
            raise ExportError(f"{name}: this is no GLB file; save the face as .glb (binary glTF 2.0)")
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


def shipped_glb() -> Glb:
    """Return the head that ships with the program, with its movestates as morph targets."""
    return Glb(format_glb(load_head()), HEAD.name)


def read_glb(path: Path) -> Glb:
    """Read a GLB file.

    Raises
    ------
    ExportError : it cannot be read, is no GLB, or is damaged.
    """
    return Glb(read_file(path, LARGEST_FILE, "a face", ExportError), printable_name(path))
