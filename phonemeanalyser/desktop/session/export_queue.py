"""Sound files that are turned into other files, one after the other, while the window goes on."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.export_kinds import EXPORT_KINDS, ExportOrder
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import EngineError
from phonemeengine.progress import Progress

MOST_PREVIEWED = 4000
"""Characters of a file that are shown before it is written."""


class ExportState(StrEnum):
    """What became of a file."""

    WAITING = tr_noop("waiting")
    WORKING = tr_noop("at work")
    DONE = tr_noop("done")
    FAILED = tr_noop("failed")
    CANCELLED = tr_noop("cancelled")


@dataclass(frozen=True)
class ExportJob:
    """A sound file and what it becomes.

    Attributes
    ----------
    source, target : the files.
    state : what became of it.
    duration : of the sound, seconds; 0 where it cannot be read.
    words : what went wrong, for people.
    """

    source: Path
    target: Path
    state: ExportState = ExportState.WAITING
    duration: float = 0.0
    words: str = ""


class ExportQueue(QObject):
    """Works through a list of files; what fails is said, and the others go on.

    Signals
    -------
    changed : something became of a file.
    finished : all is done, or cancelled.
    previewed : the beginning of what a sound would become, or why it cannot.

    Attributes
    ----------
    jobs : the list.
    """

    changed = Signal()
    finished = Signal()
    previewed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: list[ExportJob] = []
        self._work = TaskQueue(self.previewed.emit)
        self._preview = TaskQueue(self.previewed.emit)
        self._work.changed.connect(self.changed)
        self._work.idle.connect(self.finished)

    @property
    def busy(self) -> bool:
        """Whether files are still to be made."""
        return self._work.busy

    @property
    def progress(self) -> float:
        """How much of the whole list is done, 0..1."""
        over = sum(job.state not in {ExportState.WAITING, ExportState.WORKING} for job in self.jobs)
        at_work = self._work.progress if self._work.busy else 0.0
        return (over + at_work) / max(1, len(self.jobs))

    def start(self, targets: dict[Path, Path], order: ExportOrder) -> None:
        """Turn sounds into the files that they are to become, in this order."""
        self.jobs = [ExportJob(source, target) for source, target in targets.items()]
        for k in range(len(self.jobs)):
            self._work.submit(partial(self._convert, k, order))
        self.changed.emit()

    def cancel(self) -> None:
        """End all work; files that are complete stay, and none is left half."""
        self._work.cancel()
        for k, job in enumerate(self.jobs):
            if job.state in {ExportState.WAITING, ExportState.WORKING}:
                self._put(k, replace(job, state=ExportState.CANCELLED))
        self.finished.emit()

    def preview(self, source: Path, order: ExportOrder) -> None:
        """Find what a sound would become, and tell its beginning."""
        self._preview.replace(lambda progress: _beginning_of(source, order, progress), self.previewed.emit)

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)
        self._preview.close(CLOSE_TIMEOUT)

    def _convert(self, k: int, order: ExportOrder, progress: Progress) -> None:
        job = replace(self.jobs[k], state=ExportState.WORKING)
        self._put(k, job)
        try:
            with SoundReader(job.source) as reader:
                job = replace(job, duration=reader.duration)
            EXPORT_KINDS[order.kind].make(job.source, job.target, order, progress)
        except EngineError as error:
            self._put(k, replace(job, state=ExportState.FAILED, words=str(error)))
        else:
            self._put(k, replace(job, state=ExportState.DONE))

    def _put(self, k: int, job: ExportJob) -> None:
        self.jobs[k] = job
        self.changed.emit()


def _beginning_of(source: Path, order: ExportOrder, progress: Progress) -> str:
    if not EXPORT_KINDS[order.kind].is_text:
        return tr("A clip is seen once it is made; the page Talk shows the same head at once.")
    with TemporaryDirectory() as folder:
        target = Path(folder) / f"{source.stem}{EXPORT_KINDS[order.kind].ending}"
        EXPORT_KINDS[order.kind].make(source, target, order, progress)
        content = target.read_bytes()
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return tr("{target}: {n} bytes that are no text").format(
            target=target.name, n=f"{len(content):,}".replace(",", " ")
        )
    return text[:MOST_PREVIEWED] + ("\n…" if len(text) > MOST_PREVIEWED else "")


def sounds_in(paths: Sequence[Path], suffixes: Collection[str]) -> list[Path]:
    """Return sound files, and those in folders however deep, in order and each once."""
    found: dict[Path, None] = {}
    for path in paths:
        inside = sorted(path.rglob("*")) if path.is_dir() else [path]
        found |= {p: None for p in inside if p.is_file() and (p == path or p.suffix.lower() in suffixes)}
    return list(found)
