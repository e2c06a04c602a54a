"""Other programs ask a face to express something, over the network."""

from collections.abc import Iterator

import pytest
from pythonosc.udp_client import SimpleUDPClient

from phonemeengine import Expression, IdleMotion, MouthError, OscExpression, Performer, load_table
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.osc import FADE, KEPT, OscAddress
from tests.waiting import wait_for

SMILE, BROW = ARKIT.index("mouthSmileLeft"), ARKIT.index("browInnerUp")


@pytest.fixture
def sent() -> Iterator[tuple[OscExpression, SimpleUDPClient]]:
    address = OscAddress("127.0.0.1", 0)
    with OscExpression(address) as stream:
        client = SimpleUDPClient("127.0.0.1", stream.port)
        yield stream, client
        client.close()


def shows(stream: OscExpression, column: int, share: float) -> None:
    wait_for(lambda: abs(float(stream.weights(0.0)[column]) - share) < 1e-3, f"{share}")


def test_presets_and_blend_shapes_that_are_sent_are_shown(sent):
    stream, client = sent
    client.send_message("/expression", ["smile", 0.8])
    client.send_message("/VMC/Ext/Blend/Val", ["browInnerUp", 0.5])
    shows(stream, SMILE, 0.6)
    shows(stream, BROW, 0.5)
    client.send_message("/expression", ["smile", 0])
    shows(stream, SMILE, 0.0)
    shows(stream, BROW, 0.5)
    client.send_message("/VMC/Ext/Blend/Val", ["AU12L", 0.4])  # an action unit
    shows(stream, SMILE, 0.4)


def test_nonsense_is_passed_over(sent):
    stream, client = sent
    for arguments in (["joy", 1.0], ["smile"], [1.0, "smile"], ["smile", "much"], ["browInnerUp", float("nan")], []):
        client.send_message("/expression", arguments)
    client.send_message("/VMC/Ext/Bone/Pos", ["Head", 0.1])
    client.send_message("/expression", ["mouthSmile", 7.0])
    shows(stream, SMILE, 1.0)
    assert float(stream.weights(0.0).sum()) == pytest.approx(2.0)


def test_a_performer_shows_what_is_sent(sent):
    stream, client = sent
    performer = Performer(load_table("arkit"), IdleMotion(blinks=False, expression=Expression((stream,))))
    client.send_message("/expression", ["smile", 1.0])
    shows(stream, SMILE, 0.75)
    assert performer.at(1.0).weights[SMILE] == pytest.approx(0.75, abs=1e-3)


def test_a_port_that_is_taken_is_refused_in_one_sentence(sent):
    stream, _ = sent
    with pytest.raises(MouthError, match="choose another port"):
        OscExpression(OscAddress("127.0.0.1", stream.port))


def test_a_face_goes_back_to_rest_when_its_sender_stops() -> None:
    clock = [0.0]
    with OscExpression(OscAddress("127.0.0.1", 0), clock=lambda: clock[0]) as stream:
        client = SimpleUDPClient("127.0.0.1", stream.port)
        client.send_message("/expression", ["smile", 1.0])
        shows(stream, SMILE, 0.75)
        clock[0] = KEPT
        assert (float(stream.weights(0.0)[SMILE]), stream.names) == (0.75, ("smile",))
        clock[0] = KEPT + FADE / 2
        assert float(stream.weights(0.0)[SMILE]) == pytest.approx(0.375)
        clock[0] = KEPT + FADE
        assert (float(stream.weights(0.0).max()), stream.names, stream.stopped) == (0.0, (), True)
        client.send_message("/expression", ["browInnerUp", 0.5])
        shows(stream, BROW, 0.5)
        assert (float(stream.weights(0.0)[SMILE]), stream.names, stream.stopped) == (0.0, ("browInnerUp",), False)
        client.close()
