"""The microphone's controls, in one line: device, channel, rate and level."""

from dataclasses import replace

from PySide6.QtWidgets import QComboBox, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.microphone import MOST_CHANNELS, RATES, Microphone
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, offer, row, tool_button
from phonemeanalyser.desktop.widgets.level_meter import LevelMeterView

DEFAULT = tr_noop("default microphone")


class MicrophoneBar(QWidget):
    """Which microphone is listened to, and how loud it is."""

    def __init__(self, microphone: Microphone, theme: Theme) -> None:
        super().__init__()
        self._microphone = microphone
        self.device = choice((), tr("microphone"))
        self.device.setMinimumWidth(150)
        self.device.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.again = tool_button(
            "⟳", tr("Look again which microphones there are (F5)"), tr("look for microphones again")
        )
        self.channel = choice(
            (),
            tr("channel of the microphone"),
            tr("The channel that is heard and recorded, or the first two: mixed and recorded as stereo"),
        )
        self.rate = choice(
            ((f"{rate:,} Hz".replace(",", " ") if rate else tr("best rate"), rate) for rate in RATES),
            tr("sample rate"),
            tr("Sample rate of the microphone; the best is 44 100 Hz where it can do that"),
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
        labels.setdefault(wanted.label, tr("{name} (not there)").format(name=wanted.label))
        offer(self.device, [(text, name) for name, text in labels.items()], wanted.label)
        self.device.view().setMinimumWidth(self.device.view().sizeHintForColumn(0))
        self.device.setToolTip(
            tr("The microphone, by name and sound system: {name}").format(name=self.device.currentText())
        )
        chosen = next((d for d in devices if d.label == wanted.label), devices[0] if devices else None)
        most = min(chosen.n_inputs, MOST_CHANNELS) if chosen else 1
        channels = [(tr("channel {k}").format(k=k), k) for k in range(1, max(most, wanted.channel) + 1)]
        mixed = [("1 + 2", 0)] if most > 1 or wanted.channel == 0 else []
        offer(self.channel, channels + mixed, wanted.channel)
        self.rate.setCurrentIndex(max(0, self.rate.findData(wanted.rate)))
