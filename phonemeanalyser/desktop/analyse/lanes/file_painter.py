"""How the view of a file is painted: sonagram, phonemes, labels, waveform, and the course of a variable."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QImage, QPaintEngine, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.course_lanes import CourseLanes
from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, RIGHT, FileLayout
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import AT_LEFT, AT_RIGHT, CENTRED, draw_text, mixed, set_size
from phonemeanalyser.desktop.session.formant_track import MOST_SECONDS
from phonemeanalyser.desktop.session.preset import A
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sonagram_tiles import Tile
from phonemeanalyser.desktop.session.time_view import TimeSpan
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.lanes import (
    LEAST_LOUDNESS,
    lane_of_frames,
    names_in_lanes,
    paint_lane,
    paint_name,
    paint_times,
    paint_wave,
)
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

FREQUENCY_MARKS = (500, 1000, 2000, 4000, 6000, 8000)
LEVELS, PITCHES = (-80.0, 0.0), (0.0, 500.0)
"""Decibels and Hz of the sonagram's lower and upper edge, for the lines on top of it."""
FORMANT_COLOUR, PITCH_COLOUR, LEVEL_COLOUR = "#ff5050", "#50b4ff", "#ffe060"
"""As in Praat: red dots, a blue and a yellow line."""
OUTDATED = 0.43
"""How much of its colour is left of what was found with other settings."""
NOTE_ALPHA = 215
"""How opaque the ground of words over the sonagram is, 0..255."""
DOTS_APART = 3
"""Pixels between two dots of a formant at least."""
SAMPLES_APART, DOTTED_APART = 0.5, 2.5
"""Pixels between two samples from which on a line joins them, and each is a dot."""
BAR_GAP, BAR_WIDTH, SCALE_WIDTH = 5, 8, 42
"""Pixels beside the sonagram, of its bar of colours, and of a scale on top of it."""
LETTERS_APART = 11
"""Pixels between two frequencies that are written."""


