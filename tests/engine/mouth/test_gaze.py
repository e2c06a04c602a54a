"""Where eyes look: at the camera mostly, aside now and then, and steadily while the head turns."""

import numpy as np
import pytest

from phonemeengine import load_head
from phonemeengine.mouth.idle_motion import (
    EYES,
    FARTHEST,
    HIGH,
    SIDEWAYS,
    WIDE,
    Gaze,
    GazeDirection,
    HeadPose,
    gaze_weights,
)

TIMES = np.arange(0, 120, 0.01)


@pytest.mark.parametrize("seed", range(3))
def test_eyes_rest_on_the_camera_and_jump_aside_now_and_then(seed: int) -> None:
    gaze = Gaze(seed)
    seen = np.array([gaze.at(time) for time in TIMES.tolist()])
    ahead = (seen == 0).all(axis=1)
    assert 0.4 < ahead.mean() < 0.9
    assert np.abs(seen[:, 0]).max() <= WIDE
    assert np.abs(seen[:, 1]).max() <= HIGH
    moving = np.abs(np.diff(seen, axis=0)).max(axis=1) > 0
    assert 0.005 < moving.mean() < 0.1  # jumps are short
    jumps = np.flatnonzero(np.diff(moving.astype(int)) == 1)
    assert 10 < len(jumps) < 120


def test_equal_seeds_look_alike_however_often_one_asks() -> None:
    often, seldom = Gaze(7), Gaze(7)
    for time in TIMES[:3000].tolist():
        often.at(time)
    assert often.at(30.0) == seldom.at(30.0)
    assert Gaze(8).at(30.0) != GazeDirection(99, 99)


def test_eyes_stay_on_what_they_look_at_while_the_head_turns() -> None:
    weights = gaze_weights(GazeDirection(), HeadPose(yaw=6.5))
    assert weights["eyeLookInLeft"] == weights["eyeLookOutRight"] == pytest.approx(6.5 / SIDEWAYS)
    assert weights["eyeLookOutLeft"] == weights["eyeLookInRight"] == 0
    assert gaze_weights(GazeDirection(0, 5))["eyeLookUpLeft"] > 0
    assert gaze_weights(GazeDirection(0, -5))["eyeLookDownRight"] > 0
    assert max(gaze_weights(GazeDirection(90, 90)).values()) == 1.0
    assert gaze_weights(GazeDirection(90, 0))["eyeLookOutLeft"] == pytest.approx(FARTHEST / SIDEWAYS)


def test_the_head_has_the_movestates_and_they_turn_the_eyes_that_way() -> None:
    head = load_head()
    states = {state.name: state for state in head.states}
    assert set(EYES) <= set(states)
    assert list(gaze_weights(GazeDirection())) == [name for name in gaze_weights(GazeDirection()) if name in EYES]
