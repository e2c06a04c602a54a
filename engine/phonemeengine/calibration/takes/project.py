"""A project of takes: a folder that the user names, which other programs read as a corpus."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader, mono_of
from phonemeengine.calibration.takes.quality import TakeReport, check_take
from phonemeengine.calibration.takes.storage import TakeFolder, write_copy
from phonemeengine.calibration.takes.take import Take
from phonemeengine.errors import TakeError
from phonemeengine.execution import Closing, Progress, no_progress, report_progress
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE

Edit = tuple[str, Take, Take]
"""What was done, to which take, and what it became."""


class TakeProject(Closing):
    """Keeps takes, and changes them so that every change can be undone.

    A take that was changed is another value: go on with the one that is given back. No two programs have a project
    open at once.

    Parameters
    ----------
    folder : of the project; made where there is none.
    progress : called with the share of its takes that is read, 0..1.

    Attributes
    ----------
    folder : of the project; `read_corpus` reads it.
    notes : remarks for the user, a sentence each; mostly none.

    Raises
    ------
    TakeError : it cannot be made, is open elsewhere, is another kind of corpus, or a newer program wrote it.
    CorpusError : its files cannot be read or written.
    Cancelled : the answer of `progress` is not to go on.
    """

    def __init__(self, folder: Path, progress: Progress = no_progress) -> None:
        self.folder = folder
        self._disk = TakeFolder(folder, progress)
        self.notes = self._disk.notes
        self._done: list[Edit] = []
        self._undone: list[Edit] = []

    @property
    def takes(self) -> tuple[Take, ...]:
        """The takes, also the excluded ones, in the order in which they were made."""
        return self._chosen(lambda take: not take.deleted and take.number not in self._disk.missing)

    @property
    def deleted(self) -> tuple[Take, ...]:
        """What was deleted and can be restored."""
        return self._chosen(lambda take: take.deleted and take.number not in self._disk.missing)

    @property
    def missing(self) -> tuple[Take, ...]:
        """Takes whose sounds were not there when the project was opened."""
        return self._chosen(lambda take: take.number in self._disk.missing)

    @property
    def changes(self) -> tuple[str, ...]:
        """What `undo` takes back, one after the other from the last, in words such as ``delete a-3``."""
        return tuple(what for what, _, _ in self._done)

    def path_of(self, take: Take) -> Path:
        """Return the sound file of a take."""
        return self.folder / take.sound

    def add(
        self,
        samples: Float32Array,
        speaker: str,
        phoneme: Phoneme,
        *,
        rate: int = SAMPLE_RATE,
        report: TakeReport | None = None,
        device: str = "",
        time: datetime | None = None,
    ) -> Take:
        """Keep a new take.

        Parameters
        ----------
        samples : shape (n,) or (n, n_channels), ±1.
        speaker : who said it.
        phoneme : what was said.
        rate : Hz.
        report : what the check found: its steady segment counts, and the take is excluded where nothing or too
            little is found; where it is None, everything counts.
        device : the microphone, or the file that the sound is from.
        time : when it was recorded; now, where it is None.

        Raises
        ------
        TakeError : the sound is empty or the speaker has no name.
        RecordingError, CorpusError : the disk refuses; nothing has changed.
        """
        if not len(samples) or not speaker.strip():
            raise TakeError(
                f"a take needs a sound and a speaker's name, got {len(samples)} samples by {speaker!r:.40}"
            )
        duration, number, by = len(samples) / rate, self._disk.free_number(), speaker.strip()
        start, end, onset, offset = _stretch_of(report, duration)
        take = Take(
            number=number,
            sound=self._disk.place_for(number, by, phoneme, deleted=False),
            speaker=by,
            phoneme=phoneme,
            duration=duration,
            start=start,
            end=end,
            onset=onset,
            offset=offset,
            device=device,
            excluded=report is not None and report.too_little,
            time=(time or datetime.now()).astimezone().isoformat(timespec="seconds"),
            pauses=tuple((min(a, end), min(b, end)) for a, b in report.pauses) if report is not None else (),
        )
        self._disk.add(take, samples, rate)
        away = self._disk.place_for(number, by, phoneme, deleted=True)
        self._remember(f"add {take.name}", replace(take, deleted=True, sound=away), take)
        return take

    def trim(self, take: Take, start: float, end: float) -> Take:
        """Let another segment of a take count, in seconds; its sound stays as it is.

        Raises
        ------
        TakeError : there is no such segment, or no such take.
        CorpusError : the disk refuses; nothing has changed. So do all other changes.
        """
        return self._change("trim", take, replace(self._disk.current(take), start=start, end=end))

    def relabel(self, take: Take, phoneme: Phoneme) -> Take:
        """Return that a take is another phoneme; its files are renamed."""
        place = self._disk.place_for(take.number, take.speaker, phoneme, deleted=take.deleted)
        return self._change("relabel", take, replace(self._disk.current(take), phoneme=phoneme, sound=place))

    def exclude(self, take: Take) -> Take:
        """Let a take count for nothing, for now."""
        return self._change("exclude", take, replace(self._disk.current(take), excluded=True))

    def include(self, take: Take) -> Take:
        """Let an excluded take count again."""
        return self._change("include", take, replace(self._disk.current(take), excluded=False))

    def delete(self, take: Take) -> Take:
        """Move a take to the folder ``deleted``, from where it can be restored."""
        return self._move("delete", take, deleted=True)

    def restore(self, take: Take) -> Take:
        """Bring a deleted take back."""
        return self._move("restore", take, deleted=False)

    def undo(self) -> Take | None:
        """Take the last change back, and give the take as it is then; None where there is nothing to undo."""
        return self._step(self._done, self._undone, back=True)

    def redo(self) -> Take | None:
        """Do the change again that was undone last, and give the take; None where there is nothing to redo."""
        return self._step(self._undone, self._done, back=False)

    @contextmanager
    def together(self) -> Iterator[None]:
        """Make several changes at once, which takes no longer than one where there are thousands of takes.

        Raises
        ------
        CorpusError : the disk refuses; none of the changes has happened.
        """
        before = self._done[:], self._undone[:]
        try:
            with self._disk.together():
                yield
        except BaseException:
            self._done, self._undone = before
            raise

    def empty_deleted(self) -> int:
        """Remove the sounds of deleted takes for ever, and give their number; what was done before cannot be undone.

        Raises
        ------
        CorpusError : the disk refuses; what was not removed is still there.
        """
        gone = self.deleted
        self._disk.forget(gone)
        self._done, self._undone = [], []
        return len(gone)

    def write_copies(self, suffix: str) -> tuple[Path, ...]:
        """Write label files for another program beside the sounds of all takes, which follow them from now on.

        Parameters
        ----------
        suffix : ``.TextGrid`` for Praat, ``.txt`` for Audacity.

        Returns
        -------
        What was there and said something else, under its new name.

        Raises
        ------
        CorpusError : the disk refuses; what was there is still there.
        """
        found = [write_copy(self.folder, take, suffix) for take in self.takes]
        return tuple(path for path in found if path is not None)

    @override
    def close(self) -> None:
        """Let others open the project; may be called twice."""
        self._disk.close()

    def _chosen(self, wanted: Callable[[Take], bool]) -> tuple[Take, ...]:
        return tuple(take for _, take in sorted(self._disk.takes.items()) if wanted(take))

    def _move(self, what: str, take: Take, *, deleted: bool) -> Take:
        old = self._disk.current(take)
        if old.deleted == deleted:
            return old
        place = self._disk.place_for(old.number, old.speaker, old.phoneme, deleted=deleted)
        return self._change(what, take, replace(old, sound=place, deleted=deleted))

    def _change(self, what: str, take: Take, changed: Take) -> Take:
        old = self._disk.current(take)
        if changed != old:
            self._disk.put(changed)
            self._remember(f"{what} {old.name}", old, changed)
        return changed

    def _remember(self, what: str, old: Take, new: Take) -> None:
        self._done.append((what, old, new))
        self._undone.clear()

    def _step(self, source: list[Edit], target: list[Edit], *, back: bool) -> Take | None:
        if not source:
            return None
        _, old, new = source[-1]
        take = old if back else new
        self._disk.put(take)
        target.append(source.pop())
        return take


def _stretch_of(report: TakeReport | None, duration: float) -> tuple[float, float, float, float]:
    """Return start, end, onset and offset of what counts; all of the sound where none was found in it."""
    if report is None or report.start >= min(report.end, duration):
        return 0.0, duration, 0.0, duration
    start, end, onset, offset = (min(t, duration) for t in (report.start, report.end, report.onset, report.offset))
    return start, end, onset, offset


# What the check finds of takes that are on the disk.


def read_mono(path: Path) -> Float32Array:
    """Read a whole sound, of one channel, shape (n,)."""
    with SoundReader(path, as_it_is=True) as reader:
        return mono_of(reader.read(reader.n_samples), reader.channel)


def take_reports(project: TakeProject, progress: Progress = no_progress) -> dict[int, TakeReport]:
    """Check all takes, the silence first: it tells the room's level.

    Raises
    ------
    AudioError : a sound cannot be read.
    Cancelled : the answer of `progress` is not to go on.
    """
    silences = tuple(take for take in project.takes if take.phoneme is Phoneme.SILENCE)
    others = tuple(take for take in project.takes if take.phoneme is not Phoneme.SILENCE)
    reports: dict[int, TakeReport] = {}
    noise = 0.0
    for k, take in enumerate((*silences, *others)):
        report_progress(progress, k / (len(silences) + len(others)))
        reports[take.number] = take_report(project, take, noise)
        if take.phoneme is Phoneme.SILENCE and not take.excluded:
            noise = room_level((take,), reports)
    return reports


def take_report(project: TakeProject, take: Take, noise: float) -> TakeReport:
    """Check a take in a room with noise of this amplitude."""
    return check_take(read_mono(project.path_of(take)), noise, take.phoneme)


def room_level(takes: tuple[Take, ...], reports: Mapping[int, TakeReport]) -> float:
    """Return the level of the room as the newest silence tells it, as an amplitude; 0 where there is none."""
    silences = [t for t in takes if t.phoneme is Phoneme.SILENCE and not t.excluded and t.number in reports]
    return float(10 ** (reports[silences[-1].number].level / 20)) if silences else 0.0
