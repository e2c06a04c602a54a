"""A plot with a heading, axes with units, and a cursor that reads out values; and what copies plots and tables."""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pyqtgraph as pg
from numpy.typing import ArrayLike
from PySide6 import QtGui, QtWidgets
from PySide6.QtCore import QEvent, QIODevice, QObject, QPoint, QPointF, QRectF, QSaveFile, Qt, Signal
from PySide6.QtSvg import QSvgGenerator
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeengine.arrays import Float64Array
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

    def put_first(self, acts: Mapping[str, Callable[[], object]]) -> list[QtGui.QAction]:
        """Offer other things before those that all plots offer, and return their entries."""
        first = self.actions()[0]
        entries = [QtGui.QAction(name, self) for name in acts]
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
        if not (isinstance(event, QtGui.QMouseEvent) and event.type() == QEvent.Type.MouseButtonDblClick):
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
    picture = QtGui.QPixmap(plot.size() * times)
    picture.setDevicePixelRatio(times)
    QtWidgets.QWidget.render(plot, picture, QPoint())
    return picture.save(file, "PNG")


def _draw_svg(plot: QtWidgets.QWidget, file: QIODevice) -> bool:
    generator = QSvgGenerator()
    generator.setOutputDevice(file)
    generator.setSize(plot.size())
    generator.setViewBox(plot.rect())
    generator.setTitle(plot.accessibleName())
    painter = QtGui.QPainter()
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
    copy = QtGui.QAction(tr("Copy Table"), table)
    copy.triggered.connect(lambda: QtGui.QGuiApplication.clipboard().setText(text_of(table)))
    key = QtGui.QShortcut(QtGui.QKeySequence(QtGui.QKeySequence.StandardKey.Copy), table, copy.trigger)
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


READOUTS_PER_SECOND = 30


class LiveCurve(pg.PlotCurveItem):
    """A curve that is drawn anew up to 60 times a second within fixed axes.

    Its bounds are those of the axes, so its points need not be measured at every picture. They are kept, and
    changed only after Qt was told so, since it would paint a new range within the old bounds otherwise. It is painted
    as polylines, which need no path; where a value is no number, there is a gap.
    """

    _bounds = QRectF()
    _lines: tuple[QtGui.QPolygonF, ...] = ()

    def __init__(self, pen: QtGui.QPen) -> None:
        super().__init__()
        self.setPen(pen)

    @override
    def setData(self, x: ArrayLike = (), y: ArrayLike = ()) -> None:
        self.xData, self.yData = np.asarray(x, float), np.asarray(y, float)
        self.path = None
        self._lines = broken_line(self.xData, self.yData)
        self.update()

    @override
    def paint(self, painter: QtGui.QPainter, _option: Any, _widget: Any = None) -> None:
        painter.setPen(self.opts["pen"])
        for line in self._lines:
            painter.drawPolyline(line)

    @override
    def boundingRect(self) -> QRectF:
        """Return the visible part of the plot."""
        return self._bounds

    @override
    def viewTransformChanged(self) -> None:
        """Take over the new visible part (that of the view box, since viewRect() keeps the old one)."""
        super().viewTransformChanged()
        view = self.getViewBox()
        self._bounds = view.viewRect() if view is not None else QRectF()

    @override
    def dataBounds(self, *_asked: Any, **_options: Any) -> tuple[None, None]:
        """Ask for no range, since the axes are fixed."""
        return None, None


def broken_line(x: Float64Array, y: Float64Array) -> tuple[QtGui.QPolygonF, ...]:
    """Return a line as polygons for a painter, broken where a value is no number; both of shape (n,)."""
    known = np.isfinite(y)
    if known.all():
        return (polyline_of(x, y),)
    edges = np.flatnonzero(np.diff(known, prepend=False, append=False)).reshape(-1, 2)
    return tuple(polyline_of(x[a:b], y[a:b]) for a, b in edges.tolist())


def polyline_of(x: Float64Array, y: Float64Array) -> QtGui.QPolygonF:
    """Return points as a polygon for a painter, both of shape (n,)."""
    line = QtGui.QPolygonF()
    line.resize(len(x))
    if len(x):
        points = pg.functions.ndarray_from_qpolygonf(line)
        points[:, 0], points[:, 1] = x, y
    return line


DIGIT, LINE = 10, 16
"""Pixels between the numbers of a horizontal axis for each digit that they have, and between those of an upright one.
"""


