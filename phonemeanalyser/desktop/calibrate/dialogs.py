"""What the user is asked on the page of the calibration: folders, labelled recordings, and what their names mean."""

from pathlib import Path

from PySide6.QtCore import QObject, QSettings
from PySide6.QtWidgets import QFileDialog, QWidget

from phonemeanalyser.desktop.calibrate.mapping_dialog import MappingDialog
from phonemeanalyser.desktop.calibrate.model import CalibrationModel
from phonemeanalyser.desktop.session.preset import PRESET_FILTER

PROJECT, SPEAKER = "calibration/project", "calibration/speaker"


class CalibrationDialogs(QObject):
    """Asks, passes the answers to the models, and keeps project and speaker for the next start."""

    def __init__(self, window: QWidget, calibration: CalibrationModel, settings: QSettings) -> None:
        super().__init__(window)
        self._window = window
        self._calibration = calibration
        self._settings = settings
        calibration.recordings.unknown.connect(self.ask_names)
        calibration.takes.opened.connect(self._remember_project)

    def restore(self) -> None:
        """Take up the project and the speaker of the last start, where the project is still there."""
        takes = self._calibration.takes
        takes.speaker = str(self._settings.value(SPEAKER, takes.speaker))
        folder = str(self._settings.value(PROJECT, ""))
        if takes.folder is None and folder and Path(folder).is_dir():
            takes.open(Path(folder))

    def save(self) -> None:
        """Keep the speaker for the next start."""
        self._settings.setValue(SPEAKER, self._calibration.takes.speaker)

    def ask_project(self) -> None:
        """Let the user choose the folder of his takes."""
        folder = self._calibration.takes.folder or self._calibration.session.microphone.folder
        name = QFileDialog.getExistingDirectory(self._window, "The folder of the takes", str(folder))
        if name:
            self._calibration.takes.open(Path(name))

    def ask_recordings(self, folder: bool) -> None:
        """Let the user choose a folder of labelled recordings, or some sounds with their labels beside them."""
        place = str(self._settings.value("folder/recordings", str(Path.home())))
        title = "Labelled recordings"
        if folder:
            names = [QFileDialog.getExistingDirectory(self._window, title, place)]
        else:
            names, _ = QFileDialog.getOpenFileNames(self._window, title, place, "All files (*)")
        paths = [Path(name) for name in names if name]
        if paths:
            self._settings.setValue("folder/recordings", str(paths[0] if folder else paths[0].parent))
            self._calibration.recordings.load(paths)

    def ask_names(self, counts: dict[str, int], sources: list[Path]) -> None:
        """Let the user say what unknown names stand for."""
        dialog = MappingDialog(counts, self._window)
        if dialog.exec():
            self._calibration.recordings.map(dialog.mapping(), sources)

    def ask_preset(self) -> Path | None:
        """Let the user choose a preset to compare with."""
        folder = str(self._settings.value("folder/preset", str(Path.home())))
        name, _ = QFileDialog.getOpenFileName(self._window, "A preset to compare with", folder, PRESET_FILTER)
        return Path(name) if name else None

    def _remember_project(self) -> None:
        if self._calibration.takes.folder is not None:
            self._settings.setValue(PROJECT, str(self._calibration.takes.folder))
