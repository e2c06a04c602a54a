"""What the user is asked about sounds, recordings and variables."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from typing import Any

from PySide6.QtCore import QFileSystemWatcher, QObject, QSettings, Signal
from PySide6.QtWidgets import QMessageBox, QWidget

from phonemeanalyser.desktop.analyse.page import AnalysisPage
from phonemeanalyser.desktop.analyse.recognition.variable_panel import VariableDialog
from phonemeanalyser.desktop.analyse.spectra.curve_dialogs import CurveDialogs
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.preset_dialogs import PresetDialogs
from phonemeanalyser.desktop.session.curves import SUFFIX
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.settings import read_paths, remember
from phonemeanalyser.desktop.tasks import tried
from phonemeanalyser.desktop.widgets.builders import answer_of, input_dialog
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, audio_filters
from phonemeanalyser.desktop.widgets.plot import save_picture
from phonemeengine import __version__
from phonemeengine.features.variables import Variable, readable_name
from phonemeengine.presets.files import DEFAULT_PRESET, PRESET_SUFFIXES, load_preset

ICON_SIZE = 64
"""Of the program's icon in its description, pixels."""
PICTURE_FILTER = tr_noop("PNG image (*.png);;SVG drawing (*.svg)")
LABEL_FILTERS = (
    tr_noop("Praat TextGrid (*.TextGrid)"),
    tr_noop("Audacity labels (*.txt)"),
    tr_noop("Corpus labels (*.csv)"),
)


