"""The table of the 21 numbers of PhonemeData, with what each divides, speaker by speaker."""

import math
from functools import partial

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QShowEvent
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.workbench.phoneme_data_model import PhonemeDataModel
from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeengine.calibration.workbench.phoneme_data_table import ALL_SPEAKERS, NumberRow, Sides
from phonemeengine.dsp.pitch import HIGHEST, LOWEST
from phonemeengine.phonemes import Phoneme

VALUE, OTHER, SOUNDS, FIRST = range(4)
"""Columns: the number, that of the preset that is compared with, the sounds, and the first value of a speaker."""
REACH = (tr_noop("min"), tr_noop("mean"), tr_noop("max"))
WIDTHS = {VALUE: 72, OTHER: 72, SOUNDS: 104}
NARROW = 72
TAKEN = Qt.ItemDataRole.UserRole
"""The value that a click on a cell takes."""


class PhonemeDataPanel(QtWidgets.QWidget):
    """Edits the numbers: in the cell, by a click on a measured value, or fitted; and the sets for ranges of pitch.

    Signals
    -------
    file_asked : the user wants to choose a file whose numbers become a pitch set.
    """

    file_asked = Signal()

    def __init__(self, model: PhonemeDataModel, theme: Theme) -> None:
        super().__init__()
        self._model = model
        self._theme = theme
        self._lines: list[tuple[NumberRow, int]] = []
        self._rows: tuple[NumberRow, ...] | None = None
        tip = tr("Numbers to edit: those of the preset, or those of a set for a range of pitch")
        self.sets = builders.choice((), tip, tip)
        self.low, self.high = (
            builders.named(NumberField(LOWEST, HIGHEST, unit=" Hz"), tip, tip)
            for tip in (
                tr("Lowest pitch of the voices that this set is for"),
                tr("Highest pitch of the voices that this set is for"),
            )
        )
        self.add = builders.tool_button(
            tr("Add Set…"),
            tr(
                "Fit the numbers to one speaker, or read them from a file, for voices in one range of pitch; Ctrl+Z "
                "removes the set"
            ),
        )
        self.remove = builders.named(
            QtWidgets.QPushButton(tr("Remove Set")), tip=tr("Remove this pitch set; Ctrl+Z restores it")
        )
        self.fit_all = builders.named(
            QtWidgets.QPushButton(tr("Fit All Numbers")),
            tip=tr("Fit all thresholds to the loaded takes and recordings; Ctrl+Z restores the old ones"),
        )
        self.fit_row = builders.named(
            QtWidgets.QPushButton(tr("Fit Number")),
            tip=tr("Fit the number of the selected row, with all others as they are"),
        )
        self.state = builders.label(wraps=True)
        self.in_use = QtWidgets.QLabel()
        self.table = builders.named(
            QtWidgets.QTableWidget(0, FIRST),
            "PhonemeData",
            tr(
                "<p>Each number with its variable and comparison. Below each other: the sounds for which the "
                "comparison should hold, and those for which it should fail, with the smallest, mean and largest "
                "value of the variable for each speaker.</p><p>Click a value, or press Return on it, to use it as "
                "the number; double-click a number, or press Return on it, to type.</p>"
            ),
        )
        self._lay_out()
        self._connect()
        self.show_all()

    def refresh(self) -> None:
        """Show which set the voice has now."""
        words = self._model.in_use()
        self.in_use.setVisible(bool(words))
        if words != self.in_use.text():
            self.in_use.setText(words)

    def show_all(self) -> None:
        """Show numbers, values and sets as they are now."""
        model, busy = self._model, self._model.fitting.busy
        own = [(tr("Preset"), 0)]
        builders.offer(self.sets, [*own, *((s.name, k) for k, s in enumerate(model.sets, 1))], model.chosen)
        self.sets.setVisible(bool(model.sets))
        chosen = model.chosen_set
        for box, value in ((self.low, chosen and chosen.low), (self.high, chosen and chosen.high)):
            box.setVisible(chosen is not None)
            with builders.silent(box):
                box.setValue(value or LOWEST)
        self.remove.setVisible(chosen is not None)
        why = model.why_no_fit
        for button in (self.fit_all, self.fit_row):
            button.setEnabled(not why or busy)
        self.add.setEnabled(not model.why_unused)
        self.fit_all.setText(
            tr("Stop {percent:.0f} %").format(percent=100 * model.fitting.progress) if busy else tr("Fit All Numbers")
        )
        self.state.setText("" if busy else why or model.words)
        self.state.setVisible(bool(self.state.text()))
        with builders.silent(self.table):
            if model.rows is not self._rows:
                self._fill()
            self._fill_numbers()
        self.refresh()

    @override
    def showEvent(self, event: QShowEvent) -> None:
        """Show what has changed while the table was not seen."""
        super().showEvent(event)
        self.show_all()

    def _show_seen(self) -> None:
        """Follow a change, such as a threshold that is dragged elsewhere, only while the table is seen."""
        if self.isVisible():
            self.show_all()

    # -- the table ----------------------------------------------------------------------------------------

    def _fill(self) -> None:
        rows = self._rows = self._model.rows
        speakers = list(next((row.by_speaker for row in rows if row.by_speaker), {}) or {})
        filters_last = sorted(rows, key=lambda number: not number.variable)
        self._lines = [(number, side) for number in filters_last for side in range(2 if number.variable else 1)]
        self.table.clearSpans()
        self.table.setRowCount(len(self._lines))
        self.table.setColumnCount(FIRST + len(REACH) * len(speakers))
        heads = [tr("Number"), tr("Compared"), tr("Sounds")]
        for speaker in speakers:
            name = tr("all") if speaker == ALL_SPEAKERS else speaker
            heads += [f"{name}\n{tr(part)}" for part in REACH]
        self.table.setHorizontalHeaderLabels(heads)
        self.table.setVerticalHeaderLabels([_head_of(row, side) for row, side in self._lines])
        measure = self.table.horizontalHeader().fontMetrics()
        for k, head in enumerate(heads):
            needed = max(measure.horizontalAdvance(line) for line in head.split("\n")) + 14
            self.table.setColumnWidth(k, WIDTHS.get(k, max(NARROW, needed)))
        for line, (number, side) in enumerate(self._lines):
            self._fill_line(line, number, side)

    def _fill_line(self, line: int, row: NumberRow, side: int) -> None:
        if side == 0 and row.variable:
            for k in (VALUE, OTHER):
                self.table.setSpan(line, k, 2, 1)
        sounds: tuple[Phoneme, ...] = row.fails if side else row.holds
        words = " ".join(sound_name(sound) for sound in sounds)
        self._put(line, SOUNDS, words, self._theme.faint if side else self._theme.text, tip=words)
        for k, sides in enumerate((row.by_speaker or {}).values()):
            self._fill_values(line, FIRST + len(REACH) * k, sides, side)

    def _fill_numbers(self) -> None:
        data, other = self._model.data, self._model.other
        self.table.setColumnHidden(OTHER, other is None)
        for line, (number, side) in enumerate(self._lines):
            if side == 0:
                theirs = None if other is None else getattr(other, number.name)
                self._fill_number(line, number, getattr(data, number.name), theirs)

    def _fill_number(self, line: int, row: NumberRow, value: float, theirs: float | None) -> None:
        bins = tr("In bins of 21.53 Hz, as in a PhonemeData file") if row.name.startswith("high_pass") else ""
        item = self._put(line, VALUE, _written(value), self._theme.accent, tip=bins)
        item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
        if theirs is not None:
            differs = not math.isclose(theirs, value, rel_tol=1e-6)
            self._put(line, OTHER, _written(theirs), self._theme.text if differs else self._theme.faint)

    def _fill_values(self, line: int, first: int, sides: Sides, side: int) -> None:
        found = sides.fails if side else sides.holds
        values = (None,) * len(REACH) if found is None else (found.least, found.mean, found.greatest)
        for k, value in enumerate(values):
            item = self._put(line, first + k, "–" if value is None else _written(value), self._theme.text)
            item.setData(TAKEN, value)

    def _put(self, line: int, column: int, text: str, colour: str, *, tip: str = "") -> QtWidgets.QTableWidgetItem:
        item = self.table.item(line, column)
        if item is None:
            item = QtWidgets.QTableWidgetItem()
            self.table.setItem(line, column, item)
        item.setText(text)
        item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
        if column != SOUNDS:
            item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        item.setForeground(QColor(colour))
        item.setToolTip(tip)
        return item

    # -- what the user does -------------------------------------------------------------------------------

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take the selected value by Return, or begin to type the number that is selected."""
        is_return = isinstance(event, QKeyEvent) and event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}
        line, column = self.table.currentRow(), self.table.currentColumn()
        if not is_return or event.type() != QEvent.Type.KeyPress or line < 0 or not self.table.hasFocus():
            return super().eventFilter(watched, event)  # without the focus, a number that is typed ends by Return
        if column >= FIRST:
            self._take(line, column)
        elif column == VALUE:
            number = self.table.item(line, VALUE) or self.table.item(line - 1, VALUE)  # of the two lines of a number
            if number is not None:
                self.table.editItem(number)
        return True

    def _take(self, line: int, column: int) -> None:
        """Make a value of the table the number of its row."""
        item = self.table.item(line, column)
        value = None if item is None else item.data(TAKEN)
        if value is not None:
            self._model.set_number(self._lines[line][0].name, float(f"{value:.4g}"))

    def _type(self, item: QtWidgets.QTableWidgetItem) -> None:
        """Use the number that was typed."""
        if item.column() == VALUE:
            self._model.type_number(self._lines[item.row()][0].name, item.text())

    def _fit(self) -> None:
        if self._model.fitting.busy:
            self._model.fitting.cancel()
        else:
            self._model.fit()

    def _fit_selected(self) -> None:
        line = self.table.currentRow()
        self._model.fit(self._lines[max(0, line)][0].name)

    def _offer_speakers(self) -> None:
        menu = self.add.menu()
        menu.clear()
        for speaker in self._model.speakers:
            menu.addAction(speaker.replace("&", "&&"), partial(self._model.add_set, speaker))
        menu.addAction(tr("Numbers of a File…"), self.file_asked.emit)

    def _lay_out(self) -> None:
        table = self.table
        table.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.SingleSelection)
        table.setEditTriggers(
            QtWidgets.QAbstractItemView.EditTrigger.DoubleClicked
            | QtWidgets.QAbstractItemView.EditTrigger.EditKeyPressed
        )
        table.setTabKeyNavigation(False)
        table.setWordWrap(False)
        for header, height in ((table.verticalHeader(), 20), (table.horizontalHeader(), NARROW)):
            header.setDefaultSectionSize(height)
            header.setHighlightSections(False)
        heads = table.horizontalHeader()  # of two lines from the start: else the rows move, and leave a trace below
        heads.setFixedHeight(2 * heads.fontMetrics().lineSpacing() + 6)
        table.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Fixed)
        let_copy(table)
        builders.open_at_once(self.add, QtWidgets.QMenu(self.add))
        builders.tab_buttons(self.fit_all, self.fit_row, self.remove)
        buttons = (self.sets, self.low, self.high, self.fit_all, self.fit_row, self.add, self.remove, 1)
        builders.column(
            builders.row(*buttons, spacing=4),
            self.state,
            self.in_use,
            (table, 1),
            on=self,
            margins=(6, 4, 4, 4),
            spacing=4,
        )
        builders.leave_wheel(self)

    def _connect(self) -> None:
        model = self._model
        model.changed.connect(self._show_seen)
        model.fitting.changed.connect(self._show_seen)
        self.sets.activated.connect(lambda _index: model.choose(self.sets.currentData()))
        for box in (self.low, self.high):
            box.editingFinished.connect(lambda: model.set_range(self.low.value(), self.high.value()))
        self.fit_all.clicked.connect(self._fit)
        self.fit_row.clicked.connect(self._fit_selected)
        self.remove.clicked.connect(model.remove_set)
        self.add.menu().aboutToShow.connect(self._offer_speakers)
        self.table.cellClicked.connect(self._take)
        self.table.itemChanged.connect(self._type)
        self.table.installEventFilter(self)


def _head_of(row: NumberRow, side: int) -> str:
    """Return the name of a number, and below it what is compared with it."""
    return f"    {row.variable} {row.sign}" if side else row.name


def _written(value: float) -> str:
    return f"{value:.4g}"
