"""Compares the preset in use with a second one."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QLabel, QTabWidget, QVBoxLayout, QWidget

from phonemeanalyser.desktop.calibrate.figures_table import FiguresTable
from phonemeanalyser.desktop.calibrate.fit_model import ComparisonModel
from phonemeanalyser.desktop.calibrate.segment_list import SegmentList, SegmentRow
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.phoneme_keys import LetterPassthrough
from phonemeengine.calibration.scores.comparison import DifferingSegment

NONE, OTHER = "choose a preset …", "another file …"


class ComparePanel(QWidget):
    """The second preset, both presets' figures, and what only one of them gets right.

    Signals
    -------
    file_asked : the user wants to choose a preset's file.
    play_asked : path, start and end of a stretch.
    """

    file_asked = Signal()
    play_asked = Signal(Path, float, float)

    def __init__(self, comparison: ComparisonModel, theme: Theme) -> None:
        super().__init__()
        self._comparison = comparison
        self.box = QComboBox()
        self.state = QLabel()
        self.difference = QCheckBox("difference in the matrix")
        self.figures = FiguresTable(("in use", "second"), theme)
        self.own = SegmentList("only the preset in use is right", "said, not")
        self.others = SegmentList("only the second preset is right", "said, not")
        self.tabs = QTabWidget()
        self.tabs.tabBar().setAccessibleName("pages of the comparison")
        self._lay_out()
        self._connect()
        self._show()

    def offer(self, path: Path) -> None:
        """Choose a preset's file."""
        if self.box.findData(path) < 0:
            self.box.insertItem(self.box.count() - 1, path.stem, path)
        self.box.setCurrentIndex(self.box.findData(path))
        self._comparison.choose(path)

    def _lay_out(self) -> None:
        self.box.addItem(NONE, None)
        for path in self._comparison.shipped():
            self.box.addItem(path.stem, path)
        self.box.addItem(OTHER, "")
        self.box.setToolTip("Preset to compare with, on the same takes and recordings")
        self.box.setAccessibleName(self.box.toolTip())
        self.box.installEventFilter(LetterPassthrough(self.box))
        self.difference.setToolTip("Show in the matrix how much more often the preset in use gives each answer")
        self.tabs.addTab(self.figures, "figures")
        self.tabs.addTab(self.own, "only this right")
        self.tabs.addTab(self.others, "only the second right")
        row = QHBoxLayout()
        row.addWidget(self.box, 1)
        row.addWidget(self.state)
        row.addWidget(self.difference)
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 4)
        column.addLayout(row)
        column.addWidget(self.tabs, 1)
        self.tabs.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def _connect(self) -> None:
        self.box.activated.connect(self._choose)
        self._comparison.changed.connect(self._show)
        self._comparison.measuring.changed.connect(self._show_measuring)
        for view in (self.own, self.others):
            view.play_asked.connect(self.play_asked)

    def _show_measuring(self) -> None:
        measuring = self._comparison.measuring
        self.state.setText(f"measuring {100 * measuring.progress:.0f} %" if measuring.busy else "")

    def _choose(self, index: int) -> None:
        data = self.box.itemData(index)
        if data == "":
            self.box.setCurrentIndex(0)
            self.file_asked.emit()
        else:
            self._comparison.choose(data)

    def _show(self) -> None:
        comparison, preset = self._comparison.result, self._comparison.preset
        self.difference.setEnabled(comparison is not None)
        if preset is None:
            self.box.setCurrentIndex(0)
        self.figures.set_columns(("in use", preset.name if preset is not None else "second"))
        if comparison is None:
            self.figures.show_scores((None, None))
            self.own.show_rows(())
            self.others.show_rows(())
            return
        self.figures.show_scores((comparison.one.overall.scores, comparison.other.overall.scores))
        self.own.show_rows([_row_of(stretch) for stretch in comparison.stretches_one])
        self.others.show_rows([_row_of(stretch) for stretch in comparison.stretches_other])
        for k, counts in ((1, comparison.only_one), (2, comparison.only_other)):
            name = "only this" if k == 1 else "only the second"
            self.tabs.setTabText(k, f"{name} right: {int(counts.sum()) / 100:.1f} s")


def _row_of(stretch: DifferingSegment) -> SegmentRow:
    words = f"{stretch.label.label}, {stretch.wrong.label}"
    return SegmentRow(stretch.utterance.path, stretch.start, stretch.end, words)
