"""What was said when: lanes of spans over time, one above the other, such as words and phones."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QScrollBar, QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.theme import Theme, draw_text
from phonemeanalyser.desktop.widgets.builders import column
from phonemeanalyser.desktop.widgets.lanes import SIZE, Lane, TimeAxis, paint_lane, paint_name
from phonemeengine.settings import FRAME_PERIOD

LEFT = 76
HEADING, HEIGHT, GAP = 14, 20, 2
NARROWEST, WIDEST = 0.02, 12.0
"""Pixels of a frame at most zoom out and in."""
CLICK = 3
"""Pixels by which a press may move and still be a click."""


class Chapter(NamedTuple):
    """A part of the time with a name above the lanes, such as a recording; it goes to the next one."""

    start: float
    name: str


class Timeline(QWidget):
    """Paints the part of the lanes that is seen.

    Attributes
    ----------
    first : the frame of 10 ms at the left edge.
    scale : pixels of a frame.
    lanes, chapters, duration : what there is; see `show_lanes`.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.lanes: tuple[Lane, ...] = ()
        self.chapters: tuple[Chapter, ...] = ()
        self.duration = 0.0
        self.first = 0.0
        self.scale = 1.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_lanes(self, lanes: Sequence[Lane], duration: float, chapters: Sequence[Chapter] = ()) -> None:
        """Show these lanes, from above, of a sound of a given length."""
        self.lanes, self.duration, self.chapters = tuple(lanes), duration, tuple(chapters)
        self.setMinimumSize(200, round(self._bottom) + 4 + GAP)
        self.update()

    @property
    def n_frames(self) -> int:
        """How many frames there are."""
        return round(self.duration / FRAME_PERIOD)

    @property
    def n_seen(self) -> float:
        """How many frames have room."""
        return max(1.0, (self.width() - LEFT) / self.scale)

    @property
    def axis(self) -> TimeAxis:
        """Where times lie."""
        width = max(1, self.width() - LEFT)
        return TimeAxis(LEFT, width, self.first * FRAME_PERIOD, width / self.scale * FRAME_PERIOD)

    def x_of(self, seconds: float) -> float:
        """Return the pixel of a time."""
        return self.axis.x_of(seconds)

    def rows(self) -> list[tuple[QRectF, Lane]]:
        """Return where the lanes lie."""
        return [(self._row(number), lane) for number, lane in enumerate(self.lanes)]

    def lane_at(self, y: float) -> int | None:
        """Return the number of the lane at a height, of which the heading is part of the first; None below them."""
        lane = max(0, int((y - HEADING) // (HEIGHT + GAP)))
        return lane if lane < len(self.lanes) else None

    @override
    def paintEvent(self, _event: QPaintEvent) -> None:
        painter, theme, axis = QPainter(self), self._theme, self.axis
        painter.fillRect(self.rect(), QColor(theme.base))
        if not self.duration:
            return
        for row, lane in self.rows():
            paint_name(painter, row, lane.name, theme)
            paint_lane(painter, row, lane, axis, theme)
        self._paint_chapters(painter)

    @property
    def _bottom(self) -> float:
        return HEADING + len(self.lanes) * (HEIGHT + GAP) - GAP

    def _row(self, number: int) -> QRectF:
        return QRectF(LEFT, HEADING + number * (HEIGHT + GAP), max(1, self.width() - LEFT), HEIGHT)

    def _paint_chapters(self, painter: QPainter) -> None:
        borders = [*(chapter.start for chapter in self.chapters), self.duration]
        for chapter, (start, after) in zip(self.chapters, pairwise(borders), strict=True):
            x, end = self.x_of(start), self.x_of(after)
            if end < LEFT or x > self.width():
                continue
            if x >= LEFT:
                painter.fillRect(QRectF(x, 0, 1, self._bottom), QColor(self._theme.text))
            room = min(end, self.width()) - max(x, LEFT) - 6
            if room > 24:
                text = painter.fontMetrics().elidedText(chapter.name, Qt.TextElideMode.ElideMiddle, int(room))
                draw_text(painter, QRectF(max(x, LEFT) + 4, 0, room, HEADING), text, self._theme.faint, SIZE)


class TimelineView(QWidget):
    """Lanes with their scroll bar; the wheel zooms at the mouse, a drag scrolls.

    Signals
    -------
    span_clicked : number of the lane, and of the span in it.
    """

    span_clicked = Signal(int, int)

    def __init__(self, lanes: Timeline) -> None:
        super().__init__()
        self.lanes = lanes
        self._filling: float | None = None
        self._pressed: tuple[QPointF, int] | None = None
        self.bar = QScrollBar(Qt.Orientation.Horizontal)
        keeps_its_room = self.bar.sizePolicy()
        keeps_its_room.setRetainSizeWhenHidden(True)
        self.bar.setSizePolicy(keeps_its_room)
        self.bar.hide()
        column(self.lanes, self.bar, on=self, spacing=0)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.bar.valueChanged.connect(self._scroll)

    def show_lanes(self, lanes: Sequence[Lane], duration: float, chapters: Sequence[Chapter] = ()) -> None:
        """Show these lanes of a sound of a given length; of another length, from its beginning."""
        fresh = duration != self.lanes.duration
        self.lanes.show_lanes(lanes, duration, chapters)
        if fresh:
            self._fit()

    def show_time(self, seconds: float) -> None:
        """Scroll to a time, so near that its spans are distinguishable."""
        self._filling, self.lanes.scale = None, max(self.lanes.scale, 1.0)
        self._fit()
        self.bar.setValue(round(seconds / FRAME_PERIOD - self.lanes.n_seen / 2))

    def show_whole(self) -> None:
        """Zoom out, or in, to all there is, in any width until the user zooms."""
        self._filling = max(self.lanes.duration, FRAME_PERIOD)
        self._fit()

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and event.position().x() >= LEFT:
            self._pressed = event.position(), self.bar.value()

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._pressed is not None:
            moved = event.position().x() - self._pressed[0].x()
            if abs(moved) > CLICK:
                self.bar.setValue(round(self._pressed[1] - moved / self.lanes.scale))

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Choose the span that was clicked."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        pressed, self._pressed = self._pressed, None
        number = self.lanes.lane_at(event.position().y())
        if number is None or pressed is None or abs(event.position().x() - pressed[0].x()) > CLICK:
            return
        span = self.lanes.lanes[number].span_at(self.lanes.axis.time_at(event.position().x()))
        if span is not None:
            self.span_clicked.emit(number, span)

    @override
    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the mouse; with Shift, or a sideways wheel, scroll."""
        turned, lanes = event.angleDelta(), self.lanes
        if turned.x() or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.bar.setValue(round(self.bar.value() - (turned.x() or turned.y()) / 960 * lanes.n_seen))
            return
        x = event.position().x()
        frame = lanes.axis.time_at(x) / FRAME_PERIOD
        lanes.scale = min(max(lanes.scale * 1.3 ** (turned.y() / 120), NARROWEST), WIDEST)
        self._filling = None
        self._fit()
        self.bar.setValue(round(frame - (x - LEFT) / lanes.scale))

    @override
    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        lanes = self.lanes
        if self._filling is not None:
            scale = max(1, lanes.width() - LEFT) * FRAME_PERIOD / self._filling
            lanes.scale = min(max(scale, NARROWEST), WIDEST)
        seen = round(lanes.n_seen)
        self.bar.setRange(0, max(0, lanes.n_frames - seen))
        self.bar.setVisible(self.bar.maximum() > 0)
        self.bar.setPageStep(seen)
        self.bar.setSingleStep(max(1, seen // 10))
        self._scroll(self.bar.value())

    def _scroll(self, value: int) -> None:
        self.lanes.first = float(value)
        self.lanes.update()
