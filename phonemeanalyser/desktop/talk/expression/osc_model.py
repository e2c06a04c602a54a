"""The mouth over the network: whether it is sent, and where to."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, Qt, Signal

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.tasks import TaskQueue
from phonemeengine.errors import EngineError
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, tables_by_movestates

USUAL_ADDRESS = "127.0.0.1:39539"
"""Where VMC programs listen on this computer."""
AS_THE_HEAD = "head"
"""Stands for the table that moves the head."""
CLOSE_TIMEOUT = 2.0
"""Seconds after which the end of the program waits no longer for the network."""


class OscModel(QObject):
    """Sends what its performer shows, as OSC messages, while it is switched on; nothing here waits for the network.

    Parameters
    ----------
    clock : the clock of the performer's times, seconds.

    Signals
    -------
    changed : switched on or off, or another address or set.
    error : a sentence for the user.

    Attributes
    ----------
    address : ``HOST:PORT``, as the user wrote it.
    tables : what a receiver may be sent, by name, with what people call it: the table of the head, or that of each
        set of movestates.
    table : one of them.
    performer : says what the head says, with the movestates of the receiver.
    """

    changed = Signal()
    error = Signal(str)
    _lost = Signal(str)

    def __init__(self, clock: Callable[[], float]) -> None:
        super().__init__()
        self.address = USUAL_ADDRESS
        self.tables = {AS_THE_HEAD: tr("as the head"), **tables_by_movestates()}
        self.table = AS_THE_HEAD
        self._clock = clock
        self._head_table = load_table(USUAL_TABLE)
        self._own_table: MouthTable | None = None
        self.performer = Performer(self._head_table, MOUTH_ALONE)
        self._expression: Expression | None = None
        self._mouth: OscMouth | None = None
        self._wanted: OscAddress | None = None
        self._work = TaskQueue(self._fail)
        self._lost.connect(self._tell_lost, Qt.ConnectionType.QueuedConnection)

    @property
    def on(self) -> bool:
        """Whether it is switched on."""
        return self._wanted is not None

    @property
    def sending(self) -> bool:
        """Whether messages go out."""
        return self.on and self._mouth is not None and not self._mouth.failure

    @property
    def words(self) -> str:
        """What is going on, in words."""
        if not self.on:
            return tr("off")
        if self._mouth is None:
            return tr("looking for the receiver …")
        if self._mouth.failure:
            return tr("not reached")
        n = f"{self._mouth.n_sent:,}".replace(",", " ")
        return tr("sending, {n} packets").format(n=n)

    def set_on(self, on: bool) -> None:
        """Begin or end to send."""
        self._leave()
        if on:
            self._begin()
        self.changed.emit()

    def set_address(self, text: str) -> None:
        """Send elsewhere."""
        if text.strip() != self.address:
            self.address = text.strip()
            self.set_on(self.on)

    def set_table(self, name: str) -> None:
        """Send the movestates of another set."""
        if name in self.tables and name != self.table:
            self.table = name
            self._own_table = None if name == AS_THE_HEAD else load_table(name)
            self.follow(self._head_table, self.performer.idle.detail)
            self.changed.emit()

    def follow(self, head: MouthTable, detail: Detail) -> None:
        """Move as a head does that is moved by this table, in this detail."""
        self._head_table = head
        table = replace(self._own_table or head, times=head.times, phone_times=head.phone_times, motion=head.motion)
        self.performer.configure(table, replace(MOUTH_ALONE, detail=detail, expression=self._expression))

    def express(self, expression: Expression | None) -> None:
        """Express this beside the speech, where the receiver has the blend shapes of ARKit."""
        self._expression = expression
        self.follow(self._head_table, self.performer.idle.detail)

    def close(self) -> None:
        """Close the mouth at the receiver, and stop."""
        self._leave()
        self._work.finish(CLOSE_TIMEOUT)

    def _begin(self) -> None:
        try:
            address = self._wanted = OscAddress.of(self.address)
        except EngineError as error:
            self._fail(str(error))
            return
        self._work.submit(
            lambda _progress: OscMouth(address, self.performer, clock=self._clock, on_failure=self._lost.emit),
            lambda mouth: self._take(address, mouth),
        )

    def _take(self, address: OscAddress, mouth: OscMouth) -> None:
        """Send with this one, unless something else is wanted by now."""
        if address is self._wanted:
            self._mouth = mouth
            self.changed.emit()
        else:
            self._work.submit(lambda _progress: mouth.close())

    def _leave(self) -> None:
        self._wanted = None
        mouth, self._mouth = self._mouth, None
        if mouth is not None:
            self._work.submit(lambda _progress: mouth.close())

    def _fail(self, sentence: str) -> None:
        self._leave()
        self._tell_lost(sentence)
        self.changed.emit()

    def _tell_lost(self, sentence: str) -> None:
        self.error.emit(_sentence(sentence))


def _sentence(words: str) -> str:
    return f"{words[0].upper()}{words[1:]}."
