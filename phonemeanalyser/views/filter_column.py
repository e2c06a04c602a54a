"""The filters as a column, in the order in which the sound passes them."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from engine.settings import LIMITS, QUANTISATIONS, SAMPLE_RATE, Decimation, Filter, WindowFunction
from phonemeanalyser.models.preset import FILTER_PARAMETERS, PresetModel
from phonemeanalyser.theme import Theme


@dataclass(frozen=True)
class Field:
    """How a parameter is shown: its label, and either choices or decimals and step of a number."""

    label: str
    choices: tuple[tuple[str, Any], ...] = ()
    decimals: int = 2
    step: float = 0.05


TITLES: dict[Filter, tuple[str, str]] = {
    Filter.QUANTISE: ("Quantise", "Keeps every n-th sample. Plain folds high frequencies onto low ones, as the thesis "
                      "did; anti-aliased removes them first."),
    Filter.PRE_EMPHASIS: ("Pre-emphasis", "Raises high frequencies: each sample less a share of the one before it."),
    Filter.WINDOW_FUNCTION: ("Window function", "Fades the window's ends, so that a tone stays on few bins. "
                             "Off is a rectangle."),
    Filter.FREQUENCY_SMOOTH: ("Smooth frequency", "Blurs each bin with its neighbours; 1 is the mean of three."),
    Filter.TIME_SMOOTH: ("Smooth time", "Blurs each spectrum with the one before; nearer 1 is slower."),
    Filter.HIGH_PASS: ("High-pass", "Removes what lies below start, and fades it in up to end: hum and rumble."),
    Filter.LOW_PASS: ("Low-pass", "Fades out from start to end, and removes what lies above."),
    Filter.DENOISE: ("Denoise", "Sets amplitudes below the threshold to 0."),
    Filter.MEL: ("Mel", "Shows the spectrum through triangular filters, equally spaced as the ear hears (HTK mel); "
                 "variables can measure it."),
    Filter.NORMALISE: ("Normalise", "Divides each spectrum by its largest amplitude, so that loudness does not matter."),
}  # fmt: skip

FIELDS: dict[str, Field] = {
    "quantise": Field("every", tuple((f"{n}: {SAMPLE_RATE // n:,} Hz".replace(",", " "), n) for n in QUANTISATIONS)),
    "decimation": Field("kind", (("plain", Decimation.PLAIN), ("anti-aliased", Decimation.ANTI_ALIASED))),
    "pre_emphasis": Field("share", decimals=2, step=0.01),
    "window_function": Field(
        "shape", tuple((w.value.replace("_", "-").title().replace("-H", "–H"), w) for w in WindowFunction)
    ),
    "frequency_smooth": Field("strength"),
    "time_smooth": Field("strength"),
    "high_pass_start": Field("start", decimals=1, step=10),
    "high_pass_end": Field("end", decimals=1, step=10),
    "low_pass_start": Field("start", decimals=0, step=100),
    "low_pass_end": Field("end", decimals=0, step=100),
    "denoise_threshold": Field("threshold", decimals=5, step=0.0005),
    "mel_bands": Field("bands", decimals=0, step=1),
    "minimum_hold": Field("hold", decimals=2, step=0.01),
    "intensity_low": Field("0 at", decimals=0, step=1),
    "intensity_high": Field("1 at", decimals=0, step=1),
}


class FilterColumn(QScrollArea):
    """A switch, the parameters and a reset for each filter, then the statistics and the intensity's range.

    Signals
    -------
    bypass_asked : all filters off at once (True), or back to what they were.
    """

    bypass_asked = Signal(bool)

    def __init__(self, preset: PresetModel, theme: Theme) -> None:
        super().__init__()
        self._preset = preset
        self._theme = theme
        self.switches: dict[str, QCheckBox] = {}
        self.fields: dict[str, QComboBox | QDoubleSpinBox] = {}
        self.resets: dict[str, QToolButton] = {}
        self.bypass = QCheckBox("Bypass all filters")
        self._column = QVBoxLayout()
        self._fill()
        preset.changed.connect(self._show_preset)
        self._show_preset()

    def _fill(self) -> None:
        self.bypass.setToolTip("All filters off at once, and back to what they were (B)")
        self.bypass.toggled.connect(self.bypass_asked)
        self._column.setContentsMargins(6, 4, 6, 6)
        self._column.setSpacing(3)
        self._column.addWidget(self.bypass)
        for step in Filter:
            self._add_step(step.value, TITLES[step], FILTER_PARAMETERS[step], partial(self._switch, step))
            self.resets[step.value].clicked.connect(lambda _checked, s=step: self._preset.reset_filter(s))
        self._add_after_the_filters()
        self._column.addStretch(1)
        body = QWidget()
        body.setLayout(self._column)
        self.setWidget(body)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMinimumWidth(212)

    def _add_after_the_filters(self) -> None:
        statistics = ("Statistics", "Holds each phoneme for a least time, and replaces an unidentified one by the "
                      "likeliest successor.")  # fmt: skip
        intensity = ("Intensity", "Peak levels at which the intensity is 0 and 1.")
        names = {"statistics": ("minimum_hold",), "intensity": ("intensity_low", "intensity_high")}
        self._add_step(
            "statistics", statistics, names["statistics"], lambda on: self._preset.set_setting("statistics", on)
        )
        self._add_step("intensity", intensity, names["intensity"], None)
        for key, fields in names.items():
            self.resets[key].clicked.connect(lambda _checked, f=fields: self._preset.reset_settings(f))

    def _add_step(
        self, key: str, title: tuple[str, str], parameters: tuple[str, ...], switch: Callable[[bool], None] | None
    ) -> None:
        frame = QFrame()
        frame.setObjectName("step")
        frame.setStyleSheet(f"#step {{ background: {self._theme.raised}; border-radius: 4px }}")
        frame.setToolTip(f"{title[0]}: {title[1]}")
        form = QFormLayout(frame)
        form.setContentsMargins(6, 3, 4, 3)
        form.setVerticalSpacing(2)
        form.addRow(self._heading(key, title[0], switch))
        for name in parameters:
            form.addRow(self._label(FIELDS[name].label), self._field(name))
        self._column.addWidget(frame)

    def _heading(self, key: str, text: str, switch: Callable[[bool], None] | None) -> QHBoxLayout:
        heading = QHBoxLayout()
        if switch is None:
            heading.addWidget(QLabel(f"<b>{text}</b>"))
        else:
            box = QCheckBox(text)
            box.setStyleSheet("font-weight: bold")
            box.toggled.connect(switch)
            heading.addWidget(box)
            self.switches[key] = box
        reset = QToolButton()
        reset.setText("↺")
        reset.setAutoRaise(True)
        reset.setToolTip(f"Reset {text.lower()} to what the preset's file says")
        self.resets[key] = reset
        heading.addStretch(1)
        heading.addWidget(reset)
        return heading

    def _label(self, text: str) -> QLabel:
        label = QLabel(text)
        label.setStyleSheet(f"color: {self._theme.faint}")
        label.setMinimumWidth(52)
        return label

    def _field(self, name: str) -> QWidget:
        field = FIELDS[name]
        widget: QComboBox | QDoubleSpinBox
        if field.choices:
            widget = QComboBox()
            for text, value in field.choices:
                widget.addItem(text, value)
            widget.activated.connect(lambda k: self._edit(name, field.choices[k][1]))
        else:
            low, high, unit = LIMITS[name]
            widget = QDoubleSpinBox()
            widget.setRange(low, high)
            widget.setDecimals(field.decimals)
            widget.setSingleStep(field.step)
            widget.setSuffix(f" {unit}" if unit else "")
            widget.setKeyboardTracking(False)
            widget.valueChanged.connect(lambda value: self._edit(name, value))
        widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
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
        for name, widget in self.fields.items():
            widget.blockSignals(True)
            if isinstance(widget, QComboBox):
                widget.setCurrentIndex([v for _, v in FIELDS[name].choices].index(getattr(settings, name)))
            else:
                widget.setValue(getattr(settings, name))
            widget.blockSignals(False)
        for key, box in self.switches.items():
            box.blockSignals(True)
            box.setChecked(settings.statistics if key == "statistics" else settings.has(Filter(key)))
            box.setEnabled(key == "statistics" or not self._preset.bypassed)
            box.blockSignals(False)
        self.bypass.blockSignals(True)
        self.bypass.setChecked(self._preset.bypassed)
        self.bypass.blockSignals(False)
