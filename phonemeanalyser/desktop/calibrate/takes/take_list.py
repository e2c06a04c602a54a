"""The list of takes: what was said, by whom, how long, how loud, and how good."""

from collections.abc import Callable
from itertools import groupby
from typing import Any

from PySide6.QtCore import QItemSelection, QItemSelectionModel, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QTableWidget, QTableWidgetItem
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import CENTRED, PHONEME_COLOURS, Theme, draw_text
from phonemeanalyser.desktop.widgets.builders import style_list
from phonemeanalyser.desktop.widgets.keyboard import give_letters_to_page
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeengine.calibration.takes.quality import TakeReport
from phonemeengine.calibration.takes.take import Take

HEADINGS = (tr_noop("Phoneme"), tr_noop("Speaker"), "s", "dBFS", tr_noop("Check"))
TIPS = (
    tr_noop("Phoneme that the take holds"),
    tr_noop("Speaker of the take"),
    tr_noop("Duration of the trimmed part in seconds"),
    tr_noop("RMS level of the trimmed part in dBFS"),
    tr_noop("Whether the take is good enough for calibration"),
)
NUMBER = Qt.ItemDataRole.UserRole


class TakeListView(QTableWidget):
    """Shows all takes, of which several can be chosen; Delete deletes, X excludes, Return plays.

    Signals
    -------
    play_asked : number of a take.
    delete_asked, exclude_asked : the user wants that done with all that are chosen.
    """

    play_asked = Signal(int)
    delete_asked = Signal()
    exclude_asked = Signal()

    def __init__(self, takes: TakesModel, theme: Theme) -> None:
        super().__init__(0, len(HEADINGS))
        self.setIconSize(QSize(10, 10))
        self._takes = takes
        self._theme = theme
        self._filling = False
        self._shown: list[tuple[Take, TakeReport | None]] = []
        self._style()
        give_letters_to_page(self)
        let_copy(self)
        self.currentCellChanged.connect(self._choose)
        self.cellDoubleClicked.connect(lambda row, _column: self.play_asked.emit(self._number_at(row)))
        takes.changed.connect(self._fill)
        takes.added.connect(self.select_take)
        self._fill()

    @property
    def chosen(self) -> int | None:
        """Number of the take that was chosen last; None where there is none."""
        return self._number_at(self.currentRow()) if self.currentRow() >= 0 else None

    @property
    def all_chosen(self) -> set[int]:
        """Numbers of all takes that are chosen."""
        return {self._number_at(index.row()) for index in self.selectionModel().selectedRows()}

    def play(self) -> None:
        """Ask for the take that was chosen last."""
        if self.chosen is not None:
            self.play_asked.emit(self.chosen)

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(200, 96)

    def select_take(self, number: int) -> None:
        """Choose a take."""
        for row in range(self.rowCount()):
            if self._number_at(row) == number:
                self.setCurrentCell(row, 0)

    @override
    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.rowCount():
            painter = QPainter(self.viewport())
            draw_text(painter, self.viewport().rect(), tr("No takes yet"), self._theme.faint, 12, CENTRED)
            painter.end()

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Play, exclude or delete what is chosen, once however long the key is held; letters are the page's."""
        acts: dict[Qt.Key, Callable[[], object]] = {
            Qt.Key.Key_Return: self.play,
            Qt.Key.Key_Enter: self.play,
            Qt.Key.Key_Delete: self.delete_asked.emit,
            Qt.Key.Key_Backspace: self.delete_asked.emit,
            Qt.Key.Key_X: self.exclude_asked.emit,
        }
        act = acts.get(Qt.Key(event.key()))
        if act is None and event.text().isalpha():
            event.ignore()
        elif act is None:
            super().keyPressEvent(event)
        elif not event.isAutoRepeat():
            act()

    def _style(self) -> None:
        self.setHorizontalHeaderLabels([tr(heading) for heading in HEADINGS])
        for k, tip in enumerate(TIPS):
            self.model().setHeaderData(k, Qt.Orientation.Horizontal, tr(tip), Qt.ItemDataRole.ToolTipRole)
        self.horizontalHeader().setMinimumSectionSize(20)
        style_list(self, 22, (70, 0, 40, 38, 82))
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(tr("Takes"))

    def _fill(self) -> None:
        now, chosen, all_chosen = self._takes.now, self.chosen, self.all_chosen
        before, self._shown = self._shown, [(take, now.reports.get(take.number)) for take in now.takes]
        self._filling = True
        self.setRowCount(len(self._shown))
        for row, shown in enumerate(self._shown):
            if before[row : row + 1] != [shown]:  # of thousands of takes, few change at a time
                for column, item in enumerate(self._items_of(*shown)):
                    self.setItem(row, column, item)
        self.clearSelection()  # takes are chosen, not rows, which others may have now
        if chosen is not None and self._takes.take(chosen) is not None:
            self.select_take(chosen)
        elif self.currentRow() >= 0:
            self.selectRow(self.currentRow())
        self._choose_too(all_chosen)
        self._filling = False
        self._choose()

    def _items_of(self, take: Take, report: TakeReport | None) -> list[QTableWidgetItem]:
        faults = report.faults if report else {}
        fault = next((tr(str(fault)) for fault in faults), tr("good"))
        left_out = report is not None and report.too_little  # which is why it is, unless the user says otherwise
        verdict = fault if left_out or not take.excluded else tr("excluded")
        level = f"{report.level:.0f}" if report else "–"
        words = (sound_name(take.phoneme), take.speaker, f"{take.end - take.start:.2f}", level, verdict)
        items = [QTableWidgetItem(text) for text in words]
        items[0].setData(NUMBER, take.number)
        items[0].setData(Qt.ItemDataRole.DecorationRole, QColor(PHONEME_COLOURS[take.phoneme]))
        told_of = " ".join(map(tr_engine, faults.values())) or f"{take.name}, {take.device}, {take.time}"
        if take.excluded and left_out:
            told_of = tr("{take} is excluded: {reason}").format(take=take.name, reason=told_of)
        told = self._theme.faint if take.excluded else self._theme.text
        judged = self._theme.faint if take.excluded else self._theme.bad if faults else self._theme.good
        for column, item in enumerate(items):
            if column in {2, 3}:
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            item.setToolTip(told_of)
            item.setForeground(QColor(judged if column == 4 else told))
            font = item.font()
            font.setStrikeOut(take.excluded and column < 4)
            item.setFont(font)
        return items

    def _choose_too(self, numbers: set[int]) -> None:
        """Choose takes besides the one that was chosen last."""
        chosen, at = QItemSelection(), self.model().index
        rows = [row for row, (take, _report) in enumerate(self._shown) if take.number in numbers]
        for _, run in groupby(enumerate(rows), lambda numbered: numbered[1] - numbered[0]):
            together = [row for _, row in run]
            chosen.select(at(together[0], 0), at(together[-1], self.columnCount() - 1))
        self.selectionModel().select(chosen, QItemSelectionModel.SelectionFlag.Select)

    def _choose(self, *_cells: Any) -> None:
        if not self._filling and self.chosen != self._takes.selected:
            self._takes.select(self.chosen)

    def _number_at(self, row: int) -> int:
        item = self.item(row, 0)
        return int(item.data(NUMBER)) if item is not None else -1
