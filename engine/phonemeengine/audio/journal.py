"""A note for every running recording, so that one which its process did not survive is found.

A note is a file ``<number>.json`` beside a locked ``<number>.lock``. The note appears after the lock is held and goes
before it is released, and the system releases the lock of a process that dies: a note without a holder is a dead one.
"""

import json
import uuid
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
from phonemeengine.storage.files import atomic_write
from phonemeengine.storage.replacing import lock_at


class RecordingMarker:
    """Tells that a recording is running, as long as this process lives.

    Raises
    ------
    OSError, NotImplementedError : the journal cannot be written, or its disk knows no locks.
    """

    def __init__(self, journal: Path, path: Path) -> None:
        journal.mkdir(parents=True, exist_ok=True)
        self._file = journal / f"{uuid.uuid4().hex}.json"
        self._lock = _lock_of(self._file)
        self._lock.acquire(blocking=False)
        begun = datetime.now().astimezone().isoformat(timespec="seconds")
        try:
            with atomic_write(self._file) as file:
                file.write(json.dumps({"path": str(path.absolute()), "begun": begun}).encode())
        except OSError:
            self.remove()
            raise

    def remove(self) -> None:
        """Tell that the recording has ended; may be called twice."""
        _unlink(self._file)
        with suppress(OSError):
            self._lock.release()
        _unlink(_lock_path(self._file))


@dataclass(frozen=True)
class InterruptedRecording:
    """A recording that its process did not survive.

    Attributes
    ----------
    path : the file, which is playable.
    begun : when the recording began.
    seconds : its length.
    note : the journal's file about it.
    """

    path: Path
    begun: datetime
    seconds: float
    note: Path

    def forget(self) -> None:
        """Let it not be given again; the recording itself stays."""
        _dismiss(self.note)


def interrupted_recordings(journal: Path) -> list[InterruptedRecording]:
    """Return the recordings that dead processes left, the oldest first; what has gone or is empty is forgotten."""
    try:
        notes = sorted(journal.glob("*.json"))
    except OSError:
        return []
    found = [recording for note in notes if _is_dead(note) and (recording := _read(note))]
    return sorted(found, key=lambda recording: recording.begun)


def _is_dead(note: Path) -> bool:
    lock = _lock_of(note)
    try:
        lock.acquire(blocking=False)
    except (OSError, NotImplementedError):  # held by the living: a TimeoutError
        return False
    alone = note.exists()
    lock.release()
    if not alone:
        _unlink(_lock_path(note))
    return alone


def _read(note: Path) -> InterruptedRecording | None:
    try:
        content = json.loads(note.read_text(encoding="utf-8"))
        path, begun = Path(content["path"]), datetime.fromisoformat(content["begun"]).astimezone()
        with SoundReader(path) as reader:
            return InterruptedRecording(path, begun, reader.duration, note)
    except (AudioError, ValueError, KeyError, TypeError):
        _dismiss(note)
    except OSError:  # the disk may be away: the note stays for a later start
        pass
    return None


def _dismiss(note: Path) -> None:
    _unlink(note)
    _unlink(_lock_path(note))


def _lock_of(note: Path) -> Any:
    return lock_at(_lock_path(note))


def _lock_path(note: Path) -> Path:
    return note.with_suffix(".lock")


def _unlink(path: Path) -> None:
    with suppress(OSError):
        path.unlink(missing_ok=True)
