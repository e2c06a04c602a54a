"""A folder into which one batch writes at a time."""

import os
import re
import socket
import uuid
from contextlib import suppress
from pathlib import Path
from typing import Any

from phonemeengine.audio.locking import lock_at
from phonemeengine.batch.remote import is_remote, write_place
from phonemeengine.errors import BatchError
from phonemeengine.execution import Closing
from phonemeengine.storage.files import printable_name, reason_of

LOCK = ".phonemeanalyser-batch.lock"
"""The name of the file that is locked; it tells who holds it."""
PART = re.compile(r"(.+)\.[0-9a-f]{8}\.part")
"""The name of what is being written, see `phonemeengine.storage.files.atomic_write`."""


class FolderLock(Closing):
    """Keeps a folder for one batch, and makes it if need be.

    Attributes
    ----------
    token : stands in the file while the lock is held, so that another machine sees whether its folder is this one.

    Raises
    ------
    BatchError : another batch holds it, or nothing can be written there.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / LOCK
        self.token = f"{os.getpid()} {socket.gethostname()} {uuid.uuid4().hex}"
        self._lock: Any = None
        name = printable_name(folder)
        if is_remote(folder):  # which knows no locks
            write_place(self._path, self.token.encode())
            return
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._lock = lock_at(self._path)
            self._lock.acquire(blocking=False)
            self._path.write_text(self.token, encoding="utf-8")
        except TimeoutError:
            pid, host = ([*holder_of(folder).split(), "?", "?"])[:2]
            raise BatchError(
                f"{name}: another batch (process {pid} on {host}) writes into this folder; wait until it has ended, "
                "or choose another folder"
            ) from None
        except (OSError, NotImplementedError) as error:
            reason = reason_of(error) if isinstance(error, OSError) else "its disk knows no locks"
            raise BatchError(f"{folder}: cannot be written ({reason}); choose another folder") from error

    def close(self) -> None:
        """Let others in."""
        with suppress(OSError):
            self._path.unlink(missing_ok=True)  # before the release: nobody locks a file that has gone
        if self._lock is not None:
            with suppress(OSError):
                self._lock.release()


def holder_of(folder: Path) -> str:
    """Return the token of the batch that writes into a folder; empty where none does, or it cannot be read."""
    try:
        return (folder / LOCK).read_text(encoding="utf-8")
    except (OSError, ValueError):
        return ""


def sweep(targets: set[Path]) -> None:
    """Remove what processes that died have left of these files when they wrote them."""
    for folder in {target.parent for target in targets if not is_remote(target)}:
        with suppress(OSError):
            for part in [*folder.iterdir()]:
                found = PART.fullmatch(part.name)
                if found and folder / found[1] in targets:
                    part.unlink(missing_ok=True)
