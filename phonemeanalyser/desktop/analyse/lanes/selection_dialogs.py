"""What the user is asked and shown about the selected part of a file."""

from PySide6.QtCore import QObject
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.measurement_dialog import MeasurementDialog
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.inspection.measurement import StretchMeasurement


class SelectionDialogs(QObject):
    """Asks where the selected sound goes, and shows what was measured."""

    def __init__(self, window: QWidget, selection: Selection, session: Session, files: FileAsker) -> None:
        super().__init__(window)
        self._window = window
        self._selection = selection
        self._session = session
        self._files = files
        selection.measured.connect(self.show_measurement)

    def show_measurement(self, measurement: StretchMeasurement) -> None:
        """Show what was measured, beside the window."""
        preset = self._session.preset.in_force.name
        MeasurementDialog(measurement, self._session.source.name, preset, self._window).show()

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
        suggested = self._files.folder_of("stretch", path.parent) / f"{path.stem} {span.start:.2f}-{span.end:.2f}.wav"
        if target := self._files.ask_target(
            tr("Save the selected sound"), suggested, "WAV (*.wav)", "stretch", other_endings=True
        ):
            self._selection.save(target)
