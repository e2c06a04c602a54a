"""The mouth over the network, live, as OSC messages: the module that imports python-osc for output.

=========================  ============================  ==========================================================
address                    arguments                     when
=========================  ============================  ==========================================================
``/phoneme``               name, intensity 0..1          at each change, and ten times a second
``/viseme``                mouth shape, intensity 0..1   the same
``/VMC/Ext/OK``            1                             sixty times a second, with the two below (VMC protocol)
``/VMC/Ext/T``             seconds
``/VMC/Ext/Blend/Val``     movestate, weight 0..1        for each movestate that the table moves
``/VMC/Ext/Blend/Apply``                                 after the last of them
``/VMC/Ext/Bone/Pos``      bone, position, quaternion    ``Head``, where it moves; ``LeftEye`` and ``RightEye``
``/VMC/Ext/Set/Eye``       1, x, y, z                    what the eyes look at, metres from the head
=========================  ============================  ==========================================================

A performer that blinks closes the lids, or moves ``Blink`` of an avatar, and its eyes look about. Positions are zero:
an avatar keeps its own. Axes are those of Unity, left-handed: x to the face's right, y upwards, z ahead.
"""

import contextlib
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
from typing_extensions import override

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.execution import Closing
from phonemeengine.mouth.blendshape_names import ARKIT, EYELIDS, VRM, VRM1
from phonemeengine.mouth.expression.composer import Expression
from phonemeengine.mouth.expression.streams import held_expression
from phonemeengine.mouth.idle_motion import Gaze, GazeDirection, HeadPose, eyes_in_head, gaze_weights
from phonemeengine.mouth.performer import FaceState, Performer
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme

RATE = 60.0
"""Pictures of the mouth that are sent each second."""
REPEAT = 0.1
"""Seconds after which a phoneme that stays is sent again: messages may get lost, and receivers come late."""
IN_A_PACKET = 24
"""Movestates in one packet: it fits into an Ethernet frame of 1500 bytes."""

BLINKS = {VRM: "Blink", VRM1: "blink"}
"""What closes both lids of an avatar whose mouth has these movestates."""

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
            raise MouthError(
                f"an OSC receiver is HOST:PORT, such as 127.0.0.1:39539, found {text[:60]!r}; correct it"
            )
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
    """Sends what a performer shows, from a thread of its own, until it is closed; no call waits for the network.

    Parameters
    ----------
    address : the receiver.
    performer : whose mouth is sent; other threads give it the speech meanwhile.
    clock : the clock of the performer's times, seconds.
    on_failure : given a sentence, in the thread that sends, when the receiver cannot be reached for another reason.

    Raises
    ------
    MouthError : the receiver's name is unknown.
    """

    def __init__(
        self,
        address: OscAddress,
        performer: Performer,
        *,
        clock: Callable[[], float] = time.monotonic,
        on_failure: Callable[[str], object] = lambda _sentence: None,
    ) -> None:
        self.failure = ""
        self.n_sent = 0
        self._socket, self._receiver = _opened(address)
        self._performer, self._clock, self._on_failure = performer, clock, on_failure
        self._began = clock()
        self._said, self._said_at = (Phoneme.SILENCE, ""), -math.inf
        self._gaze = Gaze(performer.idle.seed)
        self._use(performer.table)
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="osc", daemon=True)
        self._thread.start()

    @override
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
        self._send_bones(HeadPose(), GazeDirection())
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
        gaze = self._gaze.at(now) if self._performer.idle.blinks else GazeDirection()
        self._send_bones(face.head, gaze)
        self._send_weights(self._with_eyes(face, gaze), now, face.blink)

    def _use(self, table: MouthTable) -> None:
        """Send what another table moves: the shapes that it moves for phonemes, others once they have moved."""
        moved = np.any(table.on_face(table.weights()) != 0, axis=0)
        self._table, self._columns = table, {*np.flatnonzero(moved).tolist()}
        self._blinks = [name for movestates, name in BLINKS.items() if table.movestates == movestates]

    def _with_eyes(self, face: FaceState, gaze: GazeDirection) -> Float32Array:
        """Return the weights with lids that blink, and eyes that look where a face has shapes of its own for it."""
        wanted = dict.fromkeys(EYELIDS, face.blink)
        if self._table.targets and self._performer.idle.blinks:
            wanted |= gaze_weights(gaze, face.head)
        weights = face.weights.copy()
        for column, name in enumerate(self._table.movestates):
            weights[column] = max(weights[column], wanted.get(name, weights[column]))
        return weights

    def _send_bones(self, pose: HeadPose, gaze: GazeDirection) -> None:
        """Turn head and eyes, where the performer moves them."""
        idle, messages = self._performer.idle, list[tuple[str, Arguments]]()
        if idle.head:
            messages.append(_bone("Head", pose))
        if idle.blinks:
            yaw, pitch = eyes_in_head(gaze, pose)
            messages += [_bone(name, HeadPose(yaw, pitch)) for name in ("LeftEye", "RightEye")]
            flat, ahead = math.cos(math.radians(pitch)), (math.radians(yaw), math.radians(pitch))
            target = -math.sin(ahead[0]) * flat, math.sin(ahead[1]), math.cos(ahead[0]) * flat
            messages.append(("/VMC/Ext/Set/Eye", (1, *target)))
        if messages:
            self._send(messages)

    def _say(self, phoneme: Phoneme, shape: str, intensity: float, now: float) -> None:
        self._said, self._said_at = (phoneme, shape), now
        intensity = 0.0 if phoneme is Phoneme.SILENCE else intensity  # asked for or not, silence has no loudness
        self._send([("/phoneme", (phoneme.label, intensity)), ("/viseme", (shape, intensity))])

    def _send_weights(self, weights: Float32Array, now: float, blink: float = 0.0) -> None:
        shown, names = self._table.on_face(weights), self._table.face_names
        self._columns.update(np.flatnonzero(shown).tolist())
        values = [(names[k], min(max(float(shown[k]), 0.0), 1.0)) for k in sorted(self._columns)]
        if self._performer.idle.blinks:
            values += [(name, blink) for name in self._blinks]
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


