"""How the chosen variable is spread over each phoneme, with the preset's thresholds to be dragged."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from phonemeanalyser.desktop.calibrate.workbench.workbench_model import Line, WorkbenchModel
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.painting import AT_RIGHT, CENTRED, draw_text
from phonemeanalyser.desktop.theme import PHONEME_COLOURS, Theme
from phonemeanalyser.desktop.widgets.plot_menu import PlotMenu, table_of
from phonemeengine.calibration.workbench.distributions import Distribution, Quartiles
from phonemeengine.features.variables import unit_of
from phonemeengine.phonemes import Phoneme

LEFT, RIGHT, TOP, BOTTOM = 88, 168, 36, 34
"""Pixels around the plot: names at its left, numbers at its right, thresholds above, the axis below."""
NEAR = 6
COLUMNS = (tr_noop("min"), tr_noop("median"), tr_noop("max"))


class DistributionView(QWidget):
    """A row for each phoneme: its histogram, mirrored, with quartiles, median and ends; and its numbers."""

    def __init__(self, workbench: WorkbenchModel, theme: Theme) -> None:
        super().__init__()
        self._workbench = workbench
        self._theme = theme
        self.lines: list[Line] = []
        self._held: Line | None = None
        self._chosen = 0
        self.setMinimumSize(380, 170)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(tr("distribution of the variable"))
        self.setToolTip(
            tr(
                "Each row is a sound: histogram, a box from quartile to quartile, the median, and a line from "
                "minimum to maximum. Drag a threshold, or move it with the arrow keys (Shift: finer; Up and Down "
                "choose one)"
            )
        )
        self.menu = PlotMenu(self, "distribution", lambda _at: table_of(self._columns()))
        workbench.distribution_changed.connect(self.show_lines)
        self.show_lines()

    def show_lines(self) -> None:
        """Show the thresholds of the preset as they are now."""
        if self._held is None:
            self.lines = self._workbench.lines()
            self._chosen = min(self._chosen, max(0, len(self.lines) - 1))
        self.update()

    def x_of(self, value: float) -> float:
        """Return where a value lies, pixels."""
        distribution = self._workbench.shown
        if distribution is None:
            return float(LEFT)
        low, high = float(distribution.edges[0]), float(distribution.edges[-1])
        if distribution.logarithmic:
            share = (math.log(max(value, low)) - math.log(low)) / (math.log(high) - math.log(low))
        else:
            share = (value - low) / (high - low)
        return LEFT + min(max(share, 0.0), 1.0) * (self.width() - LEFT - RIGHT)

    def value_at(self, x: float) -> float:
        """Return the value that lies at a pixel."""
        distribution = self._workbench.shown
        if distribution is None:
            return 0.0
        low, high = float(distribution.edges[0]), float(distribution.edges[-1])
        share = min(max((x - LEFT) / max(1, self.width() - LEFT - RIGHT), 0.0), 1.0)
        return low * (high / low) ** share if distribution.logarithmic else low + share * (high - low)

    # -- painting -----------------------------------------------------------------------------------------

    def paintEvent(self, _event: Any) -> None:
        """Paint rows, axis and thresholds."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        distribution = self._workbench.shown
        if distribution is None:
            words = (
                tr("measuring …")
                if self._workbench.measuring.busy
                else tr("Record takes, or load labelled recordings, to see how they are spread")
            )
            draw_text(painter, QRectF(self.rect()), words, self._theme.faint, 13, CENTRED)
            return
        self._paint_axis(painter, distribution)
        height = (self.height() - TOP - BOTTOM) / max(1, len(distribution.spreads))
        for k, (phoneme, spread) in enumerate(distribution.spreads.items()):
            self._paint_row(painter, distribution, phoneme, spread, TOP + k * height, height)
        for k, line in enumerate(self.lines):
            self._paint_line(painter, k, line)
        if self._workbench.preview is not None:
            self._paint_best(painter, self._workbench.preview.threshold)

    def _paint_row(
        self,
        painter: QPainter,
        distribution: Distribution,
        phoneme: Phoneme,
        spread: Quartiles,
        top: float,
        height: float,
    ) -> None:
        colour, middle = QColor(PHONEME_COLOURS[phoneme]), top + height / 2
        row = QRectF(0, top, self.width(), height)
        draw_text(painter, row.adjusted(8, 0, 0, 0), phoneme.label, self._theme.text, 12)
        self._paint_histogram(painter, distribution, spread, colour, middle, 0.46 * height)
        painter.setPen(QColor(self._theme.text))
        low, high = self.x_of(spread.minimum), self.x_of(spread.maximum)
        painter.drawLine(QPointF(low, middle), QPointF(high, middle))
        for x in (low, high):
            painter.drawLine(QPointF(x, middle - 3), QPointF(x, middle + 3))
        first, last = self.x_of(spread.lower_quartile), self.x_of(spread.upper_quartile)
        half = min(5.0, 0.24 * height)
        painter.fillRect(QRectF(first, middle - half, max(2.0, last - first), 2 * half), colour)
        painter.drawRect(QRectF(first, middle - half, max(2.0, last - first), 2 * half))
        x = self.x_of(spread.median)
        painter.fillRect(QRectF(x - 1.5, middle - half - 2, 3, 2 * half + 4), QColor(self._theme.text))
        for k, value in enumerate((spread.minimum, spread.median, spread.maximum)):
            draw_text(painter, self._cell(k, top, height), short(value), self._theme.text, 11, AT_RIGHT)

    def _paint_histogram(
        self,
        painter: QPainter,
        distribution: Distribution,
        spread: Quartiles,
        colour: QColor,
        middle: float,
        most: float,
    ) -> None:
        heights = most * spread.counts / max(1, int(spread.counts.max()))
        xs = [self.x_of(float(edge)) for edge in distribution.edges]
        centres = (np.array(xs[1:]) + np.array(xs[:-1])) / 2
        upper = [QPointF(x, middle - h) for x, h in zip(centres.tolist(), heights.tolist(), strict=True)]
        lower = [QPointF(p.x(), 2 * middle - p.y()) for p in reversed(upper)]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colour.red(), colour.green(), colour.blue(), 90))
        painter.drawPolygon(QPolygonF([*upper, *lower]))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_axis(self, painter: QPainter, distribution: Distribution) -> None:
        bottom = self.height() - BOTTOM
        for value in _ticks(distribution):
            x = self.x_of(value)
            painter.fillRect(QRectF(x, TOP, 1, bottom - TOP), QColor(self._theme.raised))
            draw_text(painter, QRectF(x - 40, bottom + 2, 80, 14), short(value), self._theme.faint, 10, CENTRED)
        scale = ", " + tr("logarithmic scale") if distribution.logarithmic else ""
        label = QRectF(LEFT, bottom + 15, self.width() - LEFT - RIGHT, 16)
        text = f"{distribution.variable} ({tr(self._unit_of(distribution))}){scale}"
        draw_text(painter, label, text, self._theme.text, 11, CENTRED)
        for k, name in enumerate(COLUMNS):
            draw_text(painter, self._cell(k, TOP - 18, 16), tr(name), self._theme.faint, 10, AT_RIGHT)

    def _paint_line(self, painter: QPainter, k: int, line: Line) -> None:
        x, colour = self.x_of(line.value), QColor(self._theme.bad)
        chosen = self.hasFocus() and k == self._chosen
        painter.fillRect(
            QRectF(x - (1 if chosen else 0.5), TOP - 4, 2 if chosen else 1.2, self.height() - TOP - BOTTOM + 4),
            colour,
        )
        tip = QPolygonF([QPointF(x - 4, TOP - 8), QPointF(x + 4, TOP - 8), QPointF(x, TOP - 1)])
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawPolygon(tip)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        text = f"{line.sign} {short(line.value)}  {line.label}"
        box = QRectF(x - 75, 1 + 13 * (k % 2), 150, 13)
        box.moveLeft(min(max(box.left(), 4.0), self.width() - RIGHT - 146.0))
        draw_text(painter, box, text, self._theme.bad, 10, CENTRED)

    def _paint_best(self, painter: QPainter, threshold: float) -> None:
        """Paint where a suggested variable parts best; it is no threshold of the preset, and cannot be dragged."""
        x = self.x_of(threshold)
        painter.setPen(QPen(QColor(self._theme.accent), 1.2, Qt.PenStyle.DashLine))
        painter.drawLine(QPointF(x, TOP - 4), QPointF(x, self.height() - BOTTOM))
        box = QRectF(x - 75, 1, 150, 13)
        box.moveLeft(min(max(box.left(), 4.0), self.width() - RIGHT - 146.0))
        draw_text(
            painter, box, tr("parts best at {value}").format(value=short(threshold)), self._theme.accent, 10, CENTRED
        )

    def _unit_of(self, distribution: Distribution) -> str:
        return unit_of(distribution.variable, self._workbench.own_variables)

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return what is drawn as columns, each under its name and unit."""
        distribution = self._workbench.shown
        if distribution is None:
            return {}
        unit, spreads = self._unit_of(distribution), distribution.spreads.values()
        numbers = ("minimum", "lower_quartile", "median", "upper_quartile", "maximum")
        return {
            "sound": [phoneme.label for phoneme in distribution.spreads],
            "frames (10 ms)": [spread.n for spread in spreads],
            **{
                f"{name.replace('_', ' ')} of {distribution.variable} ({unit})": [getattr(s, name) for s in spreads]
                for name in numbers
            },
        }

    def _cell(self, k: int, top: float, height: float) -> QRectF:
        width = (RIGHT - 16) / len(COLUMNS)
        return QRectF(self.width() - RIGHT + 8 + k * width, top, width, height)

    # -- dragging -----------------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a threshold."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self.setFocus()
        self._held = self._line_near(event.position().x())
        if self._held is not None:
            self._chosen = self.lines.index(self._held)
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move the threshold that is held."""
        x = event.position().x()
        if self._held is None:
            near = self._line_near(x) is not None
            self.setCursor(Qt.CursorShape.SizeHorCursor if near else Qt.CursorShape.ArrowCursor)
            return
        self._move(self._held, self.value_at(x))

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """End the drag."""
        if self._held is not None:
            self._held = None
            self._workbench.end_move()
            self.show_lines()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move the chosen threshold by a pixel or a tenth of one; choose another with Up and Down."""
        steps = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
        choices = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}
        if self.lines and event.key() in choices:
            self._chosen = (self._chosen + choices[Qt.Key(event.key())]) % len(self.lines)
            self.update()
        elif self.lines and event.key() in steps:
            line = self.lines[self._chosen]
            fine = 0.1 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
            self._move(line, self.value_at(self.x_of(line.value) + fine * steps[Qt.Key(event.key())]))
        else:
            super().keyPressEvent(event)

    def _move(self, line: Line, value: float) -> None:
        self._workbench.move(line, value)
        self.lines = self._workbench.lines()
        if self._held is not None:
            self._held = next((fresh for fresh in self.lines if fresh.name == line.name), None)
        self.update()

    def _line_near(self, x: float) -> Line | None:
        near = [line for line in self.lines if abs(self.x_of(line.value) - x) <= NEAR]
        return min(near, key=lambda line: abs(self.x_of(line.value) - x)) if near else None


def short(value: float) -> str:
    """Write a number with three digits that count."""
    return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def _ticks(distribution: Distribution) -> list[float]:
    low, high = float(distribution.edges[0]), float(distribution.edges[-1])
    if distribution.logarithmic:
        return [10.0**k for k in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
    step = 10 ** math.floor(math.log10((high - low) / 4))
    step *= next(m for m in (1, 2, 5, 10) if (high - low) / (m * step) <= 8)
    return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]
