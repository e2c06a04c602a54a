"""What a value holds, as a short text: the same on every machine, and another as soon as anything in it differs."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from hashlib import blake2b
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine import __version__

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
