"""How a sonagram is painted, of a file or of live sound: its levels as colours, scales, and overlays."""

import math
from typing import NamedTuple

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPaintEngine, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QComboBox

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.seen_tracks import MOST_SECONDS, KnownFormants
from phonemeanalyser.desktop.session.sonagram_tiles import USUAL_COLOURS, SonagramTiles, Tile
from phonemeanalyser.desktop.theme import AT_LEFT, AT_RIGHT, CENTRED, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.lanes import TimeAxis
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array, UInt32Array
from phonemeengine.features.variables import Features
from phonemeengine.settings import FRAME_PERIOD

COLOUR_MAPS = (USUAL_COLOURS, "inferno", "magma", "plasma", "cividis", tr_noop("grey"))
FREQUENCY_MARKS = (500, 1000, 2000, 3000, 4000, 5000, 6000, 8000, 10_000, 15_000, 20_000)
LEVELS, PITCHES = (-80.0, 0.0), (0.0, 500.0)
"""Decibels and Hz of the sonagram's lower and upper edge, for the lines on top of it."""
FORMANT_COLOUR, PITCH_COLOUR, LEVEL_COLOUR = "#ff5050", "#50b4ff", "#ffe060"
"""As in Praat: red dots, a blue and a yellow line."""
NOTE_ALPHA = 215
"""How opaque the ground of words over the sonagram is, 0..255."""
DOTS_APART = 3
"""Pixels between two dots of a formant at least."""
SIDE, BAR_WIDTH, SCALE_WIDTH, SCALE_GAP = 58, 8, 46, 2
"""Pixels at the right of the sonagram for its bar of colours, of that, of each further scale, and between them."""
SCALE_GROUND = "#20252b"
"""On which the colours of what is drawn over the sonagram are read, in a light window, too."""
SCALES: tuple[tuple[str, tuple[float, float] | None, str, str], ...] = (
    ("pitch", PITCHES, "Hz", PITCH_COLOUR),
    ("formants", None, "Hz", FORMANT_COLOUR),
    ("level", LEVELS, "dB", LEVEL_COLOUR),
)
"""What has a scale of its own, from left to right: the edges of the sonagram, the unit, and the colour."""
LETTERS_APART = 14
"""Pixels between two frequencies that are written."""
NOTHING = 256
"""The colour of what has no level, after those of the levels."""


def add_colour_maps(box: QComboBox) -> None:
    """List all colour maps, each with its name as what is chosen."""
    for name in COLOUR_MAPS:
        box.addItem(tr(name), name)


def colours_of(name: str) -> UInt32Array:
    """Return a colour map as 256 pixels of a QImage, 0xffRRGGBB."""
    if name == "grey":
        rgb = np.repeat(np.arange(256, dtype=np.uint32)[:, None], 3, axis=1)
    else:
        rgb = pg.colormap.get(name).getLookupTable(nPts=256)[:, :3].astype(np.uint32)
    pixels = np.uint32(0xFF000000) | (rgb[:, 0] << 16) | (rgb[:, 1] << 8) | rgb[:, 2]
    return np.asarray(pixels, np.uint32)


def side_width(sonagram: SonagramTiles) -> int:
    """Return how much room scales and bar of colours take at the right of a sonagram, pixels."""
    return SIDE + (SCALE_WIDTH + SCALE_GAP) * sum(name in sonagram.overlays for name, *_ in SCALES)


class Overlaid(NamedTuple):
    """What is drawn over a sonagram: variables of the frames from one on, and formants as far as they are known."""

    first: int
    features: Features
    formants: KnownFormants | None


