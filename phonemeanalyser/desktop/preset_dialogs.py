"""What the user is asked about presets: which one, under which name, and what is to become of unsaved changes."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, QTimer, QUrl, Signal
from PySide6.QtGui import QDesktopServices, QTextCursor
from PySide6.QtWidgets import QInputDialog, QMessageBox, QPlainTextEdit, QWidget

from phonemeanalyser.desktop.analyse.recognition.preset_choice import EncoderDialog, PresetBox
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import A, B, PresetDocument, PresetModel
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.unsaved import UnsavedChanges
from phonemeanalyser.desktop.settings import keep, read, read_paths, remember
from phonemeanalyser.desktop.tasks import CLOSE_TIMEOUT, TaskQueue, tried
from phonemeanalyser.desktop.widgets.builders import answer_of, input_dialog
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, ask_to_save
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker
from phonemeengine.errors import EngineError
from phonemeengine.presets import files
from phonemeengine.presets.model_choice import for_live_use
from phonemeengine.storage.paths import presets_folder

NOTES_SIZE = 800, 420
IN_USE, NOT_IN_USE, LETTER = "preset", "other preset", "preset letter"
"""Keys of what is kept of A and B for the next start."""
PRESET_FILTERS = "Preset (*.toml);;PhonemeData (*.phonemedata *.txt)"


class PresetDialogs(QObject):
    """Asks, and passes the answers to the models; what is refused is said, and leaves everything as it was.

    Signals
    -------
    rejected : a sentence for the user; an empty one after something went well.
    info : a sentence for the user about something to know.
    action_offered : a sentence, what can be done about it, and the function that does it.
    offer_ended : what was offered is of no use any more, since the preset was saved or another one was loaded.
    """

    rejected = Signal(str)
    info = Signal(str)
    action_offered = Signal(str, str, object)
    offer_ended = Signal(object)

    def __init__(
        self, window: QWidget, session: Session, preset: PresetModel, settings: QSettings, files: FileAsker
    ) -> None:
        super().__init__(window)
        self._window, self._session, self._preset = window, session, preset
        self._settings, self._files = settings, files
        self._shipping = TaskQueue(self.rejected.emit)
        preset.sides_changed.connect(self._keep_sides)
        for told in (preset.loaded, preset.file_changed):
            told.connect(self._end_offers)

    def close(self) -> None:
        """Tell no more of a preset that is being shipped."""
        self._shipping.close(CLOSE_TIMEOUT)

    def join(self, box: PresetBox) -> None:
        """Do what the user asks for in the tool bar."""
        box.chosen.connect(self.load)
        box.other_chosen.connect(self.load_other)
        box.recogniser_chosen.connect(self.choose_recogniser)

    def picker_of_other(self) -> PresetPicker:
        """Return a list of presets from which the other one of A and B is chosen."""
        picker = PresetPicker(self.sections, self._files)
        picker.other_chosen.connect(self.load_other)
        return picker

    def load(self, path: Path) -> None:
        """Load a preset, after asking what is to become of unsaved changes."""
        if self.may_go_on() and self._load(path):
            self._remember_preset(self._preset.path)

    def _load(self, path: Path) -> bool:
        """Load a preset; say what of it could not be had, and whether it is loaded."""
        is_loaded = tried(lambda: self._preset.load(path), self.rejected.emit)
        if is_loaded and (warnings := for_live_use(self._preset.preset).warnings):
            self.rejected.emit(" ".join(map(tr_engine, warnings)))
        return is_loaded

    def choose_recogniser(self, name: str) -> None:
        """Recognise with another recogniser."""
        tried(lambda: self._preset.set_recogniser(name), self.rejected.emit)

    def show_encoder(self) -> None:
        """Show where the speech encoder's model is, and let the user choose or fetch one."""
        dialog = EncoderDialog(self._files, self._window)
        dialog.model_changed.connect(self._preset.changed)
        dialog.exec()
        dialog.deleteLater()

    def offer_to_save(self) -> None:
        """Say that a calibrated preset is in use and in no file yet."""
        if self._preset.has_unsaved_changes:
            sentence = tr("The calibrated preset is in use but not saved yet.")
            self.action_offered.emit(sentence, tr("Save As…"), self.save_as)

    def _end_offers(self) -> None:
        for act in (self.save_as, self._preset.revert):
            self.offer_ended.emit(act)

    def restore(self) -> None:
        """Load A and B of the last start, and use the one that was in use; say which file is gone."""
        kept = [path for key in (IN_USE, NOT_IN_USE) if (path := self._kept(key)) != Path()]
        there, gone = [path for path in kept if path.is_file()], [path for path in kept if not path.is_file()]
        was_b = len(there) > 1 and read(self._settings, LETTER, A) == B
        first, *others = (there[::-1] if was_b else there) or [self._preset.path]
        if first != self._preset.path:
            self._load(first)
        if others:
            tried(lambda: self._preset.set_other(PresetDocument.read(others[0])), self.rejected.emit)
        if was_b and self._preset.other is not None:
            self._preset.switch()
        if gone:
            self._keep_sides()
            one = tr("The preset of the last session is no longer there: {paths}. Choose another one in the list.")
            many = tr("The presets of the last session are no longer there: {paths}. Choose others in the list.")
            self.rejected.emit((one if len(gone) == 1 else many).format(paths=", ".join(map(str, gone))))

    def _kept(self, key: str) -> Path:
        """Return the file of a preset of the last start; a factory preset's is known by its name."""
        path = read(self._settings, key, Path())
        return next((factory for factory in files.FACTORY_PRESETS if factory.stem == str(path)), path)

    def _keep(self, key: str, path: Path | None) -> None:
        path = None if path is None else path.resolve()
        keep(
            self._settings, key, "" if path is None else path.stem if path.parent == files.FACTORY.resolve() else path
        )

    def _keep_sides(self) -> None:
        """Keep which presets are A and B, and which one is in use."""
        other = self._preset.other
        self._keep(IN_USE, self._preset.path)
        self._keep(NOT_IN_USE, None if other is None or other.path == self._preset.path else other.path)
        keep(self._settings, LETTER, self._preset.letter)

    def restore_unsaved(self, unsaved: UnsavedChanges) -> None:
        """Take up what was changed and not saved when the program ended, and offer to undo that."""
        try:
            found = unsaved.restore()
        except EngineError as error:
            self.rejected.emit(
                tr("Unsaved changes from the last session cannot be restored: {error}").format(
                    error=tr_engine(str(error))
                )
            )
            return
        if found:
            name = self._preset.preset.name
            sentence = tr("Unsaved changes to the preset {name} were restored from the last session.").format(
                name=name
            )
            self.action_offered.emit(sentence, tr("Discard Changes"), self._preset.revert)

    def load_other(self, path: Path) -> None:
        """Have the preset of a file beside the one in use, as the other one of A and B."""
        if tried(lambda: self.set_other(PresetDocument.read(path)), self.rejected.emit):
            remember(self._settings, "recent presets", files.preset_path(path))

    def set_other(self, document: PresetDocument) -> None:
        """Have another preset beside the one in use, after asking about unsaved changes of the one that goes."""
        if self._may_lose_other():
            self._preset.set_other(document)

    def clear_second(self) -> None:
        """Use A, and have no B any more, after asking about its unsaved changes."""
        if self._preset.letter == B:
            self._preset.switch()
        if self._may_lose_other():
            self._preset.clear_second()

    def save(self) -> bool:
        """Save the preset to its file; a factory preset is saved under a name of the user's own."""
        if self._preset.is_factory:
            return self.save_as()
        return self._save_to(self._preset.path)

    def save_as(self, suggested: Path | None = None) -> bool:
        """Let the user choose a file to save the preset to; says whether it was saved."""
        suggested = suggested or self._own_presets_folder() / f"{self._preset.path.stem}-mine.toml"
        path = self._files.ask_target(tr("Save Preset As"), suggested, PRESET_FILTERS, "preset")
        return path is not None and self._save_to(path)

    def _save_to(self, path: Path) -> bool:
        """Save to a file; where it cannot hold all, the user says what becomes of the rest."""
        lost = self._preset.lost_in(path)
        if lost:
            answer = self._ask_what_becomes_of(lost, path)
            if answer != QMessageBox.ButtonRole.AcceptRole:
                return answer == QMessageBox.ButtonRole.YesRole and self.save_as(path.with_suffix(".toml"))
        saved = tried(lambda: self._preset.save(path), self.rejected.emit)
        if saved:
            self._remember_preset(path)
        return saved

    def _ask_what_becomes_of(self, lost: tuple[str, ...], path: Path) -> QMessageBox.ButtonRole:
        """Return what a PhonemeData file cannot hold; Yes is a TOML file, Accept the numbers only, Reject neither."""
        box = QMessageBox(QMessageBox.Icon.Question, tr("Save as PhonemeData"), "", parent=self._window)
        box.setText(
            tr(
                "A PhonemeData file holds 21 numbers only: {path} cannot store {listed} of this preset. Save the "
                "whole preset as a TOML file?"
            ).format(path=path.name, listed=_listed(lost))
        )
        roles = QMessageBox.ButtonRole
        toml = box.addButton(tr("Save as TOML…"), roles.YesRole)
        box.addButton(tr("Save 21 Numbers Only"), roles.AcceptRole)
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
        self._keep(IN_USE, path)
        remember(self._settings, "recent presets", path)

    def sections(self) -> dict[str, tuple[files.PresetEntry, ...]]:
        """Return the presets to choose from, by heading: the program's, the user's own, and others used lately."""
        mine = files.own_presets()
        listed = {*files.FACTORY_PRESETS, *mine}
        recent = read_paths(self._settings, "recent presets")
        return {
            tr("Factory"): files.preset_entries(files.FACTORY_PRESETS),
            tr("User"): files.preset_entries(mine),
            tr("Recent"): files.preset_entries(path for path in recent if path not in listed),
        }

    def show_ship(self) -> None:
        """Ask which preset is shipped, for what and where to."""
        from phonemeanalyser.desktop.ship_dialog import ShipDialog  # noqa: PLC0415 - the first window waits for it

        dialog = ShipDialog(self._preset.preset, self.sections, self._settings, self._files, self._window)
        dialog.ordered.connect(lambda order: self._ship(order.target, order.folder, order.write))
        dialog.open()

    def show_serve(self) -> None:
        """Show the server, and what is served."""
        from phonemeanalyser.desktop.serve_dialog import ServeDialog  # noqa: PLC0415 - as above

        shown = self._window.findChild(ServeDialog)
        if shown is None:
            preset = self._preset
            in_hand = preset.preset if preset.has_unsaved_changes else preset.path
            shown = ServeDialog(
                self._session.server,
                in_hand,
                preset.preset.name,
                self.sections,
                self._settings,
                self._files,
                self._window,
            )
        shown.show()
        shown.raise_()

    def _ship(self, target: str, folder: Path, write: Callable[[], tuple[Path, ...]]) -> None:
        """Ship in the background; zig takes seconds, and minutes when it is asked for the first time."""
        self.info.emit(tr("Writing files for {target} to {folder}…").format(target=target, folder=folder))

        def tell(written: tuple[Path, ...]) -> None:
            sentence = tr("{n} files written to {folder}. README.md describes the next steps.")
            url = QUrl.fromLocalFile(folder)
            self.action_offered.emit(
                sentence.format(n=len(written), folder=folder), tr("Open Folder"),
                lambda: QDesktopServices.openUrl(url),
            )  # fmt: skip

        self._shipping.submit(lambda _progress: write(), tell)

    def ask_notes(self) -> None:
        """Let the user read and change the preset's notes."""
        question = tr("Notes on the preset {preset}:").format(preset=self._preset.preset.name)
        dialog = input_dialog(self._window, tr("Preset Notes"), question, tr("Apply"))
        dialog.setOption(QInputDialog.InputDialogOption.UsePlainTextEditForTextInput)
        dialog.setTextValue(self._preset.preset.notes)
        dialog.resize(*NOTES_SIZE)
        for field in dialog.findChildren(QPlainTextEdit):  # else all is selected, and the next key deletes it
            QTimer.singleShot(0, partial(field.moveCursor, QTextCursor.MoveOperation.Start))
        if (notes := answer_of(dialog)) is not None:
            self._preset.edit(replace(self._preset.preset, notes=notes), tr("edit notes"))

    def may_close(self) -> bool:
        """Ask what is to become of unsaved changes of A and B; says whether to go on."""
        return self.may_go_on() and self._may_lose_other()

    def _may_lose_other(self) -> bool:
        """Ask what is to become of unsaved changes of the one that is not in use, which is shown meanwhile."""
        other = self._preset.other
        if other is None or not other.has_unsaved_changes or other.preset == self._preset.preset:
            return True
        self._preset.switch()
        may = self.may_go_on()
        self._preset.switch()
        return may

    def may_go_on(self) -> bool:
        """Ask what is to become of unsaved changes; says whether to go on."""
        if not self._preset.has_unsaved_changes:
            return True
        question = tr("Save changes to the preset {preset}?").format(preset=self._preset.preset.name)
        return ask_to_save(self._window, tr("Unsaved Changes"), question, self.save)


def _listed(words: tuple[str, ...]) -> str:
    return (
        words[0] if len(words) == 1 else tr("{first} and {last}").format(first=", ".join(words[:-1]), last=words[-1])
    )
