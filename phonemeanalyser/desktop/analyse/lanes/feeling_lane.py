"""The lane of the feeling in a voice: activation above pleasantness, each with its standard error as a band."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from phonemeanalyser.desktop.analyse.lanes.sonagram import usual_of
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.seen_tracks import KnownFeelings
from phonemeanalyser.desktop.theme import AT_LEFT, AT_RIGHT, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.lanes import TimeAxis
from phonemeanalyser.desktop.widgets.plot import broken_line
from phonemeengine.features.feeling import Feeling
from phonemeengine.settings import FRAME_PERIOD

FEELING_HEIGHT = 50
"""Pixels of the lane."""
BAND_ALPHA, GROUND_ALPHA = 70, 190
"""How opaque the bands are, and the ground of their names, 0..255."""
LETTERS = 10
PARTS = ((0, tr_noop("Activation")), (2, tr_noop("Pleasantness")))
"""The column of each value, before that of its standard error, and its name."""


def feeling_tip() -> str:
    """Return what the lane shows, and what it doesn't."""
    return tr(
        "How the voice differs from the speaker's usual voice, −1 to 1: activation (level, pitch, range, rate, "
        "spectral tilt) and, far less certain, pleasantness. The band is the standard error; it fills the lane where "
        "nothing is known: before the first voiced second, in pauses, in a whisper. The lane identifies no emotion: "
        "anger and joy both raise activation."
    )


def feeling_words(feeling: Feeling) -> list[str]:
    """Return both values with their standard errors, in words."""
    values = (feeling[:2], feeling[2:])
    return [
        f"{tr(name)} {value:+.2f} ± {spread:.2f}" for (_, name), (value, spread) in zip(PARTS, values, strict=True)
    ]


def paint_feelings(painter: QPainter, row: QRectF, axis: TimeAxis, known: KnownFeelings, theme: Theme) -> None:
    """Paint what is known into a row, one value above the other."""
    painter.save()
    painter.setClipRect(row, Qt.ClipOperation.IntersectClip)
    painter.fillRect(row, QColor(theme.base))
    per_point = max(1, int(np.ceil(axis.seconds / FRAME_PERIOD / max(axis.width, 1))))
    felt = usual_of(known.felt, per_point, known.first)
    times = (known.first // per_point + np.arange(len(felt)) + 0.5) * per_point * FRAME_PERIOD
    x = axis.left + (times - axis.start) / axis.seconds * axis.width
    height = (row.height() - 1) / len(PARTS)
    for k, (column, name) in enumerate(PARTS):
        part = QRectF(row.left(), row.top() + k * (height + 1), row.width(), height)
        _paint_part(painter, part, x, felt[:, column : column + 2], theme)
        _paint_name(painter, part, tr(name), theme)
    painter.setPen(QColor(theme.line))
    painter.drawLine(QPointF(row.left(), row.center().y()), QPointF(row.right(), row.center().y()))
    painter.restore()


def paint_feeling_scale(painter: QPainter, row: QRectF, theme: Theme) -> None:
    """Write the ends of the scale to the left of a row."""
    height = row.height() / len(PARTS)
    for k in range(len(PARTS)):
        for text, top in (("1", 0.0), ("−1", height - 11)):
            box = QRectF(0, row.top() + k * height + top, row.left() - 7, 11)
            draw_text(painter, box, text, theme.faint, LETTERS, AT_RIGHT)


def _paint_part(painter: QPainter, part: QRectF, x: np.ndarray, felt: np.ndarray, theme: Theme) -> None:
    low, value, high = (
        part.center().y() - np.clip(level, -1, 1).astype(np.float64) * (part.height() / 2 - 1)
        for level in (felt[:, 0] - felt[:, 1], felt[:, 0], felt[:, 0] + felt[:, 1])
    )
    band = QColor(theme.signal)
    band.setAlpha(BAND_ALPHA)
    painter.setPen(QPen(QColor(theme.line), 1, Qt.PenStyle.DotLine))
    painter.drawLine(QPointF(part.left(), part.center().y()), QPointF(part.right(), part.center().y()))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(band)
    for above, below in zip(broken_line(x, high), broken_line(x, low), strict=True):
        painter.drawPolygon(QPolygonF([*above.toList(), *reversed(below.toList())]))
    painter.setPen(QPen(QColor(theme.signal), 1))
    for line in broken_line(x, value):
        painter.drawPolyline(line)


def _paint_name(painter: QPainter, part: QRectF, name: str, theme: Theme) -> None:
    set_size(painter, LETTERS)
    ground = QColor(theme.base)
    ground.setAlpha(GROUND_ALPHA)
    box = QRectF(part.left() + 2, part.top() + 1, painter.fontMetrics().horizontalAdvance(name) + 6, 12)
    painter.fillRect(box, ground)
    draw_text(painter, box.adjusted(3, 0, 0, 0), name, theme.text, LETTERS, AT_LEFT)
