"""The mouth over the network, live, as OSC messages: the only door to python-osc.

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

import socket
import threading
import time
from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np
from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder

from phonemeengine.analyser import Analysis
from phonemeengine.errors import MouthError
from phonemeengine.lifetime import Closing
from phonemeengine.mouth.morpher import Detail, Morpher
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.viseme_override import VisemeOverride
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

RATE = 60.0
"""Pictures of the mouth that are sent each second."""
REPEAT = 0.1
"""Seconds after which a phoneme that stays is sent again: messages may get lost, and receivers come late."""
QUIET = 0.5
"""Seconds without a frame after which the mouth closes."""
CLOSE_AFTER = 10.0
"""Seconds after which every mouth has closed."""
IN_A_PACKET = 24
"""Movestates in one packet: it fits into an Ethernet frame of 1500 bytes."""
MOST_WAITING = 1000
"""Frames that wait to be sent at most."""

LEFT_TO_SPEECH: tuple[dict[Phoneme, float], float] = ({}, 1.0)
"""No shape is asked for, and the speech moves the whole mouth."""

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
    """Where the mouth is sent to, and with which table."""

    address: OscAddress
    table: MouthTable


class OscMouth(Closing):
    """Sends what is heard or asked for, from a thread of its own, until it is closed; nobody waits for the network.

    Parameters
    ----------
    address : the receiver.
    table : the mouth shapes and the movestates.
    detail : how much of the speech the mouth follows.
    seed : of the mouth's randomness.

    Raises
    ------
    MouthError : the receiver's name is unknown.
    """

    def __init__(
        self, address: OscAddress, table: MouthTable, *, detail: Detail = Detail.PHONEMES, seed: int = 0
    ) -> None:
        self.failure = ""
        self.n_sent = 0
        self._socket, self._receiver = _opened(address)
        self._table = table
        self._morpher, self._visemes = Morpher(table, detail=detail, seed=seed), VisemeOverride(table)
        self._asked: tuple[dict[Phoneme, float], float] = LEFT_TO_SPEECH
        self._columns = np.flatnonzero(np.any(table.weights() != 0, axis=0)).tolist()
        self._frames: deque[tuple[float, int, float]] = deque(maxlen=MOST_WAITING)
        self._last = (int(Phoneme.SILENCE), 0.0)
        self._said, self._said_at = -1, 0.0
        self._began = self._heard_at = time.monotonic()
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="osc", daemon=True)
        self._thread.start()

    def add_analysis(self, analysis: Analysis) -> None:
        """Take the next frames, as soon as they are known; returns at once."""
        now, n = time.monotonic(), len(analysis)
        for k in range(n):
            began = now - (n - 1 - k) * FRAME_PERIOD
            self._frames.append((began, int(analysis.phonemes[k]), float(analysis.intensities[k])))

    def ask(self, phonemes: Mapping[Phoneme, float], speech: float = 0.0) -> None:
        """Show the shapes of these phonemes, 0..1, beside a share of what is heard; of none, what is heard.

        Returns at once.
        """
        self._asked = (dict(phonemes), speech) if phonemes else LEFT_TO_SPEECH

    def close(self) -> None:
        """Close the mouth at the receiver, and stop."""
        self._closing.set()
        self._thread.join(1.0)

    def _run(self) -> None:
        following = time.monotonic()
        while not self._closing.is_set():
            self._show(time.monotonic())
            following = max(following + 1 / RATE, time.monotonic() - 1 / RATE)
            self._closing.wait(max(following - time.monotonic(), 0.0))
        self._hear_waiting()
        self._asked = LEFT_TO_SPEECH
        now = time.monotonic()
        self._hear(now, int(Phoneme.SILENCE), 0.0)
        self._send_picture(now + CLOSE_AFTER)
        self._socket.close()

    def _hear_waiting(self) -> None:
        with suppress(IndexError):
            while True:
                self._hear(*self._frames.popleft())

    def _show(self, now: float) -> None:
        self._hear_waiting()
        if now - self._heard_at > QUIET and self._last[0] != Phoneme.SILENCE:
            self._hear(now, int(Phoneme.SILENCE), 0.0)
        self._send_picture(now)

    def _hear(self, began: float, code: int, intensity: float) -> None:
        self._heard_at = began = max(began, self._heard_at)
        self._morpher.hear(began, code, intensity)
        self._last = (code, intensity)
        if code != self._said and not self._asked[0]:
            self._say(began)

    def _say(self, now: float) -> None:
        code, intensity = self._saying
        self._said, self._said_at = code, now
        phoneme = Phoneme(code)
        intensity = 0.0 if phoneme is Phoneme.SILENCE else intensity  # it may be asked for, yet nobody hears it
        self._send(
            [("/phoneme", (phoneme.label, intensity)), ("/viseme", (self._table.phonemes[phoneme], intensity))]
        )

    @property
    def _saying(self) -> tuple[int, float]:
        """What is asked for the most, or else what was heard last: a phoneme and its intensity."""
        asked, _ = self._asked
        return max(asked.items(), key=lambda entry: entry[1]) if asked else self._last

    def _send_picture(self, now: float) -> None:
        if now - self._said_at >= REPEAT or self._saying[0] != self._said:
            self._say(now)
        self._visemes.ask_as(*self._asked)
        weights = self._visemes.mixed(self._morpher.weights(now), now)
        values = [(self._table.movestates[k], min(max(float(weights[k]), 0.0), 1.0)) for k in self._columns]
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
            self.failure = f"the OSC receiver cannot be reached ({error.strerror or error}); check its address"


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
