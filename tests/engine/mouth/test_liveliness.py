"""Blinks and the movements of the head: like a person's, and the same however often anybody looks."""

import numpy as np
import pytest

from phonemeengine.mouth.idle_motion import CLOSING, FOLLOWING, OPENING, Blinker, HeadMotion
from phonemeengine.mouth.style_numbers import GestureNumbers

GESTURES = GestureNumbers()


def closures(rate: float, seconds: float, seed: int = 0) -> np.ndarray:
    blinker = Blinker(seed)
    return np.array([blinker.closure(k / rate) for k in range(round(seconds * rate))])


def blinks_of(closure: np.ndarray) -> np.ndarray:
    return np.flatnonzero(np.diff((closure > 0.5).astype(int)) == 1)


@pytest.mark.parametrize("seed", range(5))
def test_people_blink_ten_to_twenty_five_times_a_minute(seed: int) -> None:
    n = len(blinks_of(closures(50, 1200, seed)))
    assert 10 <= n / 20 <= 25


def test_blinks_come_at_irregular_times() -> None:
    pauses = np.diff(blinks_of(closures(100, 600))) / 100
    assert pauses.std() > 0.8
    assert pauses.max() < 12
    assert pauses.min() > CLOSING + OPENING - 0.02


def test_lids_close_fully_and_faster_than_they_open() -> None:
    closure = closures(1000, 30)
    assert closure.max() > 0.999
    assert closure.min() == 0
    first = np.flatnonzero(closure)
    whole = first[: np.flatnonzero(np.diff(first) > 1)[0] + 1]
    top = closure[whole].argmax()
    assert top / 1000 == pytest.approx(CLOSING, abs=0.003)
    assert (len(whole) - top) / 1000 == pytest.approx(OPENING, abs=0.003)


def test_blinks_do_not_depend_on_how_often_anybody_looks() -> None:
    np.testing.assert_allclose(closures(30, 60), closures(240, 60)[::8], atol=1e-9)


def test_two_people_do_not_blink_together() -> None:
    assert set(blinks_of(closures(100, 60, 1))) != set(blinks_of(closures(100, 60, 2)))


def pose_after(voice: tuple[float, float], before: tuple[float, float], time: float = 30.0) -> tuple[float, ...]:
    """Give the pose half a second after the voice changed from `before` (intensity, pitch) to `voice`."""
    motion = HeadMotion(seed=5)
    for k in range(round(time * 100)):
        motion.add(k / 100, *before)
    for k in range(50):
        motion.add(time + k / 100, *voice)
    pose = motion.pose(time + 0.5)
    return pose.yaw, pose.pitch, pose.roll


def test_the_head_rises_with_the_pitch() -> None:
    level, raised = pose_after((0.5, 120.0), (0.5, 120.0)), pose_after((0.5, 160.0), (0.5, 120.0))
    semitones = 12 * np.log2(160 / 120)
    assert raised[1] - level[1] == pytest.approx(GESTURES.rise * semitones, rel=0.25)
    assert raised[::2] == level[::2]


def test_the_head_sinks_with_the_loudness() -> None:
    soft, loud = pose_after((0.2, 0.0), (0.2, 0.0)), pose_after((1.0, 0.0), (0.2, 0.0))
    followed = 1 - np.exp(-0.5 / FOLLOWING)
    assert loud[1] - soft[1] == pytest.approx(-GESTURES.nod * 0.8 * followed, rel=0.02)


def test_the_head_never_turns_far_and_never_jumps() -> None:
    generator, motion, poses = np.random.default_rng(0), HeadMotion(1), []
    for k in range(60_00):
        motion.add(k / 100, float(generator.random()), float(generator.choice([0, 80, 400])))
        pose = motion.pose(k / 100)
        poses.append((pose.yaw, pose.pitch, pose.roll))
    found = np.array(poses)
    assert np.abs(found).max() < 8
    assert np.abs(np.diff(found, axis=0)).max() < 1.0
    assert found[:, 0].std() > 0.2


def test_the_pose_does_not_depend_on_how_often_anybody_looks() -> None:
    shown = []
    for every in (1, 7):
        motion, found = HeadMotion(2), []
        for k in range(700):
            motion.add(k / 100, k % 50 / 50, 100 + k % 30)
            if k % every == 0:
                found.append(motion.pose(k / 100).pitch)
        shown.append(found[:: 7 // every])
    assert shown[0] == pytest.approx(shown[1])
