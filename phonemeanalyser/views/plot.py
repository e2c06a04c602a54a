"""A plot with a heading, axes with units, and a cursor that reads out what lies under it."""

from collections.abc import Callable
from typing import Any

import pyqtgraph as pg
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtWidgets import QGraphicsItem, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from phonemeanalyser.theme import Theme
from phonemeanalyser.views.status_line import ElidedLabel

READOUTS_PER_SECOND = 30


class LiveCurve(pg.PlotCurveItem):
    """A curve that is drawn anew up to 60 times a second within fixed axes.

    Its bounds are those of the axes, so its points need not be measured at every picture. They are kept, and
    changed only after Qt was told so, since it would paint a new range within the old bounds otherwise.
    """

    _bounds = QRectF()

    def boundingRect(self) -> QRectF:
        """Give the visible part of the plot."""
        return self._bounds

    def viewTransformChanged(self) -> None:
        """Take over the new visible part (that of the view box, since viewRect() keeps the old one)."""
        super().viewTransformChanged()
        view = self.getViewBox()
        self._bounds = view.viewRect() if view is not None else QRectF()

    def dataBounds(self, *_asked: Any, **_options: Any) -> tuple[None, None]:
        """Ask for no range, since the axes are fixed."""
        return None, None


class Plot(QWidget):
    """A heading with controls at its right, and a plot below it.

    Parameters
    ----------
    title : the heading.
    axes : text and unit of the x and the y axis.
    read_out : says in words what lies at a point of the plot; an empty text for nothing.
    """

    def __init__(
        self, title: str, axes: tuple[tuple[str, str], tuple[str, str]], read_out: Callable[[float, float], str],
        theme: Theme,
    ) -> None:  # fmt: skip
        super().__init__()
        self.theme = theme
        self.graphics = pg.PlotWidget()
        self.item: Any = self.graphics.getPlotItem()
        self.header = QHBoxLayout()
        self._read_out = read_out
        self._cursor_label = QLabel(self.graphics)
        self._cursor = pg.InfiniteLine(angle=90, pen=pg.mkPen(theme.faint, style=Qt.PenStyle.DashLine))
        self._style(axes)
        self._lay_out(title)
        self._follow_mouse()

    def set_cursor(self, point: QPointF | None) -> None:
        """Show the cursor and its read-out at a point of the plot, or hide both."""
        self._cursor.setVisible(point is not None)
        if point is not None:
            self._cursor.setPos(point.x())
        self._cursor_label.setVisible(point is not None)
        if point is not None:
            self._cursor_label.setText(self._read_out(point.x(), point.y()))
            self._cursor_label.adjustSize()
            self._cursor_label.move(self.graphics.width() - self._cursor_label.width() - 14, 10)

    def leaveEvent(self, event: Any) -> None:
        """Hide the cursor when the mouse leaves."""
        self.set_cursor(None)
        super().leaveEvent(event)

    def _style(self, axes: tuple[tuple[str, str], tuple[str, str]]) -> None:
        for side, (text, unit) in zip(("bottom", "left"), axes, strict=True):
            self.item.setLabel(side, f"{text} ({unit})" if unit else text)
            axis = self.item.getAxis(side)
            axis.enableAutoSIPrefix(False)
            axis.setStyle(tickTextOffset=2, tickLength=-4)
            axis.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)  # painting an axis costs half a ms
        self.item.getAxis("left").setWidth(52)
        self.item.showGrid(x=True, y=True, alpha=0.12)
        self.item.hideButtons()
        self.item.layout.setContentsMargins(0, 2, 10, 4)
        self.item.setMenuEnabled(False)
        self.item.addItem(self._cursor, ignoreBounds=True)
        self._cursor.setVisible(False)

    def _lay_out(self, title: str) -> None:
        heading = bold(ElidedLabel(title))
        heading.setToolTip(title)
        self._cursor_label.setStyleSheet(
            f"color: {self.theme.text}; background: {self.theme.raised}; padding: 2px 5px; border-radius: 3px"
        )
        self._cursor_label.setVisible(False)
        self.header.setContentsMargins(6, 3, 6, 1)
        self.header.setSpacing(6)
        self.header.addWidget(heading, 1)
        self._body = QVBoxLayout(self)
        layout = self._body
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(self.header)
        layout.addWidget(self.graphics, 1)

    def _follow_mouse(self) -> None:
        self._proxy = pg.SignalProxy(
            self.graphics.scene().sigMouseMoved, rateLimit=READOUTS_PER_SECOND, slot=self._on_mouse
        )

    def _on_mouse(self, event: tuple[QPointF]) -> None:
        inside = self.item.vb.sceneBoundingRect().contains(event[0])
        self.set_cursor(self.item.vb.mapSceneToView(event[0]) if inside else None)


def bold(label: QLabel) -> QLabel:
    """Have a label write boldly."""
    font = label.font()
    font.setBold(True)
    label.setFont(font)
    return label


def switch(text: str, tip: str) -> QToolButton:
    """Make a small button that stays down while it is on."""
    button = QToolButton()
    button.setText(text)
    button.setToolTip(tip)
    button.setCheckable(True)
    return button
