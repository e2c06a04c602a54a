"""What is played on, how loud and how fast, behind one button beside the volume."""

from functools import partial

from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMenu, QToolButton

from phonemeanalyser.desktop.language import tr, tr_noop
from phonemeanalyser.desktop.session.playback import QUIETEST_DB, Playback
from phonemeanalyser.desktop.widgets.builders import named, open_at_once

SPEEDS = (1.0, 0.85, 0.7, 0.5, 0.35, 0.25)
DEFAULT = tr_noop("the system's output")


class OutputButton(QToolButton):
    """Says how loud it plays, in dB, and how fast where that is not as usual; its menu has devices and speeds."""

    def __init__(self, playback: Playback) -> None:
        super().__init__()
        self._playback = playback
        self._menu = QMenu(self)
        open_at_once(self, self._menu)
        named(self, tr("output device and speed"), tr("Volume in dB; click for the output device and the speed"))
        self._menu.aboutToShow.connect(playback.outputs.look)
        playback.outputs.changed.connect(self._fill)
        playback.changed.connect(self._show_state)
        self._fill()
        self._show_state()

    def _show_state(self) -> None:
        playback = self._playback
        volume = tr("silent") if playback.volume <= QUIETEST_DB else f"{playback.volume:.0f} dB".replace("-", "−")
        speed = "" if playback.speed == 1 else f", {100 * playback.speed:.0f} %"
        self.setText(f"♪ {volume}{speed}")
        for action in self._menu.actions():
            action.setChecked(action.data() in {playback.speed, playback.device})

    def _fill(self) -> None:
        playback = self._playback
        self._menu.clear()
        labels = {"": tr(DEFAULT)} | {device.label: device.label for device in playback.outputs.devices}
        labels.setdefault(playback.device, tr("{name} (not there)").format(name=playback.device))
        devices, speeds = QActionGroup(self._menu), QActionGroup(self._menu)
        for label, text in labels.items():
            action = self._menu.addAction(text, partial(playback.choose_device, label))
            action.setCheckable(True)
            action.setData(label)
            devices.addAction(action)
        self._menu.addSeparator()
        for speed in SPEEDS:
            action = self._menu.addAction(
                tr("Speed {percent:.0f} %").format(percent=100 * speed), partial(playback.set_speed, speed)
            )
            action.setCheckable(True)
            action.setData(speed)
            speeds.addAction(action)
        self._show_state()


def next_speed(speed: float, speeds: tuple[float, ...]) -> float:
    """Return the speed after this one, in the order given; the last one stays."""
    nearest = min(range(len(speeds)), key=lambda k: abs(speeds[k] - speed))
    return speeds[min(nearest + 1, len(speeds) - 1)]
