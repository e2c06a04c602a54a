"""How the view of a file is painted: sonagram, phonemes, labels, waveform, and the course of a variable."""

import math
from bisect import bisect_right

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QImage, QPaintEngine, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.analyse.lanes.file_layout import LANE, LEFT, TIME_HEIGHT, FileLayout
from phonemeanalyser.desktop.analyse.lanes.file_rows import (
    course_of,
    lane_pixels,
    usual_course_of,
    usual_of,
    wave_pixels,
    wide_runs,
)
from phonemeanalyser.desktop.analyse.lanes.sonagram import LETTER, NARROWEST_LETTER
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import AT_RIGHT, CENTRED, draw_text, format_clock, letters_on, set_size
from phonemeanalyser.desktop.session.formant_track import MOST_SECONDS
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sonagram_tiles import Tile
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeanalyser.desktop.widgets.timeline import Lane
from phonemeengine.arrays import Float32Array, UInt32Array
from phonemeengine.inspection.whole_sound import FrameState, SoundTracks
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

SPACINGS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1200, 3600)
"""Between two marks of time, seconds."""
LEAST_SPACING = 70
"""Pixels between two marks of time."""
FREQUENCY_MARKS = (500, 1000, 2000, 4000, 6000, 8000)
LEVELS, PITCHES = (-80.0, 0.0), (0.0, 500.0)
"""Decibels and Hz of the sonagram's lower and upper edge, for the lines over it."""
FORMANT_COLOUR, PITCH_COLOUR, LEVEL_COLOUR = "#ff5050", "#50b4ff", "#ffe060"
"""As in Praat: red dots, a blue and a yellow line."""
OUTDATED = 0.43
"""How much of its colour is left of what was found with other settings."""
LEAST_BOX = 4
"""Pixels of a label from which on its border is strong: of narrower ones, nothing else would be seen."""
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
        self.variable = "energy"
        self._colours: UInt32Array = np.zeros(256, np.uint32)
        self._images: dict[int, tuple[Tile, tuple[float, float], QImage]] = {}
        self._pixels = [QColor(PHONEME_COLOURS[p]) for p in Phoneme]
        self._letters = [letters_on(colour.name()) for colour in self._pixels]
        self._lane_colours = _lane_colours(self._pixels, QColor(theme.base))
        self._names = [{"silence": "–", "unidentified": "?"}.get(p.label, p.label) for p in Phoneme]

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
            self._paint_wave(painter, rows[2], tracks)
            self._paint_course(painter, rows[3], tracks)
            self._paint_over(painter, rows[0], tracks)
        for tier, row in self._layout.label_rows().items():
            self._paint_labels(painter, row, tier)
        for row, lane in self._layout.spoken_rows():
            self._paint_spoken(painter, row, lane)
        self._paint_times(painter, rows[3].bottom())
        self._paint_selection(painter, rows[3].bottom())
        x = self._layout.x_of(self._session.source.position)
        if LEFT <= x <= LEFT + self._layout.width and not self._session.seen.looks_back:
            painter.fillRect(QRectF(x - 0.5, 0, 1.5, rows[3].bottom()), QColor(self._theme.accent))
        self._paint_reading(painter, rows[0], reading)

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
        seen, n = self._view.seen, self._layout.width
        pixels = lane_pixels(tracks, seen, n, self._lane_colours)
        painter.drawImage(row, QImage(pixels.data, n, 1, 4 * n, QImage.Format.Format_RGB32))
        runs = wide_runs(tracks, seen, NARROWEST_LETTER / n * seen.seconds)
        for start, end, code in zip(*(values.tolist() for values in runs), strict=True):
            left, right = self._layout.x_of(start), self._layout.x_of(end)
            if right - left >= LETTER * len(self._names[code]):
                place = QRectF(left, row.top(), right - left, row.height())
                draw_text(painter, place, self._names[code], self._letters[code], 11, CENTRED)

    def _paint_second(self, painter: QPainter, first: QRectF) -> None:
        """Paint what the second preset hears, and the names of both."""
        row, tracks = self._layout.second_row(), self._session.second.whole.tracks
        if row is None:
            return
        painter.fillRect(row, QColor(self._theme.base))
        if tracks is not None:
            self._paint_lane(painter, row, tracks)
        set_size(painter, 10)
        for place, name in zip((first, row), self._session.second.names, strict=True):
            words = painter.fontMetrics().elidedText(name, Qt.TextElideMode.ElideRight, LEFT - 8)
            left = QRectF(0, place.top(), LEFT - 7, place.height())
            draw_text(painter, left, words, self._theme.faint, 10, AT_RIGHT)

    def _paint_errors(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        """Hatch where something else was recognised than the labels say."""
        seen = self._view.seen
        brush = QBrush(QColor(0, 0, 0, 170), Qt.BrushStyle.BDiagPattern)
        for error in self._labels.errors(tracks):
            if error.start < seen.end and seen.start < error.end:
                left, right = (self._layout.x_of(min(max(t, seen.start), seen.end)) for t in (error.start, error.end))
                painter.fillRect(QRectF(left, row.top(), right - left, row.height()), brush)

    def _paint_labels(self, painter: QPainter, row: QRectF, tier: int) -> None:
        """Paint a tier: a box for each label, with as much of its name as fits."""
        seen, state = self._view.seen, self._labels.state
        shown = state.tiers[tier]
        says = tier == state.said
        painter.fillRect(row, QColor(self._theme.base))
        draw_text(painter, QRectF(0, row.top(), LEFT - 7, row.height()), shown.name, self._theme.faint, 10, AT_RIGHT)
        set_size(painter, 11)
        labels = shown.raw_labels
        first = bisect_right(labels, seen.start, key=lambda raw: raw.end)
        drawn = LEFT - 1.0
        for k in range(first, len(labels)):
            raw = labels[k]
            if raw.start > seen.end:
                break
            left, right = (self._layout.x_of(min(max(t, seen.start), seen.end)) for t in (raw.start, raw.end))
            if right < drawn + 0.5 and not shown.points:
                continue  # lies within a pixel that is painted already
            drawn = right
            box = QRectF(left, row.top(), max(1.0, right - left), row.height())
            chosen = self._labels.chosen == (tier, k)
            strong = says and box.width() >= LEAST_BOX
            painter.fillRect(box, QColor(self._theme.faint if strong else self._theme.line))
            painter.fillRect(box.adjusted(1, 1, 0, -1), QColor(self._theme.accent if chosen else self._theme.field))
            if box.width() >= NARROWEST_LETTER or shown.points:
                words = painter.fontMetrics().elidedText(raw.name, Qt.TextElideMode.ElideRight, int(box.width()))
                draw_text(painter, box, words, self._theme.on_colour if chosen else self._theme.text, 11, CENTRED)

    def _paint_spoken(self, painter: QPainter, row: QRectF, lane: Lane) -> None:
        """Paint words, syllables, phones, letters or units: a coloured box each, with its name where that fits."""
        seen = self._view.seen
        painter.fillRect(row, QColor(self._theme.base))
        draw_text(painter, QRectF(0, row.top(), LEFT - 7, row.height()), lane.name, self._theme.faint, 10, AT_RIGHT)
        set_size(painter, 11)
        first = int(np.searchsorted(lane.ends, seen.start))
        last = int(np.searchsorted(lane.starts, seen.end))
        drawn = LEFT - 1.0
        for k in range(first, last):
            left, right = (
                self._layout.x_of(min(max(t, seen.start), seen.end)) for t in (lane.starts[k], lane.ends[k])
            )
            if right < drawn + 0.5:
                continue  # lies within a pixel that is painted already
            drawn = right
            box = QRectF(left, row.top(), max(1.0, right - left - 1), row.height())
            colour = QColor(int(lane.colours[k]))
            painter.fillRect(box, colour)
            if k in lane.marked:
                painter.fillRect(box, QBrush(QColor(self._theme.bad), Qt.BrushStyle.BDiagPattern))
            if box.width() >= NARROWEST_LETTER:
                words = painter.fontMetrics().elidedText(lane.texts[k], Qt.TextElideMode.ElideRight, int(box.width()))
                draw_text(painter, box, words, letters_on(colour.name()), 11, CENTRED)

    def _paint_wave(self, painter: QPainter, row: QRectF, tracks: SoundTracks) -> None:
        seen = self._view.seen
        peaks = self._session.waveform.outline_in(seen, tracks.peaks, self._layout.width)
        loudest = max(0.05, float(np.nanmax([np.abs(peaks.low), np.abs(peaks.high), np.zeros(self._layout.width)])))
        colour, base = (QColor(name).rgb() for name in (self._theme.signal, self._theme.base))
        height = max(3, round(row.height()))
        pixels = wave_pixels(peaks, loudest, height, colour, base)
        painter.drawImage(
            row, QImage(pixels.data, self._layout.width, height, 4 * self._layout.width, QImage.Format.Format_RGB32)
        )

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
            self._paint_hint(painter, row, tr("Formants: zoom in to {n:.0f} s or less").format(n=MOST_SECONDS))
        painter.restore()

    def _paint_hint(self, painter: QPainter, row: QRectF, words: str) -> None:
        """Say at the lower left of the sonagram why something is not drawn."""
        set_size(painter, 11)
        width = painter.fontMetrics().horizontalAdvance(words) + 14
        box = QRectF(row.left() + 4, row.bottom() - 22, width, 18)
        painter.fillRect(box, QColor(self._theme.base))
        draw_text(painter, box, words, self._theme.text, 11, CENTRED)

    def _paint_line(
        self, painter: QPainter, row: QRectF, first: int, values: Float32Array, scale: tuple[float, float],
        colour: str,
    ) -> None:  # fmt: skip
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for pen in (QPen(QColor(0, 0, 0, 150), 3), QPen(QColor(colour), 1.6)):  # seen on every colour
            painter.setPen(pen)
            for line in self._line_in(row, values, first, scale, usual=True):
                painter.drawPolyline(line)

    def _y_of(self, frequency: float, row: QRectF) -> float:
        frequencies = self._session.sonagram.settings.frequencies
        share = float(np.interp(frequency, frequencies, np.linspace(0, 1, len(frequencies)), -1, 2))
        return row.bottom() - share * row.height()

    def _paint_reading(self, painter: QPainter, row: QRectF, words: str) -> None:
        """Tell what lies under the mouse."""
        if not words:
            return
        set_size(painter, 11)
        width = painter.fontMetrics().horizontalAdvance(words) + 14
        box = QRectF(row.right() - width - 4, row.top() + 4, width, 18)
        background = QColor(self._theme.base)
        background.setAlpha(215)
        painter.fillRect(box, background)
        draw_text(painter, box, words, self._theme.text, 11, CENTRED)

    def _paint_times(self, painter: QPainter, top: float) -> None:
        seen = self._view.seen
        per_pixel = seen.seconds / self._layout.width
        spacing = next((s for s in SPACINGS if s / per_pixel >= LEAST_SPACING), SPACINGS[-1])
        for k in range(int(seen.start / spacing), int(seen.end / spacing) + 1):
            x = self._layout.x_of(k * spacing)
            if LEFT <= x <= LEFT + self._layout.width:
                painter.fillRect(QRectF(x, top, 1, 4), QColor(self._theme.faint))
                place = QRectF(
                    min(x - 40, self._widget.width() - 62), top + 3, 80, TIME_HEIGHT - 3
                )  # the last one is whole
                draw_text(painter, place, _clock(k * spacing, spacing), self._theme.faint, 10, CENTRED)

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


def _lane_colours(colours: list[QColor], base: QColor) -> UInt32Array:
    """Return the colours of phonemes by state: none where nothing is known, paler where that is outdated."""
    table = np.full((len(FrameState), len(colours)), base.rgb(), np.uint32)
    for k, colour in enumerate(colours):
        table[FrameState.KNOWN, k] = colour.rgb()
        shares = zip(
            (colour.red(), colour.green(), colour.blue()), (base.red(), base.green(), base.blue()), strict=True
        )
        pale = QColor(*(round(OUTDATED * a + (1 - OUTDATED) * b) for a, b in shares))
        table[FrameState.OUTDATED, k] = pale.rgb()
    return table


def _cut(image: QImage, left: float, right: float, row: QRectF) -> tuple[QImage, float, float]:
    """Return the columns of an image between two places that lie within a row, and between which places these lie."""
    column = (right - left) / image.width()
    first = max(0, math.ceil((row.left() - left) / column))
    last = min(image.width(), math.floor((row.right() - left) / column))
    return image.copy(first, 0, max(1, last - first), image.height()), left + first * column, left + last * column


def _rgb_of(colour: QColor) -> tuple[int, int, int]:
    return colour.red(), colour.green(), colour.blue()


def _clock(seconds: float, spacing: float) -> str:
    """Write a time as finely as marks so far apart need it."""
    if spacing < 0.1:
        return f"{format_clock(seconds - seconds % 60, False)[:-2]}{seconds % 60:05.2f}"
    return format_clock(seconds, spacing < 1)
