"""The mouth over the network: whether it is sent, and where to."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Qt, Signal
from typing_extensions import override

from phonemeanalyser.desktop.language import tr
from phonemeanalyser.desktop.talk.expression.osc_connection import OscConnection
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table, tables_by_movestates

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
    tables : what a receiver may be sent, by name, with what people call it: the table of the head, or that of each
        set of movestates.
    table : one of them.
    performer : says what the head says, with the movestates of the receiver.
    """

    _lost = Signal(str)

    def __init__(self, clock: Callable[[], float]) -> None:
        super().__init__(USUAL_ADDRESS)
        self.tables = {AS_THE_HEAD: tr("Same as the head"), **tables_by_movestates()}
        self.table = AS_THE_HEAD
        self._clock = clock
        self._head_table = load_table(USUAL_TABLE)
        self._own_table: MouthTable | None = None
        self.performer = Performer(self._head_table, MOUTH_ALONE)
        self._idle = self.performer.idle
        self._expression: Expression | None = None
        self._lost.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    @property
    def _mouth(self) -> OscMouth | None:
        mouth: OscMouth | None = self.connection
        return mouth

    @property
    def sending(self) -> bool:
        """Whether messages go out."""
        return self._mouth is not None and not self._mouth.failure

    @property
    def words(self) -> str:
        """What is going on, in words."""
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
        if name in self.tables and name != self.table:
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
