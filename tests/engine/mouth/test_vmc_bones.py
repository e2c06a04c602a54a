"""Head, eyes and blinks over VMC, as a receiver of its own sees them: a socket, and OSC 1.0 read by hand."""

import math
import socket
import struct
from collections.abc import Iterator

import numpy as np
import pytest

from phonemeengine.mouth.face_mapping import guess_mapping, mapped_table
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, IdleMotion, Performer
from phonemeengine.mouth.table import MouthTable, load_table

SPEED = 0.1
"""Seconds of the performer from one look to the next."""
Value = str | int | float
Message = tuple[str, tuple[Value, ...]]


def messages_in(packet: bytes) -> Iterator[Message]:
    """Give the messages of an OSC packet, a bundle or one message (OSC 1.0)."""
    if packet.startswith(b"#bundle\0"):
        at = 16
        while at < len(packet):
            size = struct.unpack_from(">i", packet, at)[0]
            yield from messages_in(packet[at + 4 : at + 4 + size])
            at += 4 + size
        return
    address, at = text_at(packet, 0)
    kinds, at = text_at(packet, at)
    values: list[Value] = []
    for kind in kinds[1:]:
        if kind == "s":
            text, at = text_at(packet, at)
            values.append(text)
        else:
            values.append(struct.unpack_from(">i" if kind == "i" else ">f", packet, at)[0])
            at += 4
    yield address, tuple(values)


def text_at(packet: bytes, at: int) -> tuple[str, int]:
    end = packet.index(b"\0", at)
    return packet[at:end].decode(), end + 4 - end % 4


def seen_of(table: MouthTable, idle: IdleMotion | None = None, n: int = 2000) -> list[Message]:
    """Give what a receiver sees of a performer that says nothing for a while."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(30)
        now = iter(np.arange(10_000_000) * SPEED)
        address = OscAddress("127.0.0.1", receiver.getsockname()[1])
        messages: list[Message] = []
        with OscMouth(address, Performer(table, idle), clock=lambda: float(next(now))):
            while len(messages) < n:
                packet = receiver.recv(4096)
                assert len(packet) <= 1500
                messages += messages_in(packet)
    return messages


def bones_of(messages: list[Message], name: str) -> np.ndarray:
    """Give the quaternions of a bone, shape (n, 4)."""
    return np.array([v[4:] for address, v in messages if address == "/VMC/Ext/Bone/Pos" and v[0] == name], float)


def values_of(messages: list[Message], name: str) -> list[float]:
    return [float(v[1]) for address, v in messages if address == "/VMC/Ext/Blend/Val" and v[0] == name]


@pytest.fixture(scope="module")
def avatar() -> list[Message]:
    return seen_of(load_table("vrm"))


def test_a_receiver_sees_head_eyes_gaze_and_blinks_of_an_avatar(avatar: list[Message]) -> None:
    messages = avatar
    for name in ("Head", "LeftEye", "RightEye"):
        quaternions = bones_of(messages, name)
        np.testing.assert_allclose(np.linalg.norm(quaternions, axis=1), 1, atol=1e-5)
        assert np.ptp(quaternions[:, 1]) > 0.005  # it turns to both sides
    assert max(values_of(messages, "Blink")) > 0.5
    assert min(values_of(messages, "Blink")) == 0
    looks = np.array([v for address, v in messages if address == "/VMC/Ext/Set/Eye"], float)
    assert np.all(looks[:, 0] == 1)
    np.testing.assert_allclose(np.linalg.norm(looks[:, 1:], axis=1), 1, atol=1e-5)
    assert np.all(looks[:, 3] > 0.8)  # ahead


def test_eyes_turn_as_far_as_they_look(avatar: list[Message]) -> None:
    quaternions = bones_of(avatar, "LeftEye")
    looks = np.array([v[1:] for address, v in avatar if address == "/VMC/Ext/Set/Eye"], float)
    x, y, z, w = quaternions[: len(looks)].T
    ahead = np.stack((2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)), axis=1)
    np.testing.assert_allclose(ahead, looks[: len(ahead)], atol=1e-4)


def test_lids_close_by_the_names_of_the_receiver() -> None:
    assert max(values_of(seen_of(load_table("arkit")), "eyeBlinkLeft")) > 0.5


def test_a_mouth_alone_leaves_head_and_eyes_to_the_receiver() -> None:
    messages = seen_of(load_table("vrm"), MOUTH_ALONE, n=300)
    assert not [address for address, _ in messages if "Bone" in address or "Eye" in address]
    assert not values_of(messages, "Blink")


def test_a_face_with_names_of_its_own_gets_those() -> None:
    mapping = guess_mapping(["Mouth Open", "Blink", "Smile_L", "Smile_R", "Eye_L_Look_L", "Eye_R_Look_L"])
    messages = seen_of(mapped_table(mapping, "mine"))
    sent = {str(v[0]) for address, v in messages if address == "/VMC/Ext/Blend/Val"}
    assert sent <= {name for shapes in mapping.targets.values() for name in shapes}
    assert max(values_of(messages, "Blink")) > 0.5
    assert max(values_of(messages, "Eye_L_Look_L")) > 0.05
    assert math.isclose(max(values_of(messages, "Mouth Open")), 0, abs_tol=0.2)
