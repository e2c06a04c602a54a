"""The averaged spectra as a table, and how they differ as a matrix below it."""

import math
from collections.abc import Callable
from functools import partial

from PySide6 import QtWidgets
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QIcon, QKeyEvent, QPixmap, QResizeEvent, QShowEvent
from typing_extensions import override

from phonemeanalyser.desktop.analyse.spectra.curve_dialogs import CurveDialogs
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.curves import CurveTable
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.plot import let_copy
from phonemeengine.inspection.averaged_spectrum import AveragedSpectrum
from phonemeengine.settings import SAMPLE_RATE, STAGES, Filter

NAME, SECONDS, LEVEL, FILTERS = range(4)
HEADINGS = (tr_noop("Name"), "s", "dB", tr_noop("Filters"))
TIPS = (
    tr_noop("Whether the curve is shown, its colour, and its name; F2 or a double click renames it"),
    tr_noop("Duration of the averaged frames in seconds"),
    tr_noop("Level of the averaged frames before the filters: root mean square, dBFS"),
    tr_noop("Filters through which the sound was averaged; only curves with the same filters can be compared"),
)
DELTA = tr_noop(
    "Δ: root-mean-square difference of two spectra in dB, independent of loudness (the mean difference is taken "
    "away). The measure is d2 of Gray and Markel, IEEE Trans. ASSP 24(5), 1976."
)
WIDTHS = (80, 44, 40, 0)
LEAST_FILTERS = 46
"""Of the columns, pixels: names take what they need, filters what is left, and that at least."""
MOST_COMPARED = 30
"""Curves in the matrix at most."""
CELL = 52
"""Width of a column of the matrix, pixels."""
ICON = 12


class CurveList(QtWidgets.QTableWidget):
    """Lists all curves, of which several can be chosen: Delete removes them, F2 renames one."""

    def __init__(self, curves: CurveTable) -> None:
        super().__init__(0, len(HEADINGS))
        self._curves = curves
        self.setHorizontalHeaderLabels([tr(heading) for heading in HEADINGS])
        for k, tip in enumerate(TIPS):
            self.model().setHeaderData(k, Qt.Orientation.Horizontal, tr(tip), Qt.ItemDataRole.ToolTipRole)
        builders.style_list(self, 22, WIDTHS)
        self.horizontalHeader().setMinimumSectionSize(LEAST_FILTERS)
        self.setIconSize(QSize(ICON, ICON))
        self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.ExtendedSelection)
        triggers = QtWidgets.QAbstractItemView.EditTrigger
        self.setEditTriggers(triggers.EditKeyPressed | triggers.DoubleClicked)
        self.setAccessibleName(tr("Averaged spectra"))
        let_copy(self)
        self.itemChanged.connect(self._take_edit)
        self.itemSelectionChanged.connect(self._choose)
        curves.changed.connect(self._fill)
        curves.added.connect(self.choose)
        self._fill()

    def choose(self, places: list[int]) -> None:
        """Choose curves."""
        with builders.silent(self):
            self.clearSelection()
            mode = self.selectionMode()
            self.setSelectionMode(QtWidgets.QAbstractItemView.SelectionMode.MultiSelection)
            for place in places:
                self.selectRow(place)
            self.setSelectionMode(mode)
        self._choose()

    @override
    def minimumSizeHint(self) -> QSize:
        return QSize(240, 92)

    @override
    def sizeHint(self) -> QSize:
        """Ask for the room of all curves, up to a dozen."""
        return QSize(260, 30 + 22 * min(max(self.rowCount(), 3), 12))

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_names()

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in {Qt.Key.Key_Delete, Qt.Key.Key_Backspace}:
            self._curves.remove(self._curves.chosen)
        else:
            super().keyPressEvent(event)

    def _choose(self) -> None:
        self._curves.chosen = tuple(sorted({index.row() for index in self.selectionModel().selectedRows()}))

    def _fill(self) -> None:
        chosen = list(self._curves.chosen)
        with builders.silent(self):
            self.setRowCount(len(self._curves.curves))
            for place, curve in enumerate(self._curves.curves):
                for k, item in enumerate(_items_of(curve)):
                    self.setItem(place, k, item)
        self.choose([place for place in chosen if place < self.rowCount()])
        self._fit_names()
        self.viewport().update()

    def _fit_names(self) -> None:
        room = self.viewport().width() - WIDTHS[SECONDS] - WIDTHS[LEVEL] - LEAST_FILTERS
        self.setColumnWidth(NAME, max(WIDTHS[NAME], min(self.sizeHintForColumn(NAME), room)))

    def _take_edit(self, item: QtWidgets.QTableWidgetItem) -> None:
        if item.column() != NAME:
            return
        place, curve = item.row(), self._curves.curves[item.row()]
        is_shown = item.checkState() is Qt.CheckState.Checked
        if is_shown is curve.hidden:
            chosen = self._curves.chosen
            self._curves.show(chosen if place in chosen else (place,), on=is_shown)
        elif item.text() != curve.name:
            self._curves.rename(place, item.text())
            self._fill()


