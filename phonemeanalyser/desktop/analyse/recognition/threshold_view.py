"""What the recogniser in use is tuned by, as sliders with the live value of what is compared drawn on each."""

import math
from dataclasses import dataclass
from functools import partial
from html import escape
from typing import Any

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPolygonF
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import tr_engine
from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.session.results import History
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.keyboard import ArrowKeys
from phonemeengine.errors import EngineError
from phonemeengine.features.variables import Features, readable_name
from phonemeengine.presets.controls import Control, ControlGroup, Moment
from phonemeengine.settings import HINTS

LABEL_WIDTH = 112
NBSP_HZ = "\u00a0Hz"
"""A unit that stays beside its number where a name is written on several lines."""
LARGEST = 1e6
"""A number that is typed lies within ± this."""
BY_KEY = (Qt.FocusReason.TabFocusReason, Qt.FocusReason.BacktabFocusReason)
STEPS: dict[int, int] = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
"""Which way the arrow keys move a handle."""
CURVATURE = 2.5
"""Sliders give small values more room: position = (value / highest) ** (1 / CURVATURE)."""


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

    def __init__(self, control: Control, theme: Theme) -> None:
        super().__init__()
        self.value = 0.0
        self.live: float | None = None
        self._low, self._high = control.low, control.high
        self._decimals = control.decimals
        self._curvature = 1.0 if control.low < 0 else CURVATURE
        self._sign = control.sign
        self._theme = theme
        self._mark_at = -1
        self.setMinimumSize(62, 20)
        self.setMaximumHeight(22)  # beside a name of several lines, too
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.installEventFilter(ArrowKeys(self))

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

    @override
    def paintEvent(self, _event: Any) -> None:
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
            painter.fillRect(QRectF(round(self._x_of(self.live)) - 1.5, 1, 3, self.height() - 2), colour)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(self._theme.base))
        handles = self._theme.text if self.isEnabled() else self._theme.faint
        painter.setBrush(QColor(self._theme.accent if self.hasFocus() else handles))
        top = self.height() - 1.0
        corners = (
            (handle, middle - 1),
            (handle + 5, middle + 5),
            (handle + 5, top),
            (handle - 5, top),
            (handle - 5, middle + 5),
        )
        painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in corners]))

    @override
    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._follow(event)

    @override
    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._follow(event)

    @override
    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        self.released.emit()

    @override
    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move by a hundredth of the track, with Shift by a tenth of that."""
        if event.key() not in STEPS:
            super().keyPressEvent(event)
            return
        fine = 0.1 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        self._choose(self._share_of(self.value) + STEPS[Qt.Key(event.key())] * 0.01 * fine)

    def _follow(self, event: QMouseEvent) -> None:
        self.setFocus()
        self._choose((event.position().x() - 6) / max(1, self.width() - 12))

    def _choose(self, share: float) -> None:
        value = self._low + (self._high - self._low) * min(max(share, 0.0), 1.0) ** self._curvature
        self.moved.emit(round(float(f"{value:.4g}"), self._decimals))

    def _share_of(self, value: float) -> float:
        share = (value - self._low) / (self._high - self._low)
        return float(min(max(share, 0.0), 1.0) ** (1 / self._curvature))

    def _x_of(self, value: float) -> float:
        return 6 + self._share_of(value) * (self.width() - 12)


@dataclass(frozen=True)
class Row:
    """What shows one control."""

    control: Control
    slider: ThresholdSlider
    number: NumberField
    reset: QToolButton


class ThresholdView(builders.ScrolledDown):
    """All controls of the recogniser in use, in groups; another recogniser has others.

    Signals
    -------
    touched : the user pressed a control, or came to it by a key; its name.
    """

    touched = Signal(str)

    def __init__(self, preset: PresetModel, history: History, theme: Theme) -> None:
        super().__init__()
        self.setAccessibleName(tr("Thresholds"))
        self._preset = preset
        self._history = history
        self._theme = theme
        self.rows: dict[str, Row] = {}
        self._shown: tuple[ControlGroup, ...] = ()
        self._kept: tuple[tuple[ControlGroup, ...], dict[str, Row], QWidget] | None = None
        self._body, self._fields = QWidget(), QWidget()
        self._column = builders.column(self._fields, on=self._body)
        self.show_body(self._body)
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def refresh(self) -> None:
        """Move the marks to what is compared in the newest frame."""
        moment = self._moment()
        for row in self.rows.values():
            row.slider.set_live(row.control.live(self._preset.preset, moment) if moment else None)

    def _moment(self) -> Moment | None:
        newest = self._history.newest
        if newest is None or not len(newest):
            return None
        last = newest.features.part(slice(len(newest) - 1, len(newest)))
        shown = int(newest.phonemes[-1])
        return Moment(last.frame(0), self._deficit(last, shown), self._history.phoneme_lasted())

    def _deficit(self, features: Features, phoneme: int) -> float | None:
        """Return by how much the phoneme that is shown falls short; None where the recogniser does not say."""
        try:
            deficits = self._preset.recogniser.deficits(features)
        except (EngineError, ValueError):  # the frame was measured for another recogniser
            return None
        return None if deficits is None else float(deficits[0, phoneme])

    @override
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        pressed = event.type() == QEvent.Type.MouseButtonPress
        reached = isinstance(event, QFocusEvent) and event.gotFocus() and event.reason() in BY_KEY
        if pressed or reached:
            for name, row in self.rows.items():
                if watched in (row.slider, row.number):
                    self.touched.emit(name)
        return super().eventFilter(watched, event)

    # -- rows ---------------------------------------------------------------------------------------------

    def _show_preset(self) -> None:
        if self._shown != self._preset.control_groups:
            self._exchange(self._preset.control_groups)
        if self._kept is not None and self._preset.other is None:
            self._kept[2].deleteLater()
            self._kept = None
        preset = self._preset.preset
        with builders.silent(*(row.number for row in self.rows.values())):
            for name, row in self.rows.items():
                value, saved = row.control.read(preset), self._preset.saved_value(name)
                row.slider.set_value(value)
                row.number.setValue(value)
                row.reset.setVisible(saved is not None and value != saved)

    def _exchange(self, groups: tuple[ControlGroup, ...]) -> None:
        """Show other controls; those before are kept for X, since it takes long to make hundreds of widgets."""
        kept, self._kept = self._kept, (self._shown, self.rows, self._fields)
        self._shown = groups
        self._fields.hide()
        if kept is not None and kept[0] == groups:
            self.rows, self._fields = kept[1:]
            self._fields.show()
        else:
            if kept is not None:
                kept[2].deleteLater()
            self._fill()
        self.keep_width(self._body)

    def _fill(self) -> None:
        self._fields = QWidget()
        fields = builders.grid(self._fields, margins=(6, 2, 6, 6), across=5, down=1)
        fields.setColumnStretch(1, 1)
        self.rows = {}
        for group in self._shown:
            fields.addWidget(self._heading(group), fields.rowCount(), 0, 1, 4)
            for control in group.controls:
                self.rows[control.name] = self._add_row(fields, fields.rowCount(), control)
        fields.setRowStretch(fields.rowCount(), 1)
        builders.leave_wheel(self._fields)
        self._column.addWidget(self._fields)

    def _heading(self, group: ControlGroup) -> QLabel:
        heading = QLabel(
            f"<b>{tr_engine(group.title)}</b> <span style='color:{self._theme.faint}'>{tr_engine(group.note)}</span>"
        )
        heading.setToolTip(tr_engine(group.note))
        heading.setContentsMargins(0, 5, 0, 1)
        heading.setWordWrap(True)
        heading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        return heading

    def _add_row(self, fields: QGridLayout, at: int, control: Control) -> Row:
        hint = self._hint_of(control)
        words = builders.named(self._label_of(control), tip=f"<p>{hint}</p>")
        words.setFixedWidth(LABEL_WIDTH)  # the same for all recognisers, so that the dock keeps its width
        tip = f"<p>{hint}</p><p>{tr('Drag, or press the arrow keys (Shift: finer steps).')}</p>"
        slider = builders.named(ThresholdSlider(control, self._theme), self._name_of(control), tip)
        row = Row(control, slider, self._number(control), self._reset())
        for k, widget in enumerate((words, slider, row.number, row.reset)):
            fields.addWidget(widget, at, k)
        for widget in (slider, row.number):
            widget.installEventFilter(self)
        slider.moved.connect(partial(self._preset.tune, control.name))
        slider.released.connect(self._preset.end_edit)
        row.number.valueChanged.connect(partial(self._type, row))
        row.reset.clicked.connect(lambda _checked: self._restore(control.name))
        return row

    def _label_of(self, control: Control) -> QLabel:
        """Return what a control is called: of a threshold what its variable measures, its short name below it."""
        words = tr_engine(readable_name(control.variable, self._preset.preset.variables))
        called = builders.label(tr_engine(control.label), wraps=True)
        called.setTextFormat(Qt.TextFormat.PlainText)
        if control.variable and control.variable in control.label and words != control.variable:
            called.setTextFormat(Qt.TextFormat.RichText)
            short = f"<span style='color:{self._theme.faint}; font-size:10px'>{escape(control.label)}</span>"
            called.setText(f"<span style='font-size:11px'>{escape(words).replace(' Hz', NBSP_HZ)}</span><br>{short}")
        return called

    def _name_of(self, control: Control) -> str:
        """Return what a screen reader says: what the variable measures, and what the control is called."""
        words = tr_engine(readable_name(control.variable, self._preset.preset.variables))
        return f"{words}: {tr_engine(control.label)}" if control.variable else tr_engine(control.label)

    def _hint_of(self, control: Control) -> str:
        """Return what a control does, and what the variable measures that is compared with it; as rich text."""
        words = readable_name(control.variable, self._preset.preset.variables)
        hint = escape(tr_engine(control.hint))
        if not control.sign:  # the hint of a filter is its name only
            hint = f"{escape(tr(HINTS[control.name]))}<br>{hint}"
        return f"{hint}<br>{control.variable}: {tr_engine(words)}" if words != control.variable else hint

    def _number(self, control: Control) -> NumberField:
        step = (control.high - control.low) / 100
        number = builders.named(
            NumberField(-LARGEST, LARGEST, decimals=control.decimals, step=step, waits=True),
            self._name_of(control),
            f"<p>{self._hint_of(control)}</p><p>{tr('Type a number, or press the arrow keys.')}</p>",
        )
        number.setButtonSymbols(NumberField.ButtonSymbols.NoButtons)
        number.setFixedWidth(60)
        number.editingFinished.connect(self._preset.end_edit)
        return number

    def _reset(self) -> QToolButton:
        reset = builders.tool_button("↺", tr("Reset to the value in the preset file"), tr("Reset"), flat=True)
        keep_place = reset.sizePolicy()
        keep_place.setRetainSizeWhenHidden(True)
        reset.setSizePolicy(keep_place)
        return reset

    def _type(self, row: Row, value: float) -> None:
        shown = row.control.read(self._preset.preset)
        if not math.isclose(value, shown, abs_tol=0.5 * 10**-row.control.decimals):
            self._preset.tune(row.control.name, value)

    def _restore(self, name: str) -> None:
        saved = self._preset.saved_value(name)
        if saved is not None:
            self._preset.tune(name, saved)
            self._preset.end_edit()
