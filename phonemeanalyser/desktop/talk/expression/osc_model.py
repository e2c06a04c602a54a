"""Messages over the network while that is switched on: what all connections share, and the mouth that is sent."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, tables_by_movestates

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
    def words(self) -> str:
        """What is going on, in words."""
        raise NotImplementedError

    @property
    def active(self) -> bool:
        """Whether messages go out, or come in."""
        raise NotImplementedError

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


USUAL_ADDRESS = "127.0.0.1:39539"
"""Where VMC programs listen on this computer."""
AS_THE_HEAD = "head"
"""Stands for the table that moves the head."""


class OscModel(OscConnection):
    """Sends what its performer shows, as OSC messages, while it is switched on; nothing here waits for the network.

    Parameters
    ----------
    clock : the clock of the performer's times, seconds.

    Attributes
    ----------
    table : which of the `tables` a receiver is sent.
    performer : says what the head says, with the movestates of the receiver.
    """

    _lost = Signal(str)

    def __init__(self, clock: Callable[[], float]) -> None:
        super().__init__(USUAL_ADDRESS)
        self.table = AS_THE_HEAD
        self._clock = clock
        self._head_table = load_table(USUAL_TABLE)
        self._own_table: MouthTable | None = None
        self.performer = Performer(self._head_table, MOUTH_ALONE)
        self._idle = self.performer.idle
        self._expression: Expression | None = None
        self._lost.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    @cached_property
    def tables(self) -> dict[str, str]:
        """What a receiver may be sent, by name, with what people call it: the head's table, or another one.

        It is read when the panel is first shown, from the files of all tables.
        """
        return {AS_THE_HEAD: tr("Same as the head"), **tables_by_movestates()}

    @property
    def _mouth(self) -> OscMouth | None:
        mouth: OscMouth | None = self.connection
        return mouth

    @property
    @override
    def active(self) -> bool:
        return self._mouth is not None and not self._mouth.failure

    @property
    @override
    def words(self) -> str:
        if not self.on:
            return tr("Off")
        if self._mouth is None:
            return tr("Looking for the receiver…")
        if self._mouth.failure:
            return tr("Receiver not reached")
        n = f"{self._mouth.n_sent:,}".replace(",", " ")
        return tr("Sending: {n} packets").format(n=n)

    def set_table(self, name: str) -> None:
        """Send the movestates of another set."""
        if name != self.table and name in self.tables:
            self.table = name
            self._own_table = None if name == AS_THE_HEAD else load_table(name)
            self.follow(self._head_table, self._idle)
            self.changed.emit()

    def follow(self, head: MouthTable, idle: IdleMotion) -> None:
        """Move as a head does that is moved by this table, and does this besides."""
        self._head_table, self._idle = head, idle
        table = replace(self._own_table or head, times=head.times, phone_times=head.phone_times, motion=head.motion)
        self.performer.configure(table, replace(idle, expression=self._expression))

    def express(self, expression: Expression | None) -> None:
        """Express this beside the speech, where the receiver has the blend shapes of ARKit."""
        self._expression = expression
        self.follow(self._head_table, self._idle)

    @override
    def _connect(self, address: OscAddress) -> OscMouth:
        return OscMouth(address, self.performer, clock=self._clock, on_failure=self._lost.emit)
