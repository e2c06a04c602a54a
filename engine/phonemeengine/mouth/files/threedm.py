"""Movestates as the thesis stored them, left-handed (z goes away): ``.3dm``, binary, little-endian; ``.3dma``, text.

After a first line ``3dma01`` come captions, a colon, and what they caption::

    number of movestates: 1
    movestate: smile
    vertices: 2
    7 0.1 0.02 0
    8 0.05 0.02 -0.01
    all vertices that move: 2
    7 1 2 -3
    8 1.5 2 -3

A line of a vertex is its number and a vector: the offset, or at the end the position. Empty lines mean nothing.
"""

import io
import struct
from collections.abc import Iterator
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import MOST_VERTICES
from phonemeengine.mouth.morph_mesh import MOST_STATES, MorphTargets, checked
from phonemeengine.mouth.movestate import LONGEST_NAME, Movestate, movestate_at

MAGIC = b"3dm01\0"
MIRROR = np.array([1, 1, -1], np.float32)
"""Turns left-handed coordinates into right-handed ones, and back."""


def parse_3dm(content: bytes) -> MorphTargets:
    """Read a .3dm file.

    Nothing is allocated for a count before the file has been found to be long enough for it.

    Raises
    ------
    MeshError : it is no .3dm file, is cut off or too long, or says something impossible.
    """
    if not content.startswith(MAGIC):
        raise MeshError("a .3dm file begins with 3dm01, this does not; choose another file")
    pieces = _Pieces(content, len(MAGIC))
    n_states = pieces.count("the number of movestates", MOST_STATES, 8)
    states = []
    for place in range(n_states):
        name = _name_of(pieces.bytes(f"the name of movestate {place}", LONGEST_NAME + 1), place)
        n = pieces.count(f"the number of vertices of {name!r:.60}", MOST_VERTICES, 16)
        numbers = pieces.array("<u4", n)
        states.append(movestate_at(name, numbers, pieces.vectors(n)))
    n = pieces.count("the number of vertices that move", MOST_VERTICES, 16)
    numbers, positions = pieces.array("<u4", n), pieces.vectors(n)
    pieces.end()
    moving = movestate_at("all vertices that move", numbers, positions)
    return checked(MorphTargets(tuple(states), moving.numbers, moving.offsets))


def format_3dm(targets: MorphTargets) -> bytes:
    """Write a .3dm file."""
    parts = [MAGIC, struct.pack("<I", len(targets.states))]
    for state in targets.states:
        name = state.name.encode()
        parts += [struct.pack("<I", len(name)), name, *_block(state.numbers, state.offsets)]
    return b"".join((*parts, *_block(targets.numbers, targets.positions)))


def _block(numbers: UInt32Array, vectors: Float32Array) -> tuple[bytes, bytes, bytes]:
    mirrored = vectors * MIRROR + np.float32(0)  # no -0
    return struct.pack("<I", len(numbers)), numbers.astype("<u4").tobytes(), mirrored.astype("<f4").tobytes()


def _name_of(raw: bytes, place: int) -> str:
    """Decode a name; older exporters wrote that of their Windows, and some a NUL at the end."""
    raw = raw.removesuffix(b"\0")
    try:
        return raw.decode().strip()
    except UnicodeDecodeError:  # perhaps of an older exporter
        pass
    try:
        return raw.decode("cp1252").strip()
    except UnicodeDecodeError as error:
        raise MeshError(f"the name of movestate {place} is no text ({raw[:20]!r}); export it again") from error


