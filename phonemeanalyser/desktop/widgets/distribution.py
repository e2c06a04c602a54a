"""How the chosen variable is spread over each phoneme, with the preset's thresholds to be dragged."""

import math
from collections.abc import Sequence
from html import escape
from typing import Any, Protocol

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QComboBox, QSizePolicy, QToolTip, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import sound_name, tr_engine
from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.theme import AT_RIGHT, CENTRED, PHONEME_COLOURS, Theme, draw_text, set_size
from phonemeanalyser.desktop.widgets.plot import PlotMenu, table_of
from phonemeengine.calibration.workbench.distributions import Distribution, Quartiles
from phonemeengine.phonemes import Phoneme

TOP, BOTTOM = 36, 34
"""Pixels above the plot, for the thresholds, and below it, for the axis."""
WIDE, NARROW = (88, 168), (60, 148)
"""Pixels at its left, for the names, and at its right, for the numbers."""
NEAR = 6
TICK_WIDTH = 40
"""Pixels for each number below the axis, at least."""
COLUMNS = (tr_noop("min"), tr_noop("median"), tr_noop("max"))
TAKEN = (
    tr_noop("Smallest {variable} of {sound}: {value}."),
    tr_noop("Median {variable} of {sound}: {value}."),
    tr_noop("Largest {variable} of {sound}: {value}."),
)


class DrawnThreshold(Protocol):
    """A threshold that is drawn over a distribution."""

    @property
    def name(self) -> str:
        """The control's."""

    @property
    def label(self) -> str:
        """What it is called where it is drawn."""

    @property
    def sign(self) -> str:
        """The comparison with it, ``<`` or ``>``."""

    @property
    def value(self) -> float:
        """Where it lies."""


class ThresholdSource(Protocol):
    """The thresholds of variables."""

    def lines_of(self, variable: str) -> Sequence[DrawnThreshold]:
        """Return those that a variable is compared with."""

    def move(self, name: str, value: float) -> None:
        """Move one."""

    def end_move(self) -> None:
        """End a drag."""

    def words_of(self, variable: str) -> str:
        """Return what a variable measures, in words."""

    def unit_of(self, variable: str) -> str:
        """Return the unit of a variable."""


