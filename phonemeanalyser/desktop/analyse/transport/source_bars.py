"""The bars of sources that have choices of their own: the microphone, and a tone."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QComboBox, QMenu, QSlider, QToolButton, QWidget
from typing_extensions import override

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.microphone import MOST_CHANNELS, RATES, Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, label, named, offer, row, silent, tool_button
from phonemeanalyser.desktop.widgets.fields import NumberField
from phonemeanalyser.desktop.widgets.level_meter import LevelMeterView
from phonemeengine.audio.tone import FORMANT_LIMITS, TONE_LIMITS, VOWEL_FORMANTS, Tone, ToneKind, vowel_of

DEFAULT = tr_noop("Default microphone")


class MicrophoneBar(QWidget):
    """Which microphone is listened to, and how loud it is."""

    def __init__(self, microphone: Microphone, theme: Theme) -> None:
        super().__init__()
        self._microphone = microphone
        self.device = choice((), tr("Microphone"))
        self.device.setMinimumWidth(150)
        self.device.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.again = tool_button("⟳", tr("Rescan audio devices (F5)"), tr("Rescan audio devices"))
        self.channel = choice(
            (),
            tr("Channel of the microphone"),
            tr("Channel that is analysed and recorded; 1 + 2: mixed for analysis, recorded in stereo"),
        )
        self.rate = choice(
            ((f"{rate:,} Hz".replace(",", " ") if rate else tr("Best rate"), rate) for rate in RATES),
            tr("Sample rate"),
            tr("Sample rate of the microphone; best: 44 100 Hz, if the device supports it"),
        )
        self.meter = LevelMeterView(microphone.read_level, theme)
        row((self.device, 2), self.again, self.channel, self.rate, (self.meter, 3), on=self, spacing=6)
        self._connect()
        self._fill()

    def refresh(self) -> None:
        """Show the level now."""
        self.meter.update()

    def _connect(self) -> None:
        microphone = self._microphone
        self.again.clicked.connect(microphone.refresh_devices)
        self.device.activated.connect(self._choose)
        self.channel.activated.connect(self._choose)
        self.rate.activated.connect(self._choose)
        microphone.devices_changed.connect(self._fill)
        microphone.changed.connect(self._fill)

    def _choose(self) -> None:
        label = self.device.currentData()
        same = label == self._microphone.choice.label
        channel = self.channel.currentData() if same else 1
        choice = replace(self._microphone.choice, label=label, channel=channel, rate=self.rate.currentData())
        self._microphone.choose(choice)

    def _fill(self) -> None:
        """Show the devices that are there, and what is chosen; one that has gone stays in the list, marked."""
        wanted, devices = self._microphone.choice, self._microphone.devices
        labels = {"": tr(DEFAULT)} | {device.label: device.label for device in devices}
        labels.setdefault(wanted.label, tr("{name} (not connected)").format(name=wanted.label))
        offer(self.device, [(text, name) for name, text in labels.items()], wanted.label)
        self.device.view().setMinimumWidth(self.device.view().sizeHintForColumn(0))
        self.device.setToolTip(tr("Microphone (name, sound system): {name}").format(name=self.device.currentText()))
        chosen = next((d for d in devices if d.label == wanted.label), devices[0] if devices else None)
        most = min(chosen.n_inputs, MOST_CHANNELS) if chosen else 1
        channels = [(tr("Channel {k}").format(k=k), k) for k in range(1, max(most, wanted.channel) + 1)]
        mixed = [("1 + 2", 0)] if most > 1 or wanted.channel == 0 else []
        offer(self.channel, channels + mixed, wanted.channel)
        self.rate.setCurrentIndex(max(0, self.rate.findData(wanted.rate)))


Key = TypeVar("Key")

KINDS = {".wav": tr_noop("WAV (RF64 beyond 4 GB)"), ".flac": tr_noop("FLAC (half the size)")}
BUFFERS = {
    0.04: tr_noop("Short Buffer: 10 ms, Lowest Latency"),
    0.08: tr_noop("Medium Buffer: 20 ms"),
    0.2: tr_noop("Long Buffer: 50 ms, for a Busy Computer"),
}
"""What is asked of the microphone, seconds, and how that is called."""


class RecordButton(QToolButton):
    """Begins and ends a recording; its menu says where to, and in which form.

    Signals
    -------
    folder_asked : the user wants to choose where recordings go.
    """

    folder_asked = Signal()

    def __init__(self, session: Session, theme: Theme) -> None:
        super().__init__()
        self._microphone = session.microphone
        self._theme = theme
        self.setIconSize(QSize(20, 20))
        self.setStyleSheet(f"QToolButton[checkable=true]:checked {{ background: {theme.bad} }}")
        self.setCheckable(True)
        self.setFixedWidth(46)
        self.setAccessibleName(tr("Record"))
        self.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        menu = QMenu(self)
        self.folder = QAction(self)
        self.folder.triggered.connect(self.folder_asked)
        menu.addAction(self.folder)
        menu.addSeparator()
        self.kinds = self._add_choices(menu, KINDS, self._set_kind)
        menu.addSeparator()
        self.buffers = self._add_choices(menu, BUFFERS, self._microphone.set_latency)
        menu.addSeparator()
        self.phonemes = self._add_switch(menu, tr("Save Phonemes with the Recording (.csv)"))
        self.phonemes.toggled.connect(self._set_phonemes)
        self.gaps = self._add_switch(menu, tr("Fill Gaps with Silence (and Mark Them)"))
        self.gaps.toggled.connect(self._set_fill_gaps)
        self.else_default = self._add_switch(menu, tr("Use Default Microphone if Disconnected"))
        self.else_default.toggled.connect(self._microphone.set_else_default)
        menu.aboutToShow.connect(self.show_state)
        self.setMenu(menu)

    def show_state(self) -> None:
        """Show whether it records, and how it would."""
        microphone = self._microphone
        recording = microphone.recording
        self.setChecked(recording)
        self.setIcon(_dot(self._theme, recording))
        self.setToolTip(
            tr("Stop recording (R)")
            if recording
            else tr("Record from the microphone to {folder} (R)").format(folder=microphone.folder)
        )
        self.folder.setText(tr("Save Recordings to {folder}…").format(folder=microphone.folder))
        for suffix, action in self.kinds.items():
            action.setChecked(suffix == microphone.suffix)
        for latency, action in self.buffers.items():
            action.setChecked(latency == microphone.choice.latency)
        with silent(self.phonemes, self.gaps, self.else_default):
            self.phonemes.setChecked(microphone.with_phonemes)
            self.gaps.setChecked(microphone.fill_gaps)
            self.else_default.setChecked(microphone.choice.else_default)

    def _add_choices(
        self, menu: QMenu, choices: Mapping[Key, str], act: Callable[[Key], object]
    ) -> dict[Key, QAction]:
        """Add entries of which one at a time is chosen; `act` is given what was chosen."""
        group, actions = QActionGroup(self), {}
        for key, words in choices.items():
            action = actions[key] = QAction(tr(words), self, checkable=True)
            action.triggered.connect(lambda _checked, key=key: act(key))
            group.addAction(action)
            menu.addAction(action)
        return actions

    def _add_switch(self, menu: QMenu, text: str) -> QAction:
        action = QAction(text, self, checkable=True)
        menu.addAction(action)
        return action

    def _set_kind(self, suffix: str) -> None:
        self._microphone.suffix = suffix

    def _set_phonemes(self, on: bool) -> None:
        self._microphone.with_phonemes = on

    def _set_fill_gaps(self, on: bool) -> None:
        self._microphone.fill_gaps = on


def _dot(theme: Theme, recording: bool) -> QIcon:
    pixmap = QPixmap(20, 20)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(theme.on_colour if recording else theme.bad))
    if recording:
        painter.drawRoundedRect(4, 4, 12, 12, 2, 2)
    else:
        painter.drawEllipse(3, 3, 14, 14)
    painter.end()
    return QIcon(pixmap)


@dataclass(frozen=True)
class ToneNumber:
    """How a number is shown: what stands before it, decimals, step, and what it is for."""

    prefix: str
    decimals: int
    step: float
    tip: str


NUMBERS: dict[str, ToneNumber] = {
    "frequency": ToneNumber("", 1, 10, tr_noop("Frequency of the sine wave")),
    "low": ToneNumber(tr_noop("from "), 0, 10, tr_noop("Start frequency of the sweep")),
    "high": ToneNumber(tr_noop("to "), 0, 100, tr_noop("End frequency of the sweep")),
    "sweep_seconds": ToneNumber(tr_noop("in "), 1, 1, tr_noop("Duration of the sweep")),
    "f0": ToneNumber("f0 ", 0, 5, tr_noop("Fundamental frequency of the vowel")),
    "F1": ToneNumber("F1 ", 0, 10, tr_noop("First formant")),
    "F2": ToneNumber("F2 ", 0, 20, tr_noop("Second formant")),
    "F3": ToneNumber("F3 ", 0, 20, tr_noop("Third formant")),
    "level": ToneNumber(tr_noop("level "), 0, 1, tr_noop("Level of the highest peak")),
}
FORMANTS = ("F1", "F2", "F3")
OF_VOWEL = ("f0", *FORMANTS)
OF_KIND: dict[ToneKind, tuple[str, ...]] = {
    ToneKind.SINE: ("frequency",),
    ToneKind.WHITE_NOISE: (),
    ToneKind.PINK_NOISE: (),
    ToneKind.SWEEP: ("low", "high", "sweep_seconds"),
    ToneKind.VOWEL: OF_VOWEL,
}
OWN = tr_noop("custom")
LEAST_RISE = 1.0
"""A sweep's end lies at least so far above its beginning, Hz."""
SLIDER_STEPS = 1000
SPARE = 10
"""Pixels that a field of the vowel can spare beside its number."""
ARROW_STEPS, PAGE_STEPS = 10, 100
"""An arrow key moves the slider by a little over a semitone, a page key by an octave."""


