"""``.3dm`` files: movestates as the thesis stored them, binary, little-endian, left-handed (z goes away)."""

import struct

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.mesh import MOST_VERTICES
from phonemeengine.mouth.morph_mesh import MOST_STATES, MorphTargets, checked
from phonemeengine.mouth.movestate import LONGEST_NAME, movestate_at

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
