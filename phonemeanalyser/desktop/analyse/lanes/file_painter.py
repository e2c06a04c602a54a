"""How the view of a file is painted: sonagram, phonemes, labels, waveform, and the course of a variable."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QImage, QPaintEngine, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, FileLayout
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import AT_RIGHT, CENTRED, draw_text, mixed, set_size
from phonemeanalyser.desktop.session.formant_track import MOST_SECONDS
from phonemeanalyser.desktop.session.preset import USUAL_VARIABLE
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sonagram_tiles import Tile
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.lanes import (
    PHONEME_NAMES,
    lane_of_frames,
    paint_lane,
    paint_name,
    paint_times,
    paint_wave,
)
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

FREQUENCY_MARKS = (500, 1000, 2000, 4000, 6000, 8000)
LEVELS, PITCHES = (-80.0, 0.0), (0.0, 500.0)
"""Decibels and Hz of the sonagram's lower and upper edge, for the lines over it."""
FORMANT_COLOUR, PITCH_COLOUR, LEVEL_COLOUR = "#ff5050", "#50b4ff", "#ffe060"
"""As in Praat: red dots, a blue and a yellow line."""
OUTDATED = 0.43
"""How much of its colour is left of what was found with other settings."""
NOTE_ALPHA = 215
"""How opaque the ground of words over the sonagram is, 0..255."""
DOTS_APART = 3
"""Pixels between two dots of a formant at least."""
LETTERS_APART = 11
"""Pixels between two frequencies that are written."""


