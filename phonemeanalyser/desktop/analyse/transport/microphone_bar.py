"""The microphone: device, channel, rate and level in one line, and the button that records."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TypeVar

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QComboBox, QMenu, QToolButton, QWidget

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.microphone import MOST_CHANNELS, RATES, Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.theme import Theme
from phonemeanalyser.desktop.widgets.builders import choice, offer, row, silent, tool_button
from phonemeanalyser.desktop.widgets.level_meter import LevelMeterView

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
