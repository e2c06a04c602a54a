"""The container of a .glb file: a JSON document, and one block of bytes.

See section 4 of the glTF 2.0 specification.
"""

import json
import struct
from collections.abc import Iterable
from typing import Any

from phonemeengine.errors import MeshError

MAGIC, VERSION = b"glTF", 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
HEADER, CHUNK_HEADER = 12, 8

Table = dict[str, Any]


def chunks_of(content: bytes) -> tuple[bytes, memoryview]:
    """Return the JSON and the bytes of a .glb file; the latter are no copy, and empty where there are none.

    Raises
    ------
    MeshError : it is cut off, or says something impossible.
    """
    if len(content) < HEADER + CHUNK_HEADER:
        raise MeshError("it ends within its header; it is cut off, export or copy it again")
    version, length = struct.unpack_from("<II", content, len(MAGIC))
    if version != VERSION or length != len(content):
        raise MeshError(
            f"its header says version {version} and {length} bytes, and it has {len(content)}; export it again"
        )
    chunks: dict[int, memoryview] = {}
    at = HEADER
    while at + CHUNK_HEADER <= length:
        size, kind = struct.unpack_from("<II", content, at)
        at += CHUNK_HEADER
        if size > length - at:
            raise MeshError(f"a part of it is said to have {size} bytes, and {length - at} are left; export it again")
        chunks.setdefault(kind, memoryview(content)[at : at + size])
        at += size
    if JSON_CHUNK not in chunks:
        raise MeshError("it has no JSON part; export it again")
    return bytes(chunks[JSON_CHUNK]), chunks.get(BINARY_CHUNK, memoryview(b""))


def document_of(text: bytes, largest: int) -> Table:
    """Read the JSON of a glTF, of so many bytes at most.

    Raises
    ------
    MeshError : it is too large, or no JSON table.
    """
    if len(text) > largest:
        raise MeshError(f"its JSON is larger than {largest >> 20} MB; export a .glb, with less in it")
    try:
        found = json.loads(text.rstrip(b"\0 "))
    except (ValueError, RecursionError) as error:
        raise MeshError("this is no glTF: its JSON cannot be read; choose another file") from error
    if not isinstance(found, dict):
        raise MeshError("this is no glTF: its JSON is no table; choose another file")
    return found


def glb_of(document: Table, parts: Iterable[bytes]) -> bytes:
    """Return a .glb file of a document, and of parts that follow each other in its buffer 0."""
    words = json.dumps(document, ensure_ascii=False, separators=(",", ":"))
    text = words.encode(errors="replace")  # damaged names may hold halves of letters
    chunks = _chunk(JSON_CHUNK, text, b" ") + _chunk(BINARY_CHUNK, b"".join(parts), b"\0")
    return MAGIC + struct.pack("<II", VERSION, HEADER + len(chunks)) + chunks


def _chunk(kind: int, content: bytes, filling: bytes) -> bytes:
    content += filling * (-len(content) % 4)
    return struct.pack("<II", len(content), kind) + content
