"""The pinyin mouth: on its shapes on time, between them meanwhile, and shown as any face is."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.performer import MOUTH_ALONE, Performer
from phonemeengine.mouth.table import load_table
from phonemeengine.phonemes import Phoneme
from phonemeengine.speech.pinyin.script import WrittenMark, WrittenSyllable
from phonemeengine.speech.pinyin.spring import LONGEST_JUMP, Spring
from phonemeengine.speech.pinyin.table import PinyinTable
from phonemeengine.speech.pinyin.timing import AFTERWARDS, PinyinMouth, Plan, plan_of
from tests.engine.speech.pinyin.saying import SAID, SCRIPT, TABLE, plan_at_rate

ROWS = TABLE.weights()
SPRUNG = replace(TABLE, spring=Spring())
PLAN = plan_at_rate(SCRIPT, TABLE)
SOUNDS = st.lists(
    st.sampled_from(["ma1", "lü4", "zhuang4", "er2", "m2", "fo2", "ji1", "wu3", "ke4", "。", "、"]),
    min_size=1,
    max_size=8,
).filter(lambda sounds: any(sound not in TABLE.marks for sound in sounds))


def planned(sounds: list[str], rate: float = 4.0) -> Plan:
    script = [
        WrittenMark(sound, TABLE.marks[sound]) if sound in TABLE.marks else WrittenSyllable("字", sound)
        for sound in sounds
    ]
    return plan_at_rate(script, TABLE, rate)


def seen(plan: Plan, table: PinyinTable, times: NDArray[np.float64]) -> NDArray[np.float32]:
    mouth = PinyinMouth(plan, table)
    return np.array([mouth.weights(time) for time in times.tolist()])


@given(sounds=SOUNDS, rate=st.floats(0.5, 10), reach=st.floats(0.05, 1))
def test_at_its_turn_a_syllable_has_its_onset_s_shape_and_at_its_end_its_rime_s(
    sounds: list[str], rate: float, reach: float
) -> None:
    plan = planned(sounds, rate)
    mouth = PinyinMouth(plan, replace(TABLE, reach=reach))
    for row in plan.rows:
        if row.kind == "syllable":
            np.testing.assert_array_equal(mouth.weights(row.turn), ROWS[row.shapes[0]])
        np.testing.assert_array_equal(mouth.weights(row.end), ROWS[row.shapes[-1]])


@pytest.mark.parametrize("reach", [0.25, 0.5, 1.0])
def test_at_half_of_a_movement_the_weights_are_the_mean_of_both_shapes(reach: float) -> None:
    mouth = PinyinMouth(PLAN, replace(TABLE, reach=reach))
    ni = PLAN.rows[0]
    half = reach / 2
    to_onset, to_rime = half * (ni.turn - ni.start), ni.turn + half * (ni.end - ni.turn)
    np.testing.assert_allclose(mouth.weights(to_onset), (ROWS["&"] + ROWS["d"]) / 2, atol=1e-6)
    np.testing.assert_allclose(mouth.weights(to_rime), (ROWS["d"] + ROWS["i"]) / 2, atol=1e-6)


def test_the_movement_takes_the_share_of_its_part_that_is_called_reach_and_holds_the_shape_for_the_rest() -> None:
    part = np.linspace(0.075, 0.25, 101)
    found = seen(PLAN, TABLE, part)
    gone = (found - ROWS["d"]) @ (ROWS["i"] - ROWS["d"]) / np.sum((ROWS["i"] - ROWS["d"]) ** 2)
    progress = np.minimum(np.linspace(0, 2, 101), 1)
    np.testing.assert_allclose(gone, (1 - np.cos(np.pi * progress)) / 2, atol=1e-5)


@given(sounds=SOUNDS, spring=st.booleans())
def test_weights_never_leave_the_range_of_the_shapes_between_which_they_move(sounds: list[str], spring: bool) -> None:
    plan, table = planned(sounds), SPRUNG if spring else TABLE
    times = np.arange(0, plan.duration + AFTERWARDS, 0.007)
    found = seen(plan, table, times)
    for row, before in zip(plan.rows, [None, *plan.rows], strict=False):
        within = (times >= row.start) & (times <= row.end)
        names = list(TABLE.mouth.shapes) if spring else [*row.shapes, before.shapes[-1] if before else "&"]
        shapes = np.array([ROWS[name] for name in names])
        assert (found[within] >= shapes.min(axis=0) - 1e-6).all()
        assert (found[within] <= shapes.max(axis=0) + 1e-6).all()


def test_before_the_first_syllable_in_pauses_and_after_the_last_one_the_mouth_is_at_rest() -> None:
    mouth = PinyinMouth(plan_of(SAID, TABLE), TABLE)
    for time in (-1.0, 0.0, 0.1, 0.94, 1.5, 9.0):
        np.testing.assert_array_equal(mouth.weights(time), ROWS["&"])
    unfinished = planned(["ma1"])
    np.testing.assert_array_equal(PinyinMouth(unfinished, TABLE).weights(0.25), ROWS["a"])
    np.testing.assert_array_equal(PinyinMouth(unfinished, TABLE).weights(0.25 + AFTERWARDS), ROWS["&"])


def test_in_a_long_silence_the_mouth_closes_no_slower_than_at_a_full_stop() -> None:
    mouth = PinyinMouth(plan_of(replace(SAID, duration=60.0), TABLE), TABLE)
    np.testing.assert_array_equal(mouth.weights(1.15 + 0.3), ROWS["&"])
    assert not np.array_equal(mouth.weights(1.15 + 0.29), ROWS["&"])


def test_it_does_not_matter_in_which_order_anybody_looks() -> None:
    times = np.linspace(0, 2, 97)
    np.testing.assert_array_equal(seen(PLAN, TABLE, times)[::-1], seen(PLAN, TABLE, times[::-1]))


@pytest.mark.parametrize("spring", [Spring(), Spring(damping=10)])
def test_a_spring_goes_the_same_way_however_often_anybody_looks(spring: Spring) -> None:
    table, often = replace(TABLE, spring=spring), np.arange(0, 2, 1 / 1000)
    np.testing.assert_array_equal(seen(PLAN, table, often)[::250], seen(PLAN, table, often[::250]))


def test_a_spring_at_rest_begins_as_newton_says() -> None:
    """One step of symplectic Euler from rest: the velocity is k d dt, and the way k d dt²."""
    mouth = PinyinMouth(PLAN, SPRUNG)
    way = ROWS["d"] - ROWS["&"]
    np.testing.assert_allclose(mouth.weights(1 / 240) - ROWS["&"], 900 / 240**2 * way, atol=1e-6)


def test_a_spring_that_is_damped_critically_comes_to_rest_on_its_target_without_overshoot() -> None:
    jaw = ARKIT.index("jawOpen")
    held = planned(["ma1"], rate=0.5)
    opening = seen(held, SPRUNG, np.linspace(held.rows[0].turn, held.duration, 500))[:, jaw]
    assert (np.diff(opening) >= -1e-6).all()
    assert opening[-1] == pytest.approx(ROWS["a"][jaw], abs=1e-4)
    swinging = replace(TABLE, spring=Spring(damping=10))
    assert seen(held, swinging, np.linspace(held.rows[0].turn, held.duration, 500))[:, jaw].max() > 0.7


@pytest.mark.parametrize("time", [0.2, 0.6, 0.2 + 1.5 * LONGEST_JUMP])
def test_a_seek_puts_the_mass_at_rest_on_its_target(time: float) -> None:
    plan = planned(["ma1", "hao3", "di4"], rate=1.0)
    mouth = PinyinMouth(plan, SPRUNG)
    mouth.weights(2.9 if time < 1 else 0.35)
    target = PinyinMouth(plan, replace(TABLE, reach=0.05)).weights(time)
    np.testing.assert_array_equal(mouth.weights(time), target)


@pytest.mark.parametrize(
    ("numbers", "words"),
    [
        ((0, 900, 60), "the mass of a spring must be a number above 0"),
        ((1, float("nan"), 60), "the stiffness"),
        ((1, 900, -1), "the damping"),
        ((1, 1e6, 60), "swings ever farther"),
        ((0.01, 900, 60), "swings ever farther"),
    ],
)
def test_an_impossible_spring_is_refused(numbers: tuple[float, float, float], words: str) -> None:
    with pytest.raises(MouthError, match=words):
        Spring(*numbers)


@given(stiffness=st.floats(1, 60_000), damping=st.floats(0.1, 240))
def test_a_spring_that_is_not_refused_stays_near_its_shapes(stiffness: float, damping: float) -> None:
    try:
        spring = Spring(1.0, stiffness, damping)
    except MouthError:
        return
    found = seen(planned(["ma1", "wu3"]), replace(TABLE, spring=spring), np.arange(0, 0.8, 1 / 60))
    assert np.isfinite(found).all()


def test_a_performer_plays_it_from_any_time_and_then_goes_on_by_what_it_hears() -> None:
    performer = Performer(TABLE.mouth, MOUTH_ALONE)
    performer.play(PinyinMouth(PLAN, TABLE), start=10.0)
    np.testing.assert_array_equal(performer.at(10.25).weights, ROWS["i"])
    assert performer.at(10.26).table is TABLE.mouth
    performer.play(None)
    np.testing.assert_array_equal(performer.at(11.0).weights, load_table("arkit").weights()[Phoneme.SILENCE])


def test_a_table_of_other_movestates_goes_on_by_what_is_heard() -> None:
    performer = Performer(load_table("vrm"), MOUTH_ALONE)
    performer.play(PinyinMouth(PLAN, TABLE))
    assert performer.at(0.25).weights.tolist() == [0.0] * 5
    performer.configure(TABLE.mouth, MOUTH_ALONE)
    np.testing.assert_array_equal(performer.at(0.25).weights, ROWS["i"])
