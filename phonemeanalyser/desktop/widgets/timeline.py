"""What was said when: lanes of spans over time, one above the other, such as words and phones."""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QScrollBar, QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.painting import draw_text
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column
from phonemeanalyser.desktop.widgets.lanes import (
    GRAB,
    SIZE,
    TIME_HEIGHT,
    BoundaryDrag,
    Lane,
    TimeAxis,
    paint_lane,
    paint_name,
    paint_times,
    paint_wave,
)
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.settings import FRAME_PERIOD

LEFT = 76
HEADING, HEIGHT, GAP = 14, 20, 2
WAVE_HEIGHT = 32
"""Pixels of the waveform below the lanes."""
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

    Parameters
    ----------
    outline : gives the waveform of what is seen, a point for each pixel of the axis; None while it is not
        known. Without it neither a waveform nor times stand below the lanes.

    Attributes
    ----------
    first : the frame of 10 ms at the left edge.
    scale : pixels of a frame.
    lanes, chapters, duration : what there is; see `show_lanes`.
    playhead : the time that is playing, seconds; None for none.
    drag : the boundary that is being dragged.
    """

    def __init__(self, theme: Theme, outline: Callable[[TimeAxis], Peaks | None] | None = None) -> None:
        super().__init__()
        self._theme = theme
        self._outline = outline
        self.lanes: tuple[Lane, ...] = ()
        self.chapters: tuple[Chapter, ...] = ()
        self.duration = 0.0
        self.first = 0.0
        self.scale = 1.0
        self.playhead: float | None = None
        self.drag = BoundaryDrag()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_lanes(self, lanes: Sequence[Lane], duration: float, chapters: Sequence[Chapter] = ()) -> None:
        """Show these lanes, from above, of a sound of a given length."""
        self.lanes, self.duration, self.chapters = tuple(lanes), duration, tuple(chapters)
        self.setMinimumSize(200, round(self._bottom) + (4 + GAP if self._outline is None else TIME_HEIGHT))
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
        """Paint the lanes, the names of the chapters, and where one begins; the playhead above all."""
        painter, theme, axis = QPainter(self), self._theme, self.axis
        painter.fillRect(self.rect(), QColor(theme.base))
        if not self.duration:
            return
        for row, lane in self.rows():
            paint_name(painter, row, lane.name, theme)
            paint_lane(painter, row, lane, axis, theme)
        if self._outline is not None:
            peaks = self._outline(axis)
            if peaks is not None:
                paint_wave(painter, self._row(len(self.lanes), WAVE_HEIGHT), peaks, theme)
            paint_times(painter, self._bottom, axis, theme, self.width())
        self._paint_chapters(painter)
        if self.playhead is not None:
            self._paint_time(painter, self.playhead, QRectF(0, 0, 1, self._bottom), theme.accent)
        if self.drag.held is not None:
            row = self._row(self.drag.held.lane)
            self._paint_time(
                painter, self.drag.held.seconds, QRectF(0, row.top() - 2, 2, row.height() + 4), theme.text
            )

    @property
    def _bottom(self) -> float:
        return self._row(len(self.lanes), 0 if self._outline is None else WAVE_HEIGHT + GAP).bottom() - GAP

    def _row(self, number: int, height: float = HEIGHT) -> QRectF:
        return QRectF(LEFT, HEADING + number * (HEIGHT + GAP), max(1, self.width() - LEFT), height)

    def _paint_chapters(self, painter: QPainter) -> None:
        borders = [*(chapter.start for chapter in self.chapters), self.duration]
        for chapter, (start, after) in zip(self.chapters, pairwise(borders), strict=True):
            x, end = self.x_of(start), self.x_of(after)
            if end < LEFT or x > self.width():
                continue
            self._paint_time(painter, start, QRectF(0, 0, 1, self._bottom), self._theme.text)
            room = min(end, self.width()) - max(x, LEFT) - 6
            if room > 24:
                text = painter.fontMetrics().elidedText(chapter.name, Qt.TextElideMode.ElideMiddle, int(room))
                draw_text(painter, QRectF(max(x, LEFT) + 4, 0, room, HEADING), text, self._theme.faint, SIZE)

    def _paint_time(self, painter: QPainter, seconds: float, line: QRectF, colour: str) -> None:
        x = self.x_of(seconds)
        if x >= LEFT:
            painter.fillRect(line.translated(x, 0), QColor(colour))


class TimelineView(QWidget):
    """Lanes with their scroll bar; the wheel zooms at the mouse, a drag scrolls.

    Signals
    -------
    span_clicked, span_double_clicked : number of the lane, and of the span in it.
    boundary_moved : number of the lane, of the boundary (2 k: the start of span k, 2 k + 1: its end), and the time to
        which it was dragged, seconds. Where two spans touch, it is the start of the second one. The lanes stay as
        they are until others are shown.
    """

    span_clicked = Signal(int, int)
    span_double_clicked = Signal(int, int)
    boundary_moved = Signal(int, int, float)

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
        self.setMouseTracking(True)
        lanes.setMouseTracking(True)
        self.bar.valueChanged.connect(self._scroll)

    def show_lanes(self, lanes: Sequence[Lane], duration: float, chapters: Sequence[Chapter] = ()) -> None:
        """Show these lanes of a sound of a given length; of another length, from its beginning."""
        fresh = duration != self.lanes.duration
        self.lanes.drag.release()
        self.lanes.show_lanes(lanes, duration, chapters)
        if fresh:
            self._fit()

    def show_playhead(self, seconds: float | None) -> None:
        """Show which time is playing, and scroll there where it is not seen."""
        lanes = self.lanes
        lanes.playhead = seconds
        if seconds is not None and not LEFT <= lanes.x_of(seconds) < lanes.width():
            self.bar.setValue(int(seconds / FRAME_PERIOD))
        lanes.update()

    def show_time(self, seconds: float) -> None:
        """Scroll to a time, so near that its spans are distinguishable."""
        self._filling, self.lanes.scale = None, max(self.lanes.scale, 1.0)
        self._fit()
        self.bar.setValue(round(seconds / FRAME_PERIOD - self.lanes.n_seen / 2))

    def show_whole(self) -> None:
        """Zoom out, or in, to all there is."""
        self.fill(self.lanes.duration)

    def fill(self, seconds: float) -> None:
        """Have a number of seconds fill the width from now on, until the user zooms."""
        self._filling = max(seconds, FRAME_PERIOD)
        self._fit()

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take a boundary in the hand, else what is seen, to scroll it."""
        if event.button() != Qt.MouseButton.LeftButton or event.position().x() < LEFT - GRAB:
            return
        lanes = self.lanes
        if lanes.drag.press(lanes.rows(), lanes.axis, event.position(), lanes.duration) is None:
            self._pressed = event.position(), self.bar.value()

    @override
    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            for number, span in self._spans_at(event.position()):
                self.span_double_clicked.emit(number, span)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the boundary or the lanes along; show which boundaries can be."""
        lanes, place = self.lanes, event.position()
        if lanes.drag.move(lanes.axis.time_at(place.x())) is not None:
            lanes.update()
        elif self._pressed is not None:
            moved = place.x() - self._pressed[0].x()
            if abs(moved) > CLICK:
                self.bar.setValue(round(self._pressed[1] - moved / lanes.scale))
        else:
            over = lanes.drag.boundary_at(lanes.rows(), lanes.axis, place)
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)

    @override
    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the boundary go; it has moved, unless it is where it was. Else choose the span that was clicked."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        moved, pressed, self._pressed = self.lanes.drag.release(), self._pressed, None
        self.lanes.update()
        if moved is not None:
            self.boundary_moved.emit(*moved)
        elif pressed is not None and abs(event.position().x() - pressed[0].x()) <= CLICK:
            for number, span in self._spans_at(event.position()):
                self.span_clicked.emit(number, span)

    @override
    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            tip = next(
                (
                    self.lanes.lanes[n].tips[k]
                    for n, k in self._spans_at(QPointF(event.pos()))
                    if self.lanes.lanes[n].tips
                ),
                "",
            )
            if tip:
                QToolTip.showText(event.globalPos(), tip, self)
                return True
        return super().event(event)

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

    @override
    def leaveEvent(self, _event: QEvent) -> None:
        self.unsetCursor()

    def _spans_at(self, place: QPointF) -> list[tuple[int, int]]:
        """Return lane and number of the span at a pixel, if there is one."""
        number = self.lanes.lane_at(place.y())
        if number is None or place.x() < LEFT:
            return []
        span = self.lanes.lanes[number].span_at(self.lanes.axis.time_at(place.x()))
        return [] if span is None else [(number, span)]

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