class _Pieces:
    """Hands out the pieces of a file one after the other."""

    def __init__(self, content: bytes, at: int) -> None:
        self._content = content
        self._at = at

    def count(self, what: str, most: int, size: int) -> int:
        """Read a number of things, each of at least `size` bytes, which all have room in the rest of the file."""
        if self._left < 4:
            raise MeshError(f"it ends before {what}; it is cut off, export or copy it again")
        (n,) = struct.unpack_from("<I", self._content, self._at)
        self._at += 4
        if n > most or n * size > self._left:
            room = min(most, self._left // size)
            raise MeshError(
                f"{what} is said to be {n}, and there is space for {room}; it is damaged, export it again"
            )
        return int(n)

    def bytes(self, what: str, most: int) -> bytes:
        """Read a length and as many bytes."""
        n = self.count(f"the length of {what}", most, 1)
        self._at += n
        return self._content[self._at - n : self._at]

    def array(self, dtype: str, n: int) -> NDArray[np.generic]:
        """Read n numbers of 4 bytes, for which `count` has found room."""
        found = np.frombuffer(self._content, dtype, n, self._at)
        self._at += 4 * n
        return found

    def vectors(self, n: int) -> Float32Array:
        """Read n vectors, as right-handed coordinates, shape (n, 3)."""
        found: Float32Array = self.array("<f4", 3 * n).reshape(n, 3).astype(np.float32)
        np.negative(found[:, 2], out=found[:, 2])  # unlike a product, it says nothing of signalling NaNs
        return found

    def end(self) -> None:
        """Refuse a file that goes on."""
        if self._left:
            raise MeshError(f"{self._left} bytes follow its end; it is damaged, export it again")

    @property
    def _left(self) -> int:
        return len(self._content) - self._at


TITLE = "3dma01"
STATES, STATE, VERTICES, ALL = "number of movestates", "movestate", "vertices", "all vertices that move"
LONGEST_LINE = 4096
SHORTEST_ROW = 8
"""Characters of the shortest line of a vertex, ``0 0 0 0`` and a line break."""


def parse_3dma(content: bytes) -> MorphTargets:
    """Read a .3dma file.

    Raises
    ------
    MeshError : it is no .3dma file, is cut off or too long, or says something impossible; names the line.
    """
    lines = _Lines(content)
    if lines.next_line() != TITLE:
        raise MeshError(f"a .3dma file begins with a line {TITLE!r}, this does not; choose another file")
    states = []
    for _ in range(lines.count(STATES, MOST_STATES)):
        name = lines.caption(STATE)
        states.append(movestate_at(name, *lines.rows(lines.count(VERTICES, MOST_VERTICES))))
    moving = movestate_at(ALL, *lines.rows(lines.count(ALL, MOST_VERTICES)))
    lines.end()
    return checked(MorphTargets(tuple(states), moving.numbers, moving.offsets))


def format_3dma(targets: MorphTargets) -> bytes:
    """Write a .3dma file, each number with the fewest digits that keep its float32 value."""
    out = io.BytesIO()
    out.write(f"{TITLE}\n{STATES}: {len(targets.states)}\n".encode())
    for state in targets.states:
        out.write(f"\n{STATE}: {state.name}\n{VERTICES}: {len(state)}\n".encode())
        out.writelines(_written(state))
    out.write(f"\n{ALL}: {len(targets.numbers)}\n".encode())
    out.writelines(_written(Movestate(ALL, targets.numbers, targets.positions)))
    return out.getvalue()


def _written(state: Movestate) -> Iterator[bytes]:
    for number, (x, y, z) in zip(state.numbers.tolist(), state.offsets * MIRROR + np.float32(0), strict=True):
        yield f"{number} {x!s} {y!s} {z!s}\n".encode()


class _Lines:
    """Hands out the lines of a text one after the other, and knows where it is."""

    def __init__(self, content: bytes) -> None:
        self._text = io.BytesIO(content.removeprefix(b"\xef\xbb\xbf"))
        self._size = len(content)
        self._number = 0
        self._lines = self._all()

    def next_line(self) -> str:
        """Return the next line that is not empty."""
        line = next(self._lines, None)
        if line is None:
            raise MeshError(f"it ends after line {self._number}; it is cut off, export or copy it again")
        return line

    def caption(self, caption: str) -> str:
        """Return what stands behind a caption, which must be the next."""
        found, colon, rest = self.next_line().partition(":")
        if not colon or found.strip() != caption:
            raise MeshError(f"line {self._number} must begin with '{caption}:', found {found[:40]!r}; correct it")
        return rest.strip()

    def count(self, caption: str, most: int) -> int:
        """Return the number behind a caption, which the rest of the text must have room for."""
        word = self.caption(caption)
        if not (word.isdecimal() and len(word) <= 10 and word.isascii()):
            raise MeshError(
                f"line {self._number}: '{caption}' must be a whole number, found {word[:40]!r}; correct it"
            )
        room = min(most, (self._size - self._text.tell()) // SHORTEST_ROW + 1)
        if int(word) > room:
            raise MeshError(
                f"line {self._number}: '{caption}' is said to be {word}, and there is space for {room}; correct it"
            )
        return int(word)

    def rows(self, n: int) -> tuple[Int64Array, Float32Array]:
        """Return n vertices: their numbers, and their vectors as right-handed coordinates."""
        begin = self._number + 1
        table = self._table(n)
        if table.shape != (n, 4):
            raise MeshError(f"{n} lines of a vertex number and a vector must follow line {begin - 1}; correct it")
        if not np.all(np.abs(table) < 1e30):  # false for NaN; beyond float32 anyway
            raise MeshError(f"lines {begin}..{self._number} hold a number that is not finite; correct it")
        numbers = table[:, 0]
        if not np.all((numbers >= 0) & (numbers < MOST_VERTICES) & (numbers == np.floor(numbers))):
            raise MeshError(f"lines {begin}..{self._number} must begin with vertex numbers; correct them")
        return numbers.astype(np.int64), table[:, 1:].astype(np.float32) * MIRROR

    def end(self) -> None:
        """Refuse a text that goes on."""
        if next(self._lines, None) is not None:
            raise MeshError(f"line {self._number} is beyond the end; remove what follows")

    def _table(self, n: int) -> Float64Array:
        if not n:
            return np.empty((0, 4))
        begin = self._number + 1
        rows = islice(self._lines, n)
        first = next(rows, None)
        if first is None:
            return np.empty((0, 4))
        try:
            # A generator would end silently at the text's end; the shape tells.
            return np.loadtxt(_before(first, rows), comments=None, ndmin=2)
        except ValueError as error:
            raise MeshError(
                f"lines {begin}..{self._number} must each be a vertex number and three coordinates; correct them"
            ) from error

    def _all(self) -> Iterator[str]:
        while raw := self._text.readline(LONGEST_LINE + 1):
            self._number += 1
            if len(raw) > LONGEST_LINE:
                raise MeshError(f"line {self._number} is longer than {LONGEST_LINE} bytes; this is no .3dma file")
            if line := raw.decode(errors="replace").strip():
                yield line


def _before(first: str, rest: Iterator[str]) -> Iterator[str]:
    yield first
    yield from rest
