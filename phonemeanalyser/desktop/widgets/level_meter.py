"""How loud the microphone is: peak, held peak, and a light for clipping."""

import math
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.theme import Theme, set_size
from phonemeengine.audio.level import Level

LOWEST_DB, LOUD_DB = -60.0, -6.0
MARKS_DB = (-48, -36, -24, -12, 0)
SOFT_DB = -30.0
"""A voice whose peaks stay below is too soft: turn the gain of the microphone up."""
LIGHT_WIDTH = 92
GAP = 6
"""Pixels between two marks that are written."""
FORGOTTEN = 60.0
"""Seconds after which a clipping is not told any more."""


class LevelMeterView(QWidget):
    """Paints the level from -60 to 0 dB below full scale.

    Parameters
    ----------
    read_level : tells what it is now.
    """

    def __init__(self, read_level: Callable[[], Level], theme: Theme) -> None:
        super().__init__()
        self._read_level = read_level
        self._theme = theme
        self.setMinimumSize(200, 28)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr("Microphone level"))
        self.setToolTip(
            tr(
                "Peak level of the microphone in dBFS, and the highest peak of the last 1.5 s. Raise the gain if "
                "it reads low, reduce it if it reads high. The light shows for one minute that the signal clipped"
            )
        )

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        level = self._read_level()
        track = QRectF(2, 4, self.width() - LIGHT_WIDTH - 8, 10)
        painter.fillRect(track, QColor(self._theme.line))
        x = self._x_of(level.peak, track)
        loud = level.peak >= 10 ** (LOUD_DB / 20)
        painter.fillRect(
            QRectF(track.left(), 4, x - track.left(), 10), QColor(self._theme.bad if loud else self._theme.good)
        )
        painter.fillRect(QRectF(self._x_of(level.held, track) - 1, 3, 2, 12), QColor(self._theme.text))
        self._paint_scale(painter, track)
        self._paint_light(painter, level)

    def _paint_scale(self, painter: QPainter, track: QRectF) -> None:
        set_size(painter, 9)
        painter.setPen(QColor(self._theme.faint))
        written = marks_that_fit(painter.fontMetrics().horizontalAdvance, track.width())
        for mark in MARKS_DB:
            x = self._x_of(10 ** (mark / 20), track)
            painter.fillRect(QRectF(x, 14, 1, 3), QColor(self._theme.faint))
            if mark in written:
                align = Qt.AlignmentFlag.AlignRight if mark == 0 else Qt.AlignmentFlag.AlignHCenter
                painter.drawText(QRectF(x - 30, 16, 31 if mark == 0 else 60, 12), align, _text_of(mark))

    def _paint_light(self, painter: QPainter, level: Level) -> None:
        ago = level.clipped_ago
        recent = ago is not None and ago < FORGOTTEN
        box = QRectF(self.width() - LIGHT_WIDTH, 3, LIGHT_WIDTH - 2, 22)
        fresh = recent and ago is not None and ago < 1.0
        painter.fillRect(box, QColor(self._theme.bad if fresh else self._theme.raised))
        faded = self._theme.bad if recent else self._theme.faint
        painter.setPen(QColor(self._theme.on_colour if fresh else faded))
        set_size(painter, 10)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words_of(ago, level.held))

    def _x_of(self, amplitude: float, track: QRectF) -> float:
        decibels = 20 * math.log10(max(amplitude, 1e-6))
        share = (decibels - LOWEST_DB) / -LOWEST_DB
        return track.left() + track.width() * min(max(share, 0.0), 1.0)


def marks_that_fit(width_of: Callable[[str], int], width: float) -> set[int]:
    """Return the marks that are written on a scale of some pixels, from the right, so that none runs into another."""
    written, left = set(), math.inf
    for mark in reversed(MARKS_DB):
        x = width * (mark - LOWEST_DB) / -LOWEST_DB
        half = width_of(_text_of(mark)) / 2
        end, start = (x, x - 2 * half) if mark == 0 else (x + half, x - half)
        if end + GAP <= left:
            written.add(mark)
            left = start
    return written


def _text_of(mark: int) -> str:
    return "0 dB" if mark == 0 else str(mark).replace("-", "−")


def words_of(ago: float | None, held: float = 0.0) -> str:
    """Return how long ago a sample was clipped, else how well the gain suits the highest peak of late."""
    if ago is None or ago >= FORGOTTEN:
        decibels = 20 * math.log10(max(held, 1e-6))
        if decibels <= LOWEST_DB:
            return tr("no clipping")
        suits = tr("high") if decibels > LOUD_DB else tr("low") if decibels < SOFT_DB else tr("good")
        return f"{decibels:.0f} dB, {suits}".replace("-", "−")
    return tr("CLIPPED") if ago < 1 else tr("clipped {seconds:.0f} s ago").format(seconds=ago)
