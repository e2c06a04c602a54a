"""What was said when: lanes of spans over time, one above the other, such as words and phones."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QBrush,
    QColor,
    QHelpEvent,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QScrollBar, QSizePolicy, QToolTip, QWidget

from phonemeanalyser.desktop.painting import CENTRED, draw_text, letters_on
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import column
from phonemeengine.arrays import Float64Array, UInt32Array
from phonemeengine.settings import FRAME_PERIOD

LEFT = 76
HEADING, HEIGHT, GAP = 14, 20, 2
SIZE = 11
"""Of letters, pixels."""
NARROWEST, WIDEST = 0.02, 12.0
"""Pixels of a frame at most zoom out and in."""
LEAST_TEXT = 16
"""Pixels that a span needs to be named."""
LEAST_MARK, UNDERLINE = 3, 3
"""Pixels that a span needs for its hatching to be seen, and those of the line below it."""
GRAB = 4
"""Pixels at either side of a boundary at which it is caught."""
LEAST_SPAN = FRAME_PERIOD
"""Seconds that a dragged boundary leaves of a span at least."""
TOUCHING = 1e-6
"""Seconds between two spans that have one boundary."""


@dataclass(frozen=True, eq=False)
class Lane:
    """Spans of time that do not overlap.

    Attributes
    ----------
    name : stands at its left.
    starts, ends : seconds, shape (n_spans,), in order of time.
    texts : what stands in each span.
    colours : of each span, RGB as ``QColor.rgb()`` has it, shape (n_spans,).
    marked : which spans are hatched and underlined, because they fit badly.
    movable : whether its boundaries can be dragged.
    tips : what is told of each span under the mouse; of none, nothing.
    """

    name: str
    starts: Float64Array = field(default_factory=lambda: np.zeros(0))
    ends: Float64Array = field(default_factory=lambda: np.zeros(0))
    texts: Sequence[str] = ()
    colours: UInt32Array = field(default_factory=lambda: np.zeros(0, np.uint32))
    marked: frozenset[int] = frozenset()
    movable: bool = False
    tips: Sequence[str] = ()

    def span_at(self, seconds: float) -> int | None:
        """Return the number of the span at a time; None where there is none."""
        k = int(np.searchsorted(self.starts, seconds, side="right")) - 1
        return k if k >= 0 and seconds < self.ends[k] else None

    def boundaries(self) -> Float64Array:
        """Return where spans begin and end, seconds, shape (2 n_spans,): boundary 2 k is the start of span k."""
        return np.stack((self.starts, self.ends), axis=1).ravel()

    def touches(self, k: int) -> bool:
        """Return whether span k begins where the one before ends: they have one boundary, and move together."""
        return 0 < k < len(self.starts) and bool(self.starts[k] - self.ends[k - 1] < TOUCHING)

    def room_of(self, boundary: int, duration: float) -> tuple[float, float]:
        """Return between which times a boundary can be dragged in a sound of so many seconds."""
        k, is_end = divmod(boundary, 2)
        if is_end:
            after = self.starts[k + 1] if k + 1 < len(self.starts) else duration
            return float(self.starts[k]) + LEAST_SPAN, float(after)
        before = self.starts[k - 1] + LEAST_SPAN if self.touches(k) else self.ends[k - 1] if k else 0.0
        return float(before), float(self.ends[k]) - LEAST_SPAN


class Chapter(NamedTuple):
    """A part of the time with a name above the lanes, such as a recording; it goes to the next one."""

    start: float
    name: str


class Drag(NamedTuple):
    """A boundary in the hand: its lane and number, and where it would be put, seconds."""

    lane: int
    boundary: int
    seconds: float


class Timeline(QWidget):
    """Paints the part of the lanes that is seen.

    Attributes
    ----------
    first : the frame of 10 ms at the left edge.
    scale : pixels of a frame.
    lanes, chapters, duration : what there is; see `show_lanes`.
    playhead : the time that is heard, seconds; None for none.
    drag : the boundary that is being dragged.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.lanes: tuple[Lane, ...] = ()
        self.chapters: tuple[Chapter, ...] = ()
        self.duration = 0.0
        self.first = 0.0
        self.scale = 1.0
        self.playhead: float | None = None
        self.drag: Drag | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_lanes(self, lanes: Sequence[Lane], duration: float, chapters: Sequence[Chapter] = ()) -> None:
        """Show these lanes, from above, of a sound of so many seconds."""
        self.lanes, self.duration, self.chapters = tuple(lanes), duration, tuple(chapters)
        self.setMinimumSize(200, self._bottom + GAP + 4)
        self.update()

    @property
    def n_frames(self) -> int:
        """How many frames there are."""
        return round(self.duration / FRAME_PERIOD)

    @property
    def n_seen(self) -> float:
        """How many frames have room."""
        return max(1.0, (self.width() - LEFT) / self.scale)

    def frame_at(self, x: float) -> float:
        """Return the frame at a pixel."""
        return self.first + (x - LEFT) / self.scale

    def time_at(self, x: float) -> float:
        """Return the time at a pixel, seconds."""
        return self.frame_at(x) * FRAME_PERIOD

    def x_of(self, seconds: float) -> float:
        """Return the pixel of a time."""
        return LEFT + (seconds / FRAME_PERIOD - self.first) * self.scale

    def lane_at(self, y: float) -> int | None:
        """Return the number of the lane at a height, of which the heading is part of the first; None below them."""
        lane = max(0, int((y - HEADING) // (HEIGHT + GAP)))
        return lane if lane < len(self.lanes) else None

    def boundary_at(self, x: float, y: float) -> Drag | None:
        """Return the boundary at a pixel that can be dragged: of two at one time, the start."""
        number = self.lane_at(y)
        if number is None or not self.lanes[number].movable or not len(self.lanes[number].starts):
            return None
        times = self.lanes[number].boundaries()
        nearest = float(times[np.argmin(np.abs(times - self.time_at(x)))])
        if abs(self.x_of(nearest) - x) > GRAB:
            return None
        return Drag(number, int(np.searchsorted(times, nearest + TOUCHING)) - 1, nearest)

    # -- painting -----------------------------------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the lanes, the names of the chapters, and where one begins; the playhead above all."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        if not self.duration:
            return
        for number, lane in enumerate(self.lanes):
            draw_text(painter, QRectF(6, self._top_of(number), LEFT - 8, HEIGHT), lane.name, self._theme.text, SIZE)
            self._paint_lane(painter, self._top_of(number), lane)
        self._paint_chapters(painter)
        if self.playhead is not None:
            self._paint_time(painter, self.playhead, QRectF(0, 0, 1, self._bottom), self._theme.accent)
        if self.drag is not None:
            top = self._top_of(self.drag.lane)
            self._paint_time(painter, self.drag.seconds, QRectF(0, top - 2, 2, HEIGHT + 4), self._theme.text)

    @property
    def _bottom(self) -> int:
        return self._top_of(len(self.lanes)) - GAP

    def _top_of(self, number: int) -> int:
        return HEADING + number * (HEIGHT + GAP)

    def _paint_lane(self, painter: QPainter, top: int, lane: Lane) -> None:
        times = (self.first + np.arange(max(0, self.width() - LEFT)) / self.scale) * FRAME_PERIOD
        spans = np.searchsorted(lane.starts, times, side="right") - 1
        inside = (spans >= 0) & (times < np.append(lane.ends, 0.0)[spans])
        if not inside.any():
            return
        colours = np.where(inside, np.append(lane.colours, 0)[spans], QColor(self._theme.base).rgb()).astype(
            np.uint32
        )
        n = len(colours)
        painter.drawImage(
            QRectF(LEFT, top, n, HEIGHT), QImage(colours.tobytes(), n, 1, 4 * n, QImage.Format.Format_RGB32)
        )
        seen = spans[inside]
        self._paint_spans(painter, top, lane, int(seen[0]), int(seen[-1]) + 1)

    def _paint_spans(self, painter: QPainter, top: int, lane: Lane, first: int, last: int) -> None:
        """Part spans of one colour, hatch those that are marked, and name those that have room."""
        widths = (lane.ends[first:last] - lane.starts[first:last]) / FRAME_PERIOD * self.scale
        for k in (np.flatnonzero(widths >= LEAST_MARK) + first).tolist():
            start, end = self.x_of(float(lane.starts[k])), self.x_of(float(lane.ends[k]))
            box = QRectF(max(start, LEFT), top, min(end, self.width()) - max(start, LEFT), HEIGHT)
            if lane.touches(k) and lane.colours[k] == lane.colours[k - 1] and start >= LEFT:
                painter.fillRect(QRectF(start, top, 1, HEIGHT), QColor(self._theme.base))
            if k in lane.marked:
                painter.fillRect(box, QBrush(QColor(self._theme.bad), Qt.BrushStyle.BDiagPattern))
                painter.fillRect(box.adjusted(0, HEIGHT - UNDERLINE, 0, 0), QColor(self._theme.bad))
            text = lane.texts[k]
            if box.width() >= LEAST_TEXT and painter.fontMetrics().horizontalAdvance(text) < box.width() - 2:
                letters = letters_on(QColor(int(lane.colours[k])).name())
                draw_text(painter, box, text, letters, SIZE, CENTRED)

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
    """Lanes with their scroll bar; the wheel scrolls, and with Ctrl it zooms at the mouse.

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
        """Show these lanes of a sound of so many seconds; of another length, from its beginning."""
        fresh = duration != self.lanes.duration
        self.lanes.drag = None
        self.lanes.show_lanes(lanes, duration, chapters)
        if fresh:
            self._fit()

    def show_playhead(self, seconds: float | None) -> None:
        """Show which time is heard, and scroll there where it is not seen."""
        lanes = self.lanes
        lanes.playhead = seconds
        if seconds is not None and not LEFT <= lanes.x_of(seconds) < lanes.width():
            self.bar.setValue(int(seconds / FRAME_PERIOD))
        lanes.update()

    def show_time(self, seconds: float) -> None:
        """Scroll to a time, so near that its spans are told apart."""
        self.lanes.scale = max(self.lanes.scale, 1.0)
        self._fit()
        self.bar.setValue(round(seconds / FRAME_PERIOD - self.lanes.n_seen / 2))

    def show_whole(self) -> None:
        """Zoom out to all there is."""
        self.lanes.scale = min(max((self.lanes.width() - LEFT) / max(1, self.lanes.n_frames), NARROWEST), 1.0)
        self._fit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take a boundary in the hand, or choose the span under the mouse."""
        if event.button() != Qt.MouseButton.LeftButton or event.position().x() < LEFT - GRAB:
            return
        self.lanes.drag = self.lanes.boundary_at(event.position().x(), event.position().y())
        if self.lanes.drag is None:
            for number, span in self._spans_at(event.position()):
                self.span_clicked.emit(number, span)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Tell which span it was."""
        if event.button() == Qt.MouseButton.LeftButton:
            for number, span in self._spans_at(event.position()):
                self.span_double_clicked.emit(number, span)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the boundary along, as far as its neighbours; show which can be."""
        lanes, x = self.lanes, event.position().x()
        if lanes.drag is None:
            over = lanes.boundary_at(x, event.position().y())
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)
            return
        low, high = lanes.lanes[lanes.drag.lane].room_of(lanes.drag.boundary, lanes.duration)
        lanes.drag = lanes.drag._replace(seconds=min(max(lanes.time_at(x), low), high))
        lanes.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let the boundary go; it has moved, unless it is where it was."""
        lanes, drag = self.lanes, self.lanes.drag
        if event.button() != Qt.MouseButton.LeftButton or drag is None:
            return
        lanes.drag = None
        lanes.update()
        if drag.seconds != lanes.lanes[drag.lane].boundaries()[drag.boundary]:
            self.boundary_moved.emit(*drag)

    def event(self, event: QEvent) -> bool:
        """Tell of the span under the mouse what there is to tell."""
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

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Scroll, or zoom at the mouse."""
        turns = (event.angleDelta().y() or event.angleDelta().x()) / 120
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.bar.setValue(round(self.bar.value() - turns * self.lanes.n_seen / 8))
            return
        x = event.position().x()
        frame = self.lanes.frame_at(x)
        self.lanes.scale = min(max(self.lanes.scale * 1.3**turns, NARROWEST), WIDEST)
        self._fit()
        self.bar.setValue(round(frame - (x - LEFT) / self.lanes.scale))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Let the scroll bar know how much is seen."""
        super().resizeEvent(event)
        self._fit()

    def leaveEvent(self, _event: QEvent) -> None:
        """Show the usual cursor elsewhere."""
        self.unsetCursor()

    def _spans_at(self, place: QPointF) -> list[tuple[int, int]]:
        """Return lane and number of the span at a pixel, if there is one."""
        number = self.lanes.lane_at(place.y())
        if number is None or place.x() < LEFT:
            return []
        span = self.lanes.lanes[number].span_at(self.lanes.time_at(place.x()))
        return [] if span is None else [(number, span)]

    def _fit(self) -> None:
        seen = int(self.lanes.n_seen)
        self.bar.setRange(0, max(0, self.lanes.n_frames - seen))
        self.bar.setVisible(self.bar.maximum() > 0)
        self.bar.setPageStep(seen)
        self.bar.setSingleStep(max(1, seen // 10))
        self._scroll(self.bar.value())

    def _scroll(self, value: int) -> None:
        self.lanes.first = float(value)
        self.lanes.update()
