"""How the view of a file is painted: sonagram, phonemes, labels, waveform, and the lanes of variables' courses."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QPaintEngine, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.feeling_lane import paint_feeling_scale, paint_feelings
from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, FileLayout
from phonemeanalyser.desktop.analyse.lanes.sonagram import Overlaid, SonagramPainter
from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.courses import Courses, ThresholdLine
from phonemeanalyser.desktop.session.preset import A
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import AT_RIGHT, CENTRED, PHONEME_COLOURS, Theme, draw_text, mixed, set_size
from phonemeanalyser.desktop.widgets import lanes
from phonemeanalyser.desktop.widgets.distribution import short
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import values_of
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

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


OUTDATED = 0.43
"""How much of its colour is left of what was found with other settings."""
SAMPLES_APART, DOTTED_APART = 0.5, 2.5
"""Pixels between two samples from which on a line joins them, and each is a dot."""


class FilePainter:
    """Paints what is seen of the file; all but selection, playhead and reading is kept as a picture until it changes.

    Parameters
    ----------
    session : the file, and what is known of it.
    theme : the colours.
    layout : where things lie.
    courses : the variables below the waveform.
    widget : what is painted on.

    Attributes
    ----------
    sonagram : paints the sonagram.
    """

    def __init__(
        self, session: Session, theme: Theme, layout: FileLayout, courses: CourseLanes, widget: QWidget
    ) -> None:
        self._session, self._labels, self._view = session, session.labels, session.view
        self._theme, self._layout, self._courses, self._widget = theme, layout, courses, widget
        self.sonagram = SonagramPainter(session.sonagram, theme)
        self._lane_colours = _lane_colours(QColor(theme.base))
        self._names = [
            name if state is not FrameState.UNKNOWN else "" for state in FrameState for name in lanes.names_in_lanes()
        ]
        self._picture = QPixmap()
        self._shows: tuple[object, ...] = ()
        self._courses_differ = False

    def renew(self, *, courses_only: bool = False) -> None:
        """Paint the rows anew the next time, or only the courses."""
        self._courses_differ |= courses_only
        self._shows = self._shows if courses_only else ()

    def paint(self, painter: QPainter, reading: str) -> None:
        """Paint all rows, the selection, the playhead, and a reading."""
        rows = self._layout.rows()
        if self._view.duration <= 0:
            draw_text(painter, QRectF(self._widget.rect()), tr("No file"), self._theme.faint, 13, CENTRED)
            return
        if painter.paintEngine().type() is QPaintEngine.Type.SVG:  # lines, as they are asked for, and no pixels
            self._paint_rows(painter, rows)
        else:
            painter.drawPixmap(0, 0, self._picture_of_rows(rows))
        self._paint_selection(painter, rows[3].bottom())
        x = self._layout.x_of(self._session.source.position)
        if LEFT <= x <= LEFT + self._layout.width and not self._session.seen.looks_back:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, rows[3].bottom()), QColor(self._theme.accent))
        if reading:
            self.sonagram.paint_note(painter, rows[0], reading, above=True)

    def _picture_of_rows(self, rows: tuple[QRectF, ...]) -> QPixmap:
        """Return the picture of all rows: the one that is kept, as far as it shows what is known now."""
        session, widget = self._session, self._widget
        tracks, ratio, ground = session.whole.tracks, widget.devicePixelRatioF(), widget.palette().window()
        known = None if tracks is None else (id(tracks), tracks.n_written)
        sides = session.preset.letter, session.second.names
        shows = (widget.size(), ratio, ground.color(), self._view.seen, known, session.seen.looks_back, sides)
        if shows == self._shows and not self._courses_differ:
            return self._picture
        is_new = shows != self._shows
        self._shows, self._courses_differ = shows, False
        if is_new:
            self._picture = QPixmap((widget.size() * ratio).expandedTo(QSize(1, 1)))
            self._picture.setDevicePixelRatio(ratio)
        painter = QPainter(self._picture)
        try:
            painter.setFont(widget.font())
            top = 0.0 if is_new else rows[3].top()
            painter.fillRect(QRectF(0, top, widget.width(), widget.height() - top), ground)
            self._paint_rows(painter, rows, courses_only=not is_new)
        finally:
            painter.end()
        return self._picture

    def _paint_rows(self, painter: QPainter, rows: tuple[QRectF, ...], *, courses_only: bool = False) -> None:
        if not courses_only:
            self._paint_above(painter)
        self._courses.paint(painter, self._session.whole.tracks)
        lanes.paint_times(painter, rows[3].bottom(), self._layout.axis, self._theme, self._widget.width())

    def _paint_above(self, painter: QPainter) -> None:
        """Paint the rows above the courses."""
        rows, tracks = self._layout.rows(), self._session.whole.tracks
        for row in rows[:3]:
            painter.fillRect(row, QColor(self._theme.base))
        self._paint_sonagram(painter, rows[0])
        if tracks is not None:
            self._paint_recognised(painter, rows[LANE], tracks)
            peaks = self._session.waveform.outline_in(self._view.seen, tracks.peaks, self._layout.width)
            lanes.paint_wave(painter, rows[2], peaks, self._theme)
            self._paint_samples(painter, rows[2])
            self._paint_over(painter, rows[0], tracks)
        for row, lane in (*self._layout.label_lanes(), *self._layout.spoken_rows()):
            lanes.paint_name(painter, row, lane.name, self._theme)
            lanes.paint_lane(painter, row, lane, self._layout.axis, self._theme)
        if (feeling := self._layout.feeling_row()) is not None:
            known = self._session.feelings.feelings_in(self._view.seen)
            paint_feelings(painter, feeling, self._layout.axis, known, self._theme)
            paint_feeling_scale(painter, feeling, self._theme)

    def _paint_sonagram(self, painter: QPainter, row: QRectF) -> None:
        tiles = self._session.sonagram.tiles_for(self._view.seen, self._layout.width)
        self.sonagram.paint_tiles(painter, row, self._layout.axis, tiles)
        self.sonagram.paint_side(painter, row)
        self.sonagram.paint_marks(painter, row, self._theme.faint, LEFT - 7)

    def _paint_over(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        first, last = self._frames_seen(tracks)
        wanted = "formants" in self._session.sonagram.overlays
        formants = self._session.formants.formants_in(self._view.seen) if wanted else None
        over = Overlaid(first, tracks.features.part(slice(first, last)), formants)
        self.sonagram.paint_over(painter, row, self._layout.axis, over)

    def _paint_lane(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        first, last = self._frames_seen(tracks)
        codes = tracks.states[first:last].astype(np.intp) * len(Phoneme) + tracks.phonemes[first:last]
        lane = lanes.lane_of_frames("", codes, self._names, self._lane_colours, first=first)
        lanes.paint_lane(painter, row, lane, self._layout.axis, self._theme)

    def _paint_recognised(self, painter: QPainter, first: QRectF, tracks: SoundTracks) -> None:
        """Paint what is recognised; with a second preset that of A above that of B, and a mark at the one in use."""
        second, other = self._layout.second_row(), self._session.second.whole.tracks
        here, there = (first, second) if self._session.preset.letter == A else (second or first, first)
        self._paint_lane(painter, here, tracks)
        if not self._session.seen.looks_back:
            self._paint_errors(painter, here, tracks)
        if second is None:
            return
        painter.fillRect(there or second, QColor(self._theme.base))
        if other is not None:
            self._paint_lane(painter, there or second, other)
        for place, name in zip((first, second), self._session.second.names, strict=True):
            lanes.paint_name(painter, place, name, self._theme)
        painter.fillRect(QRectF(LEFT - 4, here.top(), 3, here.height()), QColor(self._theme.accent))

    def _paint_errors(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        """Hatch where something else was recognised than the labels say; errors in one pixel are one."""
        seen, axis = self._view.seen, self._layout.axis
        times = self._labels.error_spans(tracks) * FRAME_PERIOD
        times = np.clip(times[(times[:, 0] < seen.end) & (times[:, 1] > seen.start)], seen.start, seen.end)
        if not len(times):
            return
        lefts, rights = (axis.left + (times - axis.start) / axis.seconds * axis.width).T
        apart = lefts[1:] - rights[:-1] >= 1
        brush = QBrush(QColor(0, 0, 0, 170), Qt.BrushStyle.BDiagPattern)
        for left, right in zip(lefts[np.append(True, apart)], rights[np.append(apart, True)], strict=True):
            painter.fillRect(QRectF(left, row.top(), right - left, row.height()), brush)

    def _paint_samples(self, painter: QPainter, row: QRectF) -> None:
        """Paint single samples, joined by a line, where they are far enough apart; farther, as dots."""
        apart = self._layout.width / max(self._view.seen.seconds, 1e-9) / SAMPLE_RATE
        known = self._session.waveform.samples_in(self._view.seen) if apart >= SAMPLES_APART else None
        if known is None or not len(known[1]):
            return
        first, samples = known
        loudest = max(lanes.LEAST_LOUDNESS, float(np.abs(samples).max()))
        x = LEFT + ((first + np.arange(len(samples))) / SAMPLE_RATE - self._view.seen.start) * SAMPLE_RATE * apart
        y = row.center().y() - samples * (row.height() / 2 - 1) / loudest
        places = [QPointF(*place) for place in zip(x.tolist(), y.tolist(), strict=True)]
        painter.save()
        painter.setClipRect(row)
        painter.fillRect(row, QColor(self._theme.base))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(self._theme.signal), 1))
        painter.setBrush(QColor(self._theme.signal))
        painter.drawPolyline(QPolygonF(places))
        for place in places if apart >= DOTTED_APART else ():
            painter.drawEllipse(place, 1.5, 1.5)
        painter.restore()

    def _paint_selection(self, painter: QPainter, bottom: float) -> None:
        selection = self._view.selection
        if selection is None:
            return
        left, right = (min(max(self._layout.x_of(t), LEFT), LEFT + self._layout.width) for t in selection)
        colour = QColor(self._theme.accent)
        colour.setAlpha(60)
        painter.fillRect(QRectF(left, 0, right - left, bottom), colour)
        for edge, inside in ((left, 1), (right, -1)):  # light beside dark: seen on every colour
            painter.fillRect(QRectF(edge - 0.5, 0, 1, bottom), QColor("white"))
            painter.fillRect(QRectF(edge - 0.5 - inside, 0, 1, bottom), QColor("black"))

    def _frames_seen(self, tracks: SoundTracks) -> tuple[int, int]:
        seen = self._view.seen
        return max(0, int(seen.start / FRAME_PERIOD)), min(tracks.n_frames, int(seen.end / FRAME_PERIOD) + 1)


def _lane_colours(base: QColor) -> UInt32Array:
    """Return the colours of all phonemes by state: none where nothing is known, paler where that is outdated."""
    shares = {FrameState.UNKNOWN: 0.0, FrameState.OUTDATED: OUTDATED, FrameState.KNOWN: 1.0}
    colours = [mixed(QColor(PHONEME_COLOURS[p]), base, shares[state]) for state in FrameState for p in Phoneme]
    return np.array([colour.rgb() for colour in colours], np.uint32)
