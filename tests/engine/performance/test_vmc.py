from itertools import count

import numpy as np
import pytest

from phonemeengine import CorpusError, OscMouth, Performer, load_table
from phonemeengine.mouth.osc import RATE
from phonemeengine.performance.face_track import parse_vmc
from tests.engine.performance.faces import osc_line, recorded_vmc
from tests.fakes.osc_receiver import Receiver
from tests.waiting import wait_for


@pytest.mark.parametrize("clock", [True, False])
def test_frames_have_the_senders_time_where_it_tells_it_else_that_of_their_packets(clock: bool) -> None:
    track = parse_vmc(recorded_vmc([100 + k / 32 for k in range(9)], clock=clock), "a.osc")
    assert track.channels == ("jawOpen",)
    assert track.times == pytest.approx(np.arange(9) / 32, abs=1e-6)
    assert track.weights[:, 0] == pytest.approx(np.arange(9) / 100)


def test_what_is_not_sent_anew_stays_as_it_is() -> None:
    lines = recorded_vmc([1.0, 1.05, 1.1], clock=True).split("\n")
    track = parse_vmc("\n".join(line for line in lines if "0.01" not in line), "a.osc")
    assert track.weights[:, 0] == pytest.approx([0, 0, 0.02])


def test_shoulders_travel_as_blend_shapes_and_other_names_are_passed_over() -> None:
    frames = recorded_vmc([1.0, 1.05], clock=True)
    track = parse_vmc(frames.replace("JawOpen", "ShoulderShiftLeft") + recorded_vmc([1.1], clock=True), "a.osc")
    assert track.channels == ("shoulderShiftLeft", "jawOpen")
    assert track.weights[:, 0] == pytest.approx([0, 0.01, 0.01])


def test_action_units_count_for_shapes_that_are_not_sent() -> None:
    frames = recorded_vmc([1.0, 1.05, 1.1], clock=True)
    units = frames.replace("JawOpen", "AU12L"), frames.replace("JawOpen", "AU26"), frames
    for text, channels in zip(units, (("mouthSmileLeft",), ("jawOpen",), ("jawOpen",)), strict=True):
        track = parse_vmc(text, "a.osc")
        assert track.channels == channels
        assert track.weights[:, 0] == pytest.approx([0, 0.01, 0.02])


def test_what_the_program_sends_can_be_recorded() -> None:
    receiver, times = Receiver(), count()
    performer = Performer(load_table("arkit"))
    with OscMouth(receiver.address, performer, clock=lambda: next(times) / RATE):
        wait_for(lambda: len(receiver.of("/VMC/Ext/Blend/Apply")) > 5, "six frames")
    receiver.close()
    text = "\n".join(osc_line(1.0, address, *arguments) for address, arguments in receiver.messages)  # type: ignore[arg-type]
    track = parse_vmc(text, "a.osc")
    assert len(track.times) > 5
    assert np.diff(track.times)[:5] == pytest.approx(1 / RATE, abs=1e-5)
    assert "jawOpen" in track.channels


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "there is no blend shape of ARKit"),
        (osc_line(1, "/VMC/Ext/Blend/Apply"), "there is no blend shape of ARKit"),
        ("hello", "line 1: a message that oscdump wrote begins like"),
        (osc_line(1, "/VMC/Ext/Blend/Val", "jawOpen"), "line 1: a blend shape is like"),
        (osc_line(1, "/VMC/Ext/T", "soon"), "line 1: this must be a number"),
        (recorded_vmc([1.0], clock=True), "it needs two frames or more"),
        (recorded_vmc([1.0, 1.2], clock=True), "for 0.1 s at most, found 0.20 s without one"),
        (recorded_vmc([2.0, 1.9], clock=False), "the times of frames must not go back"),
    ],
)
def test_what_is_no_recording_of_a_face_is_refused_in_a_sentence(text: str, sentence: str) -> None:
    with pytest.raises(CorpusError, match=sentence.replace(".", r"\.")):
        parse_vmc(text, "a.osc")