class ToneBar(QWidget):
    """Which tone is played in place of a sound.

    Signals
    -------
    tone_changed : the user chose another `Tone`.
    """

    tone_changed = Signal(Tone)

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._tone = Tone()
        kinds = [(tr(kind.value.replace("_", " ")), kind) for kind in ToneKind]
        self.kind = choice(kinds, tr("Kind of tone"), tr("Kind of tone"))
        self.slider = named(
            QSlider(Qt.Orientation.Horizontal),
            tr("Frequency of the sine wave on a logarithmic scale"),
            tr("Frequency of the sine wave; arrow keys: by a semitone, page keys: by an octave"),
        )
        self.unit = label("Hz", theme.faint)
        self.vowel = choice([(tr(name), name) for name in (*VOWEL_FORMANTS, OWN)], tr("Vowel"), tr("Vowel"))
        self.numbers = {name: self._number(name) for name in NUMBERS}
        self._lay_out()
        self._connect()
        self.show_tone(self._tone)

    @property
    def tone(self) -> Tone:
        """The tone that the controls show."""
        return self._tone

    def show_tone(self, tone: Tone) -> None:
        """Show a tone, without a signal."""
        self._tone = tone
        self.kind.setCurrentIndex(self.kind.findData(tone.kind))
        self.vowel.setCurrentIndex(self.vowel.findData(vowel_of(tone.formants) or OWN))
        with silent(self.slider):
            self.slider.setValue(_step_of(tone.frequency))
        for name, box in self.numbers.items():
            with silent(box):
                box.setValue(_value_of(tone, name))
        shown = (*OF_KIND[tone.kind], "level")
        for name, box in self.numbers.items():
            box.setVisible(name in shown and _has(tone, name))
        self.slider.setVisible(tone.kind is ToneKind.SINE)
        self.vowel.setVisible(tone.kind is ToneKind.VOWEL)
        self.unit.setVisible(tone.kind is ToneKind.VOWEL)

    def _number(self, name: str) -> NumberField:
        look = NUMBERS[name]
        low, high, unit = TONE_LIMITS.get(name, (*FORMANT_LIMITS, "Hz"))
        tip = f"{tr(look.tip)}, {low:g}..{high:g} {unit}"
        box = named(NumberField(low, high, decimals=look.decimals, step=look.step, waits=True), tr(look.tip), tip)
        box.setPrefix(tr(look.prefix) if look.prefix else "")
        if name not in OF_VOWEL:  # which share one unit behind them, so that they fit into the line
            box.setSuffix(f" {unit}")
        box.valueChanged.connect(lambda value: self._edit(name, value))
        return box

    @override
    def changeEvent(self, event: QEvent) -> None:
        """Have the fields of the vowel as wide as they need be, in the style of the window."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.StyleChange:
            for name in OF_VOWEL:
                self.numbers[name].setFixedWidth(self.numbers[name].sizeHint().width() - SPARE)

    def _lay_out(self) -> None:
        self.slider.setRange(0, SLIDER_STEPS)
        self.slider.setSingleStep(ARROW_STEPS)
        self.slider.setPageStep(PAGE_STEPS)
        self.slider.setMinimumWidth(120)
        numbers = [box for name, box in self.numbers.items() if name != "level"]
        row(
            self.kind,
            (self.slider, 1),
            self.vowel,
            *numbers,
            self.unit,
            0,
            self.numbers["level"],
            on=self,
            margins=(6, 3, 6, 3),
            spacing=4,
        )

    def _connect(self) -> None:
        self.kind.activated.connect(self._choose_kind)
        self.slider.valueChanged.connect(lambda step: self._edit("frequency", _frequency_at(step)))
        self.vowel.activated.connect(self._choose_vowel)

    def _choose_kind(self, k: int) -> None:
        self._choose(replace(self._tone, kind=ToneKind(self.kind.itemData(k))))  # Qt gives a plain string back

    def _choose_vowel(self, k: int) -> None:
        """Take a vowel's formants; to choose its own ones is to change those that are there."""
        name = self.vowel.itemData(k)
        if name == OWN:
            self.numbers["F1"].setFocus()
            self.numbers["F1"].selectAll()
        self._choose(replace(self._tone, formants=VOWEL_FORMANTS.get(name, self._tone.formants)))
        self.vowel.setCurrentIndex(k)

    def _edit(self, name: str, value: float) -> None:
        self._choose(_with(self._tone, name, value))

    def _choose(self, tone: Tone) -> None:
        if tone != self._tone:
            self.show_tone(tone)
            self.tone_changed.emit(tone)


