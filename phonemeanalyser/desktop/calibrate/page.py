"""The page of the calibration: takes at the left, what they say of the preset at the right; and what it asks."""

from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Qt
from PySide6.QtWidgets import QComboBox, QDialog, QGridLayout, QMessageBox, QScrollArea, QWidget

from phonemeanalyser.desktop.calibrate.guide.guide_view import GuideView
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.calibrate.takes.takes_panel import TakesPanel
from phonemeanalyser.desktop.calibrate.workbench.workbench_view import WorkbenchView
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_count
from phonemeanalyser.desktop.settings import keep, read
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.file_asker import FileAsker, audio_filters
from phonemeanalyser.desktop.widgets.keyboard import HeldKeys
from phonemeanalyser.desktop.widgets.pages import PageStack
from phonemeanalyser.desktop.widgets.preset_picker import PresetPicker, preset_filter
from phonemeengine.phonemes import Phoneme


class CalibrationPage(QWidget):
    """Lays out what belongs to calibration.

    Parameters
    ----------
    head : says in the guided calibration what is recognised.
    picker : the list of presets, from which the other one of A and B is chosen.

    Attributes
    ----------
    keys : to be installed as an event filter of the window.
    """

    def __init__(self, calibration: CalibrationModel, head: QWidget, picker: PresetPicker, theme: Theme) -> None:
        super().__init__()
        self._calibration = calibration
        self._theme = theme
        self.takes = TakesPanel(calibration, theme)
        self.keys = HeldKeys(calibration, self)
        self.right = PageStack()
        self.guide = GuideView(calibration, head, theme)
        self.workbench = WorkbenchView(calibration, picker, theme)
        self._lay_out()
        self.takes.guide_asked.connect(calibration.begin_guide)
        calibration.guide.changed.connect(self._show_guide)

    def refresh(self) -> None:
        """Show what changes by itself."""
        if self._calibration.guide.running:
            self.guide.refresh()
        elif self.workbench.phoneme_data.isVisible():
            self.workbench.phoneme_data.refresh()

    def _show_guide(self) -> None:
        running = self._calibration.guide.running
        self.right.setCurrentWidget(self.guide if running else self.workbench)
        self.takes.guide.setEnabled(not running)
        self.takes.room.setEnabled(not running)
        self.takes.record.setEnabled(not running)

    def _lay_out(self) -> None:
        self.right.addWidget(self.workbench)
        self.right.addWidget(self.guide)
        builders.row(self.takes, builders.line(self._theme.line, upright=True), (self.right, 1), on=self, spacing=0)


