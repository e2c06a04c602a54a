"""The microphones that there are."""

import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.threads import start_thread
from phonemeengine.audio.devices import Device, inputs_of
from phonemeengine.errors import EngineError


class DeviceList(QObject):
    """Lists what records, the default first; `look` looks anew, and `see` takes note of what was found.

    Signals
    -------
    changed : the list is another.
    """

    changed = Signal()

    def __init__(self, list_devices: Callable[[], list[Device]]) -> None:
        super().__init__()
        self.devices: list[Device] = []
        self._list_devices = list_devices
        self._found: list[Device] | None = None
        self._looking: threading.Thread | None = None

    def look(self) -> None:
        """Look which there are now."""
        if self._looking is None:
            self._looking = start_thread(self._look)

    def see(self) -> None:
        """Take note of what was found, if it was."""
        if self._looking is None or self._looking.is_alive():
            return
        self._looking = None
        if self._found is not None and self._found != self.devices:
            self.devices = self._found
            self.changed.emit()

    def _look(self) -> None:
        try:
            self._found = inputs_of(self._list_devices())
        except EngineError:
            self._found = []
