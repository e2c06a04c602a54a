"""The colour bar beside the sonagram."""

from typing import Any

import numpy as np
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QWidget

from phonemeanalyser.desktop.painting import set_size
from phonemeengine.arrays import UInt32Array

BAR = 14
"""Width of the bar in pixels."""


class ColourBar(QWidget):
    """Shows which colour stands for which amplitude, brightest on top."""

    def __init__(self) -> None:
        super().__init__()
        self._colours = np.zeros((256, 1), np.uint32)
        self._labels = ("", "", "")
        self.setFixedWidth(58)

    def draw(self, colours: UInt32Array, low: str, middle: str, high: str) -> None:
        """Draw a colour map, 256 pixels, with the values at its ends and middle."""
        self._colours = np.ascontiguousarray(colours[::-1, None])
        self._labels = (high, middle, low)
        self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint the bar and its three labels."""
        painter = QPainter(self)
        top, height = 12, self.height() - 24
        image = QImage(self._colours.data, 1, 256, 4, QImage.Format.Format_RGB32)
        painter.drawImage(QRect(4, top, BAR, height), image)
        set_size(painter, 10)
        align = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        for label, y in zip(self._labels, (top, top + height // 2, top + height), strict=True):
            painter.drawText(QRect(BAR + 7, y - 8, self.width() - BAR - 7, 16), align, label)
