"""How sound is played: how loud, how fast, whether over and over, and on which device; and the tone to generate."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.microphone import DeviceList
from phonemeengine.audio.output import SLOWEST, Output, Reader, open_output
from phonemeengine.audio.stream import Device, devices, outputs_of
from phonemeengine.audio.tone import Tone
from phonemeengine.live.player import Player
from phonemeengine.presets.preset import Preset

QUIETEST_DB = -60.0
"""At this volume and below the output is silent."""


class Playback(QObject):
    """Holds what the user chose; the current source follows it.

    Parameters
    ----------
    open_device : opens an output for a number of channels; where the user chose a device, by its label, too.

    Signals
    -------
    changed : something else was chosen.

    Attributes
    ----------
    loop : whether sound begins again at its end.
    volume : dB, -60..0, where -60 is silence.
    speed : 0.25..1 of the usual speed, with the pitch kept; what is recognised stays as it is.
    device : label of the device that plays; empty for the system's default.
    outputs : the devices to choose from.
    tone : what is generated where a tone is the source.
    open_device : see above.
    """

    changed = Signal()

    def __init__(
        self, open_device: Callable[..., Output] = open_output, list_devices: Callable[[], list[Device]] = devices
    ) -> None:
        super().__init__()
        self.loop, self.volume, self.speed, self.device, self.tone = False, 0.0, 1.0, "", Tone()
        self.outputs = DeviceList(list_devices, outputs_of)
        self.open_device = open_device

    def set_loop(self, loop: bool) -> None:
        """Begin again at the end, or not."""
        self.loop = loop
        self.changed.emit()

    def set_volume(self, decibels: float) -> None:
        """Set the loudness of the playback, held to -60..0 dB."""
        self.volume = min(0.0, max(QUIETEST_DB, float(decibels)))
        self.changed.emit()

    def set_speed(self, speed: float) -> None:
        """Play slower, or as usual again; held to 0.25..1."""
        self.speed = min(1.0, max(SLOWEST, float(speed)))
        self.changed.emit()

    def choose_device(self, label: str) -> None:
        """Play on another device from now on; an empty label is the system's default."""
        if label != self.device:
            self.device = label
            self.changed.emit()

    def set_tone(self, tone: Tone) -> None:
        """Generate another tone; where a tone is the source, it is played at once."""
        self.tone = tone
        self.changed.emit()

    @property
    def gain(self) -> float:
        """The volume as a factor, 0..1."""
        return 0.0 if self.volume <= QUIETEST_DB else 10 ** (self.volume / 20)

    def open_output(self, n_channels: int) -> Output:
        """Open the chosen device, or the default one where that is not there, or a clock."""
        return self.open_device(n_channels, self.device) if self.device else self.open_device(n_channels)

    def player_of(self, reader: Reader, preset: Preset) -> Player:
        """Return a player of a sound, as loud as is chosen; the caller closes it."""
        player = Player(reader, preset, self.open_output)
        player.set_gain(self.gain)
        return player
