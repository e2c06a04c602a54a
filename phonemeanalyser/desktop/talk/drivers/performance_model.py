"""Recorded faces for what is said: which files are open, which one is chosen, and what it shows of the sound."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Signal
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeengine.analyser import analyse_file
from phonemeengine.arrays import Float32Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import EngineError, PerformanceError
from phonemeengine.execution import Progress, report_progress
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.style import Style, neutral_style
from phonemeengine.mouth.transcript import Prosody, Transcript, transcript_of_utterance
from phonemeengine.performance.choice import ExampleChoice, chosen_table
from phonemeengine.performance.driver import FACE, PerformanceDriver, PerformanceOptions, UsedUnit
from phonemeengine.performance.own_sound import OwnSound
from phonemeengine.performance.style_fit import FittedStyle, fit_style
from phonemeengine.performance.table_file import PerformanceTable, TableAbout
from phonemeengine.performance.track import PerformanceTrack, PerformedMouth, SpokenFace
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import FRAME_PERIOD, Channel


class OpenedFiles(QObject):
    """Opens files of a kind in the background, and knows which one is in use.

    Parameters
    ----------
    look : reads what is to be known of a file, which has a `title`.
    load : reads the same, and what is in it.

    Signals
    -------
    changed : other files or another choice, or it is going on.
    error : a sentence for the user.

    Attributes
    ----------
    known : what is known of the files that were opened, by path; each has a `title`.
    chosen : the file in use; None for none.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, look: Callable[[Path], Any], load: Callable[[Path], tuple[Any, Any]]) -> None:
        super().__init__()
        self.known: dict[Path, Any] = {}
        self.chosen: Path | None = None
        self._look, self._load = look, load
        self._value: Any = None
        self._kept: tuple[tuple[Path, ...], Path | None] = (), None
        self._opening = TaskQueue(self.error.emit)
        self._opening.changed.connect(self.changed)

    @property
    def name(self) -> str:
        """What the file in use is called, and whether no person moved for it; empty without one."""
        return "" if self.chosen is None else str(self.known[self.chosen].title)

    def keep(self, paths: Sequence[Path], chosen: Path | None) -> None:
        """Take note of what was open at the last start; `wake` opens it."""
        self._kept = tuple(paths), chosen

    def wake(self) -> None:
        """Open what was open at the last start, in the background; what is not there any more is forgotten."""
        (paths, chosen), self._kept = self._kept, ((), None)
        if paths:
            self._opening.submit(lambda _progress: self._found(paths), lambda found: self._take_found(found, chosen))

    @property
    def opened(self) -> tuple[tuple[Path, ...], Path | None]:
        """The files that are open, or would be after `wake`, and the one in use."""
        return self._kept if self._kept[0] else (tuple(self.known), self.chosen)

    def open(self, path: Path) -> None:
        """Open a file, in the background, and use it."""
        self._open(path)

    def choose(self, path: Path | None) -> None:
        """Use a file that was opened before; None for none."""
        if path is not None:
            self._open(path)
        elif self.chosen is not None:
            self._opening.cancel()
            self.chosen = self._value = None
            self.changed.emit()

    def _open(self, path: Path) -> None:
        self._opening.replace(lambda _progress: self._load(path), lambda loaded: self._take(path, *loaded))

    def _found(self, paths: Sequence[Path]) -> dict[Path, Any]:
        """Return what is known of those files that can be opened."""
        known = {}
        for path in paths:
            with suppress(EngineError):  # which is no longer listed
                known[path] = self._look(path)
        return known

    def _take_found(self, known: dict[Path, Any], chosen: Path | None) -> None:
        self.known = {**known, **self.known}
        if chosen in known and self.chosen is None:
            self._open(chosen)
        self.changed.emit()

    def _take(self, path: Path, known: Any, value: Any) -> None:
        self._value, self.chosen = value, path
        self.known[path] = known
        self.changed.emit()


AHEAD = 20.0
"""Seconds of a sound that are looked up before they are played."""


@dataclass(frozen=True)
class MeasuredSound:
    """A sound whose loudness and pitch count.

    Attributes
    ----------
    path, channel : the file, and which channel of it is analysed.
    preset : what the loudness is measured with.
    """

    path: Path
    channel: Channel
    preset: Preset