class LiveAxis(pg.AxisItem):
    """An axis beside what is drawn anew up to 60 times a second: painted and measured only when it changes."""

    _bounds: QRectF | None = None

    def __init__(self, side: str) -> None:
        super().__init__(side)
        self.setCacheMode(QtWidgets.QGraphicsItem.CacheMode.DeviceCoordinateCache)  # painting an axis costs half a ms
        self.enableAutoSIPrefix(False)

    @override
    def boundingRect(self) -> QRectF:
        if self._bounds is None:
            self._bounds = super().boundingRect()
        return self._bounds

    @override
    def setGeometry(self, *geometry: Any) -> None:
        self._bounds = None
        super().setGeometry(*geometry)

    @override
    def resizeEvent(self, event: Any = None) -> None:
        """Leave the name of an upright axis out where it would be cut."""
        super().resizeEvent(event)
        self._leave_out_cut_name()

    @override
    def setLabel(self, *name: Any, **style: Any) -> None:
        super().setLabel(*name, **style)
        self._leave_out_cut_name()

    def _leave_out_cut_name(self) -> None:
        if self.orientation == "left" and self.label is not None:
            self.label.setVisible(self.label.boundingRect().width() <= self.size().height())

    @override
    def tickSpacing(self, low: float, high: float, size: float) -> list[tuple[float, float]]:
        """Return the spacings of the ticks; numbers of a small plot are so far apart that they do not overlap."""
        levels: list[tuple[float, float]] = super().tickSpacing(low, high, size)
        if not levels:
            return levels
        (spacing, offset), *others = levels
        if self.orientation == "left":
            others = [level for level in others if level[0] / (high - low) * size >= LINE]
        least = LINE if self.orientation == "left" else DIGIT * len(f"{max(abs(low), abs(high)):.0f}")
        lacking = least * (high - low) / (spacing * max(size, 1.0))
        return [(spacing * 2 ** max(0, math.ceil(math.log2(lacking))), offset), *others]

    @override
    def setGrid(self, grid: float | bool) -> None:
        self._bounds = None
        super().setGrid(grid)

    @override
    def linkedViewChanged(self, *change: Any) -> None:
        """Show another range, or beside a plot of another size."""
        self._bounds = None
        super().linkedViewChanged(*change)


def live_axes() -> dict[str, LiveAxis]:
    """Make the axes of a plot."""
    return {side: LiveAxis(side) for side in ("left", "bottom")}


def unlink_hidden_axes(plot: Any) -> None:
    """Have the axes that a plot hides follow no range: at each change they would lay out their names anew."""
    for side in ("top", "right"):
        plot.getAxis(side).unlinkFromView()


class RangeBox(pg.ViewBox):
    """A view box in which a drag moves the picture, or draws a range.

    Attributes
    ----------
    draw : is given both ends of a range (on the x axis) while it is drawn; None while a drag moves the picture.
    """

    def __init__(self) -> None:
        super().__init__(enableMenu=False)
        self.draw: Callable[[float, float], object] | None = None

    @override
    def mouseDragEvent(self, event: Any, axis: int | None = None) -> None:
        """Draw a range, or move the picture."""
        if self.draw is None or event.button() != Qt.MouseButton.LeftButton:
            super().mouseDragEvent(event, axis)
            return
        event.accept()
        self.draw(*(self.mapToView(point).x() for point in (event.buttonDownPos(), event.pos())))


class ReadOut(QtWidgets.QLabel):
    """Says at a plot's upper right corner what lies under the mouse; hidden while that is nothing."""

    def __init__(self, plot: QtWidgets.QWidget, theme: Theme) -> None:
        super().__init__(plot)
        self._plot = plot
        self.setStyleSheet(f"color: {theme.text}; background: {theme.raised}; padding: 2px 5px; border-radius: 3px")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.show_reading("")

    def show_reading(self, text: str) -> None:
        """Show a text; an empty one hides it."""
        self.setVisible(bool(text))
        if text != self.text():
            self.setText(text)
            self.adjustSize()
        self.move(self._plot.width() - self.width() - 14, 8)


