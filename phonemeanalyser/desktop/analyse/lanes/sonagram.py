"""How a sonagram is painted, of a file or of live sound, and what is chosen of it: overlays, window, colours."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QObject, QPointF, QRectF, Qt
from PySide6.QtGui import QAction, QColor, QImage, QPaintEngine, QPainter, QPen, QPolygonF, QShowEvent
from PySide6.QtWidgets import QComboBox, QFormLayout, QMenu, QToolButton, QWidget, QWidgetAction
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.seen_tracks import MOST_SECONDS, KnownFormants
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sonagram_tiles import USUAL_COLOURS, SonagramTiles, Tile
from phonemeanalyser.desktop.theme import AT_LEFT, AT_RIGHT, CENTRED, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.builders import choice, label, leave_wheel, named, open_at_once, row, tool_button
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.lanes import TimeAxis
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.arrays import Float32Array, Float64Array, UInt32Array
from phonemeengine.dsp.sonagram import NARROW_BAND, WIDE_BAND, FrequencyAxis
from phonemeengine.features.variables import Features
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

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


OVERLAYS = {
    "formants": tr_noop("Formants (red dots, Burg's method, as in Praat)"),
    "pitch": tr_noop("Pitch (blue line, 0 to 500 Hz from bottom to top)"),
    "level": tr_noop("Level (yellow line, peaks from −80 to 0 dB)"),
    "feeling": tr_noop("Feeling in the voice (lane below: activation, pleasantness, standard errors)"),
    "words": tr_noop("Words, if known (lanes below: words, syllables or letters, phones, units)"),
}
"""What may be drawn over the sonagram or below it, by the names of `SonagramTiles`, and how the menu says so."""
WINDOWS = (WIDE_BAND, 0.01, 0.02, NARROW_BAND, 0.05)
"""Seconds of windows that are offered."""
TOPS = (4000.0, 5500.0, 8000.0, 11_000.0, SAMPLE_RATE / 2)
"""Highest frequencies that are offered, Hz."""
LOWEST = -120
"""dBFS, of a level that can be chosen."""


class _Fields(QWidget):
    """Fields in a menu: Down and Tab lead from it to the first of them, and Tab goes from one to the next."""

    def __init__(self, *fields: QWidget) -> None:
        super().__init__()
        self._fields = fields
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # else the menu leaves it out
        self.setFocusProxy(fields[0])

    @override
    def focusNextPrevChild(self, forwards: bool) -> bool:
        """Give the focus to the next field or the one before; a menu would give it to its lines."""
        now = self.window().focusWidget()
        at = next((k for k, field in enumerate(self._fields) if field is now), 0)
        field = self._fields[(at + (1 if forwards else -1)) % len(self._fields)]
        field.setFocus(Qt.FocusReason.TabFocusReason)
        return True

    @override
    def showEvent(self, event: QShowEvent) -> None:
        """Open without the field that had the focus last, which Down would change; it leads to the first."""
        if (before := self.window().focusWidget()) is not None:
            before.clearFocus()
        super().showEvent(event)


class SonagramChoices(QObject):
    """The switches and menus of the sonagram; several views have buttons for them.

    Attributes
    ----------
    filtered : whether the sonagram is that after the filters.
    overlays : the switches for what is drawn over the sonagram, or below it.
    axis, top, window_length, colours : choices.
    low, high : the levels of the darkest and the brightest colour, dBFS.
    """

    def __init__(self, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._session = session
        self.filtered = QAction(tr("After Filters"), self, checkable=True)
        self.filtered.setToolTip(
            tr("Show the sonagram after all active filters, as recognisers that use the filters see it")
        )
        self.overlays = {name: QAction(tr(what), self, checkable=True) for name, what in OVERLAYS.items()}
        self.axis = choice(
            ((tr(axis.value), axis.value) for axis in FrequencyAxis),
            tr("Frequency axis"),
            tr("Spacing of the frequencies in the sonagram: linear, mel or logarithmic"),
        )
        self.top = choice(
            ((f"{top:.0f} Hz", top) for top in TOPS), tr("Highest frequency"), tr("Upper edge of the sonagram")
        )
        self.window_length = choice(
            ((f"{1000 * seconds:g} ms", seconds) for seconds in WINDOWS),
            tr("Window"),
            tr(
                "Length of the sonagram's window: a short one (wide band, 6 ms) shows single pulses of the voice, a "
                "long one (narrow band, 30 ms) its harmonics"
            ),
        )
        self.low = named(
            NumberField(LOWEST, 0, unit=" dB"),
            tr("Level of the darkest colour"),
            tr("Level of the darkest colour, dBFS, the same for every sound"),
        )
        self.high = named(
            NumberField(LOWEST, 0, unit=" dB"),
            tr("Level of the brightest colour"),
            tr("Level of the brightest colour, dBFS, the same for every sound"),
        )
        self.colours = choice((), tr("Colour map"), tr("Colours of the levels in the sonagram"))
        self._over, self._looks = QMenu(parent), QMenu(parent)
        self._fill_menus()
        self._connect()

    def buttons(self) -> tuple[QToolButton, QToolButton, QToolButton]:
        """Make buttons for all choices: filters, overlays, and what the sonagram looks like."""
        filtered = QToolButton()
        filtered.setDefaultAction(self.filtered)
        over = tool_button(
            tr("Overlays"),
            tr("Curves drawn over the sonagram, and lanes below it: formants, pitch, level, feeling, words"),
        )
        looks = tool_button(tr("Sonagram"), tr("Frequencies, window, levels and colour map of the sonagram"))
        open_at_once(over, self._over)
        open_at_once(looks, self._looks)
        return filtered, over, looks

    def _fill_menus(self) -> None:
        """Put the choices into the menu of one button: a row of them is wider than a small screen."""
        sonagram = self._session.sonagram
        self._over.addActions([*self.overlays.values()])
        add_colour_maps(self.colours)
        self.top.setCurrentIndex(TOPS.index(sonagram.settings.high))
        self.window_length.setCurrentIndex(WINDOWS.index(sonagram.settings.window))
        for field, level in zip((self.low, self.high), sonagram.level_range, strict=True):
            field.setValue(level)
        form = QFormLayout(
            looks := _Fields(self.axis, self.top, self.window_length, self.low, self.high, self.colours)
        )
        for box in (self.axis, self.top, self.window_length):
            form.addRow(box.accessibleName(), box)
        form.addRow(tr("Colours from"), row(self.low, label(tr("to")), self.high, spacing=6))
        form.addRow(self.colours.accessibleName(), self.colours)
        leave_wheel(looks)
        action = QWidgetAction(self)
        action.setDefaultWidget(looks)
        self._looks.addAction(action)

    def _connect(self) -> None:
        sonagram = self._session.sonagram
        self.filtered.toggled.connect(self._session.seen.show_filtered)
        for name, action in self.overlays.items():
            action.toggled.connect(lambda on, name=name: sonagram.show_over(name, on=on))
        self.overlays["words"].setChecked(True)
        for box in (self.axis, self.top, self.window_length):
            box.currentIndexChanged.connect(lambda _k: self._measure())
        for field in (self.low, self.high):
            field.valueChanged.connect(lambda _level: self._show_levels())
        self.colours.currentIndexChanged.connect(lambda _k: sonagram.show_colours(self.colours.currentData()))

    def _measure(self) -> None:
        sonagram = self._session.sonagram
        sonagram.use(
            replace(
                sonagram.settings,
                axis=list(FrequencyAxis)[self.axis.currentIndex()],
                high=self.top.currentData(),
                window=self.window_length.currentData(),
            )
        )

    def _show_levels(self) -> None:
        self._session.sonagram.show_levels(*sorted((self.low.value(), self.high.value())))