def _has(tone: Tone, name: str) -> bool:
    return name not in FORMANTS or FORMANTS.index(name) < len(tone.formants)


def _value_of(tone: Tone, name: str) -> float:
    if name not in FORMANTS:
        return float(getattr(tone, name))
    return tone.formants[FORMANTS.index(name)].frequency if _has(tone, name) else 0.0


def _with(tone: Tone, name: str, value: float) -> Tone:
    """Return the tone with another number; the other end of a sweep gives way to it."""
    if name in FORMANTS:
        k = FORMANTS.index(name)
        formant = replace(tone.formants[k], frequency=value)
        return replace(tone, formants=(*tone.formants[:k], formant, *tone.formants[k + 1 :]))
    if name == "low":
        low = min(value, TONE_LIMITS["high"][1] - LEAST_RISE)
        return replace(tone, low=low, high=max(tone.high, low + LEAST_RISE))
    if name == "high":
        high = max(value, TONE_LIMITS["low"][0] + LEAST_RISE)
        return replace(tone, high=high, low=min(tone.low, high - LEAST_RISE))
    number: dict[str, Any] = {name: value}
    return replace(tone, **number)


def _frequency_at(step: int) -> float:
    """Return the frequency at a place of the slider, Hz, in three figures."""
    low, high, _ = TONE_LIMITS["frequency"]
    return float(f"{low * (high / low) ** (step / SLIDER_STEPS):.3g}")


def _step_of(frequency: float) -> int:
    low, high, _ = TONE_LIMITS["frequency"]
    return round(SLIDER_STEPS * math.log(frequency / low) / math.log(high / low))
