"""Expressions of other programs: whether they are listened to, and where."""

from PySide6.QtCore import QObject, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.mouth.osc import OscAddress
from phonemeengine.mouth.osc_expression import OscExpression

USUAL_ADDRESS = "127.0.0.1:39540"
"""Where VMC programs send faces to on this computer."""
CLOSE_TIMEOUT = 2.0
"""Seconds after which the end of the program waits no longer for the network."""


class ExpressionInput(QObject):
    """Listens for expressions by OSC while it is switched on; nothing here waits for the network.

    Signals
    -------
    changed : switched on or off, or another address.
    error : a sentence for the user.

    Attributes
    ----------
    address : ``HOST:PORT``, as the user wrote it.
    stream : what is heard; None while nobody listens.
    """

    changed = Signal()
    error = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.address = USUAL_ADDRESS
        self.stream: OscExpression | None = None
        self._wanted: OscAddress | None = None
        self._work = TaskQueue(self._fail)

    @property
    def on(self) -> bool:
        """Whether it is switched on."""
        return self._wanted is not None

    @property
    def words(self) -> str:
        """What is going on, in words."""
        if self.stream is None:
            return tr("off") if not self.on else tr("opening …")
        names = self.stream.names
        if not names:
            return tr("the sender has stopped") if self.stream.stopped else tr("listening")
        if len(names) == 1:
            return tr("heard {name}").format(name=names[0])
        return tr("heard {name} and {n} more").format(name=names[0], n=len(names) - 1)

    @property
    def hears(self) -> bool:
        """Whether another program sends an expression."""
        return self.stream is not None and bool(self.stream.names)

    def set_on(self, on: bool) -> None:
        """Begin or end to listen."""
        self._leave()
        if on:
            self._begin()
        self.changed.emit()

    def set_address(self, text: str) -> None:
        """Listen elsewhere."""
        if text.strip() != self.address:
            self.address = text.strip()
            self.set_on(self.on)

    def close(self) -> None:
        """Listen no more."""
        self._leave()
        self._work.finish(CLOSE_TIMEOUT)

    def _begin(self) -> None:
        try:
            address = self._wanted = OscAddress.of(self.address)
        except EngineError as error:
            self._fail(str(error))
            return
        self._work.submit(lambda _progress: OscExpression(address), lambda stream: self._take(address, stream))

    def _take(self, address: OscAddress, stream: OscExpression) -> None:
        """Listen with this one, unless something else is wanted by now."""
        if address is self._wanted:
            self.stream = stream
            self.changed.emit()
        else:
            self._work.submit(lambda _progress: stream.close())

    def _leave(self) -> None:
        self._wanted = None
        stream, self.stream = self.stream, None
        if stream is not None:
            self._work.submit(lambda _progress: stream.close())

    def _fail(self, sentence: str) -> None:
        self._leave()
        self.error.emit(f"{sentence[0].upper()}{sentence[1:]}.")
        self.changed.emit()
