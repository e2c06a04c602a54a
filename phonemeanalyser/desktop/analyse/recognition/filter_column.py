"""The filters as a column, in the order in which the sound passes them, and how far the recogniser looks ahead."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QSizePolicy, QSlider, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.engine_words import recogniser_title
from phonemeanalyser.desktop.language import tr, tr_amid
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets import builders
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeengine.presets.controls import unused_settings
from phonemeengine.presets.model_choice import figures_ahead, for_live_use, frames_ahead
from phonemeengine.recognition.spec import spec_of
from phonemeengine.settings import FRAME_PERIOD, HINTS, PARAMETERS, STAGES, Filter, Parameter, Stage

LIVE_LOOK_AHEAD = "live_look_ahead"
ENDS = (Qt.Key.Key_Home, Qt.Key.Key_End)
FRAME_MS = 1000 * FRAME_PERIOD


class LookAheadSlider(QSlider):
    """Sets the look-ahead of a microphone's recogniser, in frames of 10 ms.

    The words appear after the first paint event: they need the real-time model, and the window opens before it.

    Attributes
    ----------
    words : a label to stand under it: the latency on this machine, and how right the answers are.
    """

    def __init__(self, preset: PresetModel) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._preset = preset
        self._waiting: float | None = None
        self._painted = False
        self._after_painting = QTimer(self, singleShot=True)
        self._after_painting.timeout.connect(self._tell)
        self.words = builders.named(
            builders.label(wraps=True),
            tip=tr(
                "Latency: from a sound to its phoneme on the screen, measured on this computer since the program "
                "started, with the microphone used last. Mouth-shape accuracy and macro F1: of speakers the model "
                "was not trained on, measured after its training."
            ),
        )
        self.setRange(0, round(PARAMETERS[LIVE_LOOK_AHEAD].high / FRAME_PERIOD))
        self.setPageStep(1)
        self.setTickPosition(QSlider.TickPosition.TicksBelow)
        self.valueChanged.connect(self._set)
        self.sliderReleased.connect(preset.end_edit)
        preset.changed.connect(self._show)
        self._show()

    def show_latency(self, waiting: float | None) -> None:
        """Take the latency of an answer without any look-ahead, seconds; None says that it is not known."""
        if waiting != self._waiting:
            self._waiting = waiting
            self._tell()

    @override
    def event(self, event: QEvent) -> bool:
        """Claim the keys to the ends, which are else the window's."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride and event.key() in ENDS:
            event.accept()
            return True
        return super().event(event)

    @override
    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._painted:
            self._painted = True
            self._after_painting.start()

    def _set(self, frames: int) -> None:
        seconds = round(frames * FRAME_PERIOD, 2)
        if seconds != getattr(self._preset.preset.settings, LIVE_LOOK_AHEAD):
            self._preset.set_setting(LIVE_LOOK_AHEAD, seconds)

    def _show(self) -> None:
        with builders.silent(self):
            self.setValue(int(getattr(self._preset.preset.settings, LIVE_LOOK_AHEAD) / FRAME_PERIOD + 1e-6))
        self._tell()

    def _tell(self) -> None:
        if not self._painted:
            return
        preset = self._preset.preset
        by_model = spec_of(preset.recogniser).looks_ahead and preset.model is not None
        waits = spec_of(preset.recogniser).looks_ahead or preset.decoder is not None
        settings = preset.settings.with_number(LIVE_LOOK_AHEAD, round(self.value() * FRAME_PERIOD, 2))
        live = for_live_use(replace(preset, settings=settings))
        frames = self.value() if waits else 0
        if by_model:
            frames = frames_ahead(live)
        ahead = (
            tr("Look-ahead {ms:.0f} ms").format(ms=FRAME_MS * frames)
            if waits
            else tr("{recogniser}: no look-ahead").format(recogniser=recogniser_title(preset.recogniser))
        )
        late = tr("latency not measured yet")
        if self._waiting is not None:
            late = tr("latency {ms:.0f} ms").format(ms=1000 * self._waiting + FRAME_MS * frames)
        parts = [ahead, late]
        if by_model:
            figures = figures_ahead(live, frames)
            parts.append(
                tr("mouth-shape accuracy {percent:.0f} % · macro F1 {macro_f1:.2f}").format(
                    macro_f1=figures.macro_f1, percent=100 * figures.mouth_shapes
                )
                if figures
                else tr("accuracy not measured")
            )
        text = " · ".join(parts)
        if text != self.words.text():
            self.words.setText(text)