class FilePainter:
    """Paints what is seen of the file.

    Parameters
    ----------
    session : the file, and what is known of it.
    theme : the colours.
    layout : where things lie.
    courses : the variables below the waveform.
    widget : what is painted on.
    """

    def __init__(
        self, session: Session, theme: Theme, layout: FileLayout, courses: CourseLanes, widget: QWidget
    ) -> None:
        self._session, self._labels, self._view = session, session.labels, session.view
        self._theme, self._layout, self._courses, self._widget = theme, layout, courses, widget
        self._colours: UInt32Array = np.zeros(256, np.uint32)
        self._images: dict[int, tuple[Tile, tuple[float, float], QImage]] = {}
        self._lane_colours = _lane_colours(QColor(theme.base))
        self._names = [
            name if state is not FrameState.UNKNOWN else "" for state in FrameState for name in names_in_lanes()
        ]

    def set_colours(self, colours: UInt32Array) -> None:
        """Choose the colours of the levels, 256 RGB values."""
        self._colours = colours
        self._images = {}

    def paint(self, painter: QPainter, reading: str, exposed: QRect) -> None:
        """Paint all rows, or the courses if no more is exposed, the selection, the playhead, and a reading."""
        rows = self._layout.rows()
        if self._view.duration <= 0:
            draw_text(painter, QRectF(self._widget.rect()), tr("No file"), self._theme.faint, 13, CENTRED)
            return
        if exposed.top() < rows[3].top() - 1:
            self._paint_above(painter)
        self._courses.paint(painter, self._session.whole.tracks)
        paint_times(painter, rows[3].bottom(), self._layout.axis, self._theme, self._widget.width())
        self._paint_selection(painter, rows[3].bottom())
        x = self._layout.x_of(self._session.source.position)
        if LEFT <= x <= LEFT + self._layout.width and not self._session.seen.looks_back:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, rows[3].bottom()), QColor(self._theme.accent))
        if reading:
            self._paint_note(painter, rows[0], reading, above=True)

    def _paint_above(self, painter: QPainter) -> None:
        """Paint the rows above the courses."""
        rows, tracks = self._layout.rows(), self._session.whole.tracks
        for row in rows[:3]:
            painter.fillRect(row, QColor(self._theme.base))
        self._paint_sonagram(painter, rows[0])
        if tracks is not None:
            self._paint_recognised(painter, rows[LANE], tracks)
            peaks = self._session.waveform.outline_in(self._view.seen, tracks.peaks, self._layout.width)
            paint_wave(painter, rows[2], peaks, self._theme)
            self._paint_samples(painter, rows[2])
            self._paint_over(painter, rows[0], tracks)
        for row, lane in (*self._layout.label_lanes(), *self._layout.spoken_rows()):
            paint_name(painter, row, lane.name, self._theme)
            paint_lane(painter, row, lane, self._layout.axis, self._theme)

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
        self._paint_colour_bar(painter, row)
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

    def _paint_colour_bar(self, painter: QPainter, row: QRectF) -> None:
        """Paint which colour stands for which level, at the right, with levels in dB."""
        low, high = self._session.sonagram.level_range
        colours = np.ascontiguousarray(self._colours[::-1])
        bar = QRectF(row.right() + BAR_GAP, row.top(), BAR_WIDTH, row.height())
        painter.drawImage(bar, QImage(colours.data, 1, len(colours), 4, QImage.Format.Format_RGB32))
        marks = np.linspace(low, high, max(3, min(8, int(row.height() / 40)))).tolist()
        self._paint_scale(painter, row, [f"{level:.0f} dB" for level in marks], bar.right() + 3, self._theme.faint)

    def _paint_scale(self, painter: QPainter, row: QRectF, words: list[str], left: float, colour: str) -> None:
        """Write words beside a row, equally far apart, from its lower edge to its upper one."""
        for k, text in enumerate(words):
            y = row.bottom() - k / (len(words) - 1) * row.height()
            place = QRectF(
                left, min(max(y - 7, row.top() - 1), row.bottom() - 13), RIGHT - BAR_GAP - BAR_WIDTH - 2, 14
            )
            draw_text(painter, place, text, colour, 10, AT_LEFT)

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
            paint_name(painter, place, name, self._theme)
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
        loudest = max(LEAST_LOUDNESS, float(np.abs(samples).max()))
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

    def _line_in(
        self, row: QRectF, values: Float32Array, first: int, scale: tuple[float, float]
    ) -> tuple[QPolygonF, ...]:
        """Return the usual course of values of the frames from one on, between two values at the row's edges."""
        seen, (low, high) = self._view.seen, scale
        times, heights = usual_course_of(values, first, seen, self._layout.width)
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
        self._paint_scales_over(painter, row)
        if "formants" in self._layout.shows and self._view.seen.seconds > MOST_SECONDS:
            words = tr("Formants: zoom in to {n:.0f} s or less").format(n=MOST_SECONDS)
            self._paint_note(painter, row, words, above=False)
        painter.restore()

    def _paint_scales_over(self, painter: QPainter, row: QRectF) -> None:
        """Write the scales of pitch and level at the right edge, in the colours of their lines."""
        scales = (
            ("level", LEVELS, "dB", LEVEL_COLOUR),
            ("pitch", PITCHES, "Hz", PITCH_COLOUR),
        )
        right = row.right() - SCALE_WIDTH
        for name, (low, high), unit, colour in scales:
            if name in self._layout.shows:
                ground = QColor(0, 0, 0, 110)
                painter.fillRect(QRectF(right, row.top(), SCALE_WIDTH, row.height()), ground)
                words = [f"{value:.0f} {unit}" for value in np.linspace(low, high, 6).tolist()]
                self._paint_scale(painter, row, words, right + 3, colour)
                right -= SCALE_WIDTH + 2

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
            for line in self._line_in(row, values, first, scale):
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


def _cut(image: QImage, left: float, right: float, row: QRectF) -> tuple[QImage, float, float]:
    """Return the columns of an image between two places that lie within a row, and between which places these lie."""
    column = (right - left) / image.width()
    first = max(0, math.ceil((row.left() - left) / column))
    last = min(image.width(), math.floor((row.right() - left) / column))
    return image.copy(first, 0, max(1, last - first), image.height()), left + first * column, left + last * column


# The usual course of what is drawn over the sonagram: as many points as pixels, however many frames lie under each.


def usual_course_of(
    values: Float32Array, first: int, seen: TimeSpan, n_columns: int
) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as one line, however many frames lie under a column: see `usual_of`.

    Times in seconds, and values; NaN where it is broken.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n,).
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
