"""The takes of a project: kept, checked, trimmed, relabelled, excluded, deleted, and all of that undone."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader, mono_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes.project import TakeProject, read_mono, room_level, take_report, take_reports
from phonemeengine.calibration.takes.quality import TakeReport, check_take
from phonemeengine.calibration.takes.take import TAKES, Take
from phonemeengine.errors import TakeError
from phonemeengine.execution import Progress, subrange
from phonemeengine.live.recorder import to_mono_44k
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE, Channel

LEAST_SECONDS, LEAST_HELD = 0.05, 0.2
"""A shorter segment of a file, and what was held more briefly, was no take but a slip of the finger; seconds."""
AROUND = 0.3
"""What is kept before and after a segment of a file, seconds: so it is recognised as it was said."""
UNNAMED = "me"
"""The speaker, until one is named."""


@dataclass(frozen=True)
class Snapshot:
    """A project as it is after a change.

    Attributes
    ----------
    takes : all of it that is not deleted, in the order in which they were made.
    reports : what the check found, by number.
    changes : what was done with them since the project was opened, and not undone, in words.
    n_deleted : how many takes are deleted, and still on the disk.
    """

    takes: tuple[Take, ...] = ()
    reports: Mapping[int, TakeReport] = field(default_factory=dict)
    changes: tuple[str, ...] = ()
    n_deleted: int = 0


class TakeEdit(QUndoCommand):
    """A change of takes, which the project has made already; its journal takes it back and does it again.

    Parameters
    ----------
    what : the change in words, for the Edit menu.
    n : how many changes of the project it is.
    """

    def __init__(self, takes: "TakesModel", what: str, n: int = 1) -> None:
        super().__init__(tr_engine(what))
        self._takes = takes
        self._n = n
        self._done = True

    @override
    def undo(self) -> None:
        """Take the project's last change back."""
        self._done = False
        self._takes.undo(self._n)

    @override
    def redo(self) -> None:
        """Do it again, but for the first time, when it is pushed."""
        if not self._done:
            self._takes.redo(self._n)
        self._done = True


