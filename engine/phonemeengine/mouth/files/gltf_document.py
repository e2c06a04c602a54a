"""The document of a glTF: JSON that is looked at before it is believed, its buffers, and the arrays in them.

A small reader of our own: Python's libraries for glTF either know no morph targets or believe what a file says.
"""

import base64
import binascii
import json
import math
import struct
from collections.abc import Callable, Iterable
from typing import Any, Final
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import MOST_TRIANGLES

# The container of a .glb file: a JSON document, and one block of bytes.
#
# See section 4 of the glTF 2.0 specification.

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
    """Read the JSON of a glTF, of this many bytes at most.

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


LARGEST_JSON = 4 << 20
"""Bytes; Python's objects take twenty times as many."""
LARGEST_BUFFER = 64 << 20
MOST_BUFFERS = 16
UNKNOWN = {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}
"""Extensions that pack the vertices."""

Buffer = bytes | memoryview
Beside = Callable[[str], bytes | None]


class Document:
    """A glTF's JSON and buffers; gives what it says after checking its type and range.

    Parameters
    ----------
    content : a .glb or .gltf file.
    beside : finds the files of buffers and pictures that a .gltf names.

    Raises
    ------
    MeshError : it is no glTF, or a version or compression that this does not read.
    """

    def __init__(self, content: bytes, beside: Beside) -> None:
        text, self._blob = chunks_of(content) if content.startswith(MAGIC) else (content, memoryview(b""))
        self._root = document_of(text, LARGEST_JSON)
        self.beside = beside
        self._buffers: dict[int, Buffer] = {}
        self._lists: dict[str, list[Table]] = {}
        self._look_at_version()

    def list_of(self, key: str) -> list[Table]:
        """Return a list of the document, such as ``meshes``; empty if there is none."""
        if key not in self._lists:
            self._lists[key] = tables_of(self._root, key)
        return self._lists[key]

    def table(self, key: str) -> Table:
        """Return a table of the document, such as ``extensions``; empty if there is none."""
        return table_of(self._root, key)

    def view(self, place: int) -> bytes:
        """Return the bytes of a view of a buffer.

        Raises
        ------
        MeshError : its buffer does not hold them.
        """
        view = self.entry("bufferViews", place)
        content = self.buffer(whole_of(view, "buffer"))
        begin, length = whole_of(view, "byteOffset", 0), whole_of(view, "byteLength")
        if begin + length > len(content):
            raise MeshError(
                f"a view of {length} bytes begins at {begin}, and its buffer has {len(content)}; export it again"
            )
        return bytes(content[begin : begin + length])

    def whole(self, key: str) -> int:
        """Return a whole number of the document, such as ``scene``; 0 if there is none."""
        return whole_of(self._root, key, 0)

    def entry(self, key: str, place: int) -> Table:
        """Return an entry of a list of the document."""
        entries = self.list_of(key)
        if not 0 <= place < len(entries):
            raise MeshError(f"it names number {place} of its {key}, and there are {len(entries)}; export it again")
        return entries[place]

    def buffer(self, place: int) -> Buffer:
        """Return the bytes of a buffer: the one in the .glb, one in the text, or a file beside it."""
        if place not in self._buffers:
            table = self.entry("buffers", place)
            if len(self._buffers) >= MOST_BUFFERS:
                raise MeshError(f"it uses more than {MOST_BUFFERS} buffers; export it as .glb")
            found = self._blob if "uri" not in table else self._resource(text_of(table, "uri"))
            if sum(map(len, self._buffers.values())) + len(found) > LARGEST_BUFFER:
                raise MeshError(f"its buffers hold more than {LARGEST_BUFFER >> 20} MB; export less")
            self._buffers[place] = found
        return self._buffers[place]

    def _resource(self, uri: str) -> bytes:
        if uri.startswith("data:"):
            try:
                return base64.b64decode(uri.partition(",")[2], validate=True)
            except (binascii.Error, ValueError) as error:
                raise MeshError("the buffer in its text is no base64; export it again") from error
        found = self.beside(unquote(uri))
        if found is None:
            raise MeshError(f"its buffer {uri[:60]!r} is not beside it; put it there, or export a .glb")
        return found

    def _look_at_version(self) -> None:
        asset = table_of(self._root, "asset")
        version = text_of(asset, "version", "")
        if not version.startswith("2."):
            raise MeshError(f"it is of version {version[:10]!r}, and this program reads glTF 2; export it as glTF 2")
        required = self._root.get("extensionsRequired", [])
        packed = [name for name in required if name in UNKNOWN] if _all_texts(required) else []
        if packed:
            raise MeshError(f"its vertices are compressed with {packed[0]}; export it without compression")


def table_of(table: Table, key: str) -> Table:
    """Return a table within a table; empty if there is none."""
    found = table.get(key, {})
    if not isinstance(found, dict):
        raise MeshError(f"its {key!r} must be a table, found {_shown(found)}; export it again")
    return found


def tables_of(table: Table, key: str) -> list[Table]:
    """Return a list of tables within a table; empty if there is none."""
    found = table.get(key, [])
    if not isinstance(found, list) or not all(isinstance(entry, dict) for entry in found):
        raise MeshError(f"its {key!r} must be a list of tables, found {_shown(found)}; export it again")
    return found


