"""The document of a glTF: JSON that is looked at before it is believed, and the bytes of its buffers.

A small reader of our own: Python's libraries for glTF either know no morph targets or believe what a file says.
"""

import base64
import binascii
import math
from collections.abc import Callable
from urllib.parse import unquote

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.glb import MAGIC, Table, chunks_of, document_of

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
    beside : finds the buffers' files that a .gltf names.

    Raises
    ------
    MeshError : it is no glTF, or a version or compression that this does not read.
    """

    def __init__(self, content: bytes, beside: Beside) -> None:
        text, self._blob = chunks_of(content) if content.startswith(MAGIC) else (content, memoryview(b""))
        self._root = document_of(text, LARGEST_JSON)
        self._beside = beside
        self._buffers: dict[int, Buffer] = {}
        self._lists: dict[str, list[Table]] = {}
        self._look_at_version()

    def list_of(self, key: str) -> list[Table]:
        """Return a list of the document, such as ``meshes``; empty if there is none."""
        if key not in self._lists:
            self._lists[key] = tables_of(self._root, key)
        return self._lists[key]

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
        found = self._beside(unquote(uri))
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
