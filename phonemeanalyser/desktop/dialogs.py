"""What the user is asked: files, names, and what is to become of unsaved changes."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from html import escape
from itertools import chain
from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, QSettings, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QInputDialog, QMessageBox, QWidget

from phonemeanalyser.desktop.analyse.recognition.recogniser_choice import EncoderDialog
from phonemeanalyser.desktop.analyse.recognition.variable_dialog import VariableDialog
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import PresetModel, preset_filter
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from phonemeanalyser.desktop.session.unsaved import UnsavedChanges
from phonemeanalyser.desktop.settings import keep, read, read_paths
from phonemeanalyser.desktop.talk.model import TalkModel
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, ask_to_save
from phonemeanalyser.desktop.widgets.plot_menu import save_picture
from phonemeengine import __version__
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Variable
from phonemeengine.presets.ears import for_live_use
from phonemeengine.presets.files import (
    DEFAULT_PRESET,
    FACTORY_PRESETS,
    PRESET_SUFFIXES,
    PresetEntry,
    load_preset,
    own_presets,
    preset_entries,
)
from phonemeengine.storage.paths import presets_folder

N_RECENT = 8
CURVE_SUFFIX = ".csv"
PRESET_FILTERS = "Preset (*.toml);;PhonemeData (*.phonemedata *.txt)"
PICTURE_FILTER = tr_noop("Pixels (*.png);;Lines (*.svg)")
CURVE_FILTER = tr_noop("Curves (*.csv)")
LABEL_FILTERS = (
    tr_noop("Praat TextGrid (*.TextGrid)"),
    tr_noop("Audacity labels (*.txt)"),
    tr_noop("Corpus labels (*.csv)"),
)


class Dialogs(QObject):
    """Asks, and passes the answers to the models; what is refused is said, and leaves everything as it was.

    Signals
    -------
    rejected : a sentence for the user; an empty one after something went well.
    info : a sentence for the user about something to know.
    sound_opened : a sound file is in hand, and first among the recent ones.
    sound_changed : what became of the file in hand on the disk, in two words and in a sentence; empty for nothing.
    variable_added : name of the user's new variable.
    action_offered : a sentence, what can be done about it, and the function that does it.
    """

    rejected = Signal(str)
    info = Signal(str)
    sound_opened = Signal()
    sound_changed = Signal(str, str)
    variable_added = Signal(str)
    action_offered = Signal(str, str, object)

    def __init__(
        self, window: QWidget, session: Session, preset: PresetModel, settings: QSettings, talking: TalkModel,
        files: FileAsker,
    ) -> None:  # fmt: skip
        super().__init__(window)
        self._window, self._session, self._preset = window, session, preset
        self._settings, self._files, self._talking = settings, files, talking
        self._shipping = TaskQueue(self.rejected.emit)
        self._watcher = QFileSystemWatcher(self)
        self._watcher.fileChanged.connect(self._tell_change)
        session.opened.connect(self._watch)

    def close(self) -> None:
        """Tell no more of a preset that is being shipped."""
        self._shipping.close(CLOSE_TIMEOUT)

    @staticmethod
    def opens_as_sound(path: Path) -> bool:
        """Return whether a file is taken for a sound, which is what all are that are no preset and no curve."""
        return path.suffix.lower() not in {*PRESET_SUFFIXES, CURVE_SUFFIX}

    def open_any(self, path: Path) -> None:
        """Load a preset, a curve or a sound, by the suffix of its name."""
        kind = path.suffix.lower()
        if kind in PRESET_SUFFIXES:
            self.load_preset(path)
        elif kind == CURVE_SUFFIX:
            self.load_curve(path)
        else:
            self.open_sound(path)

    # -- sounds -------------------------------------------------------------------------------------------

    def open_sound(self, path: Path) -> bool:
        """Open a sound file; says whether it is in hand."""
        self.rejected.emit("")  # before: labels beside the sound may be refused
        if not self._session.open(path):
            return False
        if self._session.file is not None and self._session.file.cut_off:
            told = f"{path.name}: {self._session.file.cut_off}"
            self.info.emit(tr_engine(told))
        self._remember_recent("recent", path)
        self.sound_opened.emit()
        return True

    def _watch(self) -> None:
        """Watch the file in hand, as other programs may write it."""
        if self._watcher.files():
            self._watcher.removePaths(self._watcher.files())
        self.sound_changed.emit("", "")
        if self._session.path is not None:
            self._watcher.addPath(str(self._session.path))

    def _tell_change(self, name: str) -> None:
        """Say that the file in hand is another one, or none, by now."""
        path, words = Path(name), tr("gone from disk")
        tip = tr("{file} is no longer where it was; what is seen of it stays")
        if path.is_file():
            words = tr("changed on disk")
            tip = tr("{file} has changed on the disk since it was opened; click to open it again")
        self.sound_changed.emit(words, tip.format(file=path.name))

    def open_again(self) -> None:
        """Open the file in hand as it is now."""
        if self._session.path is not None:
            self.open_sound(self._session.path)

    def ask_sound(self) -> bool:
        """Let the user choose a sound file; says whether one was opened."""
        path = self._files.ask_file(tr("Open a sound file"), tr("All files (*)"), "sound")
        return path is not None and self.open_sound(path)

    def ask_and_play(self) -> None:
        """Let the user choose a sound file, and play it at once."""
        if self.ask_sound():
            self._session.play()

    def recent_sounds(self) -> list[Path]:
        """Return the sounds that were opened last, newest first."""
        return read_paths(self._settings, "recent")

    def _remember_recent(self, key: str, path: Path) -> None:
        here = path.resolve()
        recent = [here, *(other for other in read_paths(self._settings, key) if other != here)]
        self._settings.setValue(key, list(map(str, recent[:N_RECENT])))

    def last_sound(self) -> Path | None:
        """Return the sound that was opened last, if it is still there."""
        return next((path for path in self.recent_sounds()[:1] if path.is_file()), None)

    def ask_save_phonemes(self) -> None:
        """Let the user choose a file to save the phonemes of a whole sound to; its ending says in which format."""
        source = self._session.source
        if source.reopen is None or not source.duration:
            self.rejected.emit(tr("There is no sound file in hand; open the one whose phonemes are to be saved."))
            return
        sound = source.path or Path.home() / source.name
        suggested = self._files.folder_of("phonemes", sound.parent) / f"{sound.stem}.TextGrid"
        filters = ";;".join(map(tr, LABEL_FILTERS))
        if path := self._files.ask_target(tr("Save the phonemes"), suggested, filters, "phonemes"):
            self._session.writer.write(source.name, source.reopen, self._preset.in_force, path)

    def show_export(self, sounds: Sequence[Path] = ()) -> None:
        """Show what sounds can be turned into; begins with the sound in hand, unless others are named."""
        from phonemeanalyser.desktop.export_dialog import ExportDialog  # noqa: PLC0415 - the first window waits for it

        path = self._session.path
        chosen = list(sounds) or ([] if path is None else [path])
        preset, channel = self._preset.in_force, self._session.channel
        others = chain.from_iterable(self.preset_sections().values())
        face = self._talking.in_use
        if sounds:
            face = replace(face, speech=None)
        ExportDialog(preset, channel, chosen, self._settings, self._window, others, face, self._files).open()

    # -- recordings ---------------------------------------------------------------------------------------

    def ask_recordings_folder(self) -> None:
        """Let the user choose where recordings go."""
        microphone = self._session.microphone
        microphone.folder = self._files.ask_folder(tr("Where recordings go"), microphone.folder) or microphone.folder

    def measure_latency(self) -> None:
        """Play clicks, with the microphone and the loudspeaker free for that."""
        self._session.set_source(SourceKind.MICROPHONE)
        self.info.emit(tr("Listening for clicks from the loudspeaker, for three seconds …"))
        self._session.microphone.measure()

    def offer_recording(self, path: str, seconds: float, gaps: str) -> None:
        """Offer to open a recording that is complete; `gaps` says what is missing in it, if anything is."""
        sentence = tr("Recorded {seconds:.1f} s into {path}").format(seconds=seconds, path=path)
        sentence += f", {gaps}" if gaps else ""
        self.action_offered.emit(sentence, tr("Open It"), lambda: self.open_sound(Path(path)))

    def offer_speech(self, path: str) -> None:
        """Offer to open a sound file to which a text was spoken."""
        sentence = tr("Saved the spoken text as {path}, with words and phones beside it").format(path=path)
        self.action_offered.emit(sentence, tr("Open It"), lambda: self.open_sound(Path(path)))

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
            "The program ended while it recorded; {seconds:.1f} s of {begun:%Y-%m-%d, %H:%M} are safe in "
            "{path}{others}"
        ).format(seconds=newest.seconds, begun=newest.begun, path=newest.path, others=others)
        self.action_offered.emit(sentence, tr("Open It"), lambda: self.open_sound(newest.path))
        for recording in found:
            recording.forget()

    # -- presets ------------------------------------------------------------------------------------------

    def load_preset(self, path: Path) -> None:
        """Load a preset, after asking what is to become of unsaved changes."""
        if self.may_go_on() and self._load(path):
            self._remember_preset(self._preset.path)

    def _load(self, path: Path) -> bool:
        """Load a preset; say what of it could not be had, and whether it is loaded."""
        is_loaded = self._try(lambda: self._preset.load(path))
        if is_loaded and (warnings := for_live_use(self._preset.preset).warnings):
            self.rejected.emit(" ".join(warnings))
        return is_loaded

    def choose_recogniser(self, name: str) -> None:
        """Recognise with another recogniser."""
        self._try(lambda: self._preset.set_recogniser(name))

    def show_encoder(self) -> None:
        """Show where the speech encoder's model is, and let the user choose or fetch one."""
        dialog = EncoderDialog(self._files, self._window)
        dialog.model_changed.connect(self._preset.changed)
        dialog.exec()
        dialog.deleteLater()

    def offer_to_save(self) -> None:
        """Say that a calibrated preset is in use and in no file yet."""
        if self._preset.has_unsaved_changes:
            sentence = tr("The calibrated preset is in use, and not saved yet.")
            self.action_offered.emit(sentence, tr("Save As…"), self.save_as)

    def restore_preset(self) -> None:
        """Load the preset that was in use when the window was last closed, if it is still there."""
        path = read(self._settings, "preset", Path())
        if path.is_file() and path != self._preset.path:
            self._load(path)

    def restore_unsaved(self, unsaved: UnsavedChanges) -> None:
        """Take up what was changed and not saved when the program ended, and offer to undo that."""
        try:
            found = unsaved.restore()
        except EngineError as error:
            self.rejected.emit(
                tr("The changes that were not saved when the program ended cannot be read: {error}").format(
                    error=error
                )
            )
            return
        if found:
            name = self._preset.preset.name
            sentence = tr(
                "The changes of the preset {name} that were not saved when the program ended are here again."
            ).format(name=name)
            self.action_offered.emit(sentence, tr("Undo Them"), self._preset.revert)

    def ask_preset(self) -> None:
        """Let the user choose a preset file."""
        if path := self._files.ask_file(
            tr("Load a preset or PhonemeData"), preset_filter(), "preset", self._preset.path.parent
        ):
            self.load_preset(path)

    def ask_second_preset(self) -> None:
        """Let the user choose a preset file that is compared with the one in use."""
        path = self._files.ask_file(tr("Load a second preset"), preset_filter(), "preset", self._preset.path.parent)
        if path is not None:
            self._session.second.load(path)

    def save(self) -> bool:
        """Save the preset to its file; a factory preset is saved under a name of the user's own."""
        if self._preset.is_factory:
            return self.save_as()
        return self._save_to(self._preset.path)

    def save_as(self, suggested: Path | None = None) -> bool:
        """Let the user choose a file to save the preset to; says whether it was saved."""
        suggested = suggested or self._own_presets_folder() / f"{self._preset.path.stem}-mine.toml"
        path = self._files.ask_target(tr("Save the preset"), suggested, PRESET_FILTERS, "preset")
        return path is not None and self._save_to(path)

    def _save_to(self, path: Path) -> bool:
        """Save to a file; where it cannot hold all, the user says what becomes of the rest."""
        lost = self._preset.lost_in(path)
        if lost:
            answer = self._ask_what_becomes_of(lost, path)
            if answer != QMessageBox.ButtonRole.AcceptRole:
                return answer == QMessageBox.ButtonRole.YesRole and self.save_as(path.with_suffix(".toml"))
        saved = self._try(lambda: self._preset.save(path))
        if saved:
            self._remember_preset(path)
        return saved

    def _ask_what_becomes_of(self, lost: tuple[str, ...], path: Path) -> QMessageBox.ButtonRole:
        """Return what a PhonemeData file cannot hold; Yes is a TOML file, Accept the numbers only, Reject neither."""
        box = QMessageBox(
            QMessageBox.Icon.Question, tr("A PhonemeData file holds 21 numbers"), "", parent=self._window
        )
        box.setText(
            tr("{path} cannot hold {listed} of this preset. Save all of it as a TOML file?").format(
                path=path.name, listed=_listed(lost)
            )
        )
        roles = QMessageBox.ButtonRole
        toml = box.addButton(tr("Save as TOML…"), roles.YesRole)
        box.addButton(tr("Save the 21 Numbers Only"), roles.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(toml)
        box.exec()
        return box.buttonRole(box.clickedButton())

    def _own_presets_folder(self) -> Path:
        """Return the folder of the user's own presets; it is made where there is none yet."""
        folder = presets_folder()
        with suppress(OSError):  # then the dialog shows where one can save
            folder.mkdir(parents=True, exist_ok=True)
        return folder

    def _remember_preset(self, path: Path) -> None:
        keep(self._settings, "preset", path.resolve())
        self._remember_recent("recent presets", path)

    def preset_sections(self) -> dict[str, tuple[PresetEntry, ...]]:
        """Return the presets to choose from, by heading: the program's, the user's own, and others used lately."""
        mine = own_presets()
        listed = {*FACTORY_PRESETS, *mine}
        recent = read_paths(self._settings, "recent presets")
        return {
            tr("Factory"): preset_entries(FACTORY_PRESETS),
            tr("Mine"): preset_entries(mine),
            tr("Recent"): preset_entries(path for path in recent if path not in listed),
        }

    def show_ship(self) -> None:
        """Ask which preset is shipped, for what and where to."""
        from phonemeanalyser.desktop.ship_dialog import ShipDialog  # noqa: PLC0415 - the first window waits for it

        dialog = ShipDialog(self._preset.preset, self.preset_sections(), self._settings, self._files, self._window)
        dialog.ordered.connect(lambda order: self._ship(order.target, order.folder, order.write))
        dialog.open()

    def _ship(self, target: str, folder: Path, write: Callable[[], tuple[Path, ...]]) -> None:
        """Ship in the background; zig takes seconds, and minutes when it is asked for the first time."""
        self.info.emit(tr("Shipping for {target} into {folder} …").format(target=target, folder=folder))

        def tell(written: tuple[Path, ...]) -> None:
            sentence = tr("Shipped {n} files into {folder}; README.md there says how to go on")
            url = QUrl.fromLocalFile(folder)
            self.action_offered.emit(
                sentence.format(n=len(written), folder=folder), tr("Open Folder"),
                lambda: QDesktopServices.openUrl(url),
            )  # fmt: skip

        self._shipping.submit(lambda _progress: write(), tell)

    def ask_notes(self) -> None:
        """Let the user read and change the preset's notes."""
        notes, changed = QInputDialog.getMultiLineText(
            self._window,
            tr("Preset notes"),
            tr("Notes of the preset {preset}:").format(preset=self._preset.preset.name),
            self._preset.preset.notes,
        )
        if changed:
            self._preset.edit(replace(self._preset.preset, notes=notes), tr("change of notes"))

    def show_about(self) -> None:
        """Show what the program is; the notes of the preset with which it begins say how well it does."""
        notes = escape(load_preset(DEFAULT_PRESET).notes.strip()).replace("\n", " ")
        QMessageBox.about(
            self._window, "PhonemeAnalyser",
            tr("<b>PhonemeAnalyser</b><p>Calibrates real-time phoneme recognition for lip sync, and shows why a "
            "phoneme was recognised.<p>Version {version}, MIT licence; <i>Help &gt; Licences</i> lists all parts. "
            "The demo is a synthetic voice of the Festival project (CMU slt). The head is in the public domain (CC0)."
            "<p><b>The preset Learned.</b> {notes}").format(notes=notes, version=__version__),
        )  # fmt: skip

    def may_go_on(self) -> bool:
        """Ask what is to become of unsaved changes; says whether to go on."""
        if not self._preset.has_unsaved_changes:
            return True
        question = tr("Save the changes to the preset {preset}?").format(preset=self._preset.preset.name)
        return ask_to_save(self._window, tr("Unsaved changes"), question, self.save)

    def record(self) -> None:
        """Begin or end a recording; a file in hand is left only when that is wanted."""
        session = self._session
        leaves = session.source.path is not None and not session.microphone.recording
        if not leaves or self._may_record_instead_of(session.source.name):
            session.toggle_recording()

    def _may_record_instead_of(self, name: str) -> bool:
        """Ask whether to leave a file for the microphone; says whether to go on."""
        box = QMessageBox(
            QMessageBox.Icon.Question, tr("Record"), tr("Leave {name}, and record the microphone?").format(name=name),
            parent=self._window,
        )  # fmt: skip
        record = box.addButton(tr("Record"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(record)
        box.exec()
        return box.buttonRole(box.clickedButton()) == QMessageBox.ButtonRole.AcceptRole

    # -- variables and curves -----------------------------------------------------------------------------

    def ask_variable(self, low: float, high: float) -> None:
        """Let the user name a variable over a frequency range (Hz), and choose what it measures."""
        dialog = VariableDialog(low, high, self._preset.add_variable, self._window)
        if dialog.exec():
            self.variable_added.emit(dialog.variable().name)

    def add_variable(self, variable: Variable) -> None:
        """Add a variable that was suggested."""
        if self._try(lambda: self._preset.add_variable(variable)):
            self.variable_added.emit(variable.name)

    def ask_remove_variable(self) -> None:
        """Let the user choose a variable of his own to remove."""
        names = [v.name for v in self._preset.preset.variables]
        if not names:
            self.rejected.emit(
                tr("There are no variables of your own yet; mark a range on the averaged spectrum first.")
            )
            return
        name, chosen = QInputDialog.getItem(
            self._window, tr("Remove a variable"), tr("Variable:"), names, editable=False
        )
        if chosen:
            self._preset.remove_variable(name)

    def ask_curves(self) -> None:
        """Let the user choose curves to compare with."""
        for path in self._files.ask_files(tr("Load curves"), tr(CURVE_FILTER), "curve"):
            self.load_curve(path)

    def load_curve(self, path: Path) -> None:
        """Load a curve beside the averaged spectrum."""
        self._try(lambda: self._session.averages.load(path))

    def ask_save_curve(self) -> None:
        """Let the user choose a file to save the averaged spectrum to."""
        if not self._session.averages.n_frames:
            self.rejected.emit(tr("There is no averaged spectrum yet; play a sound first."))
            return
        if path := self._files.ask_target(
            tr("Save the averaged spectrum"), self._files.folder_of("curve"), tr(CURVE_FILTER), "curve"
        ):
            self._try(lambda: self._session.averages.save(path))

    def ask_save_picture(self, plot: QWidget, name: str) -> None:
        """Let the user choose a file to save the picture of a plot to: pixels, or lines that scale."""
        suggested = self._files.folder_of("picture") / f"{name}.png"
        if path := self._files.ask_target(tr("Save the picture"), suggested, tr(PICTURE_FILTER), "picture"):
            self._try(lambda: save_picture(plot, path))

    def _try(self, act: Callable[[], object]) -> bool:
        try:
            act()
        except EngineError as error:
            self.rejected.emit(str(error))
            return False
        self.rejected.emit("")
        return True


def _listed(words: tuple[str, ...]) -> str:
    return (
        words[0] if len(words) == 1 else tr("{first} and {last}").format(first=", ".join(words[:-1]), last=words[-1])
    )
