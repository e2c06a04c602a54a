"""Letters on a painter: their size, their colour, and where they stand."""

import math
from functools import cache

from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter

AT_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
AT_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
READABLE = 0.179
"""The luminance at which black and white stand out from a colour alike."""
CENTRED = Qt.AlignmentFlag.AlignCenter


def set_size(painter: QPainter, size: int) -> None:
    """Have letters be so high from now on, pixels."""
    font = painter.font()
    if font.pixelSize() != size:
        font.setPixelSize(size)
        painter.setFont(font)


def draw_text(
    painter: QPainter,
    box: QRectF | QRect,
    text: str,
    colour: str | QColor,
    size: int,
    align: Qt.AlignmentFlag = AT_LEFT,
) -> None:
    """Write one line into a box; words that have no room are shortened by `shortened`.

    Parameters
    ----------
    size : of the letters, pixels.
    """
    set_size(painter, size)
    painter.setPen(QColor(colour))
    if size * len(text) > box.width():  # no letter is wider than high
        text = shortened(painter.fontMetrics(), text, math.floor(box.width()))
    painter.drawText(box, align, text)


def shortened(metrics: QFontMetrics, text: str, width: int) -> str:
    """Return as much of a line as has room, pixels, with three dots at its end; nothing where these have none.

    A single letter is whole or not there, and no word is shortened to its first letter: it would read as another.
    """
    short = metrics.elidedText(text, Qt.TextElideMode.ElideRight, width)
    whole_or_told = short == text or len(text) > 1
    has_room = whole_or_told and metrics.horizontalAdvance(short) <= width  # Qt gives one letter uncut
    return short if has_room else ""


def mixed(colour: QColor, other: QColor, share: float) -> QColor:
    """Return a colour of which so much is the first one, 0..1, and the rest the other."""
    parts = ((one.red(), one.green(), one.blue()) for one in (colour, other))
    return QColor(*(round(share * a + (1 - share) * b) for a, b in zip(*parts, strict=True)))


@cache
def letters_on(colour: str) -> str:
    """Return black or white, whichever is read better on a colour, #rrggbb, by the luminance of WCAG 2.2."""
    return "#000000" if _luminance(QColor(colour)) > READABLE else "#ffffff"


def _luminance(colour: QColor) -> float:
    shares = (colour.redF(), colour.greenF(), colour.blueF())
    red, green, blue = (s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def size_that_fills(painter: QPainter, text: str, width: float, smallest: int, largest: int) -> int:
    """Return the size in which a text is as wide as that, pixels, within limits."""
    set_size(painter, 100)
    wide = max(1, painter.fontMetrics().horizontalAdvance(text))
    return max(smallest, min(largest, math.floor(100 * width / wide)))


def format_clock(seconds: float, fine: bool) -> str:
    """Write seconds as 1:02:03.4, without hours where there are none."""
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    tail = f"{int(rest * 10) / 10:04.1f}" if fine else f"{int(rest):02d}"
    return f"{hours}:{minutes:02d}:{tail}" if hours else f"{minutes}:{tail}"
