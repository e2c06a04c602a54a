"""The list of takes: what was said, by whom, how long, how loud, and how good."""

from typing import Any

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from phonemeanalyser.desktop.calibrate.takes_model import TakesModel
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.phoneme_keys import LetterPassthrough
from phonemeanalyser.desktop.widgets.table_copy import let_copy
from phonemeengine.calibration.takes.take import Take

HEADINGS = (tr_noop("sound"), tr_noop("speaker"), "s", "dB", tr_noop("check"))
TIPS = (
    tr_noop("What was said"), tr_noop("Who said it"), tr_noop("How much of it counts, seconds"),
    tr_noop("Level of that, dB below full scale (RMS)"), tr_noop("Whether it is good enough to calibrate with"),
)  # fmt: skip
NUMBER = Qt.ItemDataRole.UserRole


class TakeListView(QTableWidget):
    """Shows all takes; Delete deletes, X excludes, Return plays.

    Signals
    -------
    play_asked, delete_asked, exclude_asked : number of a take.
    """

    play_asked = Signal(int)
    delete_asked = Signal(int)
    exclude_asked = Signal(int)

    def __init__(self, takes: TakesModel, theme: Theme) -> None:
        super().__init__(0, len(HEADINGS))
        self.setIconSize(QSize(10, 10))
        self._takes = takes
        self._theme = theme
        self._filling = False
        self._style()
        self.installEventFilter(LetterPassthrough(self))
        let_copy(self)
        self.currentCellChanged.connect(self._choose)
        self.cellDoubleClicked.connect(lambda row, _column: self.play_asked.emit(self._number_at(row)))
        takes.changed.connect(self._fill)
        takes.added.connect(self.select_take)
        self._fill()

    @property
    def chosen(self) -> int | None:
        """Number of the chosen take; None where there is none."""
        return self._number_at(self.currentRow()) if self.currentRow() >= 0 else None

    def minimumSizeHint(self) -> QSize:
        """Ask for the room of three takes."""
        return QSize(200, 96)

    def select_take(self, number: int) -> None:
        """Choose a take."""
        for row in range(self.rowCount()):
            if self._number_at(row) == number:
                self.setCurrentCell(row, 0)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Play, exclude or delete the chosen take."""
        signals = {
            Qt.Key.Key_Return: self.play_asked, Qt.Key.Key_Enter: self.play_asked,
            Qt.Key.Key_Delete: self.delete_asked, Qt.Key.Key_Backspace: self.delete_asked,
            Qt.Key.Key_X: self.exclude_asked,
        }  # fmt: skip
        signal, number = signals.get(Qt.Key(event.key())), self.chosen
        if signal is not None and number is not None:
            signal.emit(number)
        else:
            super().keyPressEvent(event)

    def _style(self) -> None:
        self.setHorizontalHeaderLabels([tr(heading) for heading in HEADINGS])
        for k, tip in enumerate(TIPS):
            self.model().setHeaderData(k, Qt.Orientation.Horizontal, tr(tip), Qt.ItemDataRole.ToolTipRole)
        header = self.horizontalHeader()
        header.setMinimumSectionSize(20)
        header.setHighlightSections(False)
        for k, width in enumerate((70, 0, 40, 38, 82)):
            header.setSectionResizeMode(k, QHeaderView.ResizeMode.Fixed if width else QHeaderView.ResizeMode.Stretch)
            if width:
                header.resizeSection(k, width)
        header.setFixedHeight(22)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(22)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        self.setAccessibleName(tr("takes"))

    def _fill(self) -> None:
        takes, chosen = self._takes.now.takes, self.chosen
        self._filling = True
        self.setRowCount(len(takes))
        for row, take in enumerate(takes):
            for column, item in enumerate(self._items_of(take)):
                self.setItem(row, column, item)
        self._filling = False
        if chosen is not None and self._takes.take(chosen) is not None:
            self.select_take(chosen)
        self._choose()

    def _items_of(self, take: Take) -> list[QTableWidgetItem]:
        report = self._takes.now.reports.get(take.number)
        faults = report.faults if report else {}
        verdict = tr("excluded") if take.excluded else next((tr(str(fault)) for fault in faults), tr("good"))
        level = f"{report.level:.0f}" if report else "–"
        words = (take.phoneme.label, take.speaker, f"{take.end - take.start:.2f}", level, verdict)
        items = [QTableWidgetItem(text) for text in words]
        items[0].setData(NUMBER, take.number)
        items[0].setData(Qt.ItemDataRole.DecorationRole, QColor(PHONEME_COLOURS[take.phoneme]))
        told = self._theme.faint if take.excluded else self._theme.text
        judged = self._theme.faint if take.excluded else self._theme.bad if faults else self._theme.good
        for column, item in enumerate(items):
            if column in {2, 3}:
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            item.setToolTip(" ".join(map(tr_engine, faults.values())) or f"{take.name}, {take.device}, {take.time}")
            item.setForeground(QColor(judged if column == 4 else told))
            font = item.font()
            font.setStrikeOut(take.excluded and column < 4)
            item.setFont(font)
        return items

    def _choose(self, *_cells: Any) -> None:
        if not self._filling and self.chosen != self._takes.selected:
            self._takes.select(self.chosen)

    def _number_at(self, row: int) -> int:
        item = self.item(row, 0)
        return int(item.data(NUMBER)) if item is not None else -1
