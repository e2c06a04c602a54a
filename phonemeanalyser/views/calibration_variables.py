"""The variables, ranked by how well they separate the sounds, and the search for better ones."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QGridLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from engine.features.variables import Variable
from engine.phonemes import Phoneme
from phonemeanalyser.models.calibration_bench import BenchModel
from phonemeanalyser.theme import Theme
from phonemeanalyser.views.calibration_keys import KEYS, LettersPassed

NAME = Qt.ItemDataRole.UserRole


class VariablesPanel(QWidget):
    """Chooses the variable that is shown, and suggests others for a pair of sounds.

    Signals
    -------
    add_asked : a `Variable` that the user wants to have.
    """

    add_asked = Signal(Variable)

    def __init__(self, bench: BenchModel, theme: Theme) -> None:
        super().__init__()
        self._bench = bench
        self._theme = theme
        self.table = QTableWidget(0, 2)
        self.one, self.other = QComboBox(), QComboBox()
        self.search = QPushButton("suggest")
        self.add = QPushButton("add")
        self._lay_out()
        self._connect()
        self._fill()

    def refresh(self) -> None:
        """Show how far a search is."""
        busy = self._bench.searching
        self.search.setText(f"stop {100 * self._bench.search_share:.0f} %" if busy else "suggest")

    def _lay_out(self) -> None:
        self.setFixedWidth(216)
        self.table.setHorizontalHeaderLabels(["variable", "separates"])
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Fixed)
        header.resizeSection(1, 68)
        header.setFixedHeight(22)
        header.setHighlightSections(False)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(20)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setShowGrid(False)
        self.table.setTabKeyNavigation(False)
        self.table.setAccessibleName("variables")
        self.table.setToolTip(
            "The chance that of two frames of different sounds a threshold tells which is which: 50 % says nothing"
        )
        self.table.installEventFilter(LettersPassed(self.table))
        for phoneme in KEYS:
            self.one.addItem(phoneme.label, phoneme)
            self.other.addItem(phoneme.label, phoneme)
        self.other.addItem("all others", None)
        self.one.setCurrentIndex(self.one.findData(Phoneme.SZ))
        self.other.setCurrentIndex(self.other.findData(Phoneme.SCH))
        for box, name in (
            (self.one, "Sound that is to be told apart"),
            (self.other, "... from this one, or from all"),
        ):
            box.setToolTip(name)
            box.setAccessibleName(name)
            box.installEventFilter(LettersPassed(box))
        self.search.setToolTip("Search for frequency ranges that part these two best")
        self.add.setToolTip("Add the suggested variable to the preset; Ctrl+Z takes it back")
        for button in (self.search, self.add):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 4, 4, 4)
        column.setSpacing(4)
        column.addWidget(self.table, 1)
        grid = QGridLayout()
        grid.setSpacing(4)
        grid.addWidget(QLabel("part"), 0, 0)
        grid.addWidget(self.one, 0, 1)
        grid.addWidget(QLabel("from"), 0, 2)
        grid.addWidget(self.other, 0, 3)
        grid.setColumnStretch(1, 1)
        grid.setColumnStretch(3, 1)
        grid.addWidget(self.search, 1, 0, 1, 2)
        grid.addWidget(self.add, 1, 2, 1, 2)
        column.addLayout(grid)

    def _connect(self) -> None:
        self.table.currentCellChanged.connect(self._choose)
        self.search.clicked.connect(self._search)
        self.add.clicked.connect(self._add)
        self._bench.distribution_changed.connect(self._fill)
        self._bench.suggested.connect(self._fill)

    def _fill(self) -> None:
        ranked = [(r.variable, r.separation, "") for r in self._bench.ranking]
        have = {name for name, _, _ in ranked}
        suggested = [
            (s.variable.name, s.separation, f"{s.variable.kind} of {s.variable.low:.0f}–{s.variable.high:.0f} Hz, "
             f"threshold {s.threshold:.3g}")
            for s in self._bench.suggestions if s.variable.name not in have
        ]  # fmt: skip
        rows = [*suggested, *ranked]
        self.table.blockSignals(True)
        self.table.setRowCount(len(rows))
        for row, (name, separation, words) in enumerate(rows):
            new = row < len(suggested)
            items = QTableWidgetItem(f"+ {name}" if new else name), QTableWidgetItem(f"{separation:.0%}")
            items[1].setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            for column, item in enumerate(items):
                item.setData(NAME, name)
                item.setToolTip(words or name)
                item.setForeground(QColor(self._theme.accent if new else self._theme.text))
                self.table.setItem(row, column, item)
            if name == self._bench.variable:
                self.table.setCurrentCell(row, 0)
        if suggested and self.table.currentRow() < 0:
            self.table.setCurrentCell(0, 0)
        self.table.blockSignals(False)
        self._show_add()

    def _choose(self, row: int, _column: int, old: int, _old_column: int) -> None:
        item = self.table.item(row, 0)
        if item is None or row == old:
            return
        self._show_add()
        if self._suggested() is None:
            self._bench.choose(str(item.data(NAME)))

    def _search(self) -> None:
        if self._bench.searching:
            self._bench.cancel_search()
        else:
            self._bench.suggest(Phoneme(self.one.currentData()), self.other.currentData())

    def _add(self) -> None:
        variable = self._suggested()
        if variable is not None:
            self.add_asked.emit(variable)

    def _suggested(self) -> Variable | None:
        item = self.table.item(self.table.currentRow(), 0)
        name = item.data(NAME) if item is not None else ""
        return next((s.variable for s in self._bench.suggestions if s.variable.name == name), None)

    def _show_add(self) -> None:
        have = {r.variable for r in self._bench.ranking}
        variable = self._suggested()
        self.add.setEnabled(variable is not None and variable.name not in have)
