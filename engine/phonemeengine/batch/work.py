"""What is done to each file of a batch, and what came of it."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Any, Protocol

from phonemeengine.execution import Progress

Say = Callable[[str, str], None]
"""Told what is odd about something that is worked on all the same: its name, and a sentence."""


def say_nothing(_name: str, _note: str) -> None:
    """Tell nobody."""


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
    score : how well it says them, 0 is best; None where nobody knows.
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
    source, target : the files, as they were when it was made; None where nobody looked.
    """

    job: Job
    state: JobState
    made: Made = Made()
    notes: tuple[tuple[str, str], ...] = ()
    words: str = ""
    is_fatal: bool = False
    source: FileState | None = None
    target: FileState | None = None