class FilePainter:
    """Paints what is seen of the file.

    Parameters
    ----------
    session : the file, and what is known of it.
    theme : the colours.
    layout : where things lie.
    widget : what is painted on.

    Attributes
    ----------
    variable : name of the variable whose course is drawn.
    """

    def __init__(self, session: Session, theme: Theme, layout: FileLayout, widget: QWidget) -> None:
        self._session, self._labels, self._view = session, session.labels, session.view
        self._theme, self._layout, self._widget = theme, layout, widget
        self.variable = USUAL_VARIABLE
        self._colours: UInt32Array = np.zeros(256, np.uint32)
        self._images: dict[int, tuple[Tile, tuple[float, float], QImage]] = {}
        self._lane_colours = _lane_colours(QColor(theme.base))
        self._names = [
            name if state is not FrameState.UNKNOWN else "" for state in FrameState for name in PHONEME_NAMES
        ]

    def set_colours(self, colours: UInt32Array) -> None:
        """Choose the colours of the levels, 256 RGB values."""
        self._colours = colours
        self._images = {}

    def paint(self, painter: QPainter, reading: str) -> None:
        """Paint all rows, what is selected, the place that is heard, and what lies under the mouse in words."""
        rows = self._layout.rows()
        for row in rows:
            painter.fillRect(row, QColor(self._theme.base))
        if self._view.duration <= 0:
            draw_text(painter, QRectF(self._widget.rect()), tr("no file"), self._theme.faint, 13, CENTRED)
            return
        self._paint_sonagram(painter, rows[0])
        tracks = self._session.whole.tracks
        if tracks is not None:
            self._paint_lane(painter, rows[LANE], tracks)
            if not self._session.seen.looks_back:
                self._paint_errors(painter, rows[LANE], tracks)
            self._paint_second(painter, rows[LANE])
            peaks = self._session.waveform.outline_in(self._view.seen, tracks.peaks, self._layout.width)
            paint_wave(painter, rows[2], peaks, self._theme)
            self._paint_course(painter, rows[3], tracks)
            self._paint_over(painter, rows[0], tracks)
        for row, lane in (*self._layout.label_lanes(), *self._layout.spoken_rows()):
            paint_name(painter, row, lane.name, self._theme)
            paint_lane(painter, row, lane, self._layout.axis, self._theme)
        paint_times(painter, rows[3].bottom(), self._layout.axis, self._theme, self._widget.width())
        self._paint_selection(painter, rows[3].bottom())
        x = self._layout.x_of(self._session.source.position)
        if LEFT <= x <= LEFT + self._layout.width and not self._session.seen.looks_back:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, rows[3].bottom()), QColor(self._theme.accent))
        if reading:
            self._paint_note(painter, rows[0], reading, above=True)

    def _paint_sonagram(self, painter: QPainter, row: QRectF) -> None:
        painter.save()
        painter.setClipRect(row)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        drawn = self._session.sonagram.tiles_for(self._view.seen, self._layout.width)
        self._images = {id(t.levels): known for t in drawn if (known := self._images.get(id(t.levels)))}
        for tile in drawn:
            image = self._image_of(tile)
            left, right = self._layout.x_of(tile.span.start), self._layout.x_of(tile.span.end)
            if painter.paintEngine().type() is QPaintEngine.Type.SVG:  # which does not clip
                image, left, right = _cut(image, left, right, row)
            painter.drawImage(QRectF(left, row.top(), right - left, row.height()), image)
        painter.restore()
        frequencies = self._session.sonagram.settings.frequencies
        shares = np.interp(FREQUENCY_MARKS, frequencies, np.linspace(0, 1, len(frequencies)), -1, -1).tolist()
        below = row.bottom() + LETTERS_APART
        for mark, share in zip(FREQUENCY_MARKS, shares, strict=True):
            y = row.bottom() - share * row.height()
            if share >= 0 and row.top() + 6 < y <= below - LETTERS_APART:
                below = y
                painter.fillRect(QRectF(LEFT - 4, y, 4, 1), QColor(self._theme.faint))
                place = QRectF(0, y - 7, LEFT - 7, 14)
                draw_text(painter, place, f"{mark} Hz", self._theme.faint, 10, AT_RIGHT)

    def _image_of(self, tile: Tile) -> QImage:
        low, high = self._session.sonagram.level_range
        known = self._images.get(id(tile.levels))
        if known is not None and known[1] == (low, high):
            return known[2]
        scaled = (tile.levels.astype(np.float32) - low) * (255 / max(high - low, 1e-6))
        pixels = np.ascontiguousarray(self._colours[np.clip(scaled, 0, 255).astype(np.uint8)].T[::-1])
        n_rows, n = pixels.shape
        image = QImage(pixels.data, n, n_rows, 4 * n, QImage.Format.Format_RGB32).copy()
        self._images[id(tile.levels)] = tile, (low, high), image
        return image

    def _paint_lane(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        first, last = self._frames_seen(tracks)
        codes = tracks.states[first:last].astype(np.intp) * len(Phoneme) + tracks.phonemes[first:last]
        lane = lane_of_frames("", codes, self._names, self._lane_colours, first=first)
        paint_lane(painter, row, lane, self._layout.axis, self._theme)

    def _paint_second(self, painter: QPainter, first: QRectF) -> None:
        """Paint what the second preset hears, and the names of both."""
        row, tracks = self._layout.second_row(), self._session.second.whole.tracks
        if row is None:
            return
        painter.fillRect(row, QColor(self._theme.base))
        if tracks is not None:
            self._paint_lane(painter, row, tracks)
        for place, name in zip((first, row), self._session.second.names, strict=True):
            paint_name(painter, place, name, self._theme)

    def _paint_errors(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        """Hatch where something else was recognised than the labels say."""
        seen = self._view.seen
        brush = QBrush(QColor(0, 0, 0, 170), Qt.BrushStyle.BDiagPattern)
        for error in self._labels.errors(tracks):
            if error.start < seen.end and seen.start < error.end:
                left, right = (self._layout.x_of(min(max(t, seen.start), seen.end)) for t in (error.start, error.end))
                painter.fillRect(QRectF(left, row.top(), right - left, row.height()), brush)

    def _paint_course(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        first, last = self._frames_seen(tracks)
        features = tracks.features
        if self.variable not in features.names or last - first < 2:
            return
        values = features[self.variable][first:last]
        values = np.where(tracks.states[first:last] == FrameState.UNKNOWN, np.nan, values)
        if not np.isfinite(values).any():
            return
        low, high = min(0.0, float(np.nanmin(values))), float(np.nanmax(values))
        inner = row.adjusted(0, 2, 0, -2)
        painter.setPen(QPen(QColor(self._theme.signal), 1))
        for line in self._line_in(inner, values, first, (low, high)):
            painter.drawPolyline(line)
        for value, y in ((high, row.top()), (low, row.bottom() - 14)):
            draw_text(painter, QRectF(0, y, LEFT - 7, 14), f"{value:.3g}", self._theme.faint, 10, AT_RIGHT)

    def _line_in(
        self, row: QRectF, values: Float32Array, first: int, scale: tuple[float, float], *, usual: bool = False
    ) -> tuple[QPolygonF, ...]:
        """Return the course of values of the frames from one on, between two values at the row's edges.

        Far from near, it is that of their extremes, or of the `usual` values.
        """
        seen, (low, high) = self._view.seen, scale
        course = usual_course_of if usual else course_of
        times, heights = course(values, first, seen, self._layout.width)
        x = LEFT + (times - seen.start) / max(seen.seconds, 1e-9) * self._layout.width
        return broken_line(x, row.bottom() - (heights - low) / max(high - low, 1e-12) * row.height())

    def _paint_over(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        """Paint formants as dots, and pitch and level as lines on scales of their own."""
        painter.save()
        painter.setClipRect(row)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        first, last = self._frames_seen(tracks)
        features = tracks.features
        if "level" in self._layout.shows and "volume" in features.names:
            levels = 20 * np.log10(np.maximum(features["volume"][first:last], 1e-6))
            self._paint_line(painter, row, first, levels, LEVELS, LEVEL_COLOUR)
        if "pitch" in self._layout.shows and "f0" in features.names:
            pitch = features["f0"][first:last]
            self._paint_line(painter, row, first, np.where(pitch > 0, pitch, np.nan), PITCHES, PITCH_COLOUR)
        known = self._session.formants.formants_in(self._view.seen) if "formants" in self._layout.shows else None
        if known is not None:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(FORMANT_COLOUR))
            begin, end = max(0, first - known.first), min(len(known.frequencies), last - known.first)
            per_dot = max(1, math.ceil(DOTS_APART / self._layout.width * self._view.seen.seconds / FRAME_PERIOD))
            frequencies = usual_of(known.frequencies[begin:end], per_dot, begin + known.first)
            for k, formants in enumerate(frequencies.tolist(), (begin + known.first) // per_dot):
                x = self._layout.x_of((k + 0.5) * per_dot * FRAME_PERIOD)
                for frequency in formants:
                    if not math.isnan(frequency):
                        painter.drawEllipse(QPointF(x, self._y_of(frequency, row)), 1.6, 1.6)
        if "formants" in self._layout.shows and self._view.seen.seconds > MOST_SECONDS:
            words = tr("Formants: zoom in to {n:.0f} s or less").format(n=MOST_SECONDS)
            self._paint_note(painter, row, words, above=False)
        painter.restore()

    def _paint_note(self, painter: QPainter, row: QRectF, words: str, *, above: bool) -> None:
        """Write words over a row: at its right upper edge, or at its left lower one."""
        set_size(painter, 11)
        width = painter.fontMetrics().horizontalAdvance(words) + 14
        left, top = (row.right() - width - 4, row.top() + 4) if above else (row.left() + 4, row.bottom() - 22)
        box, background = QRectF(left, top, width, 18), QColor(self._theme.base)
        background.setAlpha(NOTE_ALPHA)
        painter.fillRect(box, background)
        draw_text(painter, box, words, self._theme.text, 11, CENTRED)

    def _paint_line(
        self,
        painter: QPainter,
        row: QRectF,
        first: int,
        values: Float32Array,
        scale: tuple[float, float],
        colour: str,
    ) -> None:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for pen in (QPen(QColor(0, 0, 0, 150), 3), QPen(QColor(colour), 1.6)):  # seen on every colour
            painter.setPen(pen)
            for line in self._line_in(row, values, first, scale, usual=True):
                painter.drawPolyline(line)

    def _y_of(self, frequency: float, row: QRectF) -> float:
        frequencies = self._session.sonagram.settings.frequencies
        share = float(np.interp(frequency, frequencies, np.linspace(0, 1, len(frequencies)), -1, 2))
        return row.bottom() - share * row.height()

    def _paint_selection(self, painter: QPainter, bottom: float) -> None:
        selection = self._view.selection
        if selection is None:
            return
        left, right = (min(max(self._layout.x_of(t), LEFT), LEFT + self._layout.width) for t in selection)
        colour = QColor(self._theme.accent)
        colour.setAlpha(60)
        painter.fillRect(QRectF(left, 0, right - left, bottom), colour)

    def _frames_seen(self, tracks: SoundTracks) -> tuple[int, int]:
        seen = self._view.seen
        return max(0, int(seen.start / FRAME_PERIOD)), min(tracks.n_frames, int(seen.end / FRAME_PERIOD) + 1)


def _lane_colours(base: QColor) -> UInt32Array:
    """Return the colours of all phonemes by state: none where nothing is known, paler where that is outdated."""
    shares = {FrameState.UNKNOWN: 0.0, FrameState.OUTDATED: OUTDATED, FrameState.KNOWN: 1.0}
    colours = [mixed(QColor(PHONEME_COLOURS[p]), base, shares[state]) for state in FrameState for p in Phoneme]
    return np.array([colour.rgb() for colour in colours], np.uint32)


def _cut(image: QImage, left: float, right: float, row: QRectF) -> tuple[QImage, float, float]:
    """Return the columns of an image between two places that lie within a row, and between which places these lie."""
    column = (right - left) / image.width()
    first = max(0, math.ceil((row.left() - left) / column))
    last = min(image.width(), math.floor((row.right() - left) / column))
    return image.copy(first, 0, max(1, last - first), image.height()), left + first * column, left + last * column


# The course of a variable: as many points as pixels, however many frames lie under each.


def course_of(values: Float32Array, first: int, seen: TimeSpan, n_columns: int) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as a line: times in seconds, and values; NaN where it is broken.

    Where several frames lie under a column, it goes through the lowest and the highest of them: no peak is lost.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n,).
    """
    times: Float64Array = (first + np.arange(len(values), dtype=np.float64) + 0.5) * FRAME_PERIOD
    if len(values) <= 2 * n_columns:
        return times, values.astype(np.float64)
    columns = ((times - seen.start) / seen.seconds * n_columns).astype(np.int64)
    starts = np.concatenate(([0], np.flatnonzero(np.diff(columns)) + 1))
    low, high = np.fmin.reduceat(values, starts), np.fmax.reduceat(values, starts)
    middle: Float64Array = np.repeat(seen.start + (columns[starts] + 0.5) / n_columns * seen.seconds, 2)
    return middle, np.stack((low, high), axis=1).ravel().astype(np.float64)


def usual_course_of(
    values: Float32Array, first: int, seen: TimeSpan, n_columns: int
) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as one line, however many frames lie under a column: see `usual_of`.

    Times in seconds, and values; NaN where it is broken. Parameters are those of `course_of`.
    """
    per_point = max(1, int(np.ceil(seen.seconds / FRAME_PERIOD / n_columns)))
    usual = usual_of(values[:, np.newaxis], per_point, first)[:, 0]
    times: Float64Array = (
        (first // per_point + np.arange(len(usual), dtype=np.float64) + 0.5) * per_point * FRAME_PERIOD
    )
    return times, usual.astype(np.float64)


def usual_of(values: Float32Array, n: int, first: int) -> Float32Array:
    """Return the median of every `n` frames, shape (n_groups, n_values); NaN where most of them have no value.

    Groups begin at multiples of `n`, so that they stay the same while the view scrolls.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n_frames, n_values).
    """
    if n == 1 or not len(values):
        return values
    before, after = first % n, -(first + len(values)) % n
    groups = np.pad(values, ((before, after), (0, 0)), constant_values=np.nan).reshape(-1, n, values.shape[1])
    known = np.isfinite(groups).sum(axis=1)
    groups = np.sort(groups, axis=1)  # NaN comes last
    middle = np.take_along_axis(groups, np.maximum(known - 1, 0)[:, np.newaxis] // 2, axis=1)[:, 0]
    return np.where(2 * known >= n, middle, np.float32(np.nan)).astype(np.float32)