class Dialogs(QObject):
    """Asks, and passes the answers to the models; what is refused is said, and leaves everything as it was.

    Parameters
    ----------
    face_in_use : gives the `FaceInUse` by which an export is as the head is seen.

    Signals
    -------
    rejected : a sentence for the user; an empty one after something went well.
    info : a sentence for the user about something to know.
    sound_opened : a sound file is open, and first among the recent ones.
    sound_changed : what became of the current file on the disk, in two words and in a sentence; empty for nothing.
    variable_added : name of the user's new variable.
    action_offered : a sentence, what can be done about it, and the function that does it.

    Attributes
    ----------
    presets, curves : ask about presets and averaged spectra; what they have to say is said here, too.
    """

    rejected = Signal(str)
    info = Signal(str)
    sound_opened = Signal()
    sound_changed = Signal(str, str)
    variable_added = Signal(str)
    action_offered = Signal(str, str, object)

    def __init__(
        self, window: QWidget, session: Session, preset: PresetModel, settings: QSettings,
        face_in_use: Callable[[], Any], files: FileAsker,
    ) -> None:  # fmt: skip
        super().__init__(window)
        self._window, self._session, self._preset = window, session, preset
        self._settings, self._files, self._face_in_use = settings, files, face_in_use
        self.presets = PresetDialogs(window, session, preset, settings, files)
        self.curves = CurveDialogs(window, session, files)
        for mine, theirs in (
            (self.rejected, self.curves.rejected),
            (self.info, self.curves.info),
            (self.info, session.curves.info),
            (self.rejected, self.presets.rejected),
            (self.info, self.presets.info),
            (self.action_offered, self.presets.action_offered),
        ):
            theirs.connect(mine)
        self._watcher = QFileSystemWatcher(self)
        self._watcher.fileChanged.connect(self._tell_change)
        session.opened.connect(self._watch)

    def join(self, page: AnalysisPage) -> None:
        """Connect the Analyse page: its requests open dialogs, and their results are shown on it."""
        page.picture_asked.connect(self.ask_save_picture)
        page.averaged.variable_asked.connect(self.ask_variable)
        self.variable_added.connect(page.courses.choose)
        self.curves.join(page.averaged)

    @staticmethod
    def opens_as_sound(path: Path) -> bool:
        """Return whether a file is taken for a sound, which is what all are that are no preset and no curve."""
        return path.suffix.lower() not in {*PRESET_SUFFIXES, SUFFIX}

    def open_any(self, path: Path) -> None:
        """Load a preset, a curve or a sound, by the suffix of its name."""
        kind = path.suffix.lower()
        if kind in PRESET_SUFFIXES:
            self.presets.load(path)
        elif kind == SUFFIX:
            self.curves.load(path)
        else:
            self.open_sound(path)

    # -- sounds -------------------------------------------------------------------------------------------

    def open_sound(self, path: Path) -> bool:
        """Open a sound file; says whether it is open."""
        self.rejected.emit("")  # before: labels beside the sound may be refused
        if not self._session.open(path):
            return False
        if self._session.file is not None and self._session.file.cut_off:
            told = f"{path.name}: {self._session.file.cut_off}"
            self.info.emit(tr_engine(told))
        remember(self._settings, "recent", path)
        self.sound_opened.emit()
        return True

    def _watch(self) -> None:
        """Watch the current file, as other programs may write it."""
        if self._watcher.files():
            self._watcher.removePaths(self._watcher.files())
        self.sound_changed.emit("", "")
        if self._session.path is not None:
            self._watcher.addPath(str(self._session.path))

    def _tell_change(self, name: str) -> None:
        """Say that the current file is another one, or none, by now."""
        path, words = Path(name), tr("missing on disk")
        tip = tr("{file} was moved or deleted; its analysis stays on screen")
        if path.is_file():
            words = tr("changed on disk")
            tip = tr("{file} has changed on disk since it was opened; click to reload it")
        self.sound_changed.emit(words, tip.format(file=path.name))

    def open_again(self) -> None:
        """Open the current file as it is now."""
        if self._session.path is not None:
            self.open_sound(self._session.path)

    def ask_sound(self) -> bool:
        """Let the user choose a sound file; says whether one was opened."""
        path = self._files.ask_file(tr("Open Audio File"), audio_filters(), "sound")
        return path is not None and self.open_sound(path)

    def recent_sounds(self) -> list[Path]:
        """Return the sounds that were opened last, newest first."""
        return read_paths(self._settings, "recent")

    def last_sound(self) -> Path | None:
        """Return the sound that was opened last, if it is still there."""
        return next((path for path in self.recent_sounds()[:1] if path.is_file()), None)

    def ask_save_phonemes(self) -> None:
        """Let the user choose a file to save the phonemes of a whole sound to; its ending says in which format."""
        source = self._session.source
        if source.reopen is None or not source.duration:
            self.rejected.emit(tr("No audio file is open. Open the one whose phonemes you want to save."))
            return
        sound = source.path or Path.home() / source.name
        suggested = self._files.folder_of("phonemes", sound.parent) / f"{sound.stem}.TextGrid"
        filters = ";;".join(map(tr, LABEL_FILTERS))
        if path := self._files.ask_target(tr("Save Phonemes"), suggested, filters, "phonemes"):
            self._session.writer.write(source.name, source.reopen, self._preset.in_force, path)

    def show_export(self, sounds: Sequence[Path] = ()) -> None:
        """Show what sounds can be turned into; begins with the current sound, unless others are named."""
        from phonemeanalyser.desktop.export_dialog import ExportDialog  # noqa: PLC0415 - the first window waits for it

        path = self._session.path
        chosen = list(sounds) or ([] if path is None else [path])
        preset, channel = self._preset.in_force, self._session.channel
        face = self._face_in_use()
        if sounds:
            face = replace(face, speech=None)
        ExportDialog(
            preset, channel, chosen, self._settings, self._window, self.presets.sections, face, self._files
        ).open()

    # -- recordings ---------------------------------------------------------------------------------------

    def ask_recordings_folder(self) -> None:
        """Let the user choose where recordings go."""
        microphone = self._session.microphone
        microphone.folder = self._files.ask_folder(tr("Recordings Folder"), microphone.folder) or microphone.folder

    def measure_latency(self) -> None:
        """Play clicks, with the microphone and the loudspeaker free for that."""
        self._session.set_source(SourceKind.MICROPHONE)
        self.info.emit(tr("Measuring latency: playing and recording clicks for three seconds…"))
        self._session.microphone.measure()

    def offer_recording(self, path: str, seconds: float, gaps: str) -> None:
        """Offer to open a recording that is complete; `gaps` says what is missing in it, if anything is."""
        sentence = tr("Recorded {seconds:.1f} s to {path}").format(seconds=seconds, path=path)
        sentence += f", {gaps}" if gaps else ""
        self.action_offered.emit(sentence, tr("Open"), lambda: self.open_sound(Path(path)))

    def offer_speech(self, path: str) -> None:
        """Offer to open a sound file to which a text was spoken."""
        sentence = tr("Saved the spoken text as {path}, with a label file of its words and phones").format(path=path)
        self.action_offered.emit(sentence, tr("Open"), lambda: self.open_sound(Path(path)))

    def offer_unfinished(self) -> None:
        """Offer to open a recording that was cut off when the program ended; the newest, if there are several."""
        found = self._session.microphone.interrupted_recordings()
        if not found:
            return
        newest = found[-1]
        others = (
            " " + tr("({n} more are in {folder})").format(n=len(found) - 1, folder=newest.path.parent)
            if len(found) > 1
            else ""
        )
        sentence = tr(
            "The program quit during a recording; {seconds:.1f} s from {begun:%Y-%m-%d, %H:%M} were saved to "
            "{path}{others}"
        ).format(seconds=newest.seconds, begun=newest.begun, path=newest.path, others=others)
        self.action_offered.emit(sentence, tr("Open"), lambda: self.open_sound(newest.path))
        for recording in found:
            recording.forget()

    def show_about(self) -> None:
        """Show what the program is, and how well the preset with which it begins does."""
        summary = escape(tr_engine(load_preset(DEFAULT_PRESET).summary))
        words = tr(
            "<b>PhonemeAnalyser</b><p>Calibrates real-time phoneme recognition for lip sync, and shows why a phoneme "
            "was recognised.<p>Version {version}, MIT licence; <i>Help &gt; Licences</i> lists all components. The "
            "demo is a synthetic voice of the Festival project (CMU slt). The heads are made "
            "from MakeHuman's mesh and targets, and face units by Mika Suominen (CC0)."
            "<p><b>The preset Learned.</b> {summary}"
        ).format(summary=summary, version=__version__)
        title, close = tr("About PhonemeAnalyser"), QMessageBox.StandardButton.Close
        box = QMessageBox(QMessageBox.Icon.NoIcon, title, words, close, self._window)
        box.setIconPixmap(self._window.windowIcon().pixmap(ICON_SIZE))
        box.exec()

    def record(self) -> None:
        """Begin or end a recording; an open file is left only when that is wanted."""
        session = self._session
        leaves = session.source.path is not None and not session.microphone.recording
        if not leaves or self._may_record_instead_of(session.source.name):
            session.toggle_recording()

    def _may_record_instead_of(self, name: str) -> bool:
        """Ask whether to leave a file for the microphone; says whether to go on."""
        question = tr("Switch from {name} to the microphone and record?").format(name=name)
        box = QMessageBox(QMessageBox.Icon.Question, tr("Record"), question, parent=self._window)
        record = box.addButton(tr("Record"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(record)
        box.exec()
        return box.buttonRole(box.clickedButton()) == QMessageBox.ButtonRole.AcceptRole

    # -- variables ----------------------------------------------------------------------------------------

    def ask_variable(self, low: float, high: float) -> None:
        """Let the user name a variable over a frequency range (Hz), and choose what it measures."""
        dialog = VariableDialog(low, high, self._preset.add_variable, self._window)
        if dialog.exec():
            self.variable_added.emit(dialog.variable().name)

    def add_variable(self, variable: Variable) -> None:
        """Add a variable that was suggested."""
        if tried(lambda: self._preset.add_variable(variable), self.rejected.emit):
            self.variable_added.emit(variable.name)

    def ask_remove_variable(self) -> None:
        """Let the user choose a variable of his own to remove."""
        mine = self._preset.preset.variables
        names = {f"{tr_engine(readable_name(v.name, mine))}  ({v.name})": v.name for v in mine}
        if not names:
            self.rejected.emit(tr("There are no custom variables yet. Mark a range in the averaged spectrum first."))
            return
        dialog = input_dialog(self._window, tr("Remove Variable"), tr("Variable:"), tr("Remove"), items=[*names])
        if (chosen := answer_of(dialog)) is not None:
            self._preset.remove_variable(names[chosen])

    def ask_save_picture(self, plot: QWidget, name: str) -> None:
        """Let the user choose a file to save the picture of a plot to: pixels, or lines that scale."""
        suggested = self._files.folder_of("picture") / f"{name}.png"
        if path := self._files.ask_target(tr("Save Picture"), suggested, tr(PICTURE_FILTER), "picture"):
            tried(lambda: save_picture(plot, path), self.rejected.emit)
