"""The morpher: smooth, on time, and the same however often anybody looks."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from phonemeengine.errors import MouthError
from phonemeengine.mouth.animation import animation_of
from phonemeengine.mouth.morpher import HALF_OPEN, Detail, Morpher
from phonemeengine.mouth.table import (
    SPEAKING,
    MotionSettings,
    MouthTable,
    TransitionTimes,
    load_table,
    shipped_tables,
)
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment

MACHINE = MotionSettings(randomness=0, loudness=0)
"""A manner in which everything is known beforehand."""
TABLE = replace(load_table("vrm"), motion=MACHINE)
ARKIT = load_table("arkit")
EXACT = 1e-3
"""Seconds between two looks where a time is measured."""
SILENCE, A, E, M, P, U = Phoneme.SILENCE, Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.P, Phoneme.U
Heard = list[tuple[float, Phoneme, float]]


def mouth_of(table: MouthTable, heard: Heard, times: NDArray[np.float64], **options: object) -> NDArray[np.float32]:
    """Look at a mouth at times while it hears what it hears."""
    morpher, found, waiting = Morpher(table, **options), [], list(heard)
    for time in times:
        while waiting and waiting[0][0] <= time + 1e-9:
            morpher.add(*waiting.pop(0))
        found.append(morpher.weights(time))
    return np.array(found)


def babble(seconds: float, every: float = 0.01, seed: int = 0) -> Heard:
    """Speech of nobody: a frame every 10 ms, phonemes of 10 to 200 ms, any loudness."""
    generator = np.random.default_rng(seed)
    codes: list[int] = []
    while len(codes) * every < seconds:
        codes += [int(generator.integers(0, 11))] * int(generator.integers(1, 20))
    loud = np.clip(np.cumsum(generator.normal(0, 0.1, len(codes))) + 0.5, 0, 1)
    return [(k * every, Phoneme(code), float(loud[k])) for k, code in enumerate(codes)]


def way_gone(found: NDArray[np.float32], start: NDArray[np.float32], end: NDArray[np.float32]) -> NDArray[np.float32]:
    """How much of its way from one shape to another a mouth has gone, 0..1."""
    way = end - start
    return (found - start) @ way / (way @ way)


def nine_tenths(table: MouthTable, heard: Heard) -> float:
    """Seconds until a mouth has gone nine tenths of the way to the last of what it hears, from the one before."""
    (_, before, _), (start, last, _) = heard[-2:]
    since = np.arange(0, 0.4, EXACT)
    rows = table.weights()
    gone = way_gone(mouth_of(table, heard, start + since), rows[before], rows[last])
    return float(since[np.argmax(gone >= 0.9)])


def test_the_mouth_opens_along_half_a_cosine() -> None:
    times = np.linspace(0, 0.2, 201)
    found = mouth_of(TABLE, [(0.0, A, 1.0)], times)
    expected = 0.5 - 0.5 * np.cos(math.pi * np.minimum(times / TABLE.times[A].to_shape, 1))
    np.testing.assert_allclose(found[:, TABLE.movestates.index("A")], expected, atol=1e-6)
    assert (found[:, 1:] == 0).all()


@pytest.mark.parametrize("phoneme", SPEAKING, ids=lambda p: p.label)
@pytest.mark.parametrize("name", [name for name in shipped_tables() if load_table(name).movestates])
def test_a_mouth_has_gone_nine_tenths_of_its_way_when_attack_and_release_say(name: str, phoneme: Phoneme) -> None:
    table = replace(load_table(name), motion=MACHINE)
    rows = table.weights()
    times = table.times[phoneme]
    before = next(p for p in (SILENCE, A) if not np.array_equal(rows[p], rows[phoneme]))
    reached = nine_tenths(table, [(0.0, before, 1.0), (1.0, phoneme, 1.0)])
    assert reached == pytest.approx(times.attack, abs=1.5 * EXACT)
    if not np.array_equal(rows[SILENCE], rows[phoneme]):
        left = nine_tenths(table, [(0.0, phoneme, 1.0), (1.0, SILENCE, 1.0)])
        assert left == pytest.approx(times.release, abs=1.5 * EXACT)


@pytest.mark.parametrize("name", shipped_tables())
def test_lips_meet_faster_than_an_a_opens_and_silence_closes_the_slowest(name: str) -> None:
    times = load_table(name).times
    assert 0.04 <= times[P].attack <= times[M].attack <= 0.06
    vowels = [times[p] for p in (Phoneme.I, A, E, U, Phoneme.O)]
    assert all(0.08 <= vowel.attack <= 0.12 for vowel in vowels)
    assert all(0.15 <= each.release <= 0.2 for each in times.values())
    assert min(each.release for each in times.values()) > max(each.attack for each in times.values())


def test_an_m_is_closed_before_an_a_is_open() -> None:
    table = replace(ARKIT, motion=MACHINE)
    closing = nine_tenths(table, [(0.0, A, 1.0), (1.0, M, 1.0)])
    assert closing < 0.6 * nine_tenths(table, [(0.0, M, 1.0), (1.0, A, 1.0)])


def test_an_animation_moves_as_fast_as_its_table_says() -> None:
    slow = replace(TABLE, times={**TABLE.times, A: TransitionTimes(0.4, 0.16)})
    speech = Transcript(
        "",
        2.0,
        (Segment(0, 1, SILENCE, 0.0), Segment(1, 2, A, 1.0)),
        np.ones(200, np.float32),
        np.zeros(200, np.float32),
    )
    opened = {}
    for table in (TABLE, slow):
        animation = animation_of(speech, table, 240, anticipation=0)
        opened[table.times[A].attack] = float(animation.times[np.argmax(animation.weights[:, 0] >= 0.9)]) - 1
    assert opened == {attack: pytest.approx(attack, abs=1 / 120) for attack in (0.1, 0.4)}


def test_half_of_a_short_vowel_is_seen_by_its_middle() -> None:
    """After m the mouth has some 20 ms before the vowel is heard: more would open the lips of the m."""
    found = mouth_of(replace(ARKIT, motion=MACHINE), [(0.0, M, 1.0), (0.48, A, 1.0)], np.array([0.46, 0.5, 0.55]))
    jaw = found[:, ARKIT.movestates.index("jawOpen")] / ARKIT.weights()[A, ARKIT.movestates.index("jawOpen")]
    assert jaw[0] == 0
    assert jaw[1] < 0.1
    assert jaw[2] > 0.5


def test_silence_has_priority_over_all_that_goes_on() -> None:
    heard = [(0.01 * k, (A, E, U)[k % 3], 1.0) for k in range(100)] + [(1.0, SILENCE, 1.0)]
    slowest = max(times.to_rest for times in ARKIT.times.values())
    for detail in Detail:
        found = mouth_of(ARKIT, heard, np.array([1.0, 1.0 + slowest, 3.0]), detail=detail, seed=3)
        assert found[0].max() > 0.2
        np.testing.assert_allclose(found[1], ARKIT.weights()[SILENCE], atol=1e-6)
        np.testing.assert_allclose(found[2], ARKIT.weights()[SILENCE], atol=1e-6)


def test_loudness_opens_the_mouth_and_lips_meet_at_any_loudness() -> None:
    times = np.array([1.0])
    quiet, half, loud = (mouth_of(TABLE, [(0.0, A, x)], times)[0, 0] for x in (0.0, 0.5, 1.0))
    assert (quiet, half, loud) == pytest.approx((0.4, 0.7, 1.0), abs=1e-6)
    rows = ARKIT.weights()
    for phoneme in (M, P):
        np.testing.assert_allclose(mouth_of(ARKIT, [(0.0, phoneme, 0.0)], times)[0], rows[phoneme], atol=1e-6)


@pytest.mark.parametrize("seed", range(2))
def test_it_does_not_matter_how_often_anybody_looks(seed: int) -> None:
    """At the instants that 30, 60 and 144 pictures a second share, all show the same; sixths of a second."""
    heard = babble(6.0, seed=seed)
    shown = {}
    for rate in (6, 30, 60, 144):
        times = np.arange(6 * rate + 1) / rate
        shown[rate] = mouth_of(ARKIT, heard, times, seed=seed)[:: rate // 6]
    for rate in (6, 30, 60):
        assert np.abs(shown[rate] - shown[144]).max() < 0.01 * shown[144].max()


def test_neither_place_nor_speed_jumps_however_fast_phonemes_come() -> None:
    """A change of phoneme every 10 ms, looked at every millisecond."""
    heard = [(0.01 * k, Phoneme(k * 7 % 11), 0.8) for k in range(200)]
    table = replace(ARKIT, motion=MotionSettings(randomness=0.2))
    step = 0.001
    found = mouth_of(table, heard, np.arange(0, 2, step), seed=1).astype(float)
    speed = np.diff(found, axis=0) / step
    fastest = math.pi / 2 / table.times[P].to_shape  # of half a cosine, in the middle
    assert np.abs(speed).max() < 1.3 * fastest
    assert np.abs(np.diff(speed, axis=0)).max() < 0.15 * fastest


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 1000), st.floats(0, 0.5), st.sampled_from(list(Detail)))
def test_no_weight_leaves_the_range_of_the_shapes(seed: int, randomness: float, detail: Detail) -> None:
    table = replace(ARKIT, motion=MotionSettings(randomness=randomness))
    found = mouth_of(table, babble(2.0, seed=seed), np.arange(0, 2, 0.007), detail=detail, seed=seed)
    rows = table.weights()
    assert (found <= rows.max(axis=0) + 1e-6).all()
    assert (found >= min(0, rows.min()) - 1e-6).all()


def test_no_two_mouths_are_alike_and_one_is_like_itself() -> None:
    heard, times = babble(2.0), np.arange(0, 2, 0.02)
    one, again, other = (mouth_of(ARKIT, heard, times, seed=seed) for seed in (1, 1, 2))
    assert (one == again).all()
    assert np.abs(one - other).max() > 0.02
    still = replace(ARKIT, motion=replace(ARKIT.motion, randomness=0))
    assert (mouth_of(still, heard, times, seed=1) == mouth_of(still, heard, times, seed=2)).all()


def test_a_phoneme_is_not_said_twice_in_the_same_way() -> None:
    heard = [(0.5 * k, A if k % 2 else SILENCE, 1.0) for k in range(12)]
    table = replace(TABLE, motion=MotionSettings(randomness=0.1))
    widths = mouth_of(table, heard, np.arange(0.9, 5.9, 1.0))[:, 0]
    assert len(set(widths.tolist())) == len(widths)
    assert widths.min() > 0.7


def test_a_far_mouth_follows_the_loudness_alone() -> None:
    times = np.array([1.0])
    for phoneme in (A, E, U, M):
        found = mouth_of(TABLE, [(0.0, phoneme, 0.6)], times, detail=Detail.LOUDNESS)[0]
        np.testing.assert_allclose(found, TABLE.weights()[A] * 0.6, atol=1e-6)


def test_a_mouth_of_two_states_is_open_or_shut() -> None:
    times = np.array([1.0])
    for phoneme, share in ((A, HALF_OPEN), (U, HALF_OPEN), (M, 0), (P, 0), (SILENCE, 0)):
        for intensity in (0.1, 1.0):
            found = mouth_of(TABLE, [(0.0, phoneme, intensity)], times, detail=Detail.TWO_STATES)[0]
            np.testing.assert_allclose(found, TABLE.weights()[A] * share, atol=1e-6)


def test_old_movements_are_forgotten() -> None:
    morpher = Morpher(ARKIT)
    for k, (_, phoneme, intensity) in enumerate(babble(60.0)):
        morpher.add(k / 100, phoneme, intensity)
        morpher.weights(k / 100)
    assert len(morpher._movements) < 30


@pytest.mark.parametrize(
    ("name", "value", "limits"), [("minimum_opening", -1, "0..1"), ("randomness", math.nan, "0..0.5")]
)
def test_an_impossible_manner_is_refused(name: str, value: float, limits: str) -> None:
    with pytest.raises(MouthError, match=rf"{name} must lie in {limits}, got {value:g}; choose another value"):
        MotionSettings(**{name: value})


@pytest.mark.parametrize(
    ("attack", "release", "name"), [(0, 0.1, "attack"), (0.1, 2, "release"), (math.nan, 1, "attack")]
)
def test_impossible_times_are_refused(attack: float, release: float, name: str) -> None:
    with pytest.raises(MouthError, match=rf"{name} must lie in 0.005..1 s"):
        TransitionTimes(attack, release)


def test_times_that_are_scaled_keep_within_their_limits() -> None:
    scaled = TABLE.with_motion(2, 0.5, random=True).times
    for phoneme, times in TABLE.times.items():
        assert (scaled[phoneme].attack, scaled[phoneme].release) == pytest.approx(
            (2 * times.attack, times.release / 2)
        )
    assert TABLE.with_motion(1e-3, 1e3, random=True).times[A] == TransitionTimes(0.005, 1.0)
