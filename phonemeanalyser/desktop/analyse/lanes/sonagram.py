"""The items that scroll: sonagram and phoneme lane, with time as seconds before now (0 at the right)."""

from math import ceil, floor
from typing import Any

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QComboBox

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.history import CAPACITY, MOST_BINS, NOWHERE, History
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.lanes import TimeAxis, lane_of_frames, names_in_lanes, paint_lane
from phonemeengine.arrays import Float32Array, UInt8Array, UInt32Array
from phonemeengine.dsp.sonagram import LEVELS
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import BIN_WIDTH, FRAME_PERIOD

SPAN = CAPACITY * FRAME_PERIOD
"""Seconds that can be seen."""
COLOUR_MAPS = ("viridis", "inferno", "magma", "plasma", "cividis", tr_noop("grey"))


def add_colour_maps(box: QComboBox) -> None:
    """List all colour maps, each with its name as what is chosen."""
    for name in COLOUR_MAPS:
        box.addItem(tr(name), name)


def as_measured(spectra: NDArray[np.float16], peaks: Float32Array) -> Float32Array:
    """Return spectra as loud as they were measured, whatever normalising made of them: a quiet room stays dark.

    Parameters
    ----------
    spectra : as they are shown, with or without normalising, shape (n, n_bins).
    peaks : the largest amplitude of each before normalising, shape (n,); NaN where it is not known.
    """
    amplitudes = spectra.astype(np.float32)
    shown = amplitudes.max(axis=1, initial=0.0)
    measured = np.where(np.isnan(peaks), shown, peaks)
    amplitudes *= (measured / np.maximum(shown, 1e-12)).astype(np.float32)[:, np.newaxis]
    return amplitudes


def colours_of(name: str) -> UInt32Array:
    """Return a colour map as 256 pixels of a QImage, 0xffRRGGBB."""
    if name == "grey":
        rgb = np.repeat(np.arange(256, dtype=np.uint32)[:, None], 3, axis=1)
    else:
        rgb = pg.colormap.get(name).getLookupTable(nPts=256)[:, :3].astype(np.uint32)
    pixels = np.uint32(0xFF000000) | (rgb[:, 0] << 16) | (rgb[:, 1] << 8) | rgb[:, 2]
    return np.asarray(pixels, np.uint32)


class SonagramItem(pg.GraphicsObject):
    """The last minute of spectra as an image.

    The image is a ring: only new columns are coloured, and it is painted in two pieces; in one, until it has gone
    round once.

    Attributes
    ----------
    n_drawn : columns since Clear up to the newest that is drawn; while the views are frozen, others follow it.
    """

    def __init__(self, history: History, theme: Theme) -> None:
        super().__init__()
        self._history = history
        self._nothing = np.uint32(QColor(theme.base).rgb())
        self._pixels = np.zeros((MOST_BINS, CAPACITY), np.uint32)
        self._image = QImage(self._pixels.data, CAPACITY, MOST_BINS, 4 * CAPACITY, QImage.Format.Format_RGB32)
        self.n_drawn = self._n_coloured = 0
        self._colours = colours_of(COLOUR_MAPS[0])
        self._in_decibels = True
        self._low, self._high = LEVELS

    def set_colours(self, colours: UInt32Array, in_decibels: bool, low: float, high: float) -> None:
        """Choose colours, and the amplitudes (0..1 or dB) of the darkest and the brightest."""
        self._colours, self._in_decibels, self._low, self._high = colours, in_decibels, low, high
        self.recolour()

    def recolour(self) -> None:
        """Draw everything remembered anew."""
        self._colour(0, self.n_drawn)

    def forget(self, column: int) -> None:
        """Have the columns from this one on coloured anew at the next refresh."""
        self._n_coloured = min(self._n_coloured, column)

    def refresh(self) -> None:
        """Colour what is new since the last call."""
        n = self._history.n
        first = min(self._n_coloured, n)
        self._pixels[:, np.arange(max(n, self.n_drawn - CAPACITY), self.n_drawn) % CAPACITY] = self._nothing
        self.n_drawn = self._n_coloured = n
        self._colour(first, n)

    def boundingRect(self) -> QRectF:
        """One minute by half the sample rate."""
        return QRectF(-SPAN, 0, SPAN, MOST_BINS * BIN_WIDTH)

    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        """Paint the ring's two pieces: what was written last ends at time 0."""
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)  # else a tone may fall between two pixels
        split = self.n_drawn % CAPACITY
        rows = min(MOST_BINS, int(self.viewRect().bottom() / BIN_WIDTH) + 2)
        height = rows * BIN_WIDTH
        older = CAPACITY - split if self.n_drawn >= CAPACITY else 0
        x = -(older + split) * FRAME_PERIOD
        for first, n in ((split, older), (0, split)):
            visible = x + n * FRAME_PERIOD > self.viewRect().left()
            if n and visible:
                target = QRectF(x, -BIN_WIDTH / 2, n * FRAME_PERIOD, height)
                painter.drawImage(target, self._image, QRectF(first, 0, n, rows))
            x += n * FRAME_PERIOD

    def _colour(self, first: int, last: int) -> None:
        at = self._history.indices(first, last)
        if len(at):
            spectra = as_measured(self._history.spectra[at], self._history.features(at)["max_energy"])
            self._pixels[:, at] = self._colours[self._levels_of(spectra).T]
            self._pixels[:, at[self._history.frames[at] == NOWHERE]] = self._nothing
        self.update()

    def _levels_of(self, amplitudes: Float32Array) -> UInt8Array:
        if self._in_decibels:
            amplitudes = 20 * np.log10(np.maximum(amplitudes, np.float32(1e-6)))
        scaled = (amplitudes - self._low) * (255 / max(self._high - self._low, 1e-6))
        return np.asarray(np.clip(scaled, 0, 255), np.uint8)


class PhonemeLane(pg.GraphicsObject):
    """The recognised phonemes as coloured segments, named where there is room; as far as the sonagram is drawn."""

    def __init__(self, history: History, sonagram: SonagramItem, theme: Theme) -> None:
        super().__init__()
        self._history = history
        self._sonagram = sonagram
        self._theme = theme
        colours = [*(PHONEME_COLOURS[p] for p in Phoneme), theme.base]  # the last one is that of a gap
        self._pixels = np.array([QColor(colour).rgb() for colour in colours], np.uint32)
        self._names = [*names_in_lanes(), ""]

    def boundingRect(self) -> QRectF:
        """One minute by one."""
        return QRectF(-SPAN, 0, SPAN, 1)

    def paint(self, painter: QPainter, _option: Any, _widget: Any = None) -> None:
        """Paint the segments that are in view, and the names of those that are wide enough."""
        view, n = self.viewRect(), self._sonagram.n_drawn
        first, last = (n + edge(side / FRAME_PERIOD) for edge, side in ((floor, view.left()), (ceil, view.right())))
        last = min(last, n)
        at = self._history.indices(first, last)
        row = painter.transform().mapRect(QRectF(view.left(), 0, view.width(), 1))
        painter.resetTransform()
        axis = TimeAxis(row.left(), row.width(), n * FRAME_PERIOD + view.left(), view.width())
        codes = self._history.phonemes[at]
        lane = lane_of_frames("", codes, self._names, self._pixels, first=last - len(at))
        paint_lane(painter, row, lane, axis, self._theme)