class Plot(QtWidgets.QWidget):
    """A heading with controls at its right, and a plot below it.

    Parameters
    ----------
    title : the heading.
    tip : what is drawn, and of what.
    axes : text and unit of the x and the y axis.
    read_out : says in words what lies at a point of the plot; an empty text for nothing.

    Attributes
    ----------
    cursor_label : shows that for the place of the mouse.
    """

    def __init__(
        self,
        title: str,
        tip: str,
        axes: tuple[tuple[str, str], tuple[str, str]],
        read_out: Callable[[float, float], str],
        theme: Theme,
    ) -> None:
        super().__init__()
        self.theme = theme
        self.graphics = pg.PlotWidget(viewBox=RangeBox(), enableMenu=False, axisItems=live_axes())
        self.item: Any = self.graphics.getPlotItem()
        unlink_hidden_axes(self.item)
        self._read_out = read_out
        self._mouse: QPointF | None = None
        self.graphics.setAccessibleName(title)
        self.cursor_label = ReadOut(self.graphics, theme)
        self._cursor = pg.InfiniteLine(angle=90, pen=pg.mkPen(theme.faint, style=Qt.PenStyle.DashLine))
        self._hint = QtWidgets.QLabel(tr("No data yet: press Play, or click in the recording"))
        self._style(axes)
        self._lay_out(title, tip)
        self._follow_mouse()

    def tell_empty(self, empty: bool) -> None:
        """Say how to fill the plot while nothing is drawn in it, or no longer."""
        self._hint.setVisible(empty)

    def refresh_read_out(self) -> None:
        """Show what lies under the mouse now: it may stand still while the picture moves."""
        point = None if self._mouse is None else self.item.vb.mapSceneToView(self._mouse)
        self._cursor.setVisible(point is not None)
        if point is not None:
            self._cursor.setPos(point.x())
        self.cursor_label.show_reading("" if point is None else self._read_out(point.x(), point.y()))

    @override
    def showEvent(self, event: Any) -> None:
        """Have Tab come to the plot after what stands above it."""
        items = [bar.itemAt(k) for bar in (self.beside, self.header) for k in range(bar.count())]
        above = [item.widget() for item in items if item is not None]
        reached = [w for w in above if w is not None and w.focusPolicy() & Qt.FocusPolicy.TabFocus]
        for one, other in pairwise([*reached, self.graphics]):
            QtWidgets.QWidget.setTabOrder(one, other)
        super().showEvent(event)

    @override
    def leaveEvent(self, event: Any) -> None:
        self._mouse = None
        self.refresh_read_out()
        super().leaveEvent(event)

    def _style(self, axes: tuple[tuple[str, str], tuple[str, str]]) -> None:
        for side, (text, unit) in zip(("bottom", "left"), axes, strict=True):
            self.item.setLabel(side, f"{text} ({unit})" if unit else text)
            self.item.getAxis(side).setStyle(tickTextOffset=2, tickLength=-4)
        self.item.getAxis("left").setWidth(52)
        self.item.showGrid(x=True, y=True, alpha=0.12)
        self.item.hideButtons()
        self.item.layout.setContentsMargins(0, 2, 10, 4)
        self.item.addItem(self._cursor, ignoreBounds=True)
        self._cursor.setVisible(False)

    def _lay_out(self, title: str, tip: str) -> None:
        self.heading = bold(builders.ElidedLabel(title, asks=True))
        self.heading.setToolTip(tip or title)
        self.beside, self.header = builders.row((self.heading, 1), spacing=4), builders.row(1, spacing=4)
        above = builders.Wrapping(self.beside, self.header, (6, 3, 6, 1))
        self._body = builders.column(above, (self.graphics, 1), on=self, spacing=0)
        self._hint.setStyleSheet(f"color: {self.theme.faint}; background: transparent")
        self._hint.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        builders.column(self._hint, on=self.graphics, margins=(60, 0, 12, 40))  # beside the axes
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._hint.setWordWrap(True)

    def _follow_mouse(self) -> None:
        self._proxy = pg.SignalProxy(
            self.graphics.scene().sigMouseMoved, rateLimit=READOUTS_PER_SECOND, slot=self._on_mouse
        )

    def _on_mouse(self, event: tuple[QPointF]) -> None:
        self._mouse = event[0] if self.item.vb.sceneBoundingRect().contains(event[0]) else None
        self.refresh_read_out()


def bold(label: QtWidgets.QLabel) -> QtWidgets.QLabel:
    """Have a label write boldly."""
    font = label.font()
    font.setBold(True)
    label.setFont(font)
    return label
