"""The mouth over the network: what a real receiver hears on the loopback address."""

import re
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import VRM
from phonemeengine.mouth.osc import OscAddress, OscMouth
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer, TimedFrame
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from tests.fakes.osc_receiver import Receiver
from tests.waiting import wait_for

UNREACHABLE = OscAddress("255.255.255.255", 9)
"""The system refuses to send there."""


@pytest.fixture
def receiver() -> Iterator[Receiver]:
    receiver = Receiver()
    yield receiver
    receiver.close()


@contextmanager
def mouth_to(receiver: Receiver, table: str = "vrm") -> Iterator[Performer]:
    """Send what somebody shows who may be spoken to meanwhile."""
    performer = Performer(load_table(table), MOUTH_ALONE)
    mouth = OscMouth(receiver.address, performer)
    try:
        yield performer
    finally:
        mouth.close()


def hear(performer: Performer, phoneme: Phoneme, intensity: float = 1.0) -> None:
    now = time.monotonic()
    performer.add([TimedFrame(now - FRAME_PERIOD, phoneme, intensity)], now, live=True)


@contextmanager
def speaking(performer: Performer, phoneme: Phoneme, intensity: float = 1.0) -> Iterator[None]:
    """Have it hear a phoneme as a microphone would, until the end."""
    done = threading.Event()

    def speak() -> None:
        while not done.wait(FRAME_PERIOD):
            hear(performer, phoneme, intensity)

    thread = threading.Thread(target=speak)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def test_a_receiver_hears_phonemes_and_mouth_shapes(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth, speaking(mouth, Phoneme.SCH, 0.5):
        wait_for(lambda: ("sch", 0.5) in receiver.of("/phoneme"), "the phoneme")
        wait_for(lambda: ("lips", 0.5) in receiver.of("/viseme"), "the shape")
    assert receiver.of("/phoneme")[0] == ("silence", 0.0)


def test_a_receiver_sees_the_shapes_of_phones_once_they_are_known(receiver: Receiver) -> None:
    with mouth_to(receiver, "oculus") as mouth:
        wait_for(lambda: "PP" in receiver.weights(), "the first picture")
        assert "FF" not in receiver.weights()
        now = time.monotonic()
        mouth.add([TimedFrame(now, Phoneme.UNIDENTIFIED, 1.0, phone="f")], now)
        wait_for(lambda: ("FF", 1.0) in receiver.of("/viseme"), "the shape")
        wait_for(lambda: receiver.weights().get("FF", 0) > 0.9, "teeth on the lip")
    wait_for(lambda: receiver.weights()["FF"] == 0, "a shut mouth")
    assert ("unidentified", 1.0) in receiver.of("/phoneme")


def test_a_vtuber_program_opens_the_mouth_for_a_and_shuts_it_at_the_end(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth, speaking(mouth, Phoneme.A):
        wait_for(lambda: receiver.weights().get("A", 0) > 0.7, "an open mouth")
        assert max(value for name, value in receiver.weights().items() if name != "A") < 0.05
    wait_for(lambda: receiver.weights()["A"] == 0, "a shut mouth")
    assert set(receiver.weights()) == set(VRM)


def test_what_is_asked_for_wins_over_what_is_heard_until_it_is_asked_no_more(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth, speaking(mouth, Phoneme.A):
        wait_for(lambda: receiver.weights().get("A", 0) > 0.7, "what is heard")
        mouth.set_phonemes({Phoneme.U: 0.5, Phoneme.I: 0.25}, 0.0)
        wait_for(lambda: receiver.weights()["A"] < 0.01 < receiver.weights()["U"], "what is asked for")
        wait_for(lambda: ("u", 0.5) in receiver.of("/phoneme"), "its name")
        wait_for(lambda: receiver.weights()["U"] == pytest.approx(2 * receiver.weights()["I"], rel=0.02), "halves")
        mouth.set_phonemes({}, 0.0)
        wait_for(lambda: receiver.weights()["A"] > 0.7 and receiver.weights()["U"] < 0.01, "what is heard again")
        assert receiver.of("/phoneme")[-1][0] == "a"


def test_a_mouth_that_is_asked_to_open_is_shut_at_the_end(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth:
        mouth.set_phonemes({Phoneme.A: 1.0}, 0.0)
        wait_for(lambda: receiver.weights().get("A", 0) > 0.7, "an open mouth")
    wait_for(lambda: receiver.weights()["A"] < 1e-6, "a shut mouth")
    assert receiver.of("/phoneme")[-1][0] == "silence"


def test_silence_that_is_asked_for_has_no_intensity(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth, speaking(mouth, Phoneme.A, 0.7):
        wait_for(lambda: ("a", pytest.approx(0.7)) in receiver.of("/phoneme"), "what is heard")
        n = len(receiver.of("/phoneme"))
        mouth.set_phonemes({Phoneme.SILENCE: 1.0}, 0.0)
        wait_for(lambda: "silence" in dict(receiver.of("/phoneme")[n:]), "what is asked for")
    assert {loud for name, loud in receiver.of("/phoneme") if name == "silence"} == {0.0}


def test_weights_are_applied_after_all_of_them_were_sent(receiver: Receiver) -> None:
    with mouth_to(receiver):
        wait_for(lambda: len(receiver.of("/VMC/Ext/Blend/Apply")) >= 3, "three pictures")
    names = [name for name, _ in receiver.messages if name.startswith("/VMC")]
    picture = ["/VMC/Ext/OK", "/VMC/Ext/T", *["/VMC/Ext/Blend/Val"] * 5, "/VMC/Ext/Blend/Apply"]
    assert names[: 3 * len(picture)] == 3 * picture
    assert all(arguments == () for arguments in receiver.of("/VMC/Ext/Blend/Apply"))
    assert set(receiver.of("/VMC/Ext/OK")) == {(1,)}


def test_a_face_with_many_movestates_fits_into_packets_of_a_network(receiver: Receiver) -> None:
    with mouth_to(receiver, "arkit") as mouth, speaking(mouth, Phoneme.I):
        wait_for(lambda: receiver.weights().get("mouthSmileLeft", 0) > 0.2, "a smile")
    assert 500 < max(receiver.sizes) < 1473
    assert set(receiver.weights()) < set(load_table("arkit").movestates)


def test_the_mouth_closes_when_the_microphone_gives_nothing_any_more(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth:
        with speaking(mouth, Phoneme.A):
            wait_for(lambda: receiver.weights().get("A", 0) > 0.7, "an open mouth")
        wait_for(lambda: receiver.weights()["A"] == 0, "a shut mouth")
        assert receiver.of("/phoneme")[-1] == ("silence", 0.0)


def test_a_phoneme_that_stays_is_said_again_for_those_who_come_late(receiver: Receiver) -> None:
    with mouth_to(receiver):
        wait_for(lambda: len(receiver.of("/phoneme")) >= 4, "repetitions")
    assert set(receiver.of("/phoneme")) == {("silence", 0.0)}


def test_nobody_waits_for_the_network() -> None:
    """While the thread that sends hangs, all that is heard is taken in."""
    hanging, released = threading.Event(), threading.Event()

    def hang(_sentence: str) -> None:
        hanging.set()
        assert released.wait(60)

    performer = Performer(load_table("vrm"), MOUTH_ALONE)
    mouth = OscMouth(UNREACHABLE, performer, on_failure=hang)
    assert hanging.wait(60)
    for _ in range(3000):
        hear(performer, Phoneme.A)
    assert performer.pop_said()[-1] == (Phoneme.A, 1.0, "")
    released.set()
    mouth.close()


def test_a_receiver_that_is_not_there_harms_nobody() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    mouth = OscMouth(OscAddress("127.0.0.1", port), Performer(load_table("vrm")))
    wait_for(lambda: mouth.n_sent > 3 or mouth.failure != "", "messages")
    mouth.close()
    assert not mouth._thread.is_alive()


def test_a_network_that_is_down_is_said_in_one_sentence() -> None:
    told: list[str] = []
    mouth = OscMouth(UNREACHABLE, Performer(load_table("vrm")), on_failure=told.append)
    wait_for(lambda: mouth.failure != "", "the failure")
    mouth.close()
    assert told == [mouth.failure]
    assert re.fullmatch(r"the OSC receiver cannot be reached \([^()]+\); check its address", mouth.failure)


@pytest.mark.parametrize(
    ("text", "host", "port"),
    [("127.0.0.1:39539", "127.0.0.1", 39539), ("localhost:1", "localhost", 1), ("[::1]:65535", "::1", 65535)],
)
def test_a_receiver_is_a_host_and_a_port(text: str, host: str, port: int) -> None:
    assert OscAddress.of(text) == OscAddress(host, port)


@pytest.mark.parametrize(
    "text", ["", "localhost", ":9000", "localhost:", "localhost:0", "a:65536", "a:9x", "a:-1", "a:٣"]
)
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(MouthError, match=r"an OSC receiver is HOST:PORT, such as 127\.0\.0\.1:39539, found"):
        OscAddress.of(text)


def test_a_name_that_nobody_knows_is_refused() -> None:
    nowhere = "nowhere" * 10  # no name on the network is that long
    with pytest.raises(MouthError, match=rf"the OSC receiver {nowhere} is unknown .*; check its name, or give its"):
        OscMouth(OscAddress(nowhere, 9000), Performer(load_table("vrm")))


def test_the_speech_goes_on_beside_a_shape_as_far_as_it_is_let(receiver: Receiver) -> None:
    with mouth_to(receiver) as mouth, speaking(mouth, Phoneme.A):
        wait_for(lambda: receiver.weights().get("A", 0) > 0.7, "an a")
        mouth.set_phonemes({Phoneme.U: 0.4}, 1.0)
        wait_for(lambda: receiver.weights()["U"] > 0.35 and receiver.weights()["A"] > 0.7, "both")
        mouth.set_phonemes({Phoneme.U: 0.6}, 0.4)
        wait_for(lambda: receiver.weights()["U"] > 0.55 and 0.27 < receiver.weights()["A"] < 0.45, "shares of both")
        mouth.set_phonemes({Phoneme.U: 0.6}, 0.0)
        wait_for(lambda: receiver.weights()["U"] > 0.55 and receiver.weights()["A"] < 0.01, "the shape alone")
