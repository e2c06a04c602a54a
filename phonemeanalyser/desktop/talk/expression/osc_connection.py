"""Something that sends or listens at an address of the network while it is switched on."""

from typing import Any

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.mouth.osc import OscAddress

NETWORK_TIMEOUT = 2.0
"""Seconds after which the end of the program waits no longer for the network."""


class OscConnection(QObject):
    """Opens and closes in the background, so that nothing waits for the network; subclasses say what in `_connect`.

    Signals
    -------
    changed : switched on or off, or another address.
    error : a sentence for the user.

    Attributes
    ----------
    address : ``HOST:PORT``, as the user wrote it.
    connection : what sends or listens; None where there is nothing.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self, address: str) -> None:
        super().__init__()
        self.address = address
        self.connection: Any = None
        self._wanted: OscAddress | None = None
        self._work = TaskQueue(self._fail)

    @property
    def on(self) -> bool:
        """Whether it is switched on."""
        return self._wanted is not None

    def set_on(self, on: bool) -> None:
        """Begin or end."""
        self._leave()
        if on:
            self._begin()
        self.changed.emit()

    def set_address(self, text: str) -> None:
        """Send to, or listen at, another address."""
        if text.strip() != self.address:
            self.address = text.strip()
            self.set_on(self.on)

    def close(self) -> None:
        """End, and wait for it a little."""
        self._leave()
        self._work.finish(NETWORK_TIMEOUT)

    def _connect(self, address: OscAddress) -> Any:
        """Open it, in the background; what comes has `close`."""
        raise NotImplementedError

    def _begin(self) -> None:
        try:
            address = self._wanted = OscAddress.of(self.address)
        except EngineError as error:
            self._fail(str(error))
            return
        self._work.submit(lambda _progress: self._connect(address), lambda opened: self._take(address, opened))

    def _take(self, address: OscAddress, opened: Any) -> None:
        """Use this one, unless something else is wanted by now."""
        if address is self._wanted:
            self.connection = opened
            self.changed.emit()
        else:
            self._work.submit(lambda _progress: opened.close())

    def _leave(self) -> None:
        self._wanted = None
        connection, self.connection = self.connection, None
        if connection is not None:
            self._work.submit(lambda _progress: connection.close())

    def _fail(self, sentence: str) -> None:
        self._leave()
        self._tell(sentence)
        self.changed.emit()

    def _tell(self, sentence: str) -> None:
        self.error.emit(f"{sentence[0].upper()}{sentence[1:]}.")
