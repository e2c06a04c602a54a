"""The 21 thresholds as sliders, with the live value of each one's variable drawn on it."""

import math
from typing import Any

from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPolygonF
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from engine.recognition.phoneme_data import LAYOUT
from engine.recognition.rules import CONDITIONS
from engine.settings import BIN_WIDTH, LIMITS
from phonemeanalyser.models.history import History
from phonemeanalyser.models.preset import PresetModel
from phonemeanalyser.theme import Theme
from phonemeanalyser.views.keys import KeysOfNumbers
from phonemeanalyser.views.number_field import NumberField

GROUPS = (
    ("Filters", ""),
    ("Silence", "all of these, else it is no silence"),
    ("SZ and SCH", "SZ if both, SCH if the first only"),
    ("P", "all of these"),
    ("A and E", "A if both, E if the first only"),
    ("U, O, I, M", "below the first; M if no other"),
)
HIGHEST: dict[str, tuple[float, int]] = {
    "time_smooth": (1, 3),
    "frequency_smooth": (1, 3),
    "high_pass_start": (1300, 1),
    "high_pass_end": (1300, 1),
    "denoise_threshold": (0.1, 5),
    "zero_crossings": (1500, 1),
    "energy": (20, 4),
    "max_energy": (1, 5),
    "m_szsch1": (51, 3),
    "m_s1": (66, 3),
    "energy_n": (150, 3),
    "m_p1": (3, 4),
    "m_p2": (1, 4),
    "m_ae1": (1, 4),
    "m_a1": (16, 3),
    "m_o1": (11, 3),
}
"""The right end of a slider, and decimals, by variable or by filter parameter."""
UNITS = {"high_pass_start": BIN_WIDTH, "high_pass_end": BIN_WIDTH}
"""What PhonemeData counts, where the window shows something else: bins, shown in Hz."""
CURVATURE = 2.5
"""Sliders give small values more room: position = (value / highest) ** (1 / CURVATURE)."""
CONDITION_OF = {c.threshold: c for c in CONDITIONS}


class ThresholdSlider(QWidget):
    """A track with a handle for the threshold and a mark for the live value.

    The side of the handle on which the comparison holds is coloured; the mark is green where it holds.

    Signals
    -------
    moved : the user chose another value.
    released : the drag is over.
    """

    moved = Signal(float)
    released = Signal()

    def __init__(self, highest: float, sign: str, theme: Theme) -> None:
        super().__init__()
        self.value = 0.0
        self.live: float | None = None
        self._highest = highest
        self._sign = sign
        self._theme = theme
        self._mark_at = -1
        self.setMinimumSize(70, 20)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def set_value(self, value: float) -> None:
        """Move the handle."""
        if value != self.value:
            self.value = value
            self.update()

    def set_live(self, value: float | None) -> None:
        """Move the mark; None hides it."""
        self.live = value
        mark = -1 if value is None else round(self._x_of(value))
        if mark != self._mark_at:
            self._mark_at = mark
            self.update()

    def paintEvent(self, _event: Any) -> None:
        """Paint track, handle and mark."""
        painter = QPainter(self)
        middle, handle = self.height() / 2, self._x_of(self.value)
        left, right = 6.0, self.width() - 6.0
        painter.fillRect(QRectF(left, middle - 2, right - left, 4), QColor(self._theme.line))
        if self._sign:
            holds = QRectF(left, middle - 2, handle - left, 4)
            if self._sign == ">":
                holds = QRectF(handle, middle - 2, right - handle, 4)
            painter.fillRect(holds, QColor(self._theme.accent if self.isEnabled() else self._theme.line))
        if self.live is not None:
            good = (self.live > self.value) == (self._sign == ">") and self.live != self.value
            colour = QColor(self._theme.good if good else self._theme.bad)
            painter.fillRect(QRectF(self._mark_at - 1.5, 1, 3, self.height() - 2), colour)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(self._theme.base))
        handles = self._theme.text if self.isEnabled() else self._theme.faint
        painter.setBrush(QColor(self._theme.accent if self.hasFocus() else handles))
        top = self.height() - 1.0
        corners = ((handle, middle - 1), (handle + 5, middle + 5), (handle + 5, top), (handle - 5, top),
                   (handle - 5, middle + 5))  # fmt: skip
        painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in corners]))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Jump to the mouse."""
        self._follow(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Follow the mouse."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._follow(event)

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """End the drag."""
        self.released.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move by a hundredth of the track, with Shift by a tenth of that."""
        steps = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
        if event.key() not in steps:
            super().keyPressEvent(event)
            return
        fine = 0.1 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        self._choose(self._share_of(self.value) + steps[Qt.Key(event.key())] * 0.01 * fine)

    def _follow(self, event: QMouseEvent) -> None:
        self.setFocus()
        self._choose((event.position().x() - 6) / max(1, self.width() - 12))

    def _choose(self, share: float) -> None:
        value = self._highest * min(max(share, 0.0), 1.0) ** CURVATURE
        self.moved.emit(float(f"{value:.4g}"))

    def _share_of(self, value: float) -> float:
        return float(min(max(value / self._highest, 0.0), 1.0) ** (1 / CURVATURE))

    def _x_of(self, value: float) -> float:
        return 6 + self._share_of(value) * (self.width() - 12)