FIELD_WIDTH, RESET_WIDTH = 124, 18
FILTERS = frozenset(step.value for step in Filter)


class FilterColumn(builders.ScrolledDown):
    """A switch, the parameters and a reset for each filter, then the statistics and the intensity's range.

    Attributes
    ----------
    look_ahead : how far the recogniser of a microphone looks ahead.
    """

    def __init__(self, preset: PresetModel, theme: Theme) -> None:
        super().__init__()
        self._preset = preset
        self._theme = theme
        self._unused_style = f"color: {theme.faint}; font-style: italic"
        self.switches: dict[str, QCheckBox] = {}
        self.fields: dict[str, QComboBox | NumberField] = {}
        self.resets: dict[str, QToolButton] = {}
        self.look_ahead = LookAheadSlider(preset)
        self.bypass = builders.named(
            QCheckBox(tr("Bypass all filters")), tip=tr("Switch all filters off, or back to their previous state (B)")
        )
        self.unused = builders.label(colour=theme.accent, wraps=True)
        self._headings: dict[str, QLabel | QCheckBox] = {}
        self._grid = builders.grid(margins=(6, 6, 2, 6), across=3, down=3)
        self._fill()
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _fill(self) -> None:
        self.bypass.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.bypass.toggled.connect(self._preset.set_bypassed)
        self._grid.setColumnStretch(1, 1)
        self._grid.addWidget(self.bypass, 0, 0, 1, 3)
        self.unused.setTextFormat(Qt.TextFormat.PlainText)
        self._grid.addWidget(self.unused, 1, 0, 1, 3)
        for stage in STAGES.values():
            self._add_stage(stage, self._switch_of(stage.name))
            self.resets[stage.name].clicked.connect(lambda _checked, name=stage.name: self._preset.reset_stage(name))
            if PARAMETERS[LIVE_LOOK_AHEAD] in stage.parameters:
                self._grid.addWidget(self.look_ahead.words, self._grid.rowCount(), 0, 1, 3)
        self._grid.setRowStretch(self._grid.rowCount(), 1)
        body = QWidget()
        body.setLayout(self._grid)
        builders.leave_wheel(body)
        self.setAccessibleName(tr("Filters"))
        self.show_body(body)

    def _add_stage(self, stage: Stage, switch: Callable[[bool], None] | None) -> None:
        """Add a line above, the switch, its parameters with their labels, the first beside it, and the reset."""
        at = self._grid.rowCount()
        self._grid.addWidget(builders.line(self._theme.line), at, 0, 1, 3)
        heading = self._headings[stage.name] = self._heading(stage, switch)
        reset = self._reset(stage.name, stage.label)
        hints = [tr(HINTS[of.name]) for of in stage.parameters]
        parts = [
            builders.named(builders.label(tr(of.part), self._theme.faint), tip=hint)
            for of, hint in zip(stage.parameters, hints, strict=True)
            if of.part
        ]
        self._grid.addLayout(builders.row(heading, 1, *parts[:1], spacing=3), at + 1, 0)
        for k, of in enumerate(stage.parameters):
            tip = f"{tr(of.label)}: {hints[k]}"
            self._grid.addWidget(builders.named(self._field(of), tr(of.label), tip), at + 1 + k, 1)
            if k:
                self._grid.addWidget(parts[k], at + 1 + k, 0, Qt.AlignmentFlag.AlignRight)
            else:
                self._grid.addWidget(reset, at + 1, 2)  # here, since Tab goes as the grid was filled
        if not stage.parameters:
            self._grid.addWidget(reset, at + 1, 2)

    def _heading(self, stage: Stage, switch: Callable[[bool], None] | None) -> QLabel | QCheckBox:
        heading: QLabel | QCheckBox
        if switch is None:
            heading = QLabel(tr(stage.label))
        else:
            heading = self.switches[stage.name] = QCheckBox(tr(stage.label))
            heading.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            heading.toggled.connect(switch)
        return heading

    @override
    def keep_width(self, body: QWidget) -> None:
        """Leave room for headings in either look, so that the column keeps its width."""
        for heading in self._headings.values():
            probe = type(heading)(heading.text(), body)
            usual = probe.sizeHint().width()
            probe.setStyleSheet(self._unused_style)
            heading.setMinimumWidth(max(usual, probe.sizeHint().width()))
            probe.setParent(None)
        super().keep_width(body)

    def _reset(self, key: str, text: str) -> QToolButton:
        reset = self.resets[key] = builders.tool_button(
            "↺",
            tr("Reset {text} to the value in the preset file").format(text=tr_amid(text)),
            tr("Reset {text}").format(text=tr_amid(text)),
            flat=True,
        )
        reset.setFixedWidth(RESET_WIDTH)
        return reset

    def _field(self, of: Parameter) -> QWidget:
        if of.name == LIVE_LOOK_AHEAD:
            return self.look_ahead
        widget: QComboBox | NumberField
        if of.choices:
            widget = builders.choice((tr(words), value) for words, value in of.choices)
            widget.activated.connect(lambda k: self._edit(of.name, of.choices[k][1]))
        else:
            unit = f" {tr(of.unit)}" if of.unit else ""
            widget = NumberField(of.low, of.high, decimals=of.decimals, step=of.step, unit=unit, waits=True)
            widget.valueChanged.connect(lambda value: self._edit(of.name, value))
            widget.editingFinished.connect(self._preset.end_edit)
        widget.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        widget.setMinimumWidth(FIELD_WIDTH)
        self.fields[of.name] = widget
        return widget

    def _switch_of(self, name: str) -> Callable[[bool], None] | None:
        """Return what switches a stage on and off, where it can be."""
        if name == "statistics":
            return partial(self._preset.set_setting, name)
        return partial(self._switch, Filter(name)) if name in FILTERS else None

    def _switch(self, step: Filter, on: bool) -> None:
        if on != self._preset.preset.settings.has(step):
            self._preset.set_filter(step, on)

    def _edit(self, name: str, value: Any) -> None:
        now = getattr(self._preset.preset.settings, name)
        if isinstance(now, int):
            value = round(value)
        if value != now:
            self._preset.set_setting(name, value)

    def _show_preset(self) -> None:
        settings = self._preset.preset.settings
        with builders.silent(*self.fields.values(), *self.switches.values(), self.bypass):
            for name, widget in self.fields.items():
                if isinstance(widget, QComboBox):
                    widget.setCurrentIndex([v for _, v in PARAMETERS[name].choices].index(getattr(settings, name)))
                else:
                    widget.setValue(getattr(settings, name))
            for key, box in self.switches.items():
                box.setChecked(settings.statistics if key == "statistics" else settings.has(Filter(key)))
                box.setEnabled(key == "statistics" or not self._preset.bypassed)
            self.bypass.setChecked(self._preset.bypassed)
        self._show_unused()

    def _show_unused(self) -> None:
        """Show which steps do nothing to what is recognised; they still shape what is seen."""
        name = recogniser_title(self._preset.preset.recogniser)
        unused = unused_settings(self._preset.preset)
        for of in STAGES["statistics"].parameters:
            self.fields[of.name].setEnabled(of.name not in unused)
        for key, heading in self._headings.items():
            note = (
                " " + tr("The recogniser “{name}” does not use it: it affects the display only.").format(name=name)
                if key in unused
                else ""
            )
            heading.setToolTip(f"{tr(STAGES[key].label)}: {tr(STAGES[key].hint)}{note}")
            heading.setStyleSheet(self._unused_style if key in unused else "")
        if unused >= FILTERS:
            self.unused.setText(
                tr("“{name}” uses the unfiltered signal; filters affect the display only").format(name=name)
            )
        else:
            which = ", ".join(tr(stage.label) for stage in STAGES.values() if stage.name in unused)
            self.unused.setText(tr("Not used by “{name}”: {which}").format(name=name, which=which))
        self.unused.setVisible(bool(unused & self._headings.keys()))
