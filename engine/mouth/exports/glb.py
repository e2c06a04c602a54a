"""GLB files as they are: a JSON document and one block of bytes, to which more can be added.

See section 4 of the glTF 2.0 specification.
"""

import json
import struct
from pathlib import Path
from typing import Any

from engine.audio.opening import shown_name
from engine.errors import ExportError

MAGIC, VERSION = b"glTF", 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
LARGEST_FILE = 1 << 30
HEADER = 12
CHUNK_HEADER = 8


class Glb:
    """A GLB file in memory.

    Parameters
    ----------
    document : the glTF document.
    binary : the bytes of its buffer 0.
    """

    def __init__(self, document: dict[str, Any], binary: bytes, name: str) -> None:
        self.document = document
        self._name = name
        buffers = self.list_of("buffers")
        if binary and not (buffers and isinstance(buffers[0], dict) and "uri" not in buffers[0]):
            raise self._refusal("its first buffer lies outside it")
        if not binary and buffers:
            raise self._refusal("its buffers lie outside it")
        if not buffers:
            buffers.append({"byteLength": 0})
        self._parts = [binary]
        self._length = len(binary)

    def list_of(self, name: str) -> list[Any]:
        """Give a list of the document, such as ``accessors``; it is made where it is missing."""
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
        """Give the whole file."""
        self.document["buffers"][0]["byteLength"] = self._length
        binary = b"".join(self._parts)
        binary += b"\0" * (-len(binary) % 4)
        text = json.dumps(self.document, ensure_ascii=False, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = _chunk(JSON_CHUNK, text) + _chunk(BINARY_CHUNK, binary)
        return MAGIC + struct.pack("<II", VERSION, HEADER + len(chunks)) + chunks

    def _refusal(self, fault: str) -> ExportError:
        return ExportError(f"{self._name}: {fault}; save the face as one GLB file with everything in it")


def read_glb(path: Path) -> Glb:
    """Read a GLB file.

    Raises
    ------
    ExportError : it cannot be read, is no GLB, or is damaged.
    """
    name = shown_name(path)
    try:
        size = path.stat().st_size
        content = path.read_bytes() if size <= LARGEST_FILE else b""
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise ExportError(f"{name}: it cannot be read ({reason}); check the file") from error
    if size > LARGEST_FILE:
        raise ExportError(f"{name}: a face has at most 1 GB, this has {size / 1e9:.1f} GB; choose another")
    if content[:4] != MAGIC or len(content) < HEADER + CHUNK_HEADER:
        raise ExportError(f"{name}: this is no GLB file; save the face as .glb (binary glTF 2.0)")
    return _parsed(content, name)


def _parsed(content: bytes, name: str) -> Glb:
    version, length = struct.unpack_from("<II", content, 4)
    if version != VERSION or not HEADER + CHUNK_HEADER <= length <= len(content):
        raise ExportError(f"{name}: this GLB is damaged or of version {version}, not 2; export it anew")
    chunks: dict[int, bytes] = {}
    at = HEADER
    while at + CHUNK_HEADER <= length:
        size, kind = struct.unpack_from("<II", content, at)
        if at + CHUNK_HEADER + size > length:
            raise ExportError(f"{name}: this GLB is cut off; export it anew")
        chunks.setdefault(kind, content[at + CHUNK_HEADER : at + CHUNK_HEADER + size])
        at += CHUNK_HEADER + size
    try:
        document = json.loads(chunks.get(JSON_CHUNK, b""))
    except (ValueError, RecursionError) as error:
        raise ExportError(f"{name}: the document in this GLB cannot be read ({error}); export it anew") from error
    if not isinstance(document, dict):
        raise ExportError(f"{name}: the document in this GLB is no object; export it anew")
    return Glb(document, chunks.get(BINARY_CHUNK, b""), name)


def _chunk(kind: int, content: bytes) -> bytes:
    return struct.pack("<II", len(content), kind) + content
