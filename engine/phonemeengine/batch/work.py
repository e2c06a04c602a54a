"""What is done to each file of a batch, and what came of it."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, fields, is_dataclass
from enum import Enum, StrEnum
from functools import cached_property
from hashlib import blake2b
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from phonemeengine import __version__
from phonemeengine.execution import Progress

# What a value holds, as a short text: the same on every machine, and another as soon as anything in it differs.

LENGTH = 16
"""Bytes of a digest."""
BLOCK = 1 << 20


def fingerprint_of(*values: object) -> str:
    """Return a digest of values: numbers, texts, arrays, dataclasses of them, and paths, which stand for their files.

    The program's version goes into it.
    """
    digest = blake2b(digest_size=LENGTH)
    for part in _parts((__version__, *values)):
        digest.update(len(part).to_bytes(8))
        digest.update(part)
    return digest.hexdigest()


def size_and_time(path: Path) -> tuple[int, int]:
    """Return the bytes of a file, and when it was last written, nanoseconds; OSError where it cannot be asked.

    What is at an address has a number in place of the time, which is another one whenever it is written.
    """
    about = path.stat()
    if isinstance(path, Path):
        return about.st_size, about.st_mtime_ns
    key: str = path.fs.ukey(path.path)
    return about.st_size, int.from_bytes(blake2b(key.encode(), digest_size=7).digest())


def digest_of(path: Path) -> str:
    """Return a digest of a file's content; OSError where it cannot be read."""
    digest = blake2b(digest_size=LENGTH)
    with path.open("rb") as file:
        while block := file.read(BLOCK):
            digest.update(block)
    return digest.hexdigest()


def _parts(value: Any) -> Iterator[bytes]:
    if isinstance(value, Path):
        yield digest_of(value).encode() if value.is_file() else _encoded(str(value))
    elif isinstance(value, np.ndarray):
        yield f"{value.dtype.str}{value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, bytes):
        yield b"bytes"
        yield value
    elif isinstance(getattr(type(value), "digest", None), cached_property):  # a network, which is what its arrays are
        yield _encoded(value.digest)
    elif (listed := _listed(value)) is not None:
        yield f"{len(listed)}".encode()
        for item in listed:
            yield from _parts(item)
    else:
        yield _encoded(repr(value.value if isinstance(value, Enum) else value))


def _listed(value: Any) -> list[Any] | None:
    """Return what a value is made of, in an order that is always the same; None of one that has no parts."""
    if is_dataclass(value):
        return [type(value).__name__, *(getattr(value, f.name) for f in fields(value) if f.compare)]
    if isinstance(value, Mapping):
        return sorted(((repr(key), item) for key, item in value.items()), key=lambda entry: entry[0])
    if isinstance(value, frozenset | set):
        return sorted(map(repr, value))
    return [*value] if isinstance(value, tuple | list) else None


def _encoded(text: str) -> bytes:
    return text.encode(errors="surrogateescape")


Say = Callable[[str, str], None]
"""Told what is odd about something that is worked on all the same: its name, and a sentence."""


def say_nothing(_name: str, _note: str) -> None:
    """Report nothing."""


@dataclass(frozen=True)
class Job:
    """A sound file (or a folder without any), and the file that is written of it; None means standard output.

    Attributes
    ----------
    source, target : the files.
    number : tells jobs apart that have the same files.
    origin : where the source was before it was fetched from elsewhere; None where it was not.
    earlier : whether the same work made the target that is there, as the batch noted it; None where nothing is noted.
    """

    source: Path
    target: Path | None
    number: int = 0
    origin: Path | None = None
    earlier: bool | None = field(default=None, compare=False)

    @property
    def sound(self) -> Path:
        """The sound that was asked for, wherever it is now."""
        return self.origin or self.source


@dataclass(frozen=True)
class Made:
    """What came of a file.

    Attributes
    ----------
    duration : of the sound, seconds.
    language : of what is said in it, where its words are known.
    score : how well it says them, 0 is best; None where unknown.
    value : what is not written, but given back.
    """

    duration: float = 0.0
    language: str = ""
    score: float | None = None
    value: Any = field(default=None, compare=False)


Act = Callable[[Job, Say, Progress], Made]
"""Does what is to be done to one file."""


class Work(Protocol):
    """What is done to each file. It is pickled, and goes to other processes and machines."""

    def fingerprint(self) -> str:
        """Return what tells it from other work: its kind, preset and options."""

    def known_of(self, job: Job) -> str:
        """Return what it knows of one file besides, such as the words that are said in it."""

    def opened(self) -> AbstractContextManager[Act]:
        """Open what it needs, once in each process."""


class JobState(StrEnum):
    """What became of a file: it was made, or before; or it could not be."""

    DONE = "done"
    SKIPPED = "done before"
    FAILED = "failed"


@dataclass(frozen=True)
class FileState:
    """What tells whether a file is still the same.

    Attributes
    ----------
    size : bytes.
    changed : when it was last written, nanoseconds, by the clock of its disk.
    digest : of its content.
    """

    size: int
    changed: int
    digest: str


@dataclass(frozen=True)
class Outcome:
    """What became of a job.

    Attributes
    ----------
    job : the job.
    state : made now or before, or failed.
    made : what came of it.
    notes : names and sentences of what is odd.
    words : what was wrong, for people; empty where nothing was.
    is_fatal : whether all others will fail likewise: the disk is full.
    source, target : the files, as they were when it was made; None where that was not checked.
    """

    job: Job
    state: JobState
    made: Made = Made()
    notes: tuple[tuple[str, str], ...] = ()
    words: str = ""
    is_fatal: bool = False
    source: FileState | None = None
    target: FileState | None = None
