"""The microphones that there are."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.audio.devices import Device, inputs_of


class DeviceList(QObject):
    """Lists what records, the default first; a sound system that does not answer has none.

    Signals
    -------
    changed : the list is another.
    """

    changed = Signal()

    def __init__(self, list_devices: Callable[[], list[Device]]) -> None:
        super().__init__()
        self.devices: list[Device] = []
        self._list_devices = list_devices
        self._looking = TaskQueue(lambda _sentence: self._show([]))

    def look(self) -> None:
        """Look which there are now."""
        if not self._looking.busy:
            self._looking.submit(lambda _progress: inputs_of(self._list_devices()), self._show)

    def _show(self, devices: list[Device]) -> None:
        if devices != self.devices:
            self.devices = devices
            self.changed.emit()
