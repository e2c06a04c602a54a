"""Lists of stretches: of a cell of the matrix, or of what one preset gets right that the other misses."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QAbstractItemView, QTableWidget, QTableWidgetItem

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.widgets.builders import style_list
from phonemeanalyser.desktop.widgets.table_copy import let_copy

MOST = 500
"""Rows that are shown at most."""


@dataclass(frozen=True)
class SegmentRow:
    """A stretch in a list: the file, its seconds, and what is told of it."""

    path: Path
    start: float
    end: float
    words: str = ""


class SegmentList(QTableWidget):
    """Shows stretches; a click, or Return, plays one.

    Signals
    -------
    play_asked : path, start and end.
    """

    play_asked = Signal(Path, float, float)

    def __init__(self, name: str, words: str) -> None:
        super().__init__(0, 4)
        self.rows: list[SegmentRow] = []
        self.setHorizontalHeaderLabels([tr("recording"), tr("from (s)"), "ms", words])
        self.setAccessibleName(name)
        self.setToolTip(tr("Click a stretch to hear it, or choose one and press Return"))
        style_list(self, 20, (0, 60, 44, 90))
        self.setColumnHidden(3, not words)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setMinimumHeight(60)
        let_copy(self)
        self.cellClicked.connect(lambda row, _column: self._play(row))
        self.cellActivated.connect(lambda row, _column: self._play(row))

    def show_rows(self, rows: Sequence[SegmentRow]) -> None:
        """Show stretches, as many as there is use for."""
        if list(rows[:MOST]) == self.rows:
            return
        self.rows = list(rows[:MOST])
        self.setRowCount(len(self.rows))
        for k, row in enumerate(self.rows):
            words = (row.path.stem, f"{row.start:.2f}", f"{1000 * (row.end - row.start):.0f}", row.words)
            for column, text in enumerate(words):
                item = QTableWidgetItem(text)
                item.setToolTip(f"{row.path}, {row.start:.2f} – {row.end:.2f} s")
                if column in {1, 2}:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.setItem(k, column, item)

    def _play(self, k: int) -> None:
        row = self.rows[k]
        self.play_asked.emit(row.path, row.start, row.end)
