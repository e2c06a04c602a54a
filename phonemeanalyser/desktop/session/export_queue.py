"""Sound files that are turned into other files, one after the other, while the window goes on."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.export_kinds import EXPORT_KINDS, PICTURES, ExportOrder, with_texts, work_of
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.reports.batch_report import write_batch_report
from phonemeengine.audio.files import SoundReader, sounds_under
from phonemeengine.batch.runner import BatchOptions, BatchProgress, run_batch
from phonemeengine.batch.runner import in_the_way as jobs_in_the_way
from phonemeengine.batch.work import Job, JobState, Outcome, say_nothing
from phonemeengine.conversion.work import CONVERSIONS
from phonemeengine.execution import Progress
from phonemeengine.inspection.measurement import save_stretch
from phonemeengine.settings import Channel

MOST_PREVIEWED = 4000
"""Characters of a file that are shown before it is written."""
SECONDS_PREVIEWED = 30.0
"""Of a longer sound, what its beginning becomes is shown."""


class ExportState(StrEnum):
    """What became of a file."""

    WAITING = tr_noop("waiting")
    WORKING = tr_noop("running")
    DONE = tr_noop("done")
    SKIPPED = tr_noop("already done")
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
    notes : what is odd, for people.
    """

    source: Path
    target: Path
    state: ExportState = ExportState.WAITING
    duration: float = 0.0
    words: str = ""
    notes: tuple[str, ...] = ()


class ExportQueue(QObject):
    """Works through a list of files, many of them on all cores; what fails is said, and the others go on.

    Signals
    -------
    changed : something became of a file.
    finished : all is done, or cancelled.
    previewed : the beginning of what a sound would become, or why it cannot.

    Attributes
    ----------
    jobs : the list.
    progress : how much of the whole list is done, 0..1.
    """

    changed = Signal()
    finished = Signal()
    previewed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: list[ExportJob] = []
        self.progress = 0.0
        self._numbers: dict[Job, int] = {}
        self._lock, self._is_cancelled = Lock(), False
        self._work = TaskQueue(self._refuse)
        self._preview = TaskQueue(self.previewed.emit)
        self._work.changed.connect(self.changed)
        self._work.idle.connect(self._end)

    @property
    def busy(self) -> bool:
        """Whether files are still to be made."""
        return self._work.busy

    def start(self, targets: dict[Path, Path], order: ExportOrder, folder: Path | None = None) -> None:
        """Turn sounds into the files that they are to become.

        Parameters
        ----------
        targets : the files, by sound.
        order : what they are turned into.
        folder : where all of them go, in which it is noted what was done, so that it is not done twice; None where
            they go beside their sounds.
        """
        self.jobs = [ExportJob(source, target) for source, target in targets.items()]
        self.progress, self._is_cancelled = 0.0, False
        jobs = [Job(source, target) for source, target in targets.items()]
        self._numbers = {job: k for k, job in enumerate(jobs)}
        self._work.submit(lambda progress: self._run(jobs, order, folder, progress))
        self.changed.emit()

    def cancel(self) -> None:
        """End all work; files that are complete stay, and none is left half."""
        self._work.cancel()
        with self._lock:
            self._is_cancelled = True
            for k, job in enumerate(self.jobs):
                if job.state in {ExportState.WAITING, ExportState.WORKING}:
                    self.jobs[k] = replace(job, state=ExportState.CANCELLED)
        self.finished.emit()

    def preview(self, source: Path, order: ExportOrder) -> None:
        """Find what a sound would become, and tell its beginning."""
        self._preview.replace(lambda progress: _beginning_of(source, order, progress), self.previewed.emit)

    def close(self) -> None:
        """End all work."""
        self._work.close(CLOSE_TIMEOUT)
        self._preview.close(CLOSE_TIMEOUT)

    def _refuse(self, sentence: str) -> None:
        """Say of all files that were left why nothing becomes of them."""
        for k, job in enumerate(self.jobs):
            if job.state in {ExportState.WAITING, ExportState.WORKING}:
                self.jobs[k] = replace(job, state=ExportState.FAILED, words=sentence)
        self.finished.emit()

    def _end(self) -> None:
        """Say of files that are left, as after an error of the program, that nothing became of them."""
        self._refuse(tr("stopped by an unexpected error"))

    def _run(self, jobs: list[Job], order: ExportOrder, folder: Path | None, progress: Progress) -> None:
        """Work in a thread of its own."""

        def show(found: BatchProgress) -> bool:
            self.progress = found.share
            for job in found.at_hand:
                self._put(job, state=ExportState.WORKING)
            return progress(found.share)

        if order.speech is not None or order.kind == PICTURES:
            folder = None  # neither a text nor a folder of pictures is a file of which it could be noted
        options = BatchOptions(folder=folder)
        known = with_texts(order, [job.source for job in jobs])
        if order.texts is None and known.texts is not None:
            for job in jobs:
                if not known.texts.knows(job.source):
                    self._put(job, notes=(tr("no text or TextGrid beside the file"),))
        outcomes = run_batch(jobs, work_of(known), options, on_outcome=self._take, on_progress=show)
        if folder is not None:
            write_batch_report(outcomes, folder)

    def _take(self, outcome: Outcome) -> None:
        state, duration = _STATES[outcome.state], outcome.made.duration
        notes = (*self.jobs[self._numbers[outcome.job]].notes, *(note for _, note in outcome.notes))
        self._put(outcome.job, state=state, duration=duration, words=outcome.words, notes=notes)

    def _put(self, job: Job, **known: Any) -> None:
        number = self._numbers[job]
        with self._lock:
            if self._is_cancelled and known.get("state") is ExportState.WORKING:
                return
            self.jobs[number] = replace(self.jobs[number], **known)
        self.changed.emit()


