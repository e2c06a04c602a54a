"""The bytes of an ``.ear`` file: little-endian numbers of 32 bits, in sections that say how long they are."""

import struct
import zlib
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

MAGIC = b"EAR\x1a"
VERSION = 1
"""Of the layout; an ear refuses newer ones."""


class SectionWriter:
    """Collects the content of one section."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def whole(self, *numbers: int) -> None:
        """Write whole numbers, 0 or more."""
        self._parts.append(struct.pack(f"<{len(numbers)}I", *numbers))

    def floats(self, numbers: ArrayLike) -> None:
        """Write numbers of single precision."""
        self._parts.append(np.asarray(numbers, "<f4").tobytes())

    def doubles(self, *numbers: float) -> None:
        """Write numbers of double precision."""
        self._parts.append(struct.pack(f"<{len(numbers)}d", *numbers))

    def halves(self, numbers: ArrayLike) -> None:
        """Write numbers of half precision, up to a whole 32 bits."""
        self._padded(np.asarray(numbers, "<f2").tobytes())

    def text(self, text: str) -> None:
        """Write a text in UTF-8 with its length."""
        content = text.encode(errors="replace")
        self.whole(len(content))
        self._padded(content)

    def filters(self, bank: ArrayLike) -> None:
        """Write filters, shape (n_bins, n_filters): of each the stretch of bins that it weighs."""
        for weights in np.asarray(bank, np.float32).T:
            weighed = np.flatnonzero(weights)
            first, stop = (int(weighed[0]), int(weighed[-1]) + 1) if len(weighed) else (0, 0)
            self.whole(first, stop - first)
            self.floats(weights[first:stop])

    def _padded(self, content: bytes) -> None:
        self._parts.append(content + bytes(-len(content) % 4))

    @property
    def content(self) -> bytes:
        """All that was written."""
        return b"".join(self._parts)


def join_sections(sections: Iterable[tuple[str, SectionWriter]]) -> bytes:
    """Return a file of sections, each with the four letters of its name."""
    parts = [(name.encode(), section.content) for name, section in sections]
    body = b"".join(name + struct.pack("<I", len(content)) + content for name, content in parts)
    return MAGIC + struct.pack("<III", VERSION, 16 + len(body), zlib.crc32(body)) + body


def is_ear_file(content: bytes) -> bool:
    """Return whether a file's content begins as an ``.ear`` file."""
    return content.startswith(MAGIC)