class MappingDialog(QDialog):
    """A row for each name; what is left at "unidentified" counts for no figure."""

    def __init__(self, counts: dict[str, int], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Unknown Labels"))
        self.boxes: dict[str, QComboBox] = {}
        intro = builders.label(
            tr(
                "These labels are not known phoneme names. Choose a phoneme for each one; labels left "
                "unidentified are not scored."
            ),
            wraps=True,
        )
        body = QWidget()
        grid = QGridLayout(body)
        phonemes = [(sound_name(phoneme), phoneme) for phoneme in Phoneme]
        for place, (name, count) in enumerate(sorted(counts.items(), key=lambda entry: -entry[1])):
            words = builders.label(name)
            words.setTextFormat(Qt.TextFormat.PlainText)
            self.boxes[name] = box = builders.choice(phonemes, tr("Phoneme for {name}").format(name=name))
            box.setCurrentIndex(box.findData(Phoneme.UNIDENTIFIED))
            for k, widget in enumerate((words, builders.label(f"{count} ×"), box)):
                grid.addWidget(widget, place, k)
        grid.setRowStretch(len(counts), 1)
        builders.leave_wheel(body)
        scroll = QScrollArea()
        scroll.setWidget(body)
        scroll.setWidgetResizable(True)
        builders.column(
            intro, scroll, builders.dialog_buttons(self, builders.CANCEL, verb=tr("Assign")), on=self, margins=None
        )
        self.resize(380, 420)

    def mapping(self) -> dict[str, Phoneme]:
        """Return what each name stands for."""
        return {name: Phoneme(box.currentData()) for name, box in self.boxes.items()}


PROJECT, SPEAKER = "calibration/project", "calibration/speaker"


class CalibrationDialogs(QObject):
    """Asks, passes the answers to the models, and keeps project and speaker for the next start."""

    def __init__(self, window: QWidget, calibration: CalibrationModel, settings: QSettings, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._calibration = calibration
        self._settings, self._files = settings, files
        calibration.recordings.unknown.connect(self.ask_names)
        calibration.takes.opened.connect(self._remember_project)

    def join(self, page: CalibrationPage) -> None:
        """Answer what a page asks."""
        page.takes.project_asked.connect(self.ask_project)
        page.takes.empty_asked.connect(self.ask_empty_deleted)
        page.takes.import_asked.connect(self.ask_recordings)
        page.workbench.phoneme_data.file_asked.connect(self._ask_pitch_set)

    def restore(self) -> None:
        """Take up the project and the speaker of the last start, where the project is still there."""
        takes = self._calibration.takes
        takes.speaker = read(self._settings, SPEAKER, takes.speaker)
        folder = read(self._settings, PROJECT, "")
        if takes.folder is None and folder and Path(folder).is_dir():
            takes.open(Path(folder))

    def save(self) -> None:
        """Keep the speaker for the next start."""
        keep(self._settings, SPEAKER, self._calibration.takes.speaker)

    def ask_project(self) -> None:
        """Let the user choose the folder of his takes."""
        folder = self._calibration.takes.folder or self._calibration.session.microphone.folder
        if chosen := self._files.ask_folder(tr("Choose Takes Folder"), folder):
            self._calibration.takes.open(chosen)

    def ask_empty_deleted(self) -> None:
        """Remove deleted takes for ever, if the user says so once more."""
        takes = self._calibration.takes
        n = takes.now.n_deleted
        if not n:
            takes.info.emit(tr("There are no deleted takes."))
            return
        text = tr_count(
            "Permanently remove the deleted take from disk? Earlier changes to takes can then no longer be undone.",
            "Permanently remove {n} deleted takes from disk? Earlier changes to takes can then no longer be undone.",
            n,
        )
        box = QMessageBox(QMessageBox.Icon.Question, tr("Remove Deleted Takes"), text, parent=self._window)
        remove = box.addButton(tr("Remove"), QMessageBox.ButtonRole.DestructiveRole)
        box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Cancel))
        box.exec()
        if box.clickedButton() is remove:
            takes.empty_deleted()

    def ask_recordings(self, folder: bool) -> None:
        """Let the user choose a folder of labelled recordings, or some sounds with their labels beside them."""
        title, kind = tr("Load Labelled Recordings"), "recordings"
        if not folder:
            paths = self._files.ask_files(title, audio_filters(), kind)
        elif chosen := self._files.ask_folder(title, self._files.folder_of(kind)):
            self._files.remember(kind, chosen)
            paths = [chosen]
        else:
            paths = []
        if paths:
            self._calibration.recordings.load(paths)

    def ask_names(self, counts: dict[str, int], sources: list[Path]) -> None:
        """Let the user say what unknown names stand for."""
        dialog = MappingDialog(counts, self._window)
        if dialog.exec():
            self._calibration.recordings.map(dialog.mapping(), sources)

    def _ask_pitch_set(self) -> None:
        """Let the user choose a file whose numbers become a pitch set."""
        if path := self._files.ask_file(tr("Choose PhonemeData for a Pitch Set"), preset_filter(), "preset"):
            self._calibration.phoneme_data.add_file(path)

    def _remember_project(self) -> None:
        if self._calibration.takes.folder is not None:
            keep(self._settings, PROJECT, self._calibration.takes.folder)
