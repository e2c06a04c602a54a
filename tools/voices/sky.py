"""Actors of the game Beneath a Steel Sky: packed sounds of 8 bits and 11 kHz, a group of speakers a section."""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np

from tools.voices.packages import RECORDINGS
from tools.voices.recordings import Clip, Source, from_bytes, voices_of
from tools.voices.rnc import PACKED, unpacked
from tools.voices.voice import Voice

SOURCE = Source(
    "sky",
    "en",
    "free with its notice, also modified, no fee for the game itself ((C) Revolution Software Ltd)",
    RECORDINGS["sky"],
)
FOLDER = "usr/share/scummvm/beneath-a-steel-sky"
SAMPLE_RATE = 11025
FIRST, END = 50000, 60000  # numbers of the files that hold speech
SECTIONS = (0, 600, 1100, 2430, 3380, 4530, 5080, 5230)  # the first line of each section of the game
HEAD = 22  # bytes before the samples
SIZE = 0x3FFFFF  # bits of an entry's last number that are the size
OFFSET, BY_16 = 0x7FFFFF, 0x800000  # bits of its middle number: the offset, and whether it counts 16 bytes


def voices(cache: Path) -> list[Voice]:
    """One voice for each section of the game; the hero speaks in all."""
    folder = cache / "packages" / SOURCE.package / FOLDER
    disk = (folder / "sky.dsk").read_bytes()
    clips: dict[str, list[Clip]] = defaultdict(list)
    for number, offset, size in entries_of((folder / "sky.dnr").read_bytes()):
        if FIRST <= number < END:
            section = bisect_right(SECTIONS, number - FIRST) - 1
            clips[f"section{section}"].append(partial(_read, disk[offset : offset + size]))
    return voices_of(SOURCE, clips)


def entries_of(table: bytes) -> Iterator[tuple[int, int, int]]:
    """Number, offset and size in bytes of the files on the disk: 2, 3 and 3 bytes each, behind their count."""
    for start in range(4, 4 + 8 * int.from_bytes(table[:4], "little"), 8):
        number, offset, size = (
            int.from_bytes(table[start + first : start + end], "little") for first, end in ((0, 2), (2, 5), (5, 8))
        )
        yield number, (offset & OFFSET) << (4 if offset & BY_16 else 0), size & SIZE


def _read(file: bytes) -> tuple[np.ndarray, int]:
    body = file[HEAD:]
    return from_bytes(unpacked(body) if body.startswith(PACKED) else body, SAMPLE_RATE)
