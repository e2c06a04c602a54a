"""The lanes of courses: variables over time, one below the other, with thresholds that can be dragged."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from phonemeanalyser.desktop.analyse.lanes.file_layout import LEFT, FileLayout
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.courses import Courses, ThresholdLine
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import AT_RIGHT, CENTRED, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.distribution import short
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.inspection.whole_sound import SoundTracks
from phonemeengine.recognition.scores import values_of
from phonemeengine.settings import FRAME_PERIOD

NEAR = 4
"""Pixels by which a press may miss a threshold."""
HEADROOM = 0.08
"""Share of a lane that is left empty above the greatest value."""
LETTERS = 10
"""Height of what is written in a lane, pixels."""
SMALL = 34
"""Pixels of height below which a lane has its short name at its left, and no words over its curve."""
GROUND_ALPHA = 190
"""How opaque the ground of a variable's name is, 0..255."""


class HeldLine(NamedTuple):
    """A threshold that is dragged: the variable in whose lane it lies, and the control's name."""

    variable: str
    name: str


@dataclass(frozen=True)
class Course:
    """A variable as it is drawn: polygons in pixels, and the values at the lower and the upper edge of its lane."""

    polygons: tuple[QPolygonF, ...]
    low: float
    high: float


class CourseLanes:
    """Paints the courses, and says which threshold lies where.

    A course is kept until something else is seen or measured, so that a threshold that is dragged moves by itself.
    """

    def __init__(self, session: Session, courses: Courses, theme: Theme, layout: FileLayout) -> None:
        self._session, self._courses, self._theme, self._layout = session, courses, theme, layout
        self._kept: dict[str, tuple[object, Course | None]] = {}

    def rows(self) -> dict[str, QRectF]:
        """Return where each variable has its lane."""
        variables, room = self._courses.variables, self._layout.rows()[-1]
        height = (room.height() + 1) / len(variables)
        return {
            name: QRectF(room.left(), room.top() + k * height, room.width(), height - 1)
            for k, name in enumerate(variables)
        }

    def paint(self, painter: QPainter, tracks: SoundTracks | None) -> None:
        """Paint all lanes."""
        for variable, row in self.rows().items():
            painter.fillRect(row, QColor(self._theme.base))
            course = None if tracks is None else self._course_of(variable, row, tracks)
            if course is None:
                words = tr("Not measured yet") if self._session.whole.busy else tr("Not measured in this sound")
                draw_text(painter, row, words, self._theme.faint, LETTERS, CENTRED)
            else:
                self._paint_course(painter, row, course)
                self._paint_lines(painter, variable, row, course)
            self._paint_name(painter, variable, row)

    def line_at(self, place: QPointF) -> HeldLine | None:
        """Return the threshold that lies at a place; of several, the nearest."""
        tracks = self._session.whole.tracks
        variable = self.variable_at(place)
        course = (
            None if variable is None or tracks is None else self._course_of(variable, self.rows()[variable], tracks)
        )
        if variable is None or course is None:
            return None
        row = self.rows()[variable]
        apart = {
            line.name: abs(_y_of(line.value, row, course) - place.y())
            for line in self._courses.lines.lines_of(variable)
        }
        nearest = min(apart, key=lambda name: (apart[name], name != self._courses.control), default="")
        return HeldLine(variable, nearest) if apart.get(nearest, NEAR + 1) <= NEAR else None

    def variable_at(self, place: QPointF) -> str | None:
        """Return the variable in whose lane a place lies."""
        return next((name for name, row in self.rows().items() if row.contains(place)), None)

    def drag(self, held: HeldLine, y: float) -> None:
        """Move a threshold to a height, pixels."""
        tracks, row = self._session.whole.tracks, self.rows().get(held.variable)
        course = None if tracks is None or row is None else self._course_of(held.variable, row, tracks)
        if course is not None and row is not None:
            share = min(max((row.bottom() - y) / row.height(), 0.0), 1.0)
            self._courses.lines.move(held.name, course.low + share * (course.high - course.low))

    def _course_of(self, variable: str, row: QRectF, tracks: SoundTracks) -> Course | None:
        """Return a course as it is drawn now; None where nothing of it is measured."""
        seen, sensitivities = self._session.view.seen, self._session.preset.in_force.sensitivities
        known = tracks.n_written, tracks.names, tuple(sensitivities.items())
        key = (id(tracks), *known, seen, row.left(), row.top(), row.width(), row.height())
        kept = self._kept.get(variable)
        if kept is None or kept[0] != key:
            # with a frame on either side, to which the line leads, also where less than one is seen
            first, last = max(0, int(seen.start / FRAME_PERIOD) - 1), int(seen.end / FRAME_PERIOD) + 2
            values = values_of(tracks.features.part(slice(first, last)), variable, sensitivities)
            self._kept = {name: of for name, of in self._kept.items() if name in self._courses.variables}
            kept = self._kept[variable] = key, None if values is None else self._drawn(values, first, seen, row)
        return kept[1]

    def _drawn(self, values: Float32Array, first: int, seen: TimeSpan, row: QRectF) -> Course | None:
        times, heights = course_of(values, first, seen, self._layout.width)
        if len(values) < 2 or not np.isfinite(heights).any():
            return None
        low, high = min(0.0, float(np.nanmin(heights))), float(np.nanmax(heights))
        high += HEADROOM * max(high - low, 1e-12)
        x = LEFT + (times - seen.start) / max(seen.seconds, 1e-9) * self._layout.width
        return Course(broken_line(x, row.bottom() - (heights - low) / (high - low) * row.height()), low, high)

    def _paint_course(self, painter: QPainter, row: QRectF, course: Course) -> None:
        painter.setPen(QPen(QColor(self._theme.signal), 1))
        painter.save()
        painter.setClipRect(row, Qt.ClipOperation.IntersectClip)
        for polygon in course.polygons:
            painter.drawPolyline(polygon)
        painter.restore()
        edges = ((course.high, row.top()), (course.low, row.bottom() - 12))
        for value, y in edges if row.height() >= SMALL else ():
            draw_text(painter, QRectF(0, y, LEFT - 7, 12), short(value), self._theme.faint, LETTERS, AT_RIGHT)

    def _paint_lines(self, painter: QPainter, variable: str, row: QRectF, course: Course) -> None:
        """Paint the thresholds, the one that was touched bold, each with its value where there is room."""
        lines = self._courses.lines.lines_of(variable)
        taken: list[float] = []
        for line in sorted(lines, key=lambda line: line.name != self._courses.control):
            touched, y = line.name == self._courses.control, _y_of(line.value, row, course)
            style = Qt.PenStyle.SolidLine if touched else Qt.PenStyle.DashLine
            painter.setPen(QPen(QColor(self._theme.bad), 2 if touched else 1, style))
            painter.drawLine(QPointF(row.left(), y), QPointF(row.right(), y))
            middle = min(max(y - 7, row.top() + 5), row.bottom() - 5)
            has_room = touched or row.height() >= SMALL
            if has_room and all(abs(middle - other) > LETTERS for other in taken):
                taken.append(middle)
                self._paint_words(painter, _words_of(line), self._theme.bad, row.right() - 2, middle - 6)

    def named(self, variable: str) -> str:
        """Return what a variable measures, and its short name."""
        words = self._courses.lines.words_of(variable)
        return words if words == variable else f"{words}  ·  {variable}"

    def _paint_name(self, painter: QPainter, variable: str, row: QRectF) -> None:
        more = ""
        if self._courses.n_more and variable == self._courses.variables[-1]:
            more = tr("{n} further variables of these rules").format(n=self._courses.n_more)
        if row.height() < SMALL:
            place = QRectF(0, row.top(), LEFT - 4, row.height())
            draw_text(painter, place, variable, self._theme.text, LETTERS - 1, AT_RIGHT)
        else:
            more = "  ·  ".join([self.named(variable), *([more] if more else [])])
        if more:
            self._paint_words(painter, more, self._theme.text, None, row.top() + 1)

    def _paint_words(self, painter: QPainter, words: str, colour: str, right: float | None, top: float) -> None:
        """Write words on a ground of their own, to the left of a place, or at the left edge."""
        set_size(painter, LETTERS)
        width = painter.fontMetrics().horizontalAdvance(words) + 6
        box = QRectF(LEFT + 2 if right is None else right - width, top, width, 13)
        ground = QColor(self._theme.base)
        ground.setAlpha(GROUND_ALPHA)
        painter.fillRect(box, ground)
        painter.setPen(QColor(colour))
        painter.drawText(box, CENTRED, words)


