"""A plot with a heading, axes with units, and a cursor that reads out what lies under it."""

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pyqtgraph as pg
from numpy.typing import ArrayLike
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QGraphicsItem, QLabel, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import ElidedLabel, Wrapping, column, row
from phonemeengine.arrays import Float64Array

READOUTS_PER_SECOND = 30


class LiveCurve(pg.PlotCurveItem):
    """A curve that is drawn anew up to 60 times a second within fixed axes.

    Its bounds are those of the axes, so its points need not be measured at every picture. They are kept, and
    changed only after Qt was told so, since it would paint a new range within the old bounds otherwise. It is painted
    as polylines, which need no path; where a value is no number, there is a gap.
    """

    _bounds = QRectF()
    _lines: tuple[QPolygonF, ...] = ()

    def __init__(self, pen: QPen) -> None:
        super().__init__()
        self.setPen(pen)

    @override
    def setData(self, x: ArrayLike = (), y: ArrayLike = ()) -> None:
        self.xData, self.yData = np.asarray(x, float), np.asarray(y, float)
        self.path = None
        self._lines = broken_line(self.xData, self.yData)
        self.update()

    @override
    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
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


def broken_line(x: Float64Array, y: Float64Array) -> tuple[QPolygonF, ...]:
    """Return a line as polygons for a painter, broken where a value is no number; both of shape (n,)."""
    known = np.isfinite(y)
    if known.all():
        return (polyline_of(x, y),)
    edges = np.flatnonzero(np.diff(known, prepend=False, append=False)).reshape(-1, 2)
    return tuple(polyline_of(x[a:b], y[a:b]) for a, b in edges.tolist())


def polyline_of(x: Float64Array, y: Float64Array) -> QPolygonF:
    """Return points as a polygon for a painter, both of shape (n,)."""
    line = QPolygonF()
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
        self.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)  # painting an axis costs half a ms
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


class ReadOut(QLabel):
    """Says at a plot's upper right corner what lies under the mouse; hidden while that is nothing."""

    def __init__(self, plot: QWidget, theme: Theme) -> None:
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


class Plot(QWidget):
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
        self._hint = QLabel(tr("No data yet: press Play, or click in the recording"))
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
            QWidget.setTabOrder(one, other)
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
        self.heading = bold(ElidedLabel(title, asks=True))
        self.heading.setToolTip(tip or title)
        self.beside, self.header = row((self.heading, 1), spacing=4), row(1, spacing=4)
        above = Wrapping(self.beside, self.header, (6, 3, 6, 1))
        self._body = column(above, (self.graphics, 1), on=self, spacing=0)
        self._hint.setStyleSheet(f"color: {self.theme.faint}; background: transparent")
        self._hint.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        column(self._hint, on=self.graphics, margins=(60, 0, 12, 40))  # beside the axes
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._hint.setWordWrap(True)

    def _follow_mouse(self) -> None:
        self._proxy = pg.SignalProxy(
            self.graphics.scene().sigMouseMoved, rateLimit=READOUTS_PER_SECOND, slot=self._on_mouse
        )

    def _on_mouse(self, event: tuple[QPointF]) -> None:
        self._mouse = event[0] if self.item.vb.sceneBoundingRect().contains(event[0]) else None
        self.refresh_read_out()


def bold(label: QLabel) -> QLabel:
    """Have a label write boldly."""
    font = label.font()
    font.setBold(True)
    label.setFont(font)
    return label
