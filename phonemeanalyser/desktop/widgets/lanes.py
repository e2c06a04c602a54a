"""Lanes of spans over time, such as words and phones: where they lie, how they are painted, how a boundary moves."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeVar

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QFocusEvent, QImage, QKeyEvent, QPainter
from PySide6.QtWidgets import QLineEdit, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import AT_LEFT, AT_RIGHT, CENTRED, Theme, draw_text, format_clock, letters_on
from phonemeanalyser.desktop.widgets.builders import named
from phonemeengine.arrays import Float64Array, IndexArray, UInt8Array, UInt32Array
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

SIZE, SMALL = 11, 10
"""Of letters in spans and beside them, pixels."""
LEAST_MARK, UNDERLINE = 3, 3
"""Pixels that a span needs for more of it than its colour to be seen, and those of the line below what is marked."""
GRAB = 4
"""Pixels at either side of a boundary at which it is caught."""
TOUCHING = 1e-6
"""Seconds between two spans that have one boundary."""
SPACINGS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)
"""Between two marks of time, seconds."""
LEAST_SPACING = 70
"""Pixels between two marks of time."""
TIME_HEIGHT = 18
"""Pixels of the marks of time with their numbers."""
LEAST_LOUDNESS = 0.05
"""The amplitude that fills a waveform's height at least."""


Times = TypeVar("Times", float, Float64Array)


