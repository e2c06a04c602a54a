"""What the user is asked and shown about the selected part of a file."""

from pathlib import Path

from PySide6.QtCore import QObject, QSettings
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog, QWidget

from phonemeanalyser.desktop.analyse.measurement_dialog import MeasurementDialog
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeengine.files import free_path
from phonemeengine.measurement import StretchMeasurement


class SelectionDialogs(QObject):
    """Asks where the selected sound goes, and shows what was measured."""

    def __init__(self, window: QWidget, selection: Selection, session: Session, settings: QSettings) -> None:
        super().__init__(window)
        self._window = window
        self._selection = selection
        self._session = session
        self._settings = settings
        selection.measured.connect(self.show_measurement)

    def show_measurement(self, measurement: StretchMeasurement) -> None:
        """Show what was measured, beside the window."""
        preset = self._session.preset.in_force.name
        MeasurementDialog(measurement, self._session.name, preset, self._window).show()

    def copy_frames(self) -> None:
        """Put the selected frames on the clipboard as a table."""
        text = self._selection.frames_as_text()
        if text:
            QGuiApplication.clipboard().setText(text)
            self._selection.info.emit(
                tr("Copied {n} frames; a spreadsheet takes them.").format(n=text.count(chr(10)) - 1)
            )

    def ask_save(self) -> None:
        """Let the user choose a file to save the selected sound to."""
        span, path = self._selection.span, self._session.path
        if span is None or path is None:
            return
        folder = Path(str(self._settings.value("folder/stretch", str(path.parent))))
        suggested = folder / f"{path.stem} {span.start:.2f}-{span.end:.2f}.wav"
        name, _ = QFileDialog.getSaveFileName(
            self._window, tr("Save the selected sound"), str(suggested), "WAV (*.wav)"
        )
        if name:
            # "demo 0.10-0.25" has no ending; "demo.mp3" has one, which the engine refuses in one sentence.
            target = Path(name) if any(map(str.isalpha, Path(name).suffix)) else free_path(Path(f"{name}.wav"))
            self._settings.setValue("folder/stretch", str(target.parent))
            self._selection.save(target)