class CurvePanel(QtWidgets.QWidget):
    """The table, its commands, and the matrix.

    Attributes
    ----------
    list : the table.
    matrix : how the shown curves differ.
    """

    def __init__(self, curves: CurveTable, dialogs: CurveDialogs, theme: Theme) -> None:
        super().__init__()
        self._curves, self._dialogs, self._theme = curves, dialogs, theme
        self.list = CurveList(curves)
        self.matrix = builders.named(QtWidgets.QTableWidget(), tr("Differences of the averaged spectra"), tr(DELTA))
        self._hint = builders.label(
            tr("No averaged spectra yet: press Add, or load a curve. They stay here until you remove them."),
            theme.faint,
            wraps=True,
        )
        self._told = builders.label(colour=theme.faint, wraps=True)
        self._work = QtWidgets.QLabel()
        self._cancel = builders.tool_button(
            "✕", tr("Stop Averaging"), tr("Stop Averaging"), curves.work.cancel, flat=True
        )
        self._style_matrix()
        self._lay_out()
        self.list.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.list.customContextMenuRequested.connect(
            lambda at: self._menu().popup(self.list.viewport().mapToGlobal(at))
        )
        curves.changed.connect(self._follow)
        curves.compared.connect(self._follow)
        curves.work.changed.connect(self._tell_work)
        self._follow()
        self._tell_work()

    @override
    def showEvent(self, event: QShowEvent) -> None:
        """Compare when it is seen: curves through other filters are measured for that."""
        super().showEvent(event)
        self._follow()

    # -- commands -----------------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        add, more, dialogs = QtWidgets.QMenu(self), QtWidgets.QMenu(self), self._dialogs
        for words, act in (
            (tr("This File"), dialogs.add_file),
            (tr("Selection"), dialogs.add_selection),
            (tr("Microphone Since Clear"), dialogs.add_microphone),
            (tr("By Phoneme…"), dialogs.ask_by_phoneme),
            (tr("Folder…"), dialogs.ask_folder),
            (tr("Load Curve…"), dialogs.ask_load),
        ):
            add.addAction(words, act)
        for words, act in (
            (tr("Save Curve…"), dialogs.ask_save_chosen),
            (tr("Export Levels as CSV…"), dialogs.ask_export),
            (tr("Export Differences as CSV…"), dialogs.ask_export_differences),
            (tr("Save Picture…"), dialogs.picture_asked.emit),
        ):
            more.addAction(words, act)
        buttons: list[QtWidgets.QToolButton] = []
        for text, tip, menu in (
            (tr("Add"), tr("Add an averaged spectrum, measured through the filters that are on"), add),
            (tr("Save"), tr("Save or export what is selected in the table; all that is shown if nothing is"), more),
        ):
            buttons.append(builders.tool_button(text, tip))
            builders.open_at_once(buttons[-1], menu)
        remove = builders.tool_button(
            tr("Remove"), tr("Remove what is selected (Delete); undo restores it"), act=self._remove
        )
        parts = QtWidgets.QSplitter(Qt.Orientation.Vertical)
        below = QtWidgets.QWidget()
        builders.column(self._told, (self.matrix, 1), on=below, spacing=2)
        for widget in (self.list, below):
            parts.addWidget(widget)
        parts.setChildrenCollapsible(False)
        bar = builders.row(*buttons, remove, 1, self._work, self._cancel, spacing=4)
        builders.column(bar, self._hint, (parts, 1), on=self, margins=(6, 4, 6, 4), spacing=4)

    def _menu(self) -> QtWidgets.QMenu:
        """Return what can be done with the chosen curves."""
        menu, chosen, curves = QtWidgets.QMenu(self), self._curves.chosen, self._curves
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        first = self.list.model().index(chosen[0] if chosen else 0, NAME)
        entries: tuple[tuple[str, Callable[[], object]], ...] = (
            (tr("Rename"), partial(self.list.edit, first)),
            (tr("Colour…"), self._ask_colour),
            (tr("Show"), partial(curves.show, chosen, on=True)),
            (tr("Hide"), partial(curves.show, chosen, on=False)),
            (tr("Measure Again With Current Filters"), partial(curves.measure_again, chosen)),
            (tr("Save Curve…"), self._dialogs.ask_save_chosen),
            (tr("Remove"), self._remove),
        )
        for words, act in entries:
            menu.addAction(words, act).setEnabled(bool(chosen))
        menu.addSeparator()
        menu.addActions(self.list.actions())
        return menu

    def _remove(self) -> None:
        if self._curves.chosen:
            self._curves.remove(self._curves.chosen)

    def _ask_colour(self) -> None:
        chosen = self._curves.chosen
        colour = QtWidgets.QColorDialog.getColor(QColor(self._curves.curves[chosen[0]].colour), self, tr("Colour"))
        if colour.isValid():
            self._curves.recolour(chosen, colour.name())

    # -- what is shown ------------------------------------------------------------------------------------

    def _follow(self) -> None:
        self._hint.setVisible(not self._curves.curves)
        if self.isVisible():
            self._compare()

    def _tell_work(self) -> None:
        work = self._curves.work
        self._work.setText(f"{100 * work.progress:.0f} %" if work.busy else "")
        self._cancel.setVisible(work.busy)

    def _style_matrix(self) -> None:
        matrix = self.matrix
        matrix.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        matrix.verticalHeader().setDefaultSectionSize(22)
        matrix.verticalHeader().setMaximumWidth(110)
        for header in (matrix.verticalHeader(), matrix.horizontalHeader()):
            header.setTextElideMode(Qt.TextElideMode.ElideRight)
            header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        matrix.setIconSize(QSize(ICON, ICON))
        matrix.horizontalHeader().setDefaultSectionSize(CELL)
        matrix.horizontalHeader().setMinimumSectionSize(CELL)
        matrix.setTabKeyNavigation(False)
        matrix.setMinimumHeight(60)
        let_copy(matrix)

    def _compare(self) -> None:
        shown = self._curves.shown[:MOST_COMPARED]
        n = len(self._curves.shown)
        words = tr("Δ in dB between the shown curves")
        if n > MOST_COMPARED:
            words = tr("Δ in dB between the first {n} shown curves").format(n=MOST_COMPARED)
        self._told.setText(words if n > 1 else "")
        self._told.setToolTip(tr(DELTA))
        self.matrix.setVisible(n > 1)
        found = self._curves.differences(shown) if n > 1 else []
        self.matrix.setRowCount(len(found))
        self.matrix.setColumnCount(len(found))
        for k, (curve, differences) in enumerate(zip(shown, found, strict=n > 1)) if found else ():
            self.matrix.setHorizontalHeaderItem(k, _heading(curve))
            self.matrix.setVerticalHeaderItem(k, _heading(curve))
            for place, difference in enumerate(differences):
                known = not math.isnan(difference.decibels)
                item = QtWidgets.QTableWidgetItem(f"{difference.decibels:.1f}" if known else "–")
                if place == k:
                    item.setText("")
                item.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                item.setToolTip(f"<p>{difference.words}</p>" if difference.words else "")
                item.setForeground(QColor(self._theme.text if known else self._theme.faint))
                self.matrix.setItem(k, place, item)