class SonagramPainter:
    """Paints tiles of a sonagram into a row, with what the choices of the sonagram say.

    Parameters
    ----------
    sonagram : has the choices.
    theme : the colours of what is no level.
    """

    def __init__(self, sonagram: SonagramTiles, theme: Theme) -> None:
        self._sonagram, self._theme = sonagram, theme
        self._colours, self._colour_map = colours_of(sonagram.colour_map), sonagram.colour_map
        self._images: dict[int, tuple[Tile, tuple[object, ...], QImage]] = {}

    def paint_tiles(self, painter: QPainter, row: QRectF, axis: TimeAxis, tiles: list[Tile]) -> None:
        """Paint what is known, coarse tiles first."""
        if self._colour_map != self._sonagram.colour_map:
            self._colour_map = self._sonagram.colour_map
            self._colours = colours_of(self._colour_map)
        painter.save()
        painter.setClipRect(row, Qt.ClipOperation.IntersectClip)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        self._images = {id(t.levels): known for t in tiles if (known := self._images.get(id(t.levels)))}
        for tile in tiles:
            image = self._image_of(tile)
            left, right = axis.x_of(tile.span.start), axis.x_of(tile.span.end)
            if painter.paintEngine().type() is QPaintEngine.Type.SVG:  # which does not clip
                image, left, right = _cut(image, left, right, row)
            painter.drawImage(QRectF(left, row.top(), right - left, row.height()), image)
        painter.restore()

    def reading(self, tiles: list[Tile], seconds: float, share: float) -> list[str]:
        """Return frequency and level at a time and a share of the height, in words; the level where it is known."""
        frequencies = self._sonagram.settings.frequencies
        share = min(max(share, 0.0), 1.0)
        words = [f"{np.interp(share, np.linspace(0, 1, len(frequencies)), frequencies):.0f} Hz"]
        for tile in reversed(tiles):  # the finest one comes last
            if tile.span.start <= seconds < tile.span.end:
                column = int((seconds - tile.span.start) / tile.span.seconds * len(tile.levels))
                level = float(tile.levels[column, round(share * (len(frequencies) - 1))])
                return words if math.isnan(level) else [*words, f"{level:.0f} dB"]
        return words

    def share_of(self, frequency: float) -> float:
        """Return at which share of the height a frequency lies; -1 or 2 where that is below or above."""
        frequencies = self._sonagram.settings.frequencies
        return float(np.interp(frequency, frequencies, np.linspace(0, 1, len(frequencies)), -1, 2))

    def marks(self, height: float) -> list[tuple[float, str]]:
        """Return the frequencies that are written beside a sonagram of a height, pixels: shares of it, and words."""
        found: list[tuple[float, str]] = []
        top = height - LETTERS_APART / 3
        for mark in FREQUENCY_MARKS:
            share = self.share_of(mark)
            if 0 <= share <= 1 and (found[-1][0] if found else -1) * height + LETTERS_APART < share * height < top:
                found.append((share, f"{mark} Hz"))
        return found

    def paint_marks(self, painter: QPainter, row: QRectF, colour: str, right: float, *, ticks: bool = True) -> None:
        """Write frequencies to the left of a place."""
        for share, words in self.marks(row.height()):
            y = row.bottom() - share * row.height()
            if ticks:
                painter.fillRect(QRectF(right + 3, y, 4, 1), QColor(colour))
            draw_text(painter, QRectF(0, y - 7, right, 14), words, colour, 10, AT_RIGHT)

    def paint_side(self, painter: QPainter, row: QRectF) -> None:
        """Paint the scales of what is drawn over a row at its right, and which colour stands for which level."""
        left = row.right() + SCALE_GAP
        for _, edges, unit, colour in self._scales():
            ground = QRectF(left, row.top(), SCALE_WIDTH, row.height())
            painter.fillRect(ground, QColor(SCALE_GROUND))
            if edges is None:  # formants lie on the axis of the sonagram
                self.paint_marks(painter, row, colour, ground.right() - 2, ticks=False)
            else:
                words = [f"{value:.0f} {unit}" for value in np.linspace(*edges, 6).tolist()]
                _paint_scale(painter, row, words, left + 3, SCALE_WIDTH, colour)
            left = ground.right() + SCALE_GAP
        low, high = self._sonagram.level_range
        colours = np.ascontiguousarray(colours_of(self._sonagram.colour_map)[::-1])
        bar = QRectF(left + SCALE_GAP, row.top(), BAR_WIDTH, row.height())
        painter.drawImage(bar, QImage(colours.data, 1, len(colours), 4, QImage.Format.Format_RGB32))
        marks = np.linspace(low, high, max(3, min(8, int(row.height() / 40)))).tolist()
        words = [f"{level:.0f} dB" for level in marks]
        _paint_scale(painter, row, words, bar.right() + 3, SIDE - BAR_WIDTH - 8, self._theme.faint)

    def _scales(self) -> list[tuple[str, tuple[float, float] | None, str, str]]:
        return [scale for scale in SCALES if scale[0] in self._sonagram.overlays]

    def paint_over(self, painter: QPainter, row: QRectF, axis: TimeAxis, over: Overlaid) -> None:
        """Paint formants as dots, and pitch and level as lines on scales of their own, if these are chosen."""
        shows = self._sonagram.overlays
        painter.save()
        painter.setClipRect(row, Qt.ClipOperation.IntersectClip)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        names = over.features.names
        if "level" in shows and "volume" in names:
            levels = 20 * np.log10(np.maximum(over.features["volume"], 1e-6))
            _paint_line(painter, row, axis, over.first, levels, LEVELS, LEVEL_COLOUR)
        if "pitch" in shows and "f0" in names:
            pitch = over.features["f0"]
            _paint_line(painter, row, axis, over.first, np.where(pitch > 0, pitch, np.nan), PITCHES, PITCH_COLOUR)
        if "formants" in shows and over.formants is not None:
            self._paint_formants(painter, row, axis, over.formants)
        if "formants" in shows and axis.seconds > MOST_SECONDS:
            words = tr("Formants: zoom in to {n:.0f} s or less").format(n=MOST_SECONDS)
            self.paint_note(painter, row, words, above=False)
        painter.restore()

    def paint_note(self, painter: QPainter, row: QRectF, words: str, *, above: bool) -> None:
        """Write words over a row: at its right upper edge, or at its left lower one."""
        set_size(painter, 11)
        width = painter.fontMetrics().horizontalAdvance(words) + 14
        left, top = (row.right() - width - 4, row.top() + 4) if above else (row.left() + 4, row.bottom() - 22)
        box, background = QRectF(left, top, width, 18), QColor(self._theme.base)
        background.setAlpha(NOTE_ALPHA)
        painter.fillRect(box, background)
        draw_text(painter, box, words, self._theme.text, 11, CENTRED)

    def _image_of(self, tile: Tile) -> QImage:
        low, high = drawn = self._sonagram.level_range
        known = self._images.get(id(tile.levels))
        if known is not None and known[1] == (*drawn, self._colour_map):
            return known[2]
        scaled = (tile.levels.astype(np.float32) - low) * (255 / max(high - low, 1e-6))
        there = ~np.isnan(scaled)
        numbers = np.where(there, np.clip(np.where(there, scaled, 0), 0, 255), NOTHING).astype(np.uint16)
        colours = np.append(self._colours, np.uint32(QColor(self._theme.base).rgb()))
        pixels = np.ascontiguousarray(colours[numbers].T[::-1])
        n_rows, n = pixels.shape
        image = QImage(pixels.data, n, n_rows, 4 * n, QImage.Format.Format_RGB32).copy()
        self._images[id(tile.levels)] = tile, (*drawn, self._colour_map), image
        return image

    def _paint_formants(self, painter: QPainter, row: QRectF, axis: TimeAxis, known: KnownFormants) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(FORMANT_COLOUR))
        begin = max(0, int(axis.start / FRAME_PERIOD) - known.first)
        end = max(begin, int((axis.start + axis.seconds) / FRAME_PERIOD) + 1 - known.first)
        per_dot = max(1, math.ceil(DOTS_APART / axis.width * axis.seconds / FRAME_PERIOD))
        frequencies = usual_of(known.frequencies[begin:end], per_dot, begin + known.first)
        for k, formants in enumerate(frequencies.tolist(), (begin + known.first) // per_dot):
            x = axis.x_of((k + 0.5) * per_dot * FRAME_PERIOD)
            for frequency in formants:
                if not math.isnan(frequency):
                    y = row.bottom() - self.share_of(frequency) * row.height()
                    painter.drawEllipse(QPointF(x, y), 1.6, 1.6)


def _paint_scale(painter: QPainter, row: QRectF, words: list[str], left: float, width: float, colour: str) -> None:
    """Write words beside a row, equally far apart, from its lower edge to its upper one."""
    for k, text in enumerate(words):
        y = row.bottom() - k / (len(words) - 1) * row.height()
        place = QRectF(left, min(max(y - 7, row.top() - 1), row.bottom() - 13), width, 14)
        draw_text(painter, place, text, colour, 10, AT_LEFT)


def _paint_line(
    painter: QPainter,
    row: QRectF,
    axis: TimeAxis,
    first: int,
    values: Float32Array,
    scale: tuple[float, float],
    colour: str,
) -> None:
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(QColor(0, 0, 0, 150), 3), QPen(QColor(colour), 1.6)):  # seen on every colour
        painter.setPen(pen)
        for line in _line_in(row, axis, values, first, scale):
            painter.drawPolyline(line)


