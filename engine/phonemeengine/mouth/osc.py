"""The mouth over the network, live, as OSC messages: the door to python-osc that leads out.

=========================  ============================  ==========================================================
address                    arguments                     when
=========================  ============================  ==========================================================
``/phoneme``               name, intensity 0..1          at each change, and ten times a second
``/viseme``                mouth shape, intensity 0..1   the same
``/VMC/Ext/OK``            1                             sixty times a second, with the two below (VMC protocol)
``/VMC/Ext/T``             seconds
``/VMC/Ext/Blend/Val``     movestate, weight 0..1        for each movestate that the table moves
``/VMC/Ext/Blend/Apply``                                 after the last of them
=========================  ============================  ==========================================================
"""

import math
import socket
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.execution import Closing
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.performer import Performer
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme

RATE = 60.0
"""Pictures of the mouth that are sent each second."""
REPEAT = 0.1
"""Seconds after which a phoneme that stays is sent again: messages may get lost, and receivers come late."""
IN_A_PACKET = 24
"""Movestates in one packet: it fits into an Ethernet frame of 1500 bytes."""

Arguments = tuple[str | int | float, ...]


@dataclass(frozen=True)
class OscAddress:
    """Where messages go."""

    host: str
    port: int

    @classmethod
    def of(cls, text: str) -> "OscAddress":
        """Read ``HOST:PORT``, such as ``127.0.0.1:39539`` or ``[::1]:39539``.

        Raises
        ------
        MouthError : it is none.
        """
        host, colon, port = text.rpartition(":")
        host = host.strip("[]")
        if not (colon and host and port.isascii() and port.isdecimal() and len(port) < 6 and 0 < int(port) < 65536):
            raise MouthError(f"an OSC receiver is HOST:PORT, such as 127.0.0.1:39539, found {text[:60]!r}")
        return cls(host, int(port))


@dataclass(frozen=True)
class OscSettings:
    """Where the mouth is sent to, with which table, and what the face expresses meanwhile."""

    address: OscAddress
    table: MouthTable
    expression: Expression | None = None

    def __post_init__(self) -> None:
        if self.expression is not None:
            self.expression.check_fits(self.table.movestates, self.table.name)


class OscMouth(Closing):
    """Sends what a performer shows, from a thread of its own, until it is closed; nobody waits for the network.

    Parameters
    ----------
    address : the receiver.
    performer : whose mouth is sent; it hears what is said from other threads meanwhile.
    clock : the clock of the performer's times, seconds.
    on_failure : given a sentence, in the thread that sends, when the receiver cannot be reached for another reason.

    Raises
    ------
    MouthError : the receiver's name is unknown.
    """

    def __init__(
        self, address: OscAddress, performer: Performer, *, clock: Callable[[], float] = time.monotonic,
        on_failure: Callable[[str], object] = lambda _sentence: None,
    ) -> None:  # fmt: skip
        self.failure = ""
        self.n_sent = 0
        self._socket, self._receiver = _opened(address)
        self._performer, self._clock, self._on_failure = performer, clock, on_failure
        self._began = clock()
        self._said, self._said_at = (Phoneme.SILENCE, ""), -math.inf
        self._use(performer.table)
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="osc", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Close the mouth at the receiver, and stop."""
        self._closing.set()
        self._thread.join(1.0)

    def _run(self) -> None:
        following = time.monotonic()
        while not self._closing.is_set():
            self._show(self._clock())
            following = max(following + 1 / RATE, time.monotonic() - 1 / RATE)
            self._closing.wait(max(following - time.monotonic(), 0.0))
        self._say(Phoneme.SILENCE, self._table.phonemes[Phoneme.SILENCE], 0.0, self._clock())
        self._send_weights(self._table.weights()[Phoneme.SILENCE], self._clock())
        self._socket.close()

    def _show(self, now: float) -> None:
        face = self._performer.at(now)
        if face.table is not self._table:
            self._use(face.table)
        for phoneme, intensity, phone in self._performer.pop_said():
            shape = self._table.shape_of(phoneme, phone)
            if (phoneme, shape) != self._said or now - self._said_at >= REPEAT:
                self._say(phoneme, shape, intensity, now)
        self._send_weights(face.weights, now)

    def _use(self, table: MouthTable) -> None:
        """Send the movestates of another table: those that it moves for phonemes, others once they have moved."""
        self._table, self._columns = table, {*np.flatnonzero(np.any(table.weights() != 0, axis=0)).tolist()}

    def _say(self, phoneme: Phoneme, shape: str, intensity: float, now: float) -> None:
        self._said, self._said_at = (phoneme, shape), now
        intensity = 0.0 if phoneme is Phoneme.SILENCE else intensity  # it may be asked for, yet nobody hears it
        self._send([("/phoneme", (phoneme.label, intensity)), ("/viseme", (shape, intensity))])

    def _send_weights(self, weights: Float32Array, now: float) -> None:
        self._columns.update(np.flatnonzero(weights).tolist())
        values = [(self._table.movestates[k], min(max(float(weights[k]), 0.0), 1.0)) for k in sorted(self._columns)]
        messages: list[tuple[str, Arguments]] = [("/VMC/Ext/OK", (1,)), ("/VMC/Ext/T", (now - self._began,))]
        messages += [("/VMC/Ext/Blend/Val", value) for value in values]
        messages.append(("/VMC/Ext/Blend/Apply", ()))
        for k in range(0, len(messages), IN_A_PACKET):
            self._send(messages[k : k + IN_A_PACKET])

    def _send(self, messages: list[tuple[str, Arguments]]) -> None:
        """Send a bundle; what the network refuses is lost, as messages of UDP may be."""
        try:
            self._socket.sendto(_bundle(messages), self._receiver)
            self.n_sent += 1
        except OSError as error:
            failure = f"the OSC receiver cannot be reached ({error.strerror or error}); check its address"
            if failure != self.failure:
                self.failure = failure
                self._on_failure(failure)


def _bundle(messages: list[tuple[str, Arguments]]) -> bytes:
    bundle = OscBundleBuilder(IMMEDIATELY)
    for address, arguments in messages:
        message = OscMessageBuilder(address)
        for argument, kind in _typed(arguments):
            message.add_arg(argument, kind)
        bundle.add_content(message.build())
    return bytes(bundle.build().dgram)


def _typed(arguments: Arguments) -> Iterator[tuple[str | int | float, str]]:
    kinds = {str: "s", int: "i", float: "f"}
    return ((argument, kinds[type(argument)]) for argument in arguments)


def _opened(address: OscAddress) -> tuple[socket.socket, Any]:
    """Look the receiver up once, so that sending never asks for a name."""
    try:
        found = socket.getaddrinfo(address.host, address.port, type=socket.SOCK_DGRAM)
        family, kind, protocol, _, receiver = found[0]
        door = socket.socket(family, kind, protocol)
    except (OSError, UnicodeError) as error:
        raise MouthError(
            f"the OSC receiver {address.host} is unknown ({error}); check its name, or give its number"
        ) from error
    door.setblocking(False)
    return door, receiver