class TimeAxis(NamedTuple):
    """Where times lie on a widget: a number of seconds from `start` on, over `width` pixels from `left` on."""

    left: float
    width: float
    start: float
    seconds: float

    @property
    def end(self) -> float:
        """The last time that is seen, seconds."""
        return self.start + self.seconds

    def x_of(self, seconds: Times) -> Times:
        """Return the pixel of a time, or of several."""
        return self.left + (seconds - self.start) / self.seconds * self.width

    def time_at(self, x: float) -> float:
        """Return the time at a pixel, seconds."""
        return self.start + (x - self.left) / self.width * self.seconds


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
    tips : the tooltip of each span; of none, nothing.
    outline : the colour around each span; empty where spans differ by their own.
    are_points : whether spans only begin somewhere, so that their texts stand there.
    least : seconds that a dragged boundary leaves of a span at least.
    doubtful : which spans are hatched faintly, because what they say is not certain.
    """

    name: str
    starts: Float64Array = field(default_factory=lambda: np.zeros(0))
    ends: Float64Array = field(default_factory=lambda: np.zeros(0))
    texts: Sequence[str] = ()
    colours: UInt32Array = field(default_factory=lambda: np.zeros(0, np.uint32))
    marked: frozenset[int] = frozenset()
    movable: bool = False
    tips: Sequence[str] = ()
    outline: str = ""
    are_points: bool = False
    least: float = FRAME_PERIOD
    doubtful: frozenset[int] = frozenset()

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
        """Return between which times a boundary can be dragged in a sound of a given length."""
        k, is_end = divmod(boundary, 2)
        if is_end:
            after = self.starts[k + 1] if k + 1 < len(self.starts) else duration
            return float(self.starts[k]) + self.least, float(after)
        before = self.starts[k - 1] + self.least if self.touches(k) else self.ends[k - 1] if k else 0.0
        return float(before), float(self.ends[k]) - self.least


def lane_of_frames(
    name: str,
    codes: IndexArray | UInt8Array,
    texts: Sequence[str],
    colours: UInt32Array,
    *,
    first: int = 0,
    breaks: Sequence[int] = (),
) -> Lane:
    """Return the runs of frames in a row that have one code.

    Parameters
    ----------
    codes : of the frames from `first` on, shape (n_frames,).
    texts, colours : by code.
    breaks : frames at which a run begins in any case, counted from `first` on.
    """
    begins = np.ones(len(codes), bool)
    begins[1:] = codes[1:] != codes[:-1]
    begins[[at for at in breaks if at < len(codes)]] = True
    edges = np.append(np.flatnonzero(begins), len(codes))
    found = codes[edges[:-1]]
    times = (first + edges) * FRAME_PERIOD
    return Lane(name, times[:-1], times[1:], np.array(texts, object)[found].tolist(), colours[found])


def names_in_lanes() -> list[str]:
    """Return what phonemes are called in lanes, in order."""
    marks = {Phoneme.SILENCE: "–", Phoneme.UNIDENTIFIED: "?"}
    return [marks.get(phoneme) or sound_name(phoneme) for phoneme in Phoneme]


class Drag(NamedTuple):
    """A boundary in the hand: the number of its lane, its own, and where it would be put, seconds."""

    lane: int
    boundary: int
    seconds: float


class BoundaryDrag:
    """Catches a boundary with the mouse, and moves it as far as its neighbours.

    Attributes
    ----------
    held : the boundary in the hand; None for none.
    """

    def __init__(self, grab: int = GRAB) -> None:
        self.held: Drag | None = None
        self._grab = grab
        self._caught: Drag | None = None
        self._room = (0.0, 0.0)

    def boundary_at(self, rows: Sequence[tuple[QRectF, Lane]], axis: TimeAxis, place: QPointF) -> Drag | None:
        """Return the boundary at a pixel that can be dragged: of two at one time, the start."""
        for number, (row, lane) in enumerate(rows):
            if row.top() <= place.y() <= row.bottom() and lane.movable and len(lane.starts):
                times = lane.boundaries()
                nearest = float(times[np.argmin(np.abs(times - axis.time_at(place.x())))])
                if abs(axis.x_of(nearest) - place.x()) <= self._grab:
                    return Drag(number, int(np.searchsorted(times, nearest + TOUCHING)) - 1, nearest)
        return None

    def press(
        self, rows: Sequence[tuple[QRectF, Lane]], axis: TimeAxis, place: QPointF, duration: float
    ) -> Drag | None:
        """Grab the boundary at a pixel, in a sound of a given length; return it."""
        self.held = self._caught = self.boundary_at(rows, axis, place)
        if self.held is not None:
            self._room = rows[self.held.lane][1].room_of(self.held.boundary, duration)
        return self.held

    def move(self, seconds: float) -> Drag | None:
        """Drag the boundary to a time, as far as its neighbours; return where it is."""
        if self.held is not None:
            low, high = self._room
            self.held = self.held._replace(seconds=min(max(seconds, low), high))
        return self.held

    def release(self) -> Drag | None:
        """Let the boundary go; return it, if it is elsewhere now."""
        moved = None if self.held == self._caught else self.held
        self.held = self._caught = None
        return moved


# Painting. A row is where a lane lies; times lie on an axis.


def paint_lane(painter: QPainter, row: QRectF, lane: Lane, axis: TimeAxis, theme: Theme) -> None:
    """Paint what is seen of a lane: each span in its colour, and in as much of its text as has room."""
    n, base = max(1, round(axis.width)), QColor(theme.base).rgb()
    times = axis.start + (np.arange(n) + 0.5) / n * axis.seconds
    spans = np.searchsorted(lane.starts, times, side="right") - 1
    inside = (spans >= 0) & (times < np.append(lane.ends, 0.0)[spans])
    pixels = np.where(inside, np.append(lane.colours, base)[spans], base).astype(np.uint32)
    place = QRectF(axis.left, row.top(), axis.width, row.height())
    painter.drawImage(place, QImage(pixels.data, n, 1, 4 * n, QImage.Format.Format_RGB32))
    first = int(np.searchsorted(lane.ends, axis.start, side="right"))
    last = int(np.searchsorted(lane.starts, axis.end))
    begins, ends = np.maximum(lane.starts[first:last], axis.start), np.minimum(lane.ends[first:last], axis.end)
    lefts, rights = (axis.left + (at - axis.start) / axis.seconds * axis.width for at in (begins, ends))
    for k in np.flatnonzero(rights - lefts >= LEAST_MARK).tolist():
        box = QRectF(lefts[k], row.top(), rights[k] - lefts[k], row.height())
        _paint_span(painter, box, lane, first + k, theme)


def _paint_span(painter: QPainter, box: QRectF, lane: Lane, k: int, theme: Theme) -> None:
    """Part a span from those of its colour, hatch it where it is marked, and name it."""
    colour = QColor(int(lane.colours[k]))
    if lane.outline:
        painter.fillRect(box, QColor(lane.outline))
        painter.fillRect(box.adjusted(1, 1, 0, -1), colour)
    elif lane.touches(k) and lane.colours[k] == lane.colours[k - 1]:
        painter.fillRect(QRectF(box.left(), box.top(), 1, box.height()), QColor(theme.base))
    if k in lane.doubtful:
        faint = QColor(theme.faint)
        faint.setAlphaF(0.4)
        painter.fillRect(box, QBrush(faint, Qt.BrushStyle.FDiagPattern))
    if k in lane.marked:
        painter.fillRect(box, QBrush(QColor(theme.bad), Qt.BrushStyle.BDiagPattern))
        painter.fillRect(box.adjusted(0, box.height() - UNDERLINE, 0, 0), QColor(theme.bad))
    align = AT_LEFT if lane.are_points else CENTRED
    draw_text(painter, box.adjusted(1, 0, -1, 0), lane.texts[k], letters_on(colour.name()), SIZE, align)


def paint_name(painter: QPainter, row: QRectF, name: str, theme: Theme) -> None:
    """Write the name of a row at its left."""
    draw_text(painter, QRectF(2, row.top(), row.left() - 9, row.height()), name, theme.faint, SMALL, AT_RIGHT)


def paint_times(painter: QPainter, top: float, axis: TimeAxis, theme: Theme, most: float) -> None:
    """Write marks of time below a height; the last one is whole, left of `most`, pixels."""
    spacing = next((s for s in SPACINGS if s / axis.seconds * axis.width >= LEAST_SPACING), SPACINGS[-1])
    for k in range(int(axis.start / spacing), int(axis.end / spacing) + 1):
        x = axis.x_of(k * spacing)
        if axis.left <= x <= axis.left + axis.width:
            painter.fillRect(QRectF(x, top, 1, 4), QColor(theme.faint))
            place = QRectF(min(x - 40, most - 62), top + 3, 80, TIME_HEIGHT - 3)
            draw_text(painter, place, _clock(k * spacing, spacing), theme.faint, SMALL, CENTRED)


def paint_wave(painter: QPainter, row: QRectF, peaks: Peaks, theme: Theme) -> None:
    """Paint the outline of a waveform, a column of which is a pixel, as high as its loudest sample lets it be."""
    n, height = len(peaks.low), max(3, round(row.height()))
    loudest = max(LEAST_LOUDNESS, float(np.nanmax([np.abs(peaks.low), np.abs(peaks.high), np.zeros(n)])))
    pixels = wave_pixels(peaks, loudest, height, QColor(theme.signal).rgb(), QColor(theme.base).rgb())
    place = QRectF(row.left(), row.top(), row.width(), height)  # scaled down, a line of one pixel would have gaps
    painter.drawImage(place, QImage(pixels.data, n, height, 4 * n, QImage.Format.Format_RGB32))


def wave_pixels(
    peaks: Peaks, loudest: float, height: int, colour: int | UInt32Array, background: int | UInt32Array
) -> UInt32Array:
    """Return the outline of a waveform, RGB, shape (height, n_columns); both colours may be those of each column."""
    middle = (height - 1) / 2
    scale = middle / loudest
    top, bottom = (np.nan_to_num(middle - values * scale, nan=-9.0) for values in (peaks.high, peaks.low))
    rows = np.arange(height)[:, np.newaxis]
    inside = (rows >= np.round(top)) & (rows <= np.round(bottom)) & ~np.isnan(peaks.low)
    return np.where(inside, colour, background).astype(np.uint32)


def _clock(seconds: float, spacing: float) -> str:
    """Write a time as finely as marks so far apart need it."""
    if spacing < 0.1:
        digits = 2 if spacing >= 0.01 else 3
        return f"{format_clock(seconds - seconds % 60, False)[:-2]}{seconds % 60:0{3 + digits}.{digits}f}"
    return format_clock(seconds, spacing < 1)


LEAST_WIDTH = 90
"""Pixels in which a name can be read while it is typed, however short the label is."""
_KEYS = {int(Qt.Key.Key_Return): 0, int(Qt.Key.Key_Enter): 0, int(Qt.Key.Key_Tab): 1, int(Qt.Key.Key_Backtab): -1}
"""Keys that end the typing, and the number of labels from it to the one that is named next; 0 for none."""


class LabelEditor(QLineEdit):
    """Lies over a label while its name is typed. Return takes the name, Tab names the next label, Escape cancels.

    Signals
    -------
    typed : the name, and how many labels further on another one is to be named.
    """

    typed = Signal(str, int)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._view = parent
        named(self, tr("Name of the label"))
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)  # over a label that is narrower than the field
        self.hide()

    def open_over(self, box: QRectF, name: str, *, begun: bool) -> None:
        """Ask for a name over a box; one that is `begun` is typed on, another one is selected, to be replaced."""
        place = QRect(0, 0, max(LEAST_WIDTH, round(box.width())), self.sizeHint().height())
        place.moveCenter(box.center().toPoint())
        room = self._view.rect()
        place.moveLeft(max(0, min(place.left(), room.right() - place.width())))
        place.moveTop(max(0, min(place.top(), room.bottom() - place.height())))
        self.setGeometry(place)
        self.setText(name)
        self.show()
        self.raise_()
        self.setFocus()
        if not begun:
            self.selectAll()

    @override
    def event(self, event: QEvent) -> bool:
        """Take the keys that end the typing before shortcuts and the change of focus do."""
        if isinstance(event, QKeyEvent) and event.key() in {*_KEYS, int(Qt.Key.Key_Escape)}:
            if event.type() == QEvent.Type.KeyPress:
                self._end(_KEYS.get(event.key()))
            event.accept()
            return True
        return super().event(event)

    @override
    def focusOutEvent(self, event: QFocusEvent) -> Any:
        """Take the name where the user goes on elsewhere, but not because of a menu of its own."""
        super().focusOutEvent(event)
        if self.isVisible() and event.reason() != Qt.FocusReason.PopupFocusReason:
            self._end(0)

    def _end(self, step: int | None) -> None:
        if not self.isVisible():
            return
        had_focus, name = self.hasFocus(), self.text()
        self.hide()
        if had_focus:
            self._view.setFocus()
        if step is not None:
            self.typed.emit(name, step)