class TakesModel(QObject):
    """The takes of the current project. The disk is asked in the background.

    Signals
    -------
    opened : another project is open.
    changed : the takes are others.
    edited : a change was made that can be undone: what, in words, and how many takes it changed.
    emptied : deleted takes are gone for ever, and what was done before cannot be undone.
    added : number of a take that is new.
    sound_read : the sound of the selected take is there.
    info : a sentence for the user about something that went well.
    error : a sentence for the user; an empty one after a good take.
    opening_changed : a folder is being opened, is opened farther, or no longer.
    idle : all that was asked of the disk is done.
    """

    opened = Signal()
    changed = Signal()
    edited = Signal(str, int)
    emptied = Signal()
    added = Signal(int)
    sound_read = Signal()
    info = Signal(str)
    error = Signal(str)
    opening_changed = Signal()
    idle = Signal()

    def __init__(self, default_folder: Callable[[], Path]) -> None:
        super().__init__()
        self.speaker = UNNAMED
        self.now = Snapshot()
        self.selected: int | None = None
        self.sound: Float32Array = np.zeros(0, np.float32)
        self._default_folder = default_folder
        self._project: TakeProject | None = None
        self._shown: Path | None = None
        self._reports: dict[int, TakeReport] = {}
        self._disk = TaskQueue(self.error.emit)
        self._disk.idle.connect(self.idle)
        self._to_open: Path | None = None
        self._told_opening: int | None = None
        self._disk.changed.connect(self._follow_disk)

    # -- what there is ------------------------------------------------------------------------------------

    @property
    def folder(self) -> Path | None:
        """The project's folder; None while there is no project."""
        return self._project.folder if self._project else None

    @property
    def busy(self) -> bool:
        """Whether the disk is being asked."""
        return self._disk.busy

    @property
    def opening(self) -> float | None:
        """How much of a folder that is being opened is read and checked, 0..1; None where none is."""
        return None if self._to_open is None else self._disk.progress

    def take(self, number: int) -> Take | None:
        """Return a take by its number; None where there is none."""
        return next((take for take in self.now.takes if take.number == number), None)

    def path_of(self, take: Take) -> Path:
        """Return the sound file of a take."""
        return (self.folder or Path()) / take.sound

    def utterances(self) -> tuple[LabelledUtterance, ...]:
        """Return those takes that count, as labelled recordings."""
        return tuple(
            LabelledUtterance(self.path_of(take), take.to_labels(), take.speaker, "takes")
            for take in self.now.takes
            if not take.excluded
        )

    def noise(self) -> float:
        """Return the level of the room as the newest silence tells it, as an amplitude; 0 where there is none."""
        return room_level(self.now.takes, self._reports)

    # -- the project --------------------------------------------------------------------------------------

    def open(self, folder: Path) -> None:
        """Open a project, made where there is none; the one before is closed when that went well."""

        def act(progress: Progress) -> Snapshot:
            try:
                return self._opened_in_work(folder, lambda share: progress(share) and self._to_open == folder)
            finally:
                if self._to_open == folder:
                    self._to_open = None

        self._to_open = folder
        self._disk.submit(act, self._show)

    def cancel_opening(self) -> None:
        """Leave the folder that is being opened; the project before stays, and whatever else was asked is done."""
        self._to_open = None

    def close(self) -> None:
        """Wait until everything is on the disk, and let the project go."""
        self.cancel_opening()
        self._disk.finish()
        if self._project is not None:
            self._project.close()
            self._project = None

    # -- changes ------------------------------------------------------------------------------------------

    def add(
        self,
        samples: Float32Array,
        rate: int,
        phoneme: Phoneme,
        device: str,
        *,
        instead_of: Callable[[], int | None] = lambda: None,
    ) -> None:
        """Keep a new take, shape (n, n_channels), and check it.

        Parameters
        ----------
        instead_of : gives the number of a take that makes room; asked when all takes before this one are kept.
        """
        if len(samples) < LEAST_HELD * rate:
            self.error.emit(
                tr(
                    "The take is too short ({seconds:.2f} s). Hold {phoneme} for as long as you say the sound."
                ).format(phoneme=sound_name(phoneme), seconds=len(samples) / rate)
            )
            return
        speaker = self.speaker.strip() or UNNAMED

        def act(project: TakeProject) -> Take:
            report = check_take(to_mono_44k(samples, rate), self._noise_now(project), phoneme)
            take = project.add(samples, speaker, phoneme, rate=rate, report=report, device=device)
            self._reports[take.number] = report
            for older in [t for t in project.takes if t.number == instead_of()]:
                project.delete(older)
            return take

        self._change(act, self._tell_added)

    def add_from_file(self, path: Path, channel: Channel, start: float, end: float, phoneme: Phoneme) -> None:
        """Make a segment of a file, in seconds, a take; what lies around it is kept, and does not count.

        The mix keeps both channels of a stereo file.
        """

        def act(project: TakeProject) -> Take:
            before = min(start, AROUND)
            with SoundReader(path, channel, as_it_is=True) as reader:
                reader.seek(round((start - before) * SAMPLE_RATE))
                samples = reader.read(round((before + end - start + AROUND) * SAMPLE_RATE))
            if channel is not Channel.MIX:
                samples = mono_of(samples, channel)[:, np.newaxis]
            marked = samples[round(before * SAMPLE_RATE) : round((before + end - start) * SAMPLE_RATE)]
            report = check_take(to_mono_44k(marked, SAMPLE_RATE), self._noise_now(project), phoneme)
            take = project.add(
                samples,
                self.speaker.strip() or UNNAMED,
                phoneme,
                report=report.within(before, end - start),
                device=path.name,
            )
            self._reports[take.number] = report
            return take

        if end - start < LEAST_SECONDS:
            self.error.emit(
                tr("The range marked in {path} is too short ({seconds:.2f} s). Mark a longer one.").format(
                    path=path.name, seconds=max(0.0, end - start)
                )
            )
            return
        self._change(act, self._tell_added)

    def trim(self, number: int, start: float, end: float) -> None:
        """Let another segment of a take count, seconds."""
        self._change_take(number, lambda project, take: project.trim(take, start, min(end, take.duration)))

    def relabel(self, number: int, phoneme: Phoneme) -> None:
        """Let a take be another phoneme."""
        self._change_take(
            number, lambda project, take: self._checked(project, project.relabel(take, phoneme)) or take
        )

    def set_excluded(self, numbers: Collection[int], excluded: bool) -> None:
        """Let takes count for nothing for now, or let them count again."""
        words = tr("exclude {n} takes") if excluded else tr("include {n} takes")
        self._change_takes(
            numbers, lambda project, take: project.exclude(take) if excluded else project.include(take), words
        )

    def delete(self, numbers: Collection[int]) -> None:
        """Delete takes; one undo brings them back."""
        self._change_takes(numbers, lambda project, take: project.delete(take), tr("delete {n} takes"))

    def undo(self, n: int = 1) -> None:
        """Take the last changes back."""
        self._step(n, TakeProject.undo)

    def redo(self, n: int = 1) -> None:
        """Do again what was undone."""
        self._step(n, TakeProject.redo)

    def empty_deleted(self) -> None:
        """Remove deleted takes for ever; what was done before cannot be undone then."""
        project = self._project
        if project is not None:
            self._disk.submit(
                lambda _progress: (project.empty_deleted(), self._snapshot_of(project)), self._show_emptied
            )

    def write_labels(self, suffix: str, program: str) -> None:
        """Write label files for another program beside the sounds of all takes: its name, and how they end."""
        self._disk.submit(lambda _progress: _write_labels(self._project, suffix, program), self.info.emit)

    def select(self, number: int | None) -> None:
        """Choose a take, whose sound is read."""
        self.selected = number
        take = self.take(number) if number is not None else None
        if take is None:
            self.sound = np.zeros(0, np.float32)
            self.sound_read.emit()
            return
        path = self.path_of(take)
        self._disk.submit(lambda _progress: read_mono(path), lambda sound: self._show_sound(number, sound))

    # -- in the background --------------------------------------------------------------------------------

    def _change_takes(self, numbers: Collection[int], act: Callable[[TakeProject, Take], Take], words: str) -> None:
        """Change several takes at a time, which are one step of undo with words of their own."""
        wanted = frozenset(numbers)

        def change(project: TakeProject) -> None:
            with project.together():
                for take in [t for t in project.takes if t.number in wanted]:
                    act(project, take)

        self._change(change, words=words)

    def _step(self, n: int, step: Callable[[TakeProject], Take | None]) -> None:
        def change(project: TakeProject) -> None:
            with project.together():
                takes = [step(project) for _ in range(n)]
            if n == 1:  # several at a time were excluded, included or deleted, and sound as before
                self._checked(project, takes[0])

        self._change(change, is_new=False)

    def _change_take(self, number: int, act: Callable[[TakeProject, Take], Take]) -> None:
        def change(project: TakeProject) -> Take | None:
            take = next((t for t in project.takes if t.number == number), None)
            return act(project, take) if take is not None else None

        self._change(change)

    def _change(
        self,
        act: Callable[[TakeProject], Take | None],
        then: Callable[[Take], object] = lambda _take: None,
        *,
        is_new: bool = True,
        words: str = "",
    ) -> None:
        """Change the project, one change after the other; the first one makes it where there is none.

        Several changes are one step of undo where there are words for their number.
        """

        def work(progress: Progress) -> tuple[Take | None, Snapshot]:
            if self._project is None:
                self._opened_in_work(self._default_folder(), progress)
            project = self._project
            assert project is not None
            return act(project), self._snapshot_of(project)

        def hand_over(found: tuple[Take | None, Snapshot]) -> None:
            before = len(self.now.changes)
            self._show(found[1])
            made = self.now.changes[before:] if is_new else ()
            if words and len(made) > 1:
                self.edited.emit(words.format(n=len(made)), len(made))
            else:
                for what in made:
                    self.edited.emit(what, 1)
            if found[0] is not None:
                then(found[0])

        self._disk.submit(work, hand_over)

    def _opened_in_work(self, folder: Path, progress: Progress) -> Snapshot:
        if self._project is not None and folder.resolve() == self._project.folder.resolve():
            return self._snapshot_of(self._project)
        project, before = TakeProject(folder, subrange(progress, 0.0, 0.2)), self._project
        try:
            self._reports = take_reports(project, subrange(progress, 0.2, 1.0))
        except BaseException:
            project.close()  # which removes its lock
            raise
        self._project = project
        if before is not None:
            before.close()
        return self._snapshot_of(project)

    def _follow_disk(self) -> None:
        """Tell how far a folder is opened, where that is another than was told."""
        told = None if self.opening is None else int(100 * self.opening)
        if told != self._told_opening:
            self._told_opening = told
            self.opening_changed.emit()

    def _show_emptied(self, found: tuple[int, Snapshot]) -> None:
        self._show(found[1])
        self.emptied.emit()
        self.info.emit(
            tr_count("1 deleted take removed from the disk.", "{n} deleted takes removed from the disk.", found[0])
        )

    def _show(self, now: Snapshot) -> None:
        self.now = now
        if self._project is not None and self.folder != self._shown:
            self._shown = self.folder
            self.select(None)
            self.opened.emit()
            for note in self._project.notes:
                self.info.emit(f"{note[0].upper()}{note[1:]}.")
        if self.selected is not None and self.take(self.selected) is None:
            self.select(None)
        self.changed.emit()

    def _checked(self, project: TakeProject, take: Take | None) -> Take | None:
        """Check a take anew, that may be another phoneme now."""
        if take is not None and not take.deleted:
            self._reports[take.number] = take_report(project, take, self._noise_now(project))
        return take

    def _snapshot_of(self, project: TakeProject) -> Snapshot:
        return Snapshot(project.takes, dict(self._reports), project.changes, len(project.deleted))

    def _noise_now(self, project: TakeProject) -> float:
        return room_level(project.takes, self._reports)

    def _tell_added(self, take: Take) -> None:
        self.added.emit(take.number)
        words = tr("{take} is excluded: {reason}") if take.excluded else "{take}: {reason}"
        faults = self.now.reports[take.number].faults.values()
        told = (words.format(take=take.name, reason=tr_engine(sentence)) for sentence in faults)
        self.error.emit(next(told, ""))

    def _show_sound(self, number: int | None, sound: Float32Array) -> None:
        if number == self.selected:
            self.sound = sound
            self.sound_read.emit()


def _write_labels(project: TakeProject | None, suffix: str, program: str) -> str:
    """Write label files beside all takes, and say how many."""
    if project is None or not project.takes:
        raise TakeError(tr("There are no takes to write labels for. Record one first."))
    aside, n = project.write_copies(suffix), len(project.takes)
    one = tr("1 label file for {program} written to {folder}.")
    many = tr("{n} label files for {program} written to {folder}.")
    files = (one if n == 1 else many).format(n=n, program=program, folder=project.folder / TAKES)
    kept = (
        " " + tr("Files that were changed were kept under another name, such as {name}.").format(name=aside[0].name)
        if aside
        else ""
    )
    return files + kept
