"""How the view of a file is painted: sonagram, phonemes, labels, waveform, and the course of a variable."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QPaintEngine, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.course_lanes import CourseLanes
from phonemeanalyser.desktop.analyse.lanes.feeling_lane import paint_feeling_scale, paint_feelings
from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, FileLayout
from phonemeanalyser.desktop.analyse.lanes.sonagram import Overlaid, SonagramPainter
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import A
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import CENTRED, PHONEME_COLOURS, Theme, draw_text, mixed
from phonemeanalyser.desktop.widgets import lanes
from phonemeengine.arrays import UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

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
