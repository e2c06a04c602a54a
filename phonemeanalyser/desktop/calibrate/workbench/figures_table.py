"""Figures of agreement side by side, and lists of stretches, such as those of a cell of the matrix."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import style_list
from phonemeanalyser.desktop.widgets.plot_menu import let_copy
from phonemeengine.calibration.scores.scoring import Scores

ROWS: tuple[tuple[str, str, bool, str], ...] = (
    (
        tr_noop("macro F1, ten sounds"),
        "macro_f1",
        True,
        tr_noop("The mean F1 of the ten sounds: no figure hides a rare one"),
    ),
    (tr_noop("frames right, ten sounds"), "accuracy", True, tr_noop("Share of frames that are right")),
    (
        tr_noop("clear vowels right"),
        "vowel_accuracy",
        True,
        tr_noop("Share of frames of a, e, i, o and u that are right"),
    ),
    (
        tr_noop("mouth shapes right"),
        "viseme_accuracy",
        True,
        tr_noop("Share of frames with the right one of six mouth shapes"),
    ),
    (tr_noop("silence found"), "silence_recall", True, tr_noop("Share of silent frames that are called silence")),
    (
        tr_noop("speech called silence"),
        "false_silence",
        False,
        tr_noop("Share of spoken frames that are called silence"),
    ),
    (
        tr_noop("changes per second"),
        "changes_per_s",
        False,
        tr_noop("How often the answer changes: flicker, where labels change less"),
    ),
)
"""Heading, name of the figure, whether more is better, and what it means."""


class FiguresTable(QTableWidget):
    """A row for each figure, a column for each that is compared."""

    def __init__(self, columns: Sequence[str], theme: Theme) -> None:
        super().__init__(len(ROWS), len(columns))
        self._theme = theme
        self.setVerticalHeaderLabels([tr(heading) for heading, _, _, _ in ROWS])
        self.set_columns(columns)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        let_copy(self)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setHighlightSections(False)
        self.verticalHeader().setDefaultSectionSize(22)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        for row, (_, _, _, tip) in enumerate(ROWS):
            self.model().setHeaderData(row, Qt.Orientation.Vertical, tr(tip), Qt.ItemDataRole.ToolTipRole)

    def set_columns(self, names: Sequence[str]) -> None:
        """Name what is compared."""
        self.setColumnCount(len(names))
        self.setHorizontalHeaderLabels(list(names))

    def show_scores(self, scores: Sequence[Scores | None]) -> None:
        """Show figures; those after the first are coloured by whether they are better than it."""
        for row, (_, name, more_is_better, _) in enumerate(ROWS):
            for column, found in enumerate(scores):
                value = float(getattr(found, name)) if found is not None else math.nan
                item = QTableWidgetItem(words_of(name, value))
                item.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                first = scores[0]
                if column and first is not None and not math.isnan(value):
                    gain = (value - float(getattr(first, name))) * (1 if more_is_better else -1)
                    colour = (
                        self._theme.good if gain > 5e-4 else self._theme.bad if gain < -5e-4 else self._theme.text
                    )
                    item.setForeground(QColor(colour))
                self.setItem(row, column, item)


def words_of(name: str, value: float) -> str:
    """Write a figure: shares in percent, rates as they are."""
    if math.isnan(value):
        return "–"
    return f"{value:.1f}" if name.endswith("per_s") else f"{value:.1%}"


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
