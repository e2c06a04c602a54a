"""The sound of the chosen take, with the ends of what counts of it to be dragged."""

from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import draw_text, mixed
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.key_filters import ArrowKeys
from phonemeanalyser.desktop.widgets.lanes import BoundaryDrag, Lane, TimeAxis, wave_pixels
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.waveform_peaks import Peaks
from phonemeengine.settings import SAMPLE_RATE

HEADING = 15
"""Pixels above the sound, for words."""
NEAR = 8
"""Pixels from an end within which it is taken hold of."""
LEAST = 0.03
"""What counts lasts at least so long, seconds."""
SHARE = 0.92
"""Of the height, that the loudest sample takes."""
THINNED = 60 / 255
"""How much of its colour is seen behind what counts."""


class TakeWaveform(QWidget):
    """Draws a take, and lets its ends be moved with the mouse, or with arrow keys (Shift: the other end).

    Signals
    -------
    trimmed : start and end of what counts, seconds.
    """

    trimmed = Signal(float, float)

    def __init__(self, takes: TakesModel, theme: Theme) -> None:
        super().__init__()
        self._takes = takes
        self._theme = theme
        self.ends: tuple[float, float] | None = None
        self._drag = BoundaryDrag(NEAR)
        self.setMinimumSize(120, 64)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.installEventFilter(ArrowKeys(self))
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Trim take"))
        self.setToolTip(
            tr("Drag the edges to trim the take; the arrow keys move the start by 10 ms, with Shift the end")
        )
        self.menu = PlotMenu(self, "take", lambda _at: table_of(self._columns()))
        takes.changed.connect(self._show)
        takes.sound_read.connect(self._show)

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        sound = self._takes.sound
        if take is None or self.ends is None or not len(sound):
            painter.setPen(QColor(self._theme.faint))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, tr("Select a take to play and trim it"))
            return
        left, right = (self.axis.x_of(end) for end in self.ends)
        counting = QColor(PHONEME_COLOURS[take.phoneme])
        self._paint_sound(painter, left, right, counting)
        for x in (left, right):
            painter.fillRect(QRectF(x - 1, HEADING, 2, self.height() - HEADING), counting)
            painter.fillRect(QRectF(x - 4, (self.height() + HEADING) / 2 - 8, 8, 16), counting)
        words = f"{take.name}   " + tr("{start:.2f} – {end:.2f} s of {duration:.2f} s").format(
            start=self.ends[0], end=self.ends[1], duration=take.duration
        )
        draw_text(painter, QRectF(6, 0, self.width() - 10, HEADING), words, self._theme.text, 10)

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus()
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag.press(self._rows(), self.axis, event.position(), self._duration)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        held = self._drag.move(round(self.axis.time_at(event.position().x()), 3))
        if held is None:
            over = self._drag.boundary_at(self._rows(), self.axis, event.position())
            self.setCursor(Qt.CursorShape.ArrowCursor if over is None else Qt.CursorShape.SplitHCursor)
        else:
            self._put(held.boundary, held.seconds)

    @override
    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        if self._drag.release() is not None and self.ends is not None:
            self.trimmed.emit(*self.ends)

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {Qt.Key.Key_Left: -0.01, Qt.Key.Key_Right: 0.01}
        if event.key() not in steps or self.ends is None:
            super().keyPressEvent(event)
            return
        end = int(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        low, high = self._rows()[0][1].room_of(end, self._duration)
        self._put(end, min(max(self.ends[end] + steps[Qt.Key(event.key())], low), high))
        self.trimmed.emit(*self.ends)

    def _show(self) -> None:
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        if self._drag.held is None:
            self.ends = (take.start, take.end) if take is not None else None
        self.update()

    def _put(self, end: int, seconds: float) -> None:
        if self.ends is not None:
            self.ends = (self.ends[0], seconds) if end else (seconds, self.ends[1])
            self.update()

    def _columns(self) -> dict[str, Float32Array | Float64Array]:
        sound = self._takes.sound
        return {tr("time (s)"): np.arange(len(sound)) / SAMPLE_RATE, "amplitude": sound}

    def _paint_sound(self, painter: QPainter, left: float, right: float, counting: QColor) -> None:
        sound, width, height = self._takes.sound, max(1, self.width()), max(3, self.height() - HEADING)
        edges = np.linspace(0, len(sound), width + 1).astype(int)[:-1]
        peaks = Peaks(np.minimum.reduceat(sound, edges), np.maximum.reduceat(sound, edges))
        loudest = max(float(np.abs(sound).max()), 1e-4) / SHARE
        columns, base = np.arange(width), QColor(self._theme.base)
        counts = (left <= columns) & (columns <= right)
        colour = np.where(counts, QColor(self._theme.signal).rgb(), QColor(self._theme.faint).rgb())
        background = np.where(counts, mixed(counting, base, THINNED).rgb(), base.rgb())
        pixels = wave_pixels(peaks, loudest, height, colour.astype(np.uint32), background.astype(np.uint32))
        image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
        painter.drawImage(0, HEADING, image)

    @property
    def _duration(self) -> float:
        return max(len(self._takes.sound) / SAMPLE_RATE, 1e-3)

    @property
    def axis(self) -> TimeAxis:
        """Where times lie."""
        return TimeAxis(0, max(1, self.width()), 0.0, self._duration)

    def _rows(self) -> list[tuple[QRectF, Lane]]:
        """Return what counts as a lane of one span, whose ends can be dragged anywhere on the widget."""
        if self.ends is None:
            return []
        starts, ends = (np.array([end]) for end in self.ends)
        return [(QRectF(self.rect()), Lane("", starts, ends, movable=True, least=LEAST))]
