"""``.3dma`` files: what a .3dm file holds, as text that people can read and edit; left-handed as well.

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
from collections.abc import Iterator
from itertools import islice

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.threedm import MIRROR
from phonemeengine.mouth.mesh import MOST_VERTICES
from phonemeengine.mouth.morph_mesh import MOST_STATES, MorphTargets, checked
from phonemeengine.mouth.movestate import Movestate, movestate_at

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
