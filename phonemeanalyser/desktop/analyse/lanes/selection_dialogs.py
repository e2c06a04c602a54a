"""What is done with the selected part of a file: saving it, and a table of what was measured of it."""

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.selection import Selection
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.widgets.builders import CLOSE, column, dialog_buttons, label, named
from phonemeanalyser.desktop.widgets.file_asker import FileAsker
from phonemeengine.features.variables import readable_name
from phonemeengine.inspection.measurement import MEASUREMENT_COLUMNS, StretchMeasurement, format_measurement
from phonemeengine.presets.preset import Preset

SIZE = 560, 520
"""Of the dialog at first, pixels."""


class MeasurementDialog(QDialog):
    """Shows a measurement; Ctrl+C, or a button, copies it for a spreadsheet.

    Attributes
    ----------
    table : a row for each measure.
    copy : the button.
    """

    def __init__(self, measurement: StretchMeasurement, sound: str, preset: Preset, parent: QWidget) -> None:
        super().__init__(parent)
        self._text = format_measurement(measurement).replace(",", "\t")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(
            tr("Measurements: {start:.3f} to {end:.3f} s of {sound}").format(
                start=measurement.start, end=measurement.end, sound=sound
            )
        )
        self.resize(*SIZE)
        rows = measurement.rows()
        self.table = named(QTableWidget(len(rows), len(MEASUREMENT_COLUMNS)), tr("Measurements"))
        self.table.setHorizontalHeaderLabels(list(map(tr, MEASUREMENT_COLUMNS)))
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for k, row in enumerate(rows):
            for place, words in enumerate(row):
                item = QTableWidgetItem(
                    words if place else sound_name(tr_engine(readable_name(words, preset.variables)))
                )
                item.setToolTip("" if place else words)
                if place > 1:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.table.setItem(k, place, item)
        told = label(
            tr(
                "Recognised with the preset {preset}. Pitch and formants: of the voiced frames. Level: root mean "
                "square (mean) and largest sample (max), dBFS. Phonemes: shares of all frames."
            ).format(preset=preset.name),
            wraps=True,
        )
        buttons = dialog_buttons(self, CLOSE)
        self.copy = buttons.addButton(tr("Copy"), QDialogButtonBox.ButtonRole.ActionRole)
        self.copy.setToolTip(tr("Copy the table as tab-separated text"))
        self.copy.clicked.connect(self.copy_table)
        QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), self, self.copy_table)
        column(self.table, told, buttons, on=self, margins=None)

    def copy_table(self) -> None:
        """Put the table on the clipboard."""
        QGuiApplication.clipboard().setText(self._text)


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
        preset = self._session.preset.in_force
        MeasurementDialog(measurement, self._session.source.name, preset, self._window).show()

    def copy_frames(self) -> None:
        """Put the selected frames on the clipboard as a table."""
        text = self._selection.frames_as_text()
        if text:
            QGuiApplication.clipboard().setText(text)
            self._selection.info.emit(
                tr("Copied {n} frames as a table; paste them into a spreadsheet.").format(n=text.count(chr(10)) - 1)
            )

    def ask_save(self) -> None:
        """Let the user choose a file to save the selected sound to."""
        span, path = self._selection.span, self._session.path
        if span is None or path is None:
            return
        suggested = self._files.folder_of("stretch", path.parent) / f"{path.stem} {span.start:.2f}-{span.end:.2f}.wav"
        if target := self._files.ask_target(
            tr("Save Selection as Audio File"), suggested, "WAV (*.wav)", "stretch", other_endings=True
        ):
            self._selection.save(target)
