"""Locks that the system releases when their process dies. The only module that imports filelock."""

from pathlib import Path
from typing import Any


def lock_at(path: Path) -> Any:
    """Return a lock on a file of its own, not yet acquired.

    ``acquire(blocking=False)`` raises TimeoutError while another holds it, another OSError where it cannot be made,
    and NotImplementedError where the disk knows no locks.
    """
    from filelock import FileLock  # noqa: PLC0415 - takes 40 ms, which only who needs a lock should wait for

    return FileLock(path, thread_local=False)