def whole_of(table: Table, key: str, default: int | None = None) -> int:
    """Return a whole number from 0 within a table."""
    found = table.get(key, default)
    if not isinstance(found, int) or isinstance(found, bool) or not 0 <= found < 1 << 32:
        raise MeshError(f"its {key!r} must be a whole number from 0, found {_shown(found)}; export it again")
    return found


def wholes_of(table: Table, key: str) -> list[int]:
    """Return a list of whole numbers from 0 within a table; empty if there is none."""
    found = table.get(key, [])
    if not isinstance(found, list):
        raise MeshError(f"its {key!r} must be a list, found {_shown(found)}; export it again")
    return [whole_of({key: entry}, key) for entry in found]


def text_of(table: Table, key: str, default: str | None = None) -> str:
    """Return a text within a table."""
    found = table.get(key, default)
    if not isinstance(found, str):
        raise MeshError(f"its {key!r} must be text, found {_shown(found)}; export it again")
    return found


def numbers_of(table: Table, key: str, default: list[float]) -> list[float]:
    """Return a list of as many finite numbers as the default has."""
    found = table.get(key, default)
    if not isinstance(found, list) or len(found) != len(default) or not all(map(_is_number, found)):
        raise MeshError(f"its {key!r} must be {len(default)} numbers, found {_shown(found)}; export it again")
    return [float(number) for number in found]


def _is_number(found: object) -> bool:
    return isinstance(found, (int, float)) and not isinstance(found, bool) and abs(found) < 1e30  # false for NaN


def _all_texts(found: object) -> bool:
    return isinstance(found, list) and all(isinstance(entry, str) for entry in found)


def _shown(found: object) -> str:
    if isinstance(found, (list, dict)):
        return f"a {type(found).__name__} of {len(found)}"
    if isinstance(found, float) and not math.isfinite(found):
        return "a number that is not finite"
    return repr(found)[:40] if not isinstance(found, int) or abs(found) < 1 << 64 else "a huge number"


# Accessors of a glTF: arrays within its buffers, plain, interleaved, whole numbers as fractions, and sparse.

COMPONENTS: Final = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
MOST_ENTRIES = 3 * MOST_TRIANGLES

Array = NDArray[Any]


def array_of(document: Document, place: int) -> Array:
    """Return the array of an accessor, shape (count, width); floats are float32, fractions are made floats.

    Raises
    ------
    MeshError : the accessor says what its buffer does not hold.
    """
    accessor = document.entry("accessors", place)
    n, dtype, width = _form_of(accessor)
    viewed = "bufferView" in accessor
    found = _viewed(document, accessor, n, dtype, width) if viewed else np.zeros((n, width), dtype)
    if "sparse" in accessor:
        found = _with_sparse(document, table_of(accessor, "sparse"), found)
    if accessor.get("normalized") is True and dtype.kind in "iu":
        most = (1 << (8 * dtype.itemsize - (dtype.kind == "i"))) - 1
        return np.maximum(found.astype(np.float32) / most, -1).astype(np.float32)
    return found


def count_of(document: Document, place: int) -> int:
    """Return how many entries an accessor says it has."""
    return _form_of(document.entry("accessors", place))[0]


def _form_of(accessor: Table) -> tuple[int, np.dtype[Any], int]:
    n = whole_of(accessor, "count")
    kind, shape = whole_of(accessor, "componentType"), text_of(accessor, "type")
    if kind not in COMPONENTS or shape not in WIDTHS:
        raise MeshError(f"an accessor is of type {kind} {shape[:20]!r}, which no vertex has; export it again")
    if n > MOST_ENTRIES:
        raise MeshError(f"an accessor has at most {MOST_ENTRIES} entries, got {n}; make the mesh coarser")
    return n, np.dtype(COMPONENTS[kind]), WIDTHS[shape]


def _viewed(document: Document, table: Table, n: int, dtype: np.dtype[Any], width: int) -> Array:
    """Look at a part of a buffer as an array, after checking that it is long enough; copies nothing."""
    view = document.entry("bufferViews", whole_of(table, "bufferView"))
    content = document.buffer(whole_of(view, "buffer"))
    begin, length = whole_of(view, "byteOffset", 0), whole_of(view, "byteLength")
    offset, row = whole_of(table, "byteOffset", 0), dtype.itemsize * width
    stride = whole_of(view, "byteStride", row)
    needed = offset + (stride * (n - 1) + row if n else 0)
    if stride < row or needed > length or begin + length > len(content):
        raise MeshError(
            f"an accessor needs {needed} bytes at {begin}, and its buffer has {len(content)}; it is damaged, "
            "export it again"
        )
    return np.ndarray((n, width), dtype, content, begin + offset, (stride, dtype.itemsize))


def _with_sparse(document: Document, sparse: Table, base: Array) -> Array:
    n = whole_of(sparse, "count")
    if n > len(base):
        raise MeshError(f"a sparse accessor changes {n} of {len(base)} entries; it is damaged, export it again")
    places = table_of(sparse, "indices")
    kind = whole_of(places, "componentType")
    if kind not in (5121, 5123, 5125):
        raise MeshError(f"the indices of a sparse accessor are of type {kind}; export it again")
    where = _viewed(document, places, n, np.dtype(COMPONENTS[kind]), 1)[:, 0].astype(np.int64)
    if n and where.max() >= len(base):
        raise MeshError(f"a sparse accessor changes entry {where.max()}, and it has {len(base)}; export it again")
    changed = base.copy()
    changed[where] = _viewed(document, table_of(sparse, "values"), n, base.dtype, base.shape[1])
    return changed
