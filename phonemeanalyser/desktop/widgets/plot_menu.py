"""What copies: the menu of every plot (its whole, values, picture), and tables, by Ctrl+C or a right click."""

import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QIODevice, QObject, QPoint, QSaveFile, Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QMouseEvent, QPainter, QPixmap, QShortcut
from PySide6.QtSvg import QSvgGenerator
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeengine.errors import EngineError

PICTURE_WIDTH = 1200
"""Pixels that a picture has at least from left to right."""
NO_CACHE = QtWidgets.QGraphicsItem.CacheMode.NoCache
Reset = Callable[[], object]


class PlotMenu(QtWidgets.QMenu):
    """Opens where a plot is right-clicked; a double click resets the zoom, where there is one.

    Parameters
    ----------
    plot : what is drawn on.
    name : what its picture is called.
    values : gives, as tab-separated text, what lies where the menu was opened (a point of the plot, pixels).
    reset : shows the whole again.

    Attributes
    ----------
    at : where it was opened, a point of the plot.

    Signals
    -------
    save_asked : the user wants to save a picture of this plot, of this name.
    """

    save_asked = Signal(QtWidgets.QWidget, str)

    def __init__(
        self, plot: QtWidgets.QWidget, name: str, values: Callable[[QPoint], str], reset: Reset | None = None
    ) -> None:
        super().__init__(plot)
        self._plot, self._name = plot, name
        self._values, self._reset = values, reset
        self.at = QPoint()
        if reset is not None:
            self.addAction(tr("Reset Zoom"), reset)
            self.addSeparator()
            surface = plot.viewport() if isinstance(plot, QtWidgets.QAbstractScrollArea) else plot
            surface.installEventFilter(self)
        self.addAction(tr("Copy Values"), self._copy_values)
        self.addAction(tr("Copy Picture"), lambda: QtWidgets.QApplication.clipboard().setPixmap(plot.grab()))
        self.addAction(tr("Save Picture…"), self.ask_save)
        plot.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        plot.customContextMenuRequested.connect(self.open_at)

    def put_first(self, acts: Mapping[str, Callable[[], object]]) -> list[QAction]:
        """Offer other things before those that all plots offer, and return their entries."""
        first = self.actions()[0]
        entries = [QAction(name, self) for name in acts]
        for entry, act in zip(entries, acts.values(), strict=True):
            entry.triggered.connect(act)
        self.insertActions(first, entries)
        self.insertSeparator(first)
        return entries

    def ask_save(self) -> None:
        """Have the user asked where a picture of the plot is to be saved."""
        self.save_asked.emit(self._plot, self._name)

    def open_at(self, at: QPoint) -> None:
        """Open at a point of the plot."""
        self.at = at
        self.popup(self._plot.mapToGlobal(at))

    @override
    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if not (isinstance(event, QMouseEvent) and event.type() == QEvent.Type.MouseButtonDblClick):
            return False
        if event.button() == Qt.MouseButton.LeftButton and self._reset is not None:
            self._reset()
        return True

    def _copy_values(self) -> None:
        QtWidgets.QApplication.clipboard().setText(self._values(self.at))


def table_of(columns: Mapping[str, Sequence[object] | np.ndarray]) -> str:
    """Write columns of equal length, each under its name and unit, as tab-separated text; NaN is an empty cell."""
    rows = zip(*columns.values(), strict=True)
    lines = ["\t".join(columns), *("\t".join(map(_cell, row)) for row in rows)]
    return "\n".join(lines) + "\n"


def _cell(value: object) -> str:
    if not isinstance(value, (float, np.floating)):
        return str(value)
    return "" if np.isnan(value) else f"{value:.6g}"


def save_picture(plot: QtWidgets.QWidget, path: Path) -> None:
    """Write the picture of a plot: lines into an SVG file, pixels into any other.

    Raises
    ------
    EngineError : it cannot be written.
    """
    file = QSaveFile(str(path))
    write = _draw_svg if path.suffix.lower() == ".svg" else _draw_png
    if not (file.open(QIODevice.OpenModeFlag.WriteOnly) and write(plot, file) and file.commit()):
        raise EngineError(
            tr("{path}: cannot be written ({fault}); choose another folder").format(
                path=path.name, fault=file.errorString()
            )
        )


def _draw_png(plot: QtWidgets.QWidget, file: QIODevice) -> bool:
    if not isinstance(
        plot, QtWidgets.QGraphicsView
    ):  # the head, which a graphics card draws, and what is wide anyway
        return plot.grab().save(file, "PNG")
    times = math.ceil(PICTURE_WIDTH / plot.width())  # what is small in the window is sharp in a document all the same
    picture = QPixmap(plot.size() * times)
    picture.setDevicePixelRatio(times)
    QtWidgets.QWidget.render(plot, picture, QPoint())
    return picture.save(file, "PNG")


def _draw_svg(plot: QtWidgets.QWidget, file: QIODevice) -> bool:
    generator = QSvgGenerator()
    generator.setOutputDevice(file)
    generator.setSize(plot.size())
    generator.setViewBox(plot.rect())
    generator.setTitle(plot.accessibleName())
    painter = QPainter()
    begun = painter.begin(generator)
    if begun:
        kept = (
            [item for item in plot.items() if item.cacheMode() != NO_CACHE]
            if isinstance(plot, QtWidgets.QGraphicsView)
            else []
        )
        modes = [item.cacheMode() for item in kept]
        try:
            for item in kept:  # what is kept as pixels would be pixels here
                item.setCacheMode(NO_CACHE)
            QtWidgets.QWidget.render(
                plot, painter, QPoint()
            )  # a view of a scene has one of its own, of the scene alone
        finally:
            painter.end()
            for item, mode in zip(kept, modes, strict=True):
                item.setCacheMode(mode)
    return begun


def let_copy(table: QtWidgets.QTableWidget) -> None:
    """Have a table copy itself, headings and all."""
    copy = QAction(tr("Copy Table"), table)
    copy.triggered.connect(lambda: QGuiApplication.clipboard().setText(text_of(table)))
    key = QShortcut(QKeySequence(QKeySequence.StandardKey.Copy), table, copy.trigger)
    key.setContext(Qt.ShortcutContext.WidgetShortcut)
    table.addAction(copy)
    table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)


def text_of(table: QtWidgets.QTableWidget) -> str:
    """Return what a table shows, as tab-separated text; columns that are hidden are left out."""
    columns = [k for k in range(table.columnCount()) if not table.isColumnHidden(k)]
    named = not table.verticalHeader().isHidden()  # each row has a name
    heading = [_words(table.horizontalHeaderItem(k)) for k in columns]
    lines = [["", *heading] if named else heading]
    for row in range(table.rowCount()):
        cells = [_words(table.item(row, k)) for k in columns]
        lines.append([_words(table.verticalHeaderItem(row)), *cells] if named else cells)
    return "".join("\t".join(line) + "\n" for line in lines)


def _words(item: QtWidgets.QTableWidgetItem | None) -> str:
    return "" if item is None else item.text().replace("\t", " ").replace("\n", " ")
