"""The microphone's controls, in one line: device, channel, rate and level."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QToolButton, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.microphone import MOST_CHANNELS, RATES, Microphone
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.level_meter import LevelMeterView

DEFAULT = tr_noop("default microphone")


class MicrophoneBar(QWidget):
    """Which microphone is listened to, and how loud it is."""

    def __init__(self, microphone: Microphone, theme: Theme) -> None:
        super().__init__()
        self._microphone = microphone
        self.device, self.channel, self.rate = QComboBox(), QComboBox(), QComboBox()
        self.again = QToolButton()
        self.meter = LevelMeterView(microphone.read_level, theme)
        self._lay_out()
        self._connect()
        self._fill()

    def refresh(self) -> None:
        """Show the level now."""
        self.meter.update()

    def _lay_out(self) -> None:
        self.device.setMinimumWidth(150)
        self.device.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.device.setAccessibleName(tr("microphone"))
        self.again.setText("⟳")
        self.again.setToolTip(tr("Look again which microphones there are (F5)"))
        self.again.setAccessibleName(tr("look for microphones again"))
        self.again.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.channel.setToolTip(
            tr("The channel that is heard and recorded, or the first two: mixed and recorded as stereo")
        )
        self.channel.setAccessibleName(tr("channel of the microphone"))
        for rate in RATES:
            self.rate.addItem(f"{rate:,} Hz".replace(",", " ") if rate else tr("best rate"), rate)
        self.rate.setToolTip(tr("Sample rate of the microphone; the best is 44 100 Hz where it can do that"))
        self.rate.setAccessibleName(tr("sample rate"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(6)
        for widget in (self.device, self.again, self.channel, self.rate, self.meter):
            row.addWidget(widget, {self.device: 2, self.meter: 3}.get(widget, 0))

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
        choice, devices = self._microphone.choice, self._microphone.devices
        labels = {"": tr(DEFAULT)} | {device.label: device.label for device in devices}
        labels.setdefault(choice.label, tr("{name} (not there)").format(name=choice.label))
        _offer(self.device, labels, choice.label)
        self.device.view().setMinimumWidth(self.device.view().sizeHintForColumn(0))
        self.device.setToolTip(
            tr("The microphone, by name and sound system: {name}").format(name=self.device.currentText())
        )
        chosen = next((d for d in devices if d.label == choice.label), devices[0] if devices else None)
        most = min(chosen.n_inputs, MOST_CHANNELS) if chosen else 1
        channels = {k: tr("channel {k}").format(k=k) for k in range(1, max(most, choice.channel) + 1)}
        _offer(self.channel, channels | ({0: "1 + 2"} if most > 1 or choice.channel == 0 else {}), choice.channel)
        self.rate.setCurrentIndex(max(0, self.rate.findData(choice.rate)))


def _offer(box: QComboBox, entries: Mapping[Any, str], chosen: Any) -> None:
    """Fill a box anew, if it shows anything else."""
    shown = {box.itemData(k): box.itemText(k) for k in range(box.count())}
    if shown != entries:
        box.clear()
        for key, text in entries.items():
            box.addItem(text, key)
    box.setCurrentIndex(box.findData(chosen))
