"""What was made in a folder, and of what: a file in it with a line for each output, to which lines are added.

A line is a JSON object. It counts as long as its output and its source are what they were, and what is asked for is
the same. Size and time of writing are looked at first; where only the time differs, the content is.
"""

import json
import os
import re
import socket
import time
import uuid
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from typing_extensions import override

from phonemeengine.batch.remote import is_remote, write_place
from phonemeengine.batch.work import FileState, Job, JobState, Made, Outcome, digest_of, size_and_time
from phonemeengine.errors import BatchError
from phonemeengine.execution import Closing
from phonemeengine.storage.files import atomic_write, printable_name, reason_of
from phonemeengine.storage.replacing import lock_at

RECORD = ".phonemeanalyser-batch"
"""Its name."""
INTERVAL = 30.0
"""Seconds after which a record at an address is written anew."""


class BatchRecord(Closing):
    """The record of a folder; one that cannot be read is begun anew.

    Parameters
    ----------
    folder : where the outputs go.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._path = folder / RECORD
        self._lines: dict[str, dict[str, Any]] = {}
        self._written, self._is_late = time.monotonic(), False
        content = self._content()
        lines = content.splitlines()
        for line in lines:
            with suppress(ValueError, KeyError, TypeError):
                entry = json.loads(line)
                self._lines[entry["target"]] = entry
        self._is_loose = bool(content) and (len(lines) > 2 * len(self._lines) or not content.endswith(b"\n"))

    def tidy(self) -> None:
        """Write the file anew where many lines no longer count, or the last one was cut off."""
        if self._is_loose:
            self._rewrite()

    def found(self, job: Job, key: str) -> Outcome | None:
        """Return what came of a job before; None where it is to be done, now or again.

        Parameters
        ----------
        key : what tells what is asked for, see `fingerprint_of`.
        """
        entry = None if job.target is None else self._lines.get(self._name_of(job.target))
        if entry is None or job.target is None or entry.get("key") != key:
            return None
        try:
            outcome = Outcome(
                job,
                JobState.SKIPPED,
                Made(**entry["made"]),
                tuple((n, w) for n, w in entry["notes"]),
                source=FileState(**entry["source"]),
                target=FileState(**entry["written"]),
            )
            states = _same(job.source, outcome.source), _same(job.target, outcome.target)
        except (OSError, ValueError, KeyError, TypeError):
            return None
        if None in states:
            return None
        if states != (outcome.source, outcome.target):
            outcome = replace(outcome, source=states[0], target=states[1])
            self.add([(outcome, key)])
        return outcome

    def made_earlier(self, job: Job, key: str) -> bool | None:
        """Return whether the target that is there was made by what is asked for; None where that is not known.

        Parameters
        ----------
        key : as in `found`.
        """
        entry = None if job.target is None else self._lines.get(self._name_of(job.target))
        if entry is None or job.target is None:
            return None
        try:
            is_there = _same(job.target, FileState(**entry["written"])) is not None
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return entry.get("key") == key if is_there else None

    def add(self, outcomes: Iterable[tuple[Outcome, str]]) -> None:
        """Note what was made, with the keys of what was asked for.

        Raises
        ------
        BatchError : it cannot be written.
        """
        entries = [self._entry_of(outcome, key) for outcome, key in outcomes]
        self._lines |= {entry["target"]: entry for entry in entries}
        if not entries:
            return
        if is_remote(self._path):
            self._is_late = True
            if time.monotonic() - self._written > INTERVAL:
                self.close()
            return
        try:
            _append(self._path, _lines_of(entries))
        except OSError as error:
            raise BatchError(
                f"{printable_name(self._folder)}: what was done cannot be noted there ({reason_of(error)}); free "
                "some space, or choose another folder"
            ) from error

    @override
    def close(self) -> None:
        """Write what was not written yet: nothing can be added to what is at an address."""
        if self._is_late:
            self._rewrite()
            self._written, self._is_late = time.monotonic(), False

    def _entry_of(self, outcome: Outcome, key: str) -> dict[str, Any]:
        assert outcome.job.target is not None
        assert outcome.source is not None
        assert outcome.target is not None
        made = outcome.made
        return {
            "target": self._name_of(outcome.job.target),
            "key": key,
            "source": asdict(outcome.source),
            "written": asdict(outcome.target),
            "made": {"duration": made.duration, "language": made.language, "score": made.score},
            "notes": outcome.notes,
        }

    def _name_of(self, target: Path) -> str:
        return str(target).removeprefix(str(self._folder)).replace("\\", "/").lstrip("/")

    def _content(self) -> bytes:
        try:
            return self._path.read_bytes()
        except OSError:
            return b""

    def _rewrite(self) -> None:
        if is_remote(self._path):
            write_place(self._path, _lines_of(self._lines.values()))
            return
        with atomic_write(self._path) as file:
            file.write(_lines_of(self._lines.values()))


def _same(path: Path, before: FileState | None) -> FileState | None:
    """Return what a file is now, if its content is what it was; else None."""
    size, changed = size_and_time(path)
    if before is None or size != before.size:
        return None
    if changed == before.changed:
        return before
    return replace(before, changed=changed) if digest_of(path) == before.digest else None


def _lines_of(entries: Iterable[dict[str, Any]]) -> bytes:
    return "".join(f"{json.dumps(entry)}\n" for entry in entries).encode()


def _append(path: Path, lines: bytes) -> None:
    """Add lines in one go."""
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | getattr(os, "O_BINARY", 0), 0o666)
    try:
        os.write(handle, lines)
    finally:
        os.close(handle)


# A folder into which one batch writes at a time.

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

    @override
    def close(self) -> None:
        with suppress(OSError):
            self._path.unlink(missing_ok=True)  # before the release: no process locks a file that has gone
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
