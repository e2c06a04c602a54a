"""The sound of the chosen take, with the ends of what counts of it to be dragged."""

from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.calibrate.takes.takes_model import TakesModel
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.painting import set_size
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import SAMPLE_RATE

HEADING = 15
"""Pixels above the sound, for words."""
NEAR = 8
"""Pixels from an end within which it is taken hold of."""
LEAST = 0.03
"""What counts lasts at least so long, seconds."""


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
        self._held: int | None = None
        self.setMinimumSize(120, 64)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(tr("trim the take"))
        self.setToolTip(
            tr("Drag the ends of what counts; arrow keys move the beginning by 10 ms, with Shift the end")
        )
        self.menu = PlotMenu(self, "take", lambda _at: table_of(self._columns()))
        takes.changed.connect(self._show)
        takes.sound_read.connect(self._show)

    def paintEvent(self, _event: Any) -> None:
        """Paint the sound, what counts of it, and how long that is."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        sound = self._takes.sound
        if take is None or self.ends is None or not len(sound):
            painter.setPen(QColor(self._theme.faint))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, tr("choose a take to hear and trim it"))
            return
        left, right = (self._x_of(end) for end in self.ends)
        counting = QColor(PHONEME_COLOURS[take.phoneme])
        painter.fillRect(QRectF(left, HEADING, right - left, self.height() - HEADING), _thinned(counting))
        self._paint_sound(painter, left, right)
        for x in (left, right):
            painter.fillRect(QRectF(x - 1, HEADING, 2, self.height() - HEADING), counting)
            painter.fillRect(QRectF(x - 4, (self.height() + HEADING) / 2 - 8, 8, 16), counting)
        painter.setPen(QColor(self._theme.text))
        set_size(painter, 10)
        words = f"{take.name}   " + tr("{start:.2f} – {end:.2f} s of {duration:.2f} s").format(
            start=self.ends[0], end=self.ends[1], duration=take.duration
        )
        painter.drawText(self.rect().adjusted(6, 2, -4, 0), Qt.AlignmentFlag.AlignLeft, words)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the nearer end."""
        self.setFocus()
        if event.button() == Qt.MouseButton.LeftButton:
            self._held = self._end_near(event.position().x())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move the end that is held."""
        x = event.position().x()
        if self._held is None:
            shape = Qt.CursorShape.ArrowCursor if self._end_near(x) is None else Qt.CursorShape.SizeHorCursor
            self.setCursor(shape)
        else:
            self._move(self._held, self._seconds_at(x))

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let what was dragged count."""
        if self._held is not None and self.ends is not None:
            self._held = None
            self.trimmed.emit(*self.ends)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move an end by 10 ms."""
        steps = {Qt.Key.Key_Left: -0.01, Qt.Key.Key_Right: 0.01}
        if event.key() not in steps or self.ends is None:
            super().keyPressEvent(event)
            return
        end = int(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        self._move(end, self.ends[end] + steps[Qt.Key(event.key())])
        self.trimmed.emit(*self.ends)

    def _show(self) -> None:
        take = self._takes.take(self._takes.selected) if self._takes.selected is not None else None
        if self._held is None:
            self.ends = (take.start, take.end) if take is not None else None
        self.update()

    def _move(self, end: int, seconds: float) -> None:
        if self.ends is None:
            return
        start, stop = self.ends
        if end == 0:
            start = min(max(0.0, seconds), stop - LEAST)
        else:
            stop = max(min(self._duration, seconds), start + LEAST)
        self.ends = max(0.0, start), min(stop, self._duration)
        self.update()

    def _columns(self) -> dict[str, Float32Array | Float64Array]:
        sound = self._takes.sound
        return {tr("time (s)"): np.arange(len(sound)) / SAMPLE_RATE, "amplitude": sound}

    def _paint_sound(self, painter: QPainter, left: float, right: float) -> None:
        sound, width = self._takes.sound, max(1, self.width())
        edges = np.linspace(0, len(sound), width + 1).astype(int)[:-1]
        high, low = np.maximum.reduceat(sound, edges), np.minimum.reduceat(sound, edges)
        scale = 0.46 * (self.height() - HEADING) / max(float(np.abs(sound).max()), 1e-4)
        middle = (self.height() + HEADING) / 2
        inside, outside = QColor(self._theme.signal), QColor(self._theme.faint)
        for x, (top, bottom) in enumerate(zip(high.tolist(), low.tolist(), strict=True)):
            painter.setPen(inside if left <= x <= right else outside)
            painter.drawLine(x, round(middle - scale * top), x, round(middle - scale * bottom))

    @property
    def _duration(self) -> float:
        return max(len(self._takes.sound) / SAMPLE_RATE, 1e-3)

    def _x_of(self, seconds: float) -> float:
        return seconds / self._duration * self.width()

    def _seconds_at(self, x: float) -> float:
        return round(x / max(1, self.width()) * self._duration, 3)

    def _end_near(self, x: float) -> int | None:
        if self.ends is None:
            return None
        distances = [abs(self._x_of(end) - x) for end in self.ends]
        nearest = distances.index(min(distances))
        return nearest if distances[nearest] <= NEAR else None


def _thinned(colour: QColor) -> QColor:
    return QColor(colour.red(), colour.green(), colour.blue(), 60)