def _items_of(curve: AveragedSpectrum) -> list[QtWidgets.QTableWidgetItem]:
    level = "–" if math.isnan(curve.level) else f"{curve.level:.1f}"
    items = [
        QtWidgets.QTableWidgetItem(text) for text in (curve.name, f"{curve.seconds:.1f}", level, _filters(curve))
    ]
    name = items[NAME]
    name.setCheckState(Qt.CheckState.Unchecked if curve.hidden else Qt.CheckState.Checked)
    name.setIcon(_icon(curve))
    for k, item in enumerate(items):
        if k != NAME:
            item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)
        if k in {SECONDS, LEVEL}:
            item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        item.setToolTip(told(curve))
    return items


def _heading(curve: AveragedSpectrum) -> QtWidgets.QTableWidgetItem:
    item = QtWidgets.QTableWidgetItem(_icon(curve), curve.name)
    item.setToolTip(curve.name)
    return item


def _icon(curve: AveragedSpectrum) -> QIcon:
    pixmap = QPixmap(ICON, ICON)
    pixmap.fill(QColor(curve.colour))
    icon = QIcon(pixmap)
    icon.addPixmap(pixmap, QIcon.Mode.Selected)  # which Qt would tint
    return icon


def told(curve: AveragedSpectrum) -> str:
    """Return all that is known of a curve, as a tooltip."""
    of = f"<br>{tr_engine(curve.since)}" if curve.since else ""
    frames = tr("{seconds:.2f} s, {n} frames").format(seconds=curve.seconds, n=curve.n_frames)
    filters = "<br>".join(words for _, words in _stages_of(curve))
    return f"<p><b>{curve.name}</b><br>{frames}{of}</p><p>{filters}</p>"


def _filters(curve: AveragedSpectrum) -> str:
    """Return in few words through which filters a curve went: up to which frequency, and which others were on."""
    return ", ".join(short for short, _ in _stages_of(curve))


def _stages_of(curve: AveragedSpectrum) -> list[tuple[str, str]]:
    """Return each filter of a curve in short and in full; the names are those of the filter column."""
    found = []
    for part in curve.front_end.split(", "):
        name, _, values = part.partition(" ")
        stage = STAGES.get(name) or STAGES.get(f"{name}_function")
        if stage is None:
            found.append((part, part))
        elif stage.name == Filter.QUANTISE:
            step = int(values.split()[0]) if values[:1].isdigit() else 1
            highest = f"{SAMPLE_RATE / 2000 / step:.2g} kHz"
            found.append((highest, f"{tr(stage.label)} {values.replace('_', '-')}: {highest}"))
        else:
            found.append((tr(stage.label), f"{tr(stage.label)} {values.replace('_', '-')}"))
    return found
