"""The calibration workbench: takes, recordings, what they say of the preset, and the guided calibration."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.calibrate.guide.guide_model import GuideModel, Phase
from phonemeanalyser.desktop.calibrate.takes.takes_model import TakeEdit, TakesModel
from phonemeanalyser.desktop.calibrate.workbench.fit_model import ComparisonModel, FitModel, RuleFinding
from phonemeanalyser.desktop.calibrate.workbench.phoneme_data_model import PhonemeDataModel
from phonemeanalyser.desktop.calibrate.workbench.workbench_model import RecordingsModel, WorkbenchModel
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.takes.room_noise import RoomNoise, SilenceAccuracy, measure_room, speech_in
from phonemeengine.errors import EngineError
from phonemeengine.live.recorder import to_mono_44k
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset

SECONDS = 2.0
"""How long the background noise is recorded."""

Found = tuple[RoomNoise, Preset, SilenceAccuracy]


class RoomModel(QObject):
    """Records background noise, sets the preset's silence by it, and says how well that works.

    Signals
    -------
    changed : it begins to listen, or has ended.
    info : a sentence for the user about what was found.
    error : a sentence for the user.
    """

    changed = Signal()
    info = Signal(str)
    error = Signal(str)

    def __init__(self, session: Session, preset: PresetModel, takes: TakesModel) -> None:
        super().__init__()
        self.listening = False
        self._session = session
        self._capture = session.microphone.capture
        self._preset = preset
        self._takes = takes
        self._work = TaskQueue(self.error.emit)
        session.analysed.connect(self._look_for_end)
        session.microphone.changed.connect(self._look_for_end)

    def begin(self) -> None:
        """Record background noise for two seconds; the microphone listens already."""
        self._capture.begin()
        self._listen(on=True)
        self.info.emit(
            tr("Keep quiet: measuring the background noise for {seconds:g} seconds…").format(seconds=SECONDS)
        )

    def cancel(self) -> None:
        """End it; nothing changes."""
        if self.listening:
            self._capture.end()
            self._listen(on=False)
        self._work.cancel()

    def close(self) -> None:
        """End all work."""
        self.cancel()
        self._work.close()

    def _look_for_end(self) -> None:
        """Take what was recorded, once it is enough."""
        if not self.listening:
            return
        if not self._session.microphone.active:
            self.cancel()
            self.error.emit(
                tr("The background noise was not measured, because the microphone stopped. Measure it again.")
            )
        elif self._capture.seconds >= SECONDS:
            samples, rate = self._capture.end()
            self._listen(on=False)
            preset, takes = self._preset.preset, self._takes.utterances()
            self._work.replace(lambda _progress: _found_in(samples, rate, preset, takes), self._use)

    def _use(self, found: Found) -> None:
        room, preset, accuracy = found
        if room.notes:
            self.error.emit(tr_engine(room.notes[0]))
            return
        try:
            self._preset.end_edit()
            self._preset.edit(replace(preset, name=self._preset.preset.name), tr("background noise measurement"))
            told = tr(
                "Background noise {decibels:.0f} dBFS, measured for {seconds:.1f} s. {accuracy}. Ctrl+Z undoes this."
            )
            self.info.emit(
                told.format(decibels=room.decibels, seconds=room.seconds, accuracy=tr_engine(str(accuracy)))
            )
        except EngineError as error:
            self.error.emit(str(error))

    def _listen(self, *, on: bool) -> None:
        self.listening = on
        self.changed.emit()


def _found_in(samples: Float32Array, rate: int, preset: Preset, takes: tuple[LabelledUtterance, ...]) -> Found:
    room, speech = measure_room(to_mono_44k(samples, rate), preset), speech_in(takes)
    found = room.set_silence(preset, speech)
    return room, found, room.silence_accuracy(found, speech)


AROUND = 0.15
"""What is played before and after a segment that is hardly audible by itself, seconds."""
TAKES_FOLDER = "Takes"
"""The project where no other was chosen, in the folder of recordings."""


class CalibrationModel(QObject):
    """Joins what the page shows.

    Signals
    -------
    held : another phoneme is held, or none any more.
    selection_changed : another segment of the file is marked.
    info : a sentence for the user about something that went well.
    error : a sentence for the user.
    """

    held = Signal()
    selection_changed = Signal()
    info = Signal(str)
    error = Signal(str)

    def __init__(self, session: Session, preset: PresetModel) -> None:
        super().__init__()
        self.session = session
        self.preset = preset
        self.capture = session.microphone.capture
        self.takes = TakesModel(lambda: session.microphone.folder / TAKES_FOLDER)
        self.recordings = RecordingsModel()
        self.workbench = WorkbenchModel(preset)
        self.fit = FitModel(preset, self.workbench)
        self.rule_finding = RuleFinding(preset, self.workbench)
        self.comparison = ComparisonModel(preset, self.workbench)
        self.phoneme_data = PhonemeDataModel(preset, self.workbench, session.history)
        self.guide = GuideModel(session, preset, self.takes)
        self.room = RoomModel(session, preset, self.takes)
        self.phoneme: Phoneme | None = None
        self.selection: tuple[float, float] | None = None
        self._from: float | None = None
        self.room.info.connect(self.info)
        self.takes.edited.connect(self._note_edit)
        self.takes.opened.connect(self._forget_edits)
        self.takes.emptied.connect(self._forget_edits)
        preset.loaded.connect(self._keep_edits)
        for model in (self.takes, self.recordings):
            model.changed.connect(self._load_workbench)
            model.info.connect(self.info)
            model.error.connect(self.error)
        own = self.comparison, self.phoneme_data, self.rule_finding, self.guide, self.room
        for worker in (self.workbench, self.fit, *own):
            worker.error.connect(self.error)
        self.workbench.confusion_changed.connect(self._tell_score)
        # Bound methods, since Qt would hold a lambda, and with it this model, for ever.
        self.workbench.measuring.changed.connect(self._tell_measuring)
        self.workbench.measured.connect(self._show_loaded)
        self.guide.changed.connect(self._load_sentences)
        session.opened.connect(self._forget_selection)
        session.analysed.connect(self._follow)

    def _tell_measuring(self) -> None:
        self.session.score.show_measuring(on=self.workbench.measuring.busy)

    def _show_loaded(self) -> None:
        self.session.rules.show_loaded(self.workbench.features)

    # -- takes from microphone and file -------------------------------------------------------------------

    def press(self, phoneme: Phoneme) -> None:
        """Hold a phoneme: what is recorded, or played, until `release` becomes a take of it."""
        session = self.session
        if self.phoneme is not None or self.guide.running or self.room.listening:
            return
        path = session.source.path
        if path is not None and (session.source.playing or self.selection):
            if self.selection is not None and not session.source.playing:
                self.takes.add_from_file(path, session.channel, *self.selection, phoneme)
                self._forget_selection()
                return
            self._from = session.source.position
        else:
            self.listen()
            self.capture.begin()
        self.phoneme = phoneme
        self.held.emit()

    def release(self) -> None:
        """Let the phoneme go; its take is kept."""
        phoneme, self.phoneme = self.phoneme, None
        if phoneme is None:
            return
        start, self._from = self._from, None
        self.held.emit()
        path = self.session.path
        if start is not None and path is not None:
            self.takes.add_from_file(path, self.session.channel, start, self.session.source.position, phoneme)
            return
        samples, rate = self.capture.end()
        if not len(samples) and not self.session.microphone.listening:
            self.error.emit(
                tr("No take of {phoneme} was recorded: {state}. Try again once the microphone is running.").format(
                    phoneme=sound_name(phoneme), state=tr_engine(self.session.microphone.words)
                )
            )
            return
        self.takes.add(samples, rate, phoneme, self.session.microphone.name)

    def begin_guide(self) -> None:
        """Lead through all sounds, at the microphone."""
        if self.phoneme is None:
            self.room.cancel()
            self.listen()
            self.guide.begin()

    def measure_room(self) -> None:
        """Record two seconds of background noise, and have the preset take it for silence."""
        if self.phoneme is None and not self.guide.running and not self.room.listening:
            self.listen()
            self.room.begin()

    def listen(self) -> None:
        """Have the microphone listen, whatever was open."""
        self.session.set_source(SourceKind.MICROPHONE)
        if not self.session.source.playing:
            self.session.play()

    def mark(self, *, end: bool) -> None:
        """Mark where the segment of the opened file begins, or ends: at the playhead."""
        if self.session.source.path is None:
            self.error.emit(tr("No audio file is open. Open one to mark a range in it."))
            return
        start, stop = self.selection or (0.0, self.session.source.duration)
        here = self.session.source.position
        start, stop = (min(start, here), here) if end else (here, max(stop, here))
        self.selection = start, stop
        self.selection_changed.emit()

    # -- listening to what is there -----------------------------------------------------------------------

    def play_take(self, number: int) -> None:
        """Play what counts of a take."""
        take = self.takes.take(number)
        if take is not None:
            self.play(self.takes.path_of(take), take.start, take.end, around=0.0)

    def play_sentence(self, *, new: bool) -> None:
        """Play the sentence of the guide as recognised by the preset that it found, or by the old one."""
        outcome, spoken = self.guide.outcome, self.guide.spoken
        if outcome is not None and spoken is not None:
            self.preset.try_out(outcome.preset if new else outcome.start)
            self.play(spoken.path, 0.0, spoken.labels[-1].end)

    def play(self, path: Path, start: float, end: float, *, around: float = AROUND) -> None:
        """Play a segment of a file, in seconds; it stands at the segment's beginning afterwards."""
        session = self.session
        if session.source.path != path and not session.open(path):
            return
        session.play_stretch(TimeSpan(max(0.0, start - around), end + around))

    def close(self) -> None:
        """Wait until all takes are on the disk, and end all other work."""
        searching = self.phoneme_data, self.rule_finding, self.fit
        for worker in (self.guide, self.room, *searching, self.comparison, self.workbench):
            worker.close()
        self.recordings.close()
        self.takes.close()

    def _follow(self) -> None:
        """End what has lasted long enough."""
        if self.phoneme is not None and self._from is None and self.capture.full:
            self.release()

    def _note_edit(self, what: str, n: int = 1) -> None:
        self.preset.undo_stack.push(TakeEdit(self.takes, what, n))

    def _forget_edits(self) -> None:
        """Begin a new history where there are changes of another project in the old one."""
        stack = self.preset.undo_stack
        if any(isinstance(stack.command(k), TakeEdit) for k in range(stack.count())):
            stack.clear()

    def _keep_edits(self) -> None:
        """Have what was done with the takes in the new history too, which begins with another preset."""
        for what in self.takes.now.changes:
            self._note_edit(what)

    def _load_sentences(self) -> None:
        """Show how the sentences that were just read are recognised, beside the takes."""
        if self.guide.phase is Phase.DONE:
            self.recordings.add(tuple(self.guide.sentences.values()))

    def _load_workbench(self) -> None:
        found = (*self.takes.utterances(), *self.recordings.utterances)
        if found != self.workbench.utterances:
            self.workbench.load(found)

    def _tell_score(self) -> None:
        self.session.score.show_loaded(self.workbench.confusion, self.workbench.answered)

    def _forget_selection(self) -> None:
        self.selection = None
        self.selection_changed.emit()