def _y_of(value: float, row: QRectF, course: Course) -> float:
    """Return where a value lies, pixels; what lies beyond the lane is at its edge."""
    share = (value - course.low) / (course.high - course.low)
    return min(max(row.bottom() - share * row.height(), row.top() + 1), row.bottom() - 1)


def _words_of(line: ThresholdLine) -> str:
    sign = "" if line.label.startswith(("<", ">")) else f"{line.sign} "
    return f"{tr_engine(line.label)}  {sign}{short(line.value)}"


# The course of a variable: as many points as pixels, however many frames lie under each.


def course_of(values: Float32Array, first: int, seen: TimeSpan, n_columns: int) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as a line: times in seconds, and values; NaN where it is broken.

    Where several frames lie under a column, it goes through the lowest and the highest of them: no peak is lost.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n,).
    """
    if len(values) <= 2 * n_columns:
        times: Float64Array = (first + np.arange(len(values), dtype=np.float64) + 0.5) * FRAME_PERIOD
        return times, values.astype(np.float64)
    # the first frame whose middle lies in each column: a column holds several, so no two begin with the same
    begins = (seen.start + np.arange(n_columns + 1) / n_columns * seen.seconds) / FRAME_PERIOD - 0.5 - first
    starts = np.clip(np.ceil(begins - 1e-6).astype(np.int64), 0, len(values))
    columns = np.flatnonzero(starts[1:] > starts[:-1])
    places, end = starts[:-1][columns], int(starts[-1])
    low, high = np.fmin.reduceat(values[:end], places), np.fmax.reduceat(values[:end], places)
    middles: Float64Array = np.repeat(seen.start + (columns + 0.5) / n_columns * seen.seconds, 2)
    return middles, np.stack((low, high), axis=1).ravel().astype(np.float64)
