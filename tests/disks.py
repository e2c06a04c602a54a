"""Disks and folders that refuse: by what Python tells of each change of the disk, and by permissions."""

import os
import sys
from collections.abc import Collection, Iterator
from contextlib import AbstractContextManager, contextmanager
from functools import cache
from pathlib import Path

FULL = OSError(28, "No space left on device")
CHANGES = frozenset({"open", "os.rename", "os.remove", "os.mkdir", "os.truncate"})
"""The audit events of what changes a disk; files that are opened to be read do not count."""
_NOBODY = 65534


class Refusal:
    """Raises an error at the n-th change of what lies in a folder, and at all later ones.

    Attributes
    ----------
    changes : what was tried: the name of each event, and the path.
    """

    def __init__(self, folder: Path, n: int, error: BaseException, events: Collection[str], *, once: bool) -> None:
        self.folder, self.n, self.error, self.events, self.once = str(folder), n, error, events, once
        self.changes: list[tuple[str, str]] = []

    def look(self, event: str, arguments: tuple[object, ...]) -> None:
        """Take an event, as Python tells it before it happens."""
        if event not in self.events or not str(arguments[0]).startswith(self.folder):
            return
        if event == "open" and not int(str(arguments[2])) & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
            return
        self.changes.append((event, str(arguments[0])))
        n = len(self.changes)
        if n == self.n or (n > self.n and not self.once):
            raise self.error


_in_force: list[Refusal] = []


@cache
def _listen() -> None:
    """Have Python tell what it is about to do; that cannot be ended."""
    sys.addaudithook(lambda event, arguments: [refusal.look(event, arguments) for refusal in _in_force] and None)


@contextmanager
def refused(
    folder: Path, n: int = 1, error: BaseException = FULL, events: Collection[str] = CHANGES, *, once: bool = False
) -> Iterator[Refusal]:
    """Have the n-th change of what lies in a folder fail, and all later ones, or only that."""
    _listen()
    refusal = Refusal(folder, n, error, events, once=once)
    _in_force.append(refusal)
    try:
        yield refusal
    finally:
        _in_force.remove(refusal)


def watched(folder: Path, events: Collection[str] = CHANGES) -> AbstractContextManager[Refusal]:
    """Note what changes in a folder."""
    return refused(folder, 0, events=events, once=True)


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Forbid to read or enter a path, also where root runs the tests, who is somebody else meanwhile."""
    mode, root = path.stat().st_mode, os.geteuid() == 0
    path.chmod(0)
    if root:
        os.seteuid(_NOBODY)
    try:
        yield
    finally:
        if root:
            os.seteuid(0)
        path.chmod(mode)