class DistributionView(QWidget):
    """A row for each phoneme: its histogram, mirrored, with quartiles, median and ends; and its numbers.

    A click on a number makes it the value of the chosen threshold.

    Parameters
    ----------
    thresholds : what is drawn over the distribution, and can be dragged.
    narrow : whether it has to do with little room.
    """

    def __init__(self, thresholds: ThresholdSource, theme: Theme, *, narrow: bool = False) -> None:
        super().__init__()
        self._thresholds = thresholds
        self._theme = theme
        self._left, self._right = NARROW if narrow else WIDE
        self._digits = 2 if narrow else 3
        self._distribution: Distribution | None = None
        self._words, self._best = "", float("nan")
        self.lines: Sequence[DrawnThreshold] = []
        self._held: DrawnThreshold | None = None
        self._chosen = 0
        self.setMinimumSize(250 if narrow else 380, 170)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(tr("Distribution of the variable"))
        self.setToolTip(
            tr(
                "<p>One row per phoneme: histogram, box from quartile to quartile, median, and a line from "
                "minimum to maximum.</p><p>Drag a threshold, or move it with Left and Right (Shift: in finer "
                "steps); Up and Down select one. Click a number to make it the value of the threshold.</p>"
            )
        )
        self.menu = PlotMenu(self, "distribution", lambda _at: table_of(self._columns()))

    def show_distribution(self, shown: Distribution | None, words: str = "", best: float = float("nan")) -> None:
        """Show another distribution; without one, these words; `best` is a threshold that is suggested, or NaN."""
        self._distribution, self._words, self._best = shown, words, best
        self.show_lines()

    def show_lines(self) -> None:
        """Show the thresholds of the preset as they are now."""
        if self._held is None:
            shown = self._distribution
            self.lines = [] if shown is None else self._thresholds.lines_of(shown.variable)
            self._chosen = min(self._chosen, max(0, len(self.lines) - 1))
        self.update()

    def choose_line(self, name: str) -> None:
        """Have the keys, and a click on a number, move a threshold."""
        self._chosen = next((k for k, line in enumerate(self.lines) if line.name == name), self._chosen)
        self.update()

    def x_of(self, value: float) -> float:
        """Return where a value lies, pixels."""
        distribution = self._distribution
        if distribution is None:
            return float(self._left)
        low, high = float(distribution.edges[0]), float(distribution.edges[-1])
        if distribution.logarithmic:
            share = (math.log(max(value, low)) - math.log(low)) / (math.log(high) - math.log(low))
        else:
            share = (value - low) / (high - low)
        return self._left + min(max(share, 0.0), 1.0) * (self.width() - self._left - self._right)

    def value_at(self, x: float) -> float:
        """Return the value that lies at a pixel."""
        distribution = self._distribution
        if distribution is None:
            return 0.0
        low, high = float(distribution.edges[0]), float(distribution.edges[-1])
        share = min(max((x - self._left) / max(1, self.width() - self._left - self._right), 0.0), 1.0)
        return low * (high / low) ** share if distribution.logarithmic else low + share * (high - low)

    def number_at(self, place: QPointF) -> tuple[Phoneme, int, float] | None:
        """Return whose number lies at a place, which of `COLUMNS` it is, and its value."""
        shown = self._distribution
        if shown is None or not shown.spreads:
            return None
        height = (self.height() - TOP - BOTTOM) / len(shown.spreads)
        for row, (phoneme, spread) in enumerate(shown.spreads.items()):
            for k, value in enumerate((spread.minimum, spread.median, spread.maximum)):
                if self._cell(k, TOP + row * height, height).contains(place):
                    return phoneme, k, value
        return None

    @override
    def event(self, event: QEvent) -> bool:
        """Tell what a number is, and what a click on it does."""
        found = None
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            found = self.number_at(QPointF(event.pos()))
        if found is None or self._distribution is None or not isinstance(event, QHelpEvent):
            return super().event(event)
        phoneme, k, value = found
        told = tr(TAKEN[k]).format(
            variable=self._thresholds.words_of(self._distribution.variable),
            sound=sound_name(phoneme),
            value=short(value),
        )
        if self.lines:
            told += " " + tr("Click: make it the value of {threshold}").format(
                threshold=tr_engine(self.lines[self._chosen].label)
            )
        QToolTip.showText(event.globalPos(), f"<p>{escape(told)}</p>", self)
        return True

    # -- painting -----------------------------------------------------------------------------------------

    @override
    def paintEvent(self, _event: Any) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        distribution = self._distribution
        if distribution is None or not distribution.spreads:
            inner = QRectF(self.rect()).adjusted(8, 8, -8, -8)
            set_size(painter, 13)
            painter.setPen(QColor(self._theme.faint))
            painter.drawText(inner, CENTRED | Qt.TextFlag.TextWordWrap, self._words)
            return
        self._paint_axis(painter, distribution)
        height = (self.height() - TOP - BOTTOM) / max(1, len(distribution.spreads))
        for k, (phoneme, spread) in enumerate(distribution.spreads.items()):
            self._paint_row(painter, distribution, phoneme, spread, TOP + k * height, height)
        for k, line in enumerate(self.lines):
            self._paint_line(painter, k, line)
        if not math.isnan(self._best):
            self._paint_best(painter, self._best)

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
        name = QRectF(8, top, self._left - 14, height)
        draw_text(painter, name, sound_name(phoneme), self._theme.text, 12)
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
            draw_text(
                painter, self._cell(k, top, height), shortest(value, self._digits), self._theme.text, 11, AT_RIGHT
            )

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
        for value in _ticks(distribution, min(8, (self.width() - self._left - self._right) // TICK_WIDTH)):
            x = self.x_of(value)
            painter.fillRect(QRectF(x, TOP, 1, bottom - TOP), QColor(self._theme.raised))
            draw_text(painter, QRectF(x - 40, bottom + 2, 80, 14), short(value), self._theme.faint, 10, CENTRED)
        scale = ", " + tr("log scale") if distribution.logarithmic else ""
        middle = self._left + (self.width() - self._left - self._right) / 2
        half = min(middle, self.width() - middle) - 4
        words, unit = (of(distribution.variable) for of in (self._thresholds.words_of, self._thresholds.unit_of))
        text = f"{words} ({tr(unit)}){scale}"
        draw_text(painter, QRectF(middle - half, bottom + 15, 2 * half, 16), text, self._theme.text, 11, CENTRED)
        for k, name in enumerate(COLUMNS):
            draw_text(painter, self._cell(k, TOP - 18, 16), tr(name), self._theme.faint, 10, AT_RIGHT)

    def _paint_line(self, painter: QPainter, k: int, line: DrawnThreshold) -> None:
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
        sign = "" if line.label.startswith(("<", ">")) else f"{line.sign} "  # a limit has its signs in its label
        # Two names have a row each; more would lie over one another, and stand beside the sliders anyway.
        named = len(self.lines) <= 2
        text = f"{sign}{short(line.value)}  {tr_engine(line.label)}" if named else short(line.value)
        set_size(painter, 10)
        width = painter.fontMetrics().horizontalAdvance(text) + 4
        box = QRectF(x - width / 2, 1 + 13 * (k % 2), width, 13)
        box.moveLeft(min(max(box.left(), 4.0), self.width() - self._right - width + 4.0))
        draw_text(painter, box, text, self._theme.bad, 10, CENTRED)

    def _paint_best(self, painter: QPainter, threshold: float) -> None:
        """Paint where a suggested variable parts best; it is no threshold of the preset, and cannot be dragged."""
        x = self.x_of(threshold)
        painter.setPen(QPen(QColor(self._theme.accent), 1.2, Qt.PenStyle.DashLine))
        painter.drawLine(QPointF(x, TOP - 4), QPointF(x, self.height() - BOTTOM))
        box = QRectF(x - 75, 14 if len(self.lines) == 1 else 1, 150, 13)  # beside the name of a single line
        box.moveLeft(min(max(box.left(), 4.0), self.width() - self._right - 146.0))
        draw_text(
            painter, box, tr("best threshold {value}").format(value=short(threshold)), self._theme.accent, 10, CENTRED
        )

    def _columns(self) -> dict[str, Sequence[object]]:
        """Return what is drawn as columns, each under its name and unit."""
        distribution = self._distribution
        if distribution is None:
            return {}
        unit, spreads = self._thresholds.unit_of(distribution.variable), distribution.spreads.values()
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
        width = (self._right - 14) / len(COLUMNS)
        return QRectF(self.width() - self._right + 8 + k * width, top, width, height)

    # -- dragging -----------------------------------------------------------------------------------------

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a threshold, or make a number the value of one."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self.setFocus()
        number = self.number_at(event.position())
        if number is not None and self.lines:
            self._move(self.lines[self._chosen], number[2])
            self._thresholds.end_move()
            return
        self._held = self._line_near(event.position().x())
        if self._held is not None:
            self._chosen = list(self.lines).index(self._held)
            self.update()

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        x = event.position().x()
        if self._held is None:
            shape = Qt.CursorShape.SizeHorCursor if self._line_near(x) is not None else Qt.CursorShape.ArrowCursor
            takes = self.lines and self.number_at(event.position()) is not None
            self.setCursor(Qt.CursorShape.PointingHandCursor if takes else shape)
            return
        self._move(self._held, self.value_at(x))

    @override
    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        if self._held is not None:
            self._held = None
            self._thresholds.end_move()
            self.show_lines()

    @override
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

    def _move(self, line: DrawnThreshold, value: float) -> None:
        self._thresholds.move(line.name, value)
        if self._distribution is not None:
            self.lines = self._thresholds.lines_of(self._distribution.variable)
        if self._held is not None:
            self._held = next((fresh for fresh in self.lines if fresh.name == line.name), None)
        self.update()

    def _line_near(self, x: float) -> DrawnThreshold | None:
        near = [line for line in self.lines if abs(self.x_of(line.value) - x) <= NEAR]
        return min(near, key=lambda line: abs(self.x_of(line.value) - x)) if near else None


def short(value: float) -> str:
    """Write a number with three digits that count."""
    return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def shortest(value: float, digits: int) -> str:
    """Write a number with `digits` significant digits, as short as it can be; of two, small ones keep one."""
    if 0 < abs(value) < 0.001:
        return f"{value:.{digits - 1 if digits > 2 else 0}e}".replace("e-0", "e-")
    return short(value) if abs(value) >= 100 else f"{value:.{digits}g}"


def _ticks(distribution: Distribution, most: int) -> list[float]:
    """Return round values along the axis, `most` or fewer, or one more."""
    low, high, most = float(distribution.edges[0]), float(distribution.edges[-1]), max(2, most)
    if distribution.logarithmic:
        first, last = math.ceil(math.log10(low)), math.floor(math.log10(high))
        return [10.0**k for k in range(first, last + 1, math.ceil((last - first + 1) / most))]
    step = 10 ** math.floor(math.log10((high - low) / most))
    step *= next(m for m in (1, 2, 5, 10) if (high - low) / (m * step) <= most)
    return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]


def phoneme_of_rule(distribution: Distribution | None, *boxes: QComboBox) -> Phoneme:
    """Return for which of the chosen phonemes a new rule is proposed: the one with the highest values."""
    chosen = [Phoneme(box.currentData()) for box in boxes if box.currentData() is not None]
    highest = None if distribution is None else distribution.higher_of(chosen)
    return next(iter(chosen), Phoneme.SILENCE) if highest is None else highest