def _bone(name: str, turned: HeadPose) -> tuple[str, Arguments]:
    """Return the message that turns a bone: it rolls first, then nods, then turns."""
    halves = (math.radians(angle) / 2 for angle in (turned.yaw, -turned.pitch, -turned.roll))
    (c1, s1), (c2, s2), (c3, s3) = ((math.cos(half), math.sin(half)) for half in halves)
    x, y = c1 * s2 * c3 + s1 * c2 * s3, s1 * c2 * c3 - c1 * s2 * s3
    z, w = c1 * c2 * s3 - s1 * s2 * c3, c1 * c2 * c3 + s1 * s2 * s3
    return "/VMC/Ext/Bone/Pos", (name, 0.0, 0.0, 0.0, x, -y, -z, w)


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


# What other programs ask a face to express, by OSC messages.
#
# ========================= ====================== ================================================================
# address arguments means ========================= ======================
# ================================================================ ``/expression`` name, weight 0..1 a preset such as
# ``smile``, or a blend shape of ARKit ``/VMC/Ext/Blend/Val`` blend shape, 0..1 the same, as face trackers send it
# (VMC protocol) ========================= ======================
# ================================================================

ADDRESSES = ("/expression", "/VMC/Ext/Blend/Val")
POLL = 0.05
"""Seconds after which closing is noticed."""
KEPT = 2.0
"""Seconds for which an expression stays after the last message: senders repeat it before."""
FADE = 0.5
"""Seconds in which it goes back to rest then."""


class OscExpression(Closing):
    """Listens until it is closed, in a thread of its own; an `ExpressionStream` of what was sent last.

    Messages that say nothing about a face are passed over. Once nothing has come for `KEPT` seconds, the face goes
    back to rest within `FADE` seconds.

    Parameters
    ----------
    address : where it listens, such as 127.0.0.1:39540.
    clock : measures how long nothing has come, seconds.

    Raises
    ------
    MouthError : another program listens there, or there is no such place.
    """

    def __init__(self, address: OscAddress, *, clock: Callable[[], float] = time.monotonic) -> None:
        from pythonosc.dispatcher import Dispatcher  # noqa: PLC0415 - with asyncio, for which few have a use
        from pythonosc.osc_server import BlockingOSCUDPServer  # noqa: PLC0415

        self._clock, self._received_at = clock, -math.inf
        self._shares: dict[str, float] = {}
        self._weights: Float32Array = np.zeros(len(ARKIT), np.float32)
        dispatcher = Dispatcher()
        for known in ADDRESSES:
            dispatcher.map(known, self._take)
        try:
            self._server = BlockingOSCUDPServer((address.host, address.port), dispatcher)
        except (OSError, UnicodeError) as error:
            raise MouthError(
                f"nothing can be received on {address.host}:{address.port} ({error}); choose another port"
            ) from error
        self._thread = threading.Thread(
            target=self._server.serve_forever, kwargs={"poll_interval": POLL}, name="osc expression", daemon=True
        )
        self._thread.start()

    @property
    def port(self) -> int:
        """Where it listens; the system's choice, where 0 was asked for."""
        return int(self._server.server_address[1])

    @property
    def names(self) -> tuple[str, ...]:
        """What was received so far, presets and blend shapes, the newest last; none once its sender has stopped."""
        return tuple(self._shares) if self._share_kept() else ()

    @property
    def stopped(self) -> bool:
        """Whether something was received, and its sender has stopped."""
        return bool(self._shares) and not self._share_kept()

    def weights(self, _time: float) -> Float32Array:
        """Return the weights of the 52 blend shapes of `ARKIT` now, float32, 0..1."""
        weights: Float32Array = self._weights * np.float32(self._share_kept())
        return weights

    @override
    def close(self) -> None:
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()

    def _share_kept(self) -> float:
        """Return how much is left of what was sent, 1 while its sender goes on, along half a cosine to 0."""
        gone = min(max((self._clock() - self._received_at - KEPT) / FADE, 0.0), 1.0)
        return 0.5 + 0.5 * math.cos(math.pi * gone)

    def _take(self, _address: str, *arguments: object) -> None:
        match arguments:
            case (str(name), int() | float() as share):
                before = self._shares if self._share_kept() else {}
                wanted = before | {name: min(max(0.0, share), 1.0)}
                with contextlib.suppress(MouthError):  # of a name that no face has
                    self._weights = held_expression(wanted).weights(0.0)
                    self._shares, self._received_at = wanted, self._clock()
