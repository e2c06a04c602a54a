"""What sound is played on: the system's choice, or a device of the user's."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.session.microphone import DeviceList
from phonemeengine.audio.devices import Device, outputs_of
from phonemeengine.audio.output import Output
from phonemeengine.audio.stream import devices


class Loudspeaker(QObject):
    """Opens what is played on.

    Parameters
    ----------
    open_device : opens an output for a number of channels; where the user chose a device, by its label, too.

    Signals
    -------
    chosen : the user chose another device.
    devices_changed : the list of devices is another.

    Attributes
    ----------
    label : of the device; empty for the system's default.
    """

    chosen = Signal()
    devices_changed = Signal()

    def __init__(
        self, open_device: Callable[..., Output], list_devices: Callable[[], list[Device]] = devices
    ) -> None:
        super().__init__()
        self.label = ""
        self._open_device = open_device
        self._outputs = DeviceList(list_devices, outputs_of)
        self._outputs.changed.connect(self.devices_changed)

    @property
    def devices(self) -> list[Device]:
        """The devices that play, as they were when they were looked for last."""
        return self._outputs.devices

    def refresh_devices(self) -> None:
        """Look which devices there are; `devices_changed` tells when that is known."""
        self._outputs.look()

    def choose(self, label: str) -> None:
        """Play on another device from now on; an empty label is the system's default."""
        if label != self.label:
            self.label = label
            self.chosen.emit()

    def open(self, n_channels: int) -> Output:
        """Open the chosen device, or the default one where that is not there, or a clock."""
        return self._open_device(n_channels, self.label) if self.label else self._open_device(n_channels)
