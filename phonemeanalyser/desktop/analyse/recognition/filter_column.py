"""The filters as a column, in the order in which the sound passes them."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QScrollArea, QSizePolicy, QToolButton, QWidget

from phonemeanalyser.desktop.analyse.recognition.look_ahead_slider import NAME as LIVE_LOOK_AHEAD
from phonemeanalyser.desktop.analyse.recognition.look_ahead_slider import LookAheadSlider
from phonemeanalyser.desktop.language import tr, tr_amid, tr_noop
from phonemeanalyser.desktop.session.preset import FILTER_PARAMETERS, PresetModel
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, grid, label, line, named, scrolling, silent, tool_button
from phonemeanalyser.desktop.widgets.number_field import NumberField
from phonemeanalyser.desktop.widgets.wheel import leave_wheel
from phonemeengine.presets.controls import unused_settings
from phonemeengine.settings import LIMITS, QUANTISATIONS, SAMPLE_RATE, Decimation, Filter, WindowFunction


@dataclass(frozen=True)
class FilterField:
    """How a parameter is shown: its label, and either choices or decimals and step of a number."""

    label: str
    choices: tuple[tuple[str, Any], ...] = ()
    decimals: int = 2
    step: float = 0.05


TITLES: dict[Filter, tuple[str, str]] = {
    Filter.QUANTISE: (
        tr_noop("Quantise"),
        tr_noop(
            "Keeps every n-th sample. Plain folds high frequencies onto low ones, as the thesis did; anti-aliased "
            "removes them first."
        ),
    ),
    Filter.PRE_EMPHASIS: (
        tr_noop("Pre-emphasis"),
        tr_noop("Raises high frequencies: each sample less a share of the one before it."),
    ),
    Filter.WINDOW_FUNCTION: (
        tr_noop("Window"),
        tr_noop("Fades the window's ends, so that a tone stays on few bins. Off is a rectangle."),
    ),
    Filter.FREQUENCY_SMOOTH: (
        tr_noop("Smooth F"),
        tr_noop("Blurs each bin with its neighbours; 1 is the mean of three."),
    ),
    Filter.TIME_SMOOTH: (
        tr_noop("Smooth time"),
        tr_noop("Blurs each spectrum with the one before; nearer 1 is slower."),
    ),
    Filter.HIGH_PASS: (
        tr_noop("High-pass"),
        tr_noop("Removes what lies below start (hum, rumble), and fades in up to end."),
    ),
    Filter.LOW_PASS: (tr_noop("Low-pass"), tr_noop("Fades out from start to end, and removes what lies above.")),
    Filter.DENOISE: (tr_noop("Denoise"), tr_noop("Sets amplitudes below the threshold to 0.")),
    Filter.MEL: (
        tr_noop("Mel"),
        tr_noop(
            "Shows the spectrum through triangular filters, spaced as the ear hears (HTK mel); variables can measure "
            "it."
        ),
    ),
    Filter.NORMALISE: (
        tr_noop("Normalise"),
        tr_noop("Divides each spectrum by its largest amplitude: loudness does not matter."),
    ),
}

FIELDS: dict[str, FilterField] = {
    "quantise": FilterField(
        tr_noop("every"), tuple((f"{n}: {SAMPLE_RATE // n:,} Hz".replace(",", " "), n) for n in QUANTISATIONS)
    ),
    "decimation": FilterField(
        tr_noop("kind"), ((tr_noop("plain"), Decimation.PLAIN), (tr_noop("anti-aliased"), Decimation.ANTI_ALIASED))
    ),
    "pre_emphasis": FilterField(tr_noop("share"), decimals=2, step=0.01),
    "window_function": FilterField(
        tr_noop("shape"), tuple((w.value.replace("_", "-").title(), w) for w in WindowFunction)
    ),
    "frequency_smooth": FilterField(tr_noop("strength")),
    "time_smooth": FilterField(tr_noop("strength")),
    "high_pass_start": FilterField(tr_noop("start"), decimals=1, step=10),
    "high_pass_end": FilterField(tr_noop("end"), decimals=1, step=10),
    "low_pass_start": FilterField(tr_noop("start"), decimals=0, step=100),
    "low_pass_end": FilterField(tr_noop("end"), decimals=0, step=100),
    "denoise_threshold": FilterField(tr_noop("threshold"), decimals=5, step=0.0005),
    "mel_bands": FilterField(tr_noop("bands"), decimals=0, step=1),
    "minimum_hold": FilterField(tr_noop("hold"), decimals=2, step=0.01),
    "hysteresis": FilterField(tr_noop("hysteresis"), decimals=2, step=0.05),
    "look_ahead": FilterField(tr_noop("file"), decimals=2, step=0.01),
    "live_look_ahead": FilterField(tr_noop("live")),
    "intensity_low": FilterField(tr_noop("0 at"), decimals=0, step=1),
    "intensity_high": FilterField(tr_noop("1 at"), decimals=0, step=1),
}


AFTER_THE_FILTERS: dict[str, tuple[tuple[str, str], tuple[str, ...]]] = {
    "statistics": (
        (
            tr_noop("Statistics"),
            tr_noop(
                "Holds each phoneme for a least time, and replaces an unidentified one by its likeliest follower. "
                "With hysteresis, another phoneme follows only where it is the better one by so much."
            ),
        ),
        ("minimum_hold", "hysteresis"),
    ),
    "look_ahead": (
        (
            tr_noop("Look-ahead"),
            tr_noop(
                "How long the recogniser may wait for what comes after a frame: longer is surer, and later. "
                "Rules never wait. With a microphone, waiting makes the mouth late, so it has a limit of its own."
            ),
        ),
        ("look_ahead", "live_look_ahead"),
    ),
    "intensity": (
        (
            tr_noop("Intensity"),
            tr_noop("Peak levels at which the intensity is 0 and 1; in silence it is 0 at any level."),
        ),
        ("intensity_low", "intensity_high"),
    ),
}


FIELD_WIDTH, RESET_WIDTH = 124, 18


class FilterColumn(QScrollArea):
    """A switch, the parameters and a reset for each filter, then the statistics and the intensity's range.

    Signals
    -------
    bypass_asked : all filters off at once (True), or back to what they were.

    Attributes
    ----------
    look_ahead : how far the recogniser of a microphone looks ahead.
    """

    bypass_asked = Signal(bool)

    def __init__(self, preset: PresetModel, theme: Theme) -> None:
        super().__init__()
        self._preset = preset
        self._theme = theme
        self.switches: dict[str, QCheckBox] = {}
        self.fields: dict[str, QComboBox | NumberField] = {}
        self.resets: dict[str, QToolButton] = {}
        self.look_ahead = LookAheadSlider(preset)
        self.bypass = named(
            QCheckBox(tr("Bypass all filters")), tip=tr("All filters off at once, and back to what they were (B)")
        )
        self.unused = label(colour=theme.accent, wraps=True)
        self._headings: dict[str, QWidget] = {}
        self._grid = grid(margins=(6, 6, 2, 6), across=3, down=3)
        self._fill()
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _fill(self) -> None:
        self.bypass.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.bypass.toggled.connect(self.bypass_asked)
        self._grid.setColumnStretch(1, 1)
        self._grid.addWidget(self.bypass, 0, 0, 1, 3)
        self.unused.setTextFormat(Qt.TextFormat.PlainText)
        self._grid.addWidget(self.unused, 1, 0, 1, 3)
        for step in Filter:
            self._add_step(step.value, TITLES[step], FILTER_PARAMETERS[step], partial(self._switch, step))
            self.resets[step.value].clicked.connect(lambda _checked, s=step: self._preset.reset_filter(s))
        for key, (title, parameters) in AFTER_THE_FILTERS.items():
            switch = partial(self._preset.set_setting, key) if key == "statistics" else None
            self._add_step(key, title, parameters, switch)
            resets = (key, *parameters) if switch else parameters
            self.resets[key].clicked.connect(lambda _checked, names=resets: self._preset.reset_settings(names))
            if LIVE_LOOK_AHEAD in parameters:
                self._grid.addWidget(self.look_ahead.words, self._grid.rowCount(), 0, 1, 3)
        self._grid.setRowStretch(self._grid.rowCount(), 1)
        body = QWidget()
        body.setLayout(self._grid)
        leave_wheel(body)
        self.setAccessibleName(tr("filters"))
        self.setMinimumWidth(scrolling(self, body))

    def _add_step(
        self, key: str, title: tuple[str, str], parameters: tuple[str, ...], switch: Callable[[bool], None] | None
    ) -> None:
        """Add a line above, the switch, its first parameter beside it, further ones below, and the reset."""
        row = self._grid.rowCount()
        self._grid.addWidget(line(self._theme.line), row, 0, 1, 3)
        heading = self._heading(key, title[0], switch)
        self._grid.addWidget(heading, row + 1, 0)
        reset = self._reset(key, title[0])
        for k, name in enumerate(parameters):
            words = tr(FIELDS[name].label)
            tip = f"{tr(title[0])}, {words}: {tr(title[1])}"
            self._grid.addWidget(named(self._field(name), f"{tr(title[0])} {words}", tip), row + 1 + k, 1)
            if k:
                both = label(f"{tr(FIELDS[parameters[0]].label)} / {words}", self._theme.faint)
                both.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self._grid.addWidget(both, row + 1 + k, 0)
            else:
                self._grid.addWidget(reset, row + 1, 2)  # here, since Tab goes as the grid was filled
        if not parameters:
            self._grid.addWidget(reset, row + 1, 2)
        self._headings[key] = heading

    def _heading(self, key: str, text: str, switch: Callable[[bool], None] | None) -> QWidget:
        if switch is None:
            return QLabel(tr(text))
        box = QCheckBox(tr(text))
        box.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        box.toggled.connect(switch)
        self.switches[key] = box
        return box

    def _reset(self, key: str, text: str) -> QToolButton:
        reset = self.resets[key] = tool_button(
            "↺",
            tr("Reset {text} to what the preset's file says").format(text=tr_amid(text)),
            tr("reset {text}").format(text=tr_amid(text)),
            flat=True,
        )
        reset.setFixedWidth(RESET_WIDTH)
        return reset

    def _field(self, name: str) -> QWidget:
        if name == LIVE_LOOK_AHEAD:
            return self.look_ahead
        field = FIELDS[name]
        widget: QComboBox | NumberField
        if field.choices:
            widget = choice((tr(text), value) for text, value in field.choices)
            widget.activated.connect(lambda k: self._edit(name, field.choices[k][1]))
        else:
            low, high, unit = LIMITS[name]
            unit = f" {tr(unit)}" if unit else ""
            widget = NumberField(low, high, decimals=field.decimals, step=field.step, unit=unit, waits=True)
            widget.valueChanged.connect(lambda value: self._edit(name, value))
            widget.editingFinished.connect(self._preset.end_edit)
        widget.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        widget.setMinimumWidth(FIELD_WIDTH)
        self.fields[name] = widget
        return widget

    def _switch(self, step: Filter, on: bool) -> None:
        if on != self._preset.preset.settings.has(step):
            self._preset.set_filter(step, on)

    def _edit(self, name: str, value: Any) -> None:
        if name == "mel_bands":
            value = round(value)
        if value != getattr(self._preset.preset.settings, name):
            self._preset.set_setting(name, value)

    def _show_preset(self) -> None:
        settings = self._preset.preset.settings
        with silent(*self.fields.values(), *self.switches.values(), self.bypass):
            for name, widget in self.fields.items():
                if isinstance(widget, QComboBox):
                    widget.setCurrentIndex([v for _, v in FIELDS[name].choices].index(getattr(settings, name)))
                else:
                    widget.setValue(getattr(settings, name))
            for key, box in self.switches.items():
                box.setChecked(settings.statistics if key == "statistics" else settings.has(Filter(key)))
                box.setEnabled(key == "statistics" or not self._preset.bypassed)
            self.bypass.setChecked(self._preset.bypassed)
        self._show_unused()

    def _show_unused(self) -> None:
        """Show which steps do nothing to what is recognised; they still shape what is seen."""
        name = self._preset.preset.recogniser
        unused = unused_settings(self._preset.preset)
        titles = {step.value: title for step, title in TITLES.items()}
        titles |= {key: title for key, (title, _) in AFTER_THE_FILTERS.items()}
        for key, heading in self._headings.items():
            note = (
                " " + tr("Not used by the recogniser {name}: it changes only what is seen.").format(name=name)
                if key in unused
                else ""
            )
            heading.setToolTip(f"{tr(titles[key][0])}: {tr(titles[key][1])}{note}")
            heading.setStyleSheet(f"color: {self._theme.faint}; font-style: italic" if key in unused else "")
        if {step.value for step in Filter} <= unused:
            self.unused.setText(
                tr("{name} hears the bare sound: the filters shape only what is seen").format(name=name)
            )
        else:
            which = ", ".join(tr(title) for key, (title, _) in titles.items() if key in unused)
            self.unused.setText(tr("Not used by {name}: {which}").format(name=name, which=which))
        self.unused.setVisible(bool(unused & self._headings.keys()))