def _line_in(
    row: QRectF, axis: TimeAxis, values: Float32Array, first: int, scale: tuple[float, float]
) -> tuple[QPolygonF, ...]:
    """Return the usual course of values of the frames from one on, between two values at the row's edges."""
    low, high = scale
    times, heights = usual_course_of(values, first, axis.seconds, round(axis.width))
    x = axis.left + (times - axis.start) / axis.seconds * axis.width
    return broken_line(x, row.bottom() - (heights - low) / max(high - low, 1e-12) * row.height())


def _cut(image: QImage, left: float, right: float, row: QRectF) -> tuple[QImage, float, float]:
    """Return the columns of an image between two places that lie within a row, and between which places these lie."""
    column = (right - left) / image.width()
    first = max(0, math.ceil((row.left() - left) / column))
    last = min(image.width(), math.floor((row.right() - left) / column))
    return image.copy(first, 0, max(1, last - first), image.height()), left + first * column, left + last * column


# The usual course of what is drawn over the sonagram: as many points as pixels, however many frames lie under each.


def usual_course_of(
    values: Float32Array, first: int, seconds: float, n_columns: int
) -> tuple[Float64Array, Float64Array]:
    """Return the course of a variable as one line, however many frames lie under a column: see `usual_of`.

    Times in seconds, and values; NaN where it is broken.

    Parameters
    ----------
    values : of the frames from `first` on, shape (n,).
    first : the number of the first frame.
    seconds : that are seen, in `n_columns`.
    """
    per_point = max(1, int(np.ceil(seconds / FRAME_PERIOD / n_columns)))
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
