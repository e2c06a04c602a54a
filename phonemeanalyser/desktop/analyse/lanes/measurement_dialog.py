"""What was measured of a stretch of a sound, as a table that copies."""

from PySide6.QtCore import Qt
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

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import CLOSE, column, dialog_buttons, label, named
from phonemeengine.inspection.measurement import MEASUREMENT_COLUMNS, StretchMeasurement, format_measurement

SIZE = 460, 520
"""Of the dialog at first, pixels."""


class MeasurementDialog(QDialog):
    """Shows a measurement; Ctrl+C, or a button, copies it for a spreadsheet.

    Attributes
    ----------
    table : a row for each measure.
    copy : the button.
    """

    def __init__(self, measurement: StretchMeasurement, sound: str, preset: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._text = format_measurement(measurement).replace(",", "\t")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(
            tr("{start:.3f} to {end:.3f} s of {sound}").format(
                start=measurement.start, end=measurement.end, sound=sound
            )
        )
        self.resize(*SIZE)
        rows = measurement.rows()
        self.table = named(QTableWidget(len(rows), len(MEASUREMENT_COLUMNS)), tr("what was measured"))
        self.table.setHorizontalHeaderLabels(list(map(tr, MEASUREMENT_COLUMNS)))
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.table.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        for k, row in enumerate(rows):
            for place, words in enumerate(row):
                item = QTableWidgetItem(tr(words) if place == 0 else words)
                if place > 1:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.table.setItem(k, place, item)
        told = label(
            tr(
                "Heard with the preset {preset}. Pitch and formants are of the frames with a pitch; levels are the "
                "root mean square (mean) and the largest sample (max), dB of full scale; phonemes are shares of the "
                "frames."
            ).format(preset=preset),
            wraps=True,
        )
        buttons = dialog_buttons(self, CLOSE)
        self.copy = buttons.addButton(tr("Copy"), QDialogButtonBox.ButtonRole.ActionRole)
        self.copy.setToolTip(tr("Copy the table, with tabs between the columns"))
        self.copy.clicked.connect(self.copy_table)
        QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), self, self.copy_table)
        column(self.table, told, buttons, on=self, margins=None)

    def copy_table(self) -> None:
        """Put the table on the clipboard."""
        QGuiApplication.clipboard().setText(self._text)
