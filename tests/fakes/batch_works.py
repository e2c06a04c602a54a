"""Work for batches whose troubles are named by the files."""

import errno
import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from phonemeengine.batch.work import Act, Job, Made, Say, fingerprint_of
from phonemeengine.errors import ExportError
from phonemeengine.execution import Cancelled, Progress, report_progress
from phonemeengine.presets.preset import Preset
from phonemeengine.storage.files import atomic_write
from tests.waiting import wait_for

SECONDS = 2.0


@dataclass(frozen=True)
class CopyWork:
    """Writes what a file says, and a word before it; files with these words in their names have trouble.

    ``fails`` is refused, ``crashes`` meets a bug, ``dies`` ends its process, ``dies-once`` does so the first time,
    ``full`` finds the disk full, ``waits`` waits until it is cancelled, ``holds`` says its name and waits for ever.
    """

    word: str = "copy"
    preset: Preset | None = None

    def fingerprint(self) -> str:
        return fingerprint_of(self)

    def known_of(self, job: Job) -> str:
        return "another text" if "text" in job.source.name else ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        if self.word == "closed":
            raise ExportError("what is needed cannot be opened")
        if self.word == "hungry":
            bytearray(1 << 30)
        yield self._copy

    def _copy(self, job: Job, say: Say, progress: Progress) -> Made:
        assert job.target is not None
        name = job.source.stem
        if name.startswith("noted"):
            say(name, "it is odd")
        job.target.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(job.target) as file:
            file.write(f"{self.word} ".encode())
            report_progress(progress, 0.5)
            _trouble(name, job, progress)
            file.write(job.source.read_bytes())
        return Made(SECONDS)


def _trouble(name: str, job: Job, progress: Progress) -> None:
    troubles = {
        "holds": _hold,
        "fails": _fail,
        "crashes": _crash,
        "dies-once": _die_once,
        "dies": _die,
        "full": _find_full,
        "waits": _wait,
    }
    act = next((act for word, act in troubles.items() if name.startswith(word)), None)
    if act is not None:
        act(job.source, progress)


def _hold(source: Path, _progress: Progress) -> None:
    os.write(1, f"{source.stem}\n".encode())  # at once, as several processes say theirs
    threading.Event().wait()


def _fail(source: Path, _progress: Progress) -> None:
    raise ExportError(f"{source.name}: it is refused")


def _crash(_source: Path, _progress: Progress) -> None:
    raise ZeroDivisionError("a bug")


def _die(_source: Path, _progress: Progress) -> None:
    os._exit(1)


def _die_once(source: Path, _progress: Progress) -> None:
    marker = source.with_suffix(".died")
    if not marker.exists():
        marker.touch()
        os._exit(1)


def _find_full(source: Path, _progress: Progress) -> None:
    try:
        raise OSError(errno.ENOSPC, "No space left on device")
    except OSError as error:
        raise ExportError(f"{source.name}: cannot be written (No space left on device)") from error


def _wait(source: Path, progress: Progress) -> None:
    source.with_suffix(".waiting").touch()
    wait_for(lambda: not progress(0.5))
    raise Cancelled