class FaceInHand:
    """A `MouthTrack` that raises no error: where its table fails, the face is at rest.

    Attributes
    ----------
    failure : why the table failed, as a sentence; empty where it did not.
    """

    movestates = FACE

    def __init__(self, face: PerformedMouth | SpokenFace) -> None:
        self.failure = ""
        self._face = face

    def shows(self, face: SpokenFace) -> bool:
        """Return whether it is that face."""
        return self._face is face

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds."""
        try:
            return self._face.weights(time)
        except PerformanceError as error:
            self.failure = str(error)
            return np.zeros(len(FACE), np.float32)

    def head(self, time: float) -> HeadPose | None:
        """Return how the head is turned at a time, seconds; None where it follows the sound."""
        try:
            return self._face.head(time)
        except PerformanceError as error:
            self.failure = str(error)
            return None

    def prepare(self, begin: float, end: float) -> None:
        """Look up what is said between two times, seconds."""
        if isinstance(self._face, PerformedMouth):  # what is spoken is looked up before it can play
            try:
                self._face.prepare(begin, end)
            except PerformanceError as error:
                self.failure = str(error)


class PerformanceModel(OpenedFiles):
    """Knows the tables that are open, and looks the current sound up in the one that is chosen.

    Signals
    -------
    looked_up : another face, or more units of it.
    info : a sentence for the user.

    Attributes
    ----------
    person : whose tables are used, by the language of the text; empty where a table is chosen by hand.
    choice : among the examples of a unit.
    style : in which the face speaks.
    face : what the performer shows of the current sound; None where nothing is looked up.
    units : of which it is made; they come later than the face.
    notes : what the table lacks for it, a sentence each.
    """

    looked_up = Signal()
    info = Signal(str)

    def __init__(self) -> None:
        super().__init__(_about, _opened)
        self.person = self._language = ""
        self.choice, self.style = ExampleChoice.VITERBI, neutral_style()
        self.face: FaceInHand | None = None
        self.units: tuple[UsedUnit, ...] = ()
        self.notes: tuple[str, ...] = ()
        self._measured: tuple[MeasuredSound, Prosody] | None = None
        self._ready = 0.0, 0.0
        self._work = TaskQueue(self._fail)
        self._preparing, self._fitting = (TaskQueue(self.error.emit) for _ in range(2))
        for work in (self._work, self._fitting):
            work.changed.connect(self.changed)

    @property
    def table(self) -> PerformanceTable | None:
        """The table in use, open; None for none."""
        table: PerformanceTable | None = self._value
        return table

    @property
    def progress(self) -> str:
        """What is going on, in words; nothing where that is nothing."""
        if self._opening.busy:
            return tr("Opening table…")
        if self._fitting.busy:
            return tr("Fitting: {progress:.0%}").format(progress=self._fitting.progress)
        return tr("Looking up faces: {progress:.0%}").format(progress=self._work.progress) if self._work.busy else ""

    # -- what is chosen -----------------------------------------------------------------------------------

    @override
    def open(self, path: Path) -> None:
        """Open a table, in the background, and use it."""
        self.person = ""
        super().open(path)

    @override
    def choose(self, path: Path | None) -> None:
        self.person = ""
        super().choose(path)

    @property
    def persons(self) -> tuple[str, ...]:
        """Of whom several tables are open."""
        names = [about.person for about in self.known.values() if about.person]
        return tuple(dict.fromkeys(name for name in names if names.count(name) > 1))

    def choose_person(self, person: str) -> None:
        """Use the tables of a person, each for its language; nothing to choose a table by hand."""
        self.person = person
        self._choose_by_language()
        self.changed.emit()

    def set_language(self, language: str) -> None:
        """Take note of the language of what is said; it may choose another table of a person."""
        if language != self._language:
            self._language = language
            self._choose_by_language()

    def set_choice(self, choice: ExampleChoice) -> None:
        """Choose otherwise among the examples of a unit."""
        if choice is not self.choice:
            self.choice = choice
            self.changed.emit()

    def set_style(self, style: Style) -> None:
        """Speak in another style; what is shown now is looked up again."""
        if style != self.style:
            self.style = style
            self.changed.emit()

    # -- what is looked up --------------------------------------------------------------------------------

    def look_up(self, sound: MeasuredSound, utterance: Utterance) -> None:
        """Look up what is said in a sound file, in the background."""
        table, options, known = self.table, self._options, self._measured
        if table is None:
            self.forget()
            return
        before = known[1] if known is not None and known[0] == sound else None

        def act(progress: Progress) -> tuple[Prosody, PerformanceTrack, PerformedMouth]:
            prosody = before or _measured(sound, progress)
            track = PerformanceTrack(utterance, _speech(sound, utterance, prosody), table, options)
            mouth = track.mouth()
            mouth.prepare(0.0, AHEAD)
            return prosody, track, mouth

        def take(found: tuple[Prosody, PerformanceTrack, PerformedMouth]) -> None:
            prosody, track, mouth = found
            self._measured = sound, prosody
            self._show(FaceInHand(mouth), self.units, track.notes)
            self._work.submit(
                lambda progress: _units_of(track, progress), lambda units: self._show(self.face, units, track.notes)
            )

        self._work.replace(act, take)

    def own_sound(self) -> OwnSound | None:
        """Return what has the recordings of the table in use speak; None without a table."""
        table = self.table
        return None if table is None else OwnSound(table, self.choice)

    def spoken_face(self, language: str, own: OwnSound | None = None) -> SpokenFace | None:
        """Return what looks a text up while it is spoken; None without a table. Any thread may ask.

        Parameters
        ----------
        own : makes the sound of which the face has the units; None where a voice speaks.
        """
        table, options = self.table, self._options
        if own is not None and own.table is table:
            options = replace(options, given=own.units_of)
        return None if table is None else SpokenFace(table, language, options)

    def show_spoken(self, face: SpokenFace) -> None:
        """Show a text that is being spoken, as far as it is; call it again when there is more of it."""
        if self.face is None or not self.face.shows(face):
            self._work.cancel()
            self._show(FaceInHand(face), face.units, face.notes)
        elif face.units != self.units:
            self._show(self.face, face.units, face.notes)

    def forget(self) -> None:
        """Show nothing, as another sound is open."""
        self._work.cancel()
        if self.face is not None:
            self._show(None, (), ())

    def tick(self, position: float) -> None:
        """Look up what comes after a time of the sound, seconds; and say if the table failed."""
        face = self.face
        if face is None:
            return
        if face.failure:
            self._fail(face.failure)
            return
        begin, end = self._ready
        if not (begin <= position < end - AHEAD / 2) and not self._preparing.busy:
            self._ready = position, position + AHEAD
            self._preparing.submit(lambda _progress: face.prepare(position, position + AHEAD))

    def fit_style(self, take: Callable[[Style], object]) -> None:
        """Fit a style to the recordings of the table in use, in the background."""
        path = self.chosen
        if path is None:
            self.error.emit(tr("There are no recorded faces to fit the style to; open a table in Voice & Face."))
            return

        def show(fitted: FittedStyle) -> None:
            take(fitted.style)
            sentence = tr("The style is fitted to {n:.0f} s: it differs by {after:.3f} RMS, neutral by {before:.3f}.")
            self.info.emit(sentence.format(n=fitted.seconds, after=fitted.after, before=fitted.before))

        self._fitting.replace(lambda progress: _fitted(path, progress), show)

    def close(self) -> None:
        """End all work."""
        for work in (self._opening, self._work, self._preparing, self._fitting):
            work.close(CLOSE_TIMEOUT)

    @property
    def _options(self) -> PerformanceOptions:
        return PerformanceOptions(self.choice, style=self.style)

    # -- inside -------------------------------------------------------------------------------------------

    @override
    def _take_found(self, known: dict[Path, Any], chosen: Path | None) -> None:
        super()._take_found(known, chosen)
        self._choose_by_language()

    def _choose_by_language(self) -> None:
        if self.person not in self.persons:
            return
        own = [path for path, about in self.known.items() if about.person == self.person]
        try:
            path = own[chosen_table([self.known[one] for one in own], None, None, self._language)]
        except PerformanceError:  # none is of it, or several are
            path = self.chosen if self.chosen in own else own[0]
            if self._language:
                told = tr("{person} has no table, or several, in the language of the text; {table} moves the face.")
                self.info.emit(told.format(person=self.person, table=self.known[path].name))
        if path != self.chosen:
            self._open(path)

    def _show(self, face: FaceInHand | None, units: tuple[UsedUnit, ...], notes: tuple[str, ...]) -> None:
        if face is not self.face:
            self._ready = 0.0, 0.0
        self.face, self.units = face, units
        if notes and notes != self.notes and self.table is not None:
            told = (
                tr("{table}: {note}; for {n} more notes, point at the caption below the head.")
                if len(notes) > 1
                else tr("{table}: {note}.")
            )
            self.info.emit(told.format(table=self.table.about.name, note=notes[0], n=len(notes) - 1))
        self.notes = notes
        self.looked_up.emit()

    def _fail(self, sentence: str) -> None:
        self.forget()
        self.error.emit(sentence)


def _about(path: Path) -> TableAbout:
    with PerformanceTable.open(path) as table:
        return table.about


def _opened(path: Path) -> tuple[TableAbout, PerformanceTable]:
    """Open a table, and read what every lookup needs of it."""
    table = PerformanceTable.open(path)
    table.check()
    PerformanceDriver(table)
    _ = table.phrases
    return table.about, table


def _measured(sound: MeasuredSound, progress: Progress) -> Prosody:
    prosody = Prosody()
    with SoundReader(sound.path, sound.channel) as reader:
        for analysis in analyse_file(reader, sound.preset, pitch=True):
            prosody.add(analysis)
            end = (analysis.start + len(analysis)) * FRAME_PERIOD
            report_progress(progress, min(1.0, end / max(reader.duration, FRAME_PERIOD)))
    return prosody


def _speech(sound: MeasuredSound, utterance: Utterance, prosody: Prosody) -> Transcript:
    return transcript_of_utterance(utterance, prosody.intensities, prosody.pitches, sound.path.name, sound.path)


def _units_of(track: PerformanceTrack, progress: Progress) -> tuple[UsedUnit, ...]:
    units: list[UsedUnit] = []
    duration = max(track.utterance.duration, FRAME_PERIOD)
    for unit in track.units():
        units.append(unit)
        report_progress(progress, min(1.0, unit.end / duration))
    return tuple(units)


def _fitted(path: Path, progress: Progress) -> FittedStyle:
    with PerformanceTable.open(path) as table:
        return fit_style((performance for _, performance in table.recordings()), path.stem, progress)