_STATES = {
    JobState.DONE: ExportState.DONE,
    JobState.SKIPPED: ExportState.SKIPPED,
    JobState.FAILED: ExportState.FAILED,
}


def in_the_way(targets: dict[Path, Path], order: ExportOrder, folder: Path | None) -> list[Path]:
    """Return the sounds whose files are there already, and are not known to be what the same order made.

    Of pictures, those whose folder is not empty.

    Parameters
    ----------
    targets, order, folder : as in `ExportQueue.start`.
    """
    if order.kind == PICTURES:
        return [source for source, folder in targets.items() if folder.is_dir() and any(folder.iterdir())]
    jobs = [Job(source, target) for source, target in targets.items() if target.is_file()]
    work = work_of(with_texts(order, [job.source for job in jobs]))
    return [job.source for job in jobs_in_the_way(jobs, work, folder)]


def _beginning_of(source: Path, order: ExportOrder, progress: Progress) -> str:
    if order.kind.startswith("clip-"):
        return tr("Clips have no preview. The Talk page shows the same head.")
    with TemporaryDirectory() as folder:
        order, is_long = with_texts(order, [source]), False
        if order.speech is None:
            with SoundReader(source) as reader:
                is_long = reader.duration > SECONDS_PREVIEWED
        has_words = order.texts is not None and order.texts.knows(source)
        if is_cut := is_long and order.kind in CONVERSIONS and not has_words:
            beginning = Path(folder) / f"{source.stem}.wav"
            save_stretch(source, 0.0, SECONDS_PREVIEWED, beginning, channel=order.channel)
            source, order = beginning, replace(order, channel=Channel.MIX)
        target = Path(folder) / f"{source.stem}{EXPORT_KINDS[order.kind].ending}"
        with work_of(order).opened() as act:
            act(Job(source, target), say_nothing, progress)
        content = target.read_bytes()
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return tr("{target}: {n} bytes of binary data").format(
            target=target.name, n=f"{len(content):,}".replace(",", " ")
        )
    return text[:MOST_PREVIEWED] + ("\n…" if is_cut or len(text) > MOST_PREVIEWED else "")


def sounds_in(paths: Sequence[Path]) -> list[Path]:
    """Return sound files, and those in folders however deep, in order and each once."""
    found: dict[Path, None] = {}
    for path in paths:
        found |= dict.fromkeys(sounds_under(path) if path.is_dir() else [path] if path.is_file() else [])
    return list(found)
