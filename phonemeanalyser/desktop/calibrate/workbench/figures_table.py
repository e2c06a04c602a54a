"""Figures of agreement side by side, and lists of segments, such as those of a cell of the matrix."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.preset import A, B
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import style_list
from phonemeanalyser.desktop.widgets.figures import FIGURES, colour_of_gain, figure_in_words
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeengine.arrays import Int64Array
from phonemeengine.calibration.scores.comparison import Gain, Gains
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.phonemes import Phoneme

COLUMN_WIDTH = 56
"""Pixels that a figure needs; narrower tables are scrolled."""
RANGE_TIP = tr_noop("Second minus first in percentage points; more than the number after ± is more than chance")
INTERVAL_TIP = tr_noop("95 % interval of chance: {low:+.1f} to {high:+.1f}")


class FiguresTable(QTableWidget):
    """A row for each figure, a column for each that is compared."""

    def __init__(self, columns: Sequence[str], theme: Theme) -> None:
        super().__init__(len(FIGURES), len(columns))
        self._theme = theme
        self.setVerticalHeaderLabels([tr(heading) for heading, _, _, _ in FIGURES])
        self.set_columns(columns)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        let_copy(self)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setMinimumSectionSize(COLUMN_WIDTH)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setTextElideMode(Qt.TextElideMode.ElideRight)
        self.verticalHeader().setDefaultSectionSize(22)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        for row, (_, _, _, tip) in enumerate(FIGURES):
            self.model().setHeaderData(row, Qt.Orientation.Vertical, tr(tip), Qt.ItemDataRole.ToolTipRole)

    def set_columns(self, names: Sequence[str]) -> None:
        """Name what is compared."""
        self.setColumnCount(len(names))
        self.setHorizontalHeaderLabels(list(names))
        for k, name in enumerate(names):
            self.model().setHeaderData(k, Qt.Orientation.Horizontal, name, Qt.ItemDataRole.ToolTipRole)

    def show_scores(self, scores: Sequence[Scores | None], gains: Gains | None = None) -> None:
        """Show figures; those after the first are coloured by whether they are better than it.

        A further column shows how much higher the second ones are, of some with the range that chance would give.
        """
        for row, (_, name, more_is_better, _) in enumerate(FIGURES):
            for column, found in enumerate(scores):
                value = float(getattr(found, name)) if found is not None else math.nan
                item = QTableWidgetItem(figure_in_words(name, value))
                item.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                first = scores[0]
                if column and first is not None and not math.isnan(value):
                    gain = (value - float(getattr(first, name))) * (1 if more_is_better else -1)
                    item.setForeground(QColor(colour_of_gain(gain, self._theme)))
                self.setItem(row, column, item)
            if len(scores) < self.columnCount():
                item = QTableWidgetItem(_difference(name, scores, gains))
                item.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                item.setToolTip(_range_in_words(getattr(gains, name, None)))
                self.setItem(row, len(scores), item)


def _difference(name: str, scores: Sequence[Scores | None], gains: Gains | None) -> str:
    """Return by how much the second figure is higher than the first, with its range where that is known."""
    one, other = (math.nan if found is None else float(getattr(found, name)) for found in scores)
    if math.isnan(other - one):
        return "–"
    if name.endswith("per_s"):
        return f"{other - one:+.1f}"
    gain: Gain | None = getattr(gains, name, None)
    percent = f"{100 * (other - one):+.1f}"
    return percent if gain is None else f"{percent} ±{100 * _towards_zero(gain):.1f}"


def _towards_zero(gain: Gain) -> float:
    """Return how far the interval of chance, which is seldom symmetric, reaches towards no difference, or beyond."""
    return gain.difference - gain.low if gain.difference > 0 else gain.high - gain.difference


def _range_in_words(gain: Gain | None) -> str:
    told = tr(RANGE_TIP)
    return told if gain is None else f"{told}. {tr(INTERVAL_TIP).format(low=100 * gain.low, high=100 * gain.high)}"


class ChangesTable(QTableWidget):
    """The frames whose phoneme is another one with B than with A, by phoneme."""

    def __init__(self) -> None:
        super().__init__(0, 4)
        self.setHorizontalHeaderLabels([tr("Phoneme"), A, B, tr("Becomes")])
        self.setAccessibleName(tr("Frames whose phoneme changes"))
        self.setToolTip(tr("Frames of 10 ms with A and with B, and which phonemes B gives"))
        style_list(self, 20, (62, 52, 46, 0))
        let_copy(self)

    def show_counts(self, counts: Int64Array | None) -> None:
        """Show frames, shape (11, 11): by what A answers (row), and what B answers (column)."""
        self.setRowCount(0 if counts is None else len(Phoneme))
        if counts is None:
            return
        for line, phoneme in enumerate(Phoneme):
            becomes = sorted(((int(counts[phoneme, p]), p) for p in Phoneme if p is not phoneme), reverse=True)
            words = ", ".join(f"{sound_name(p)} {n}" for n, p in becomes if n)
            cells = (sound_name(phoneme), str(counts[phoneme].sum()), str(counts[:, phoneme].sum()), words)
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                if column in {1, 2}:
                    item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.setItem(line, column, item)


MOST = 500
"""Rows that are shown at most."""


@dataclass(frozen=True)
class SegmentRow:
    """A segment in a list: the file, its seconds, and a remark."""

    path: Path
    start: float
    end: float
    words: str = ""


class SegmentList(QTableWidget):
    """Shows segments; a click, or Return, plays one.

    Signals
    -------
    play_asked : path, start and end.
    """

    play_asked = Signal(Path, float, float)

    def __init__(self, name: str, words: str) -> None:
        super().__init__(0, 4)
        self.rows: list[SegmentRow] = []
        self.setHorizontalHeaderLabels([tr("Recording"), tr("Start (s)"), "ms", words])
        self.setAccessibleName(name)
        self.setToolTip(tr("Click a segment to play it, or select one and press Return"))
        style_list(self, 20, (0, 68, 44, 90))
        self.setColumnHidden(3, not words)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setMinimumHeight(60)
        let_copy(self)
        self.cellClicked.connect(lambda row, _column: self._play(row))
        self.cellActivated.connect(lambda row, _column: self._play(row))

    def show_rows(self, rows: Sequence[SegmentRow]) -> None:
        """Show segments, as many as there is use for."""
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