class ThresholdView(QScrollArea):
    """All thresholds, grouped by rule."""

    def __init__(self, preset: PresetModel, history: History, theme: Theme) -> None:
        super().__init__()
        self._preset = preset
        self._history = history
        self._theme = theme
        self.sliders: dict[str, ThresholdSlider] = {}
        self.numbers: dict[str, NumberField] = {}
        self.resets: dict[str, QToolButton] = {}
        self.unused = QLabel()
        self._headings: dict[str, QLabel] = {}
        self._rows: dict[str, tuple[QWidget, ...]] = {}
        self._fill()
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def refresh(self) -> None:
        """Move the marks to the newest frame's values."""
        newest = self._history.newest
        values = newest.features.frame(len(newest) - 1) if newest is not None else {}
        for name, condition in CONDITION_OF.items():
            slider = self.sliders[name]
            slider.set_live(values.get(condition.variable) if slider.isEnabled() else None)

    def _fill(self) -> None:
        body = QWidget()
        grid = QGridLayout(body)
        grid.setContentsMargins(6, 2, 6, 6)
        grid.setHorizontalSpacing(5)
        grid.setVerticalSpacing(1)
        grid.setColumnStretch(1, 1)
        self._add_note(grid)
        row = 1
        for (title, _), names in zip(GROUPS, LAYOUT, strict=True):
            heading = self._headings[title] = QLabel()
            heading.setContentsMargins(0, 5, 0, 1)
            heading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            grid.addWidget(heading, row, 0, 1, 4)
            for row, name in enumerate(names, row + 1):  # noqa: B020 - rows go on from group to group
                self._add_row(grid, row, name)
            row += 1
        grid.setRowStretch(row, 1)
        self.setWidget(body)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumWidth(body.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width())

    def _add_note(self, grid: QGridLayout) -> None:
        self.unused.setTextFormat(Qt.TextFormat.PlainText)
        self.unused.setWordWrap(True)
        self.unused.setContentsMargins(0, 4, 0, 0)
        self.unused.setStyleSheet(f"color: {self._theme.accent}")
        grid.addWidget(self.unused, 0, 0, 1, 4)

    def _add_row(self, grid: QGridLayout, row: int, name: str) -> None:
        condition = CONDITION_OF.get(name)
        variable = condition.variable if condition else name
        highest, decimals = HIGHEST[variable]
        rule = f"{name[0].upper()}: " if variable == "m_o1" else ""  # three rows that else read alike
        label = QLabel(f"{rule}{variable} {condition.sign}" if condition else _words(name))
        label.setTextFormat(Qt.TextFormat.PlainText)
        label.setToolTip(f"PhonemeData name: {name}" + (", in bins there, in Hz here" if name in UNITS else ""))
        slider = ThresholdSlider(highest, condition.sign if condition else "", self._theme)
        slider.setAccessibleName(name)
        slider.setToolTip(f"{name}: drag, or arrow keys (with Shift finer). The bar is the live value.")
        number = NumberField()
        number.setRange(*LIMITS.get(name, (-1e6, 1e6, ""))[:2])
        number.setDecimals(decimals)
        number.setButtonSymbols(NumberField.ButtonSymbols.NoButtons)
        number.setKeyboardTracking(False)
        number.installEventFilter(KeysOfNumbers(number))
        number.setFixedWidth(60)
        number.setSingleStep(highest / 100)
        number.setAccessibleName(name)
        number.setToolTip(f"{name}: type a number, or arrow keys")
        reset = QToolButton()
        reset.setText("↺")
        reset.setAutoRaise(True)
        reset.setToolTip("Reset to what the preset's file says")
        keep_place = reset.sizePolicy()
        keep_place.setRetainSizeWhenHidden(True)
        reset.setSizePolicy(keep_place)
        for column, widget in enumerate((label, slider, number, reset)):
            grid.addWidget(widget, row, column)
        slider.moved.connect(lambda value: self._preset.set_threshold(name, value / UNITS.get(name, 1)))
        slider.released.connect(self._preset.end_edit)
        number.editingFinished.connect(self._preset.end_edit)
        number.valueChanged.connect(lambda value: self._type(name, value))
        reset.clicked.connect(lambda _checked: self._preset.set_threshold(name, self._preset.saved_threshold(name)))
        self.sliders[name], self.numbers[name], self.resets[name] = slider, number, reset
        self._rows[name] = (label, slider, number, reset)

    def _type(self, name: str, value: float) -> None:
        unit = UNITS.get(name, 1)
        shown = float(getattr(self._preset.preset.phoneme_data, name)) * unit
        if not math.isclose(value, shown, abs_tol=0.5 * 10 ** -self.numbers[name].decimals()):
            self._preset.set_threshold(name, value / unit)

    def _show_preset(self) -> None:
        data = self._preset.preset.phoneme_data
        for name, slider in self.sliders.items():
            value = float(getattr(data, name))
            slider.set_value(value * UNITS.get(name, 1))
            number = self.numbers[name]
            number.blockSignals(True)
            number.setValue(slider.value)
            number.blockSignals(False)
            self.resets[name].setVisible(value != self._preset.saved_threshold(name))
        self._show_used()

    def _show_used(self) -> None:
        """Grey the thresholds that the recogniser in use does not use; the notes tell of the thesis's rules."""
        unused = CONDITION_OF.keys() - self._preset.used_thresholds
        for title, note in GROUPS:
            shown = "" if unused else note
            self._headings[title].setText(f"<b>{title}</b> <span style='color:{self._theme.faint}'>{shown}</span>")
            self._headings[title].setToolTip(shown)
        for name in CONDITION_OF:
            for widget in self._rows[name]:
                widget.setEnabled(name not in unused)
            if name in unused:
                self.sliders[name].set_live(None)
        self.unused.setText(f"Grey: not used by the recogniser {self._preset.preset.recogniser}")
        self.unused.setVisible(bool(unused))


def _words(name: str) -> str:
    words = name.replace("_", " ").replace("frequency", "freq.").removesuffix(" threshold")
    return words.replace("high pass", "high-pass")
