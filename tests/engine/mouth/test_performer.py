"""The performer: whoever asks it moves alike, and it does not matter how often anybody looks."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from phonemeengine.mouth.animation import Animation, animation_of
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.movestate import Mode
from phonemeengine.mouth.performer import CLOSE_AFTER, MOUTH_ALONE, FaceState, IdleMotion, Performer, TimedFrame
from phonemeengine.mouth.table import load_table
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import segments_of
from phonemeengine.settings import FRAME_PERIOD
from tests.engine.mouth.speaking import speech

ARKIT = load_table("arkit")
JAW = ARKIT.movestates.index("jawOpen")
RATE = 60.0
ENOUGH_AHEAD = 0.4
"""Seconds, within which it is decided what becomes of phonemes that are too short."""
Weights = NDArray[np.float32]


def said(utterance: Transcript) -> list[TimedFrame]:
    """The frames of what was said, whose time begins with the sound."""
    ends = np.array([run.end for run in utterance.runs]) - 1e-9
    columns = (utterance.times, utterance.intensities, utterance.pitches)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return [
        TimedFrame(time, utterance.runs[int(np.searchsorted(ends, time, "right"))].phoneme, loud, f0)
        for time, loud, f0 in rows
    ]


def babble(seed: int, seconds: float = 20.0) -> Transcript:
    """Speech of nobody: phonemes of 10 to 200 ms, any loudness and pitch; each begins on a frame."""
    generator, codes = np.random.default_rng(seed), [0] * 30
    while len(codes) < seconds / FRAME_PERIOD:
        codes += [int(generator.integers(0, 11))] * int(generator.integers(1, 20))
    loud = generator.random(len(codes), np.float32)
    f0 = generator.choice(np.array([0, 90, 130], np.float32), len(codes))
    runs = tuple(segments_of([(np.array(codes, np.uint8), loud)], len(codes) * FRAME_PERIOD))
    return Transcript("babble", len(codes) * FRAME_PERIOD, runs, loud, f0)


def film_of(utterance: Transcript, idle: IdleMotion | None = None) -> Animation:
    return animation_of(utterance, ARKIT, RATE, idle)


def played(
    performer: Performer, frames: Sequence[TimedFrame], ahead: float, *, start: float = 0.0, rate: float = RATE
) -> list[FaceState]:
    """Look at a performer that hears frames of 20 ms, each so many seconds before its time."""
    shown, waiting = [], list(frames)
    for k in range(round((frames[-1].time - start) * rate)):
        now = start + k / rate
        while waiting and waiting[0].time + FRAME_PERIOD <= now + ahead:
            performer.add(waiting[:2], now)
            del waiting[:2]
        shown.append(performer.at(now))
    return shown


def weights_of(faces: Sequence[FaceState]) -> Weights:
    return np.array([face.weights for face in faces])


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.long) for seed in range(1, 5))])
@pytest.mark.parametrize("detail", Detail)
def test_who_knows_all_beforehand_moves_as_the_film_does(seed: int, detail: Detail) -> None:
    utterance, idle = babble(seed), IdleMotion(seed=seed, detail=detail)
    film, performer = film_of(utterance, idle), Performer(ARKIT, idle, rate=RATE)
    frames = said(utterance)
    performer.add([*frames, frames[-1]._replace(time=utterance.duration, phoneme=Phoneme.SILENCE)])
    faces = [performer.at(time) for time in film.times.tolist()]
    lids = np.array([face.blink for face in faces], np.float32)
    shown = weights_of(faces)
    for name in ("eyeBlinkLeft", "eyeBlinkRight"):
        column = ARKIT.movestates.index(name)
        shown[:, column] = np.maximum(shown[:, column], lids)
    np.testing.assert_array_equal(shown, film.weights)
    heard = round(utterance.duration * RATE)
    np.testing.assert_array_equal(np.array([face.head for face in faces[:heard]], np.float32), film.head[:heard])
    assert lids.max() > 0.5


@pytest.mark.parametrize("clock", [0.0, 50_000.0])
def test_look_ahead_that_goes_along_with_the_sound_is_as_good_as_all_of_it(clock: float) -> None:
    utterance = speech()
    frames = [frame._replace(time=frame.time + clock) for frame in said(utterance)]
    shown = weights_of(played(Performer(ARKIT, MOUTH_ALONE, rate=RATE), frames, ENOUGH_AHEAD, start=clock))
    film = film_of(utterance, MOUTH_ALONE).weights[: len(shown)]
    np.testing.assert_allclose(shown, film, atol=1e-5)
    assert film[:, JAW].max() > 0.3


def test_most_of_fast_speech_is_cleaned_within_the_look_ahead() -> None:
    utterance = babble(7)
    shown = weights_of(played(Performer(ARKIT, MOUTH_ALONE, rate=RATE), said(utterance), ENOUGH_AHEAD))
    film = film_of(utterance, MOUTH_ALONE).weights[: len(shown)]
    apart = np.abs(shown - film).max(axis=1) > 0.1
    live = weights_of(played(Performer(ARKIT, MOUTH_ALONE), said(utterance), 0.0))
    assert apart.mean() < 0.2 * (np.abs(live - film).max(axis=1) > 0.1).mean()


@pytest.mark.parametrize("ahead", [0.0, 0.1, ENOUGH_AHEAD])
def test_it_does_not_matter_how_often_anybody_looks(ahead: float) -> None:
    """A look at each sixtieth of a second, or at each tenth of one as well; blocks come at the sixtieths."""

    def shown(looks: int) -> Weights:
        performer, waiting, found = Performer(ARKIT, MOUTH_ALONE), said(speech()), []
        for k in range(150):
            now = k / RATE
            due = [frame for frame in waiting if frame.time + FRAME_PERIOD <= now + ahead]
            performer.add(due, now)
            waiting = waiting[len(due) :]
            found.append(performer.at(now).weights)
            for look in range(1, looks):
                performer.at(now + look / looks / RATE)
        return np.array(found)

    np.testing.assert_array_equal(shown(1), shown(10))


def test_a_vowel_that_is_known_early_opens_the_mouth_early_and_a_live_one_when_it_is_heard() -> None:
    frames = [TimedFrame(k * FRAME_PERIOD, Phoneme.A if k >= 50 else Phoneme.SILENCE, 1.0) for k in range(100)]
    early, live = (weights_of(played(Performer(ARKIT, MOUTH_ALONE), frames, ahead))[:, JAW] for ahead in (0.2, 0.0))
    begun = [float(np.argmax(jaw > 0)) / RATE for jaw in (early, live)]
    assert begun[0] == pytest.approx(0.5 - ARKIT.movement.opened * ARKIT.times[Phoneme.A].to_shape, abs=1.5 / RATE)
    assert begun[1] == pytest.approx(0.5 + 0.02, abs=1.5 / RATE)


def saying_a(until: float, idle: IdleMotion = MOUTH_ALONE) -> Performer:
    """Somebody who says an a up to a time, and goes on with an u that is known already."""
    performer = Performer(ARKIT, idle)
    n = round(until / FRAME_PERIOD)
    frames = [TimedFrame(k * FRAME_PERIOD, Phoneme.A if k < n else Phoneme.U, 1.0) for k in range(2 * n)]
    performer.add(frames, 0.0)
    return performer


Act = Callable[[Performer], None]


@pytest.mark.parametrize(
    ("act", "opened"),
    [
        (lambda performer: performer.close_mouth(0.8), False),
        (lambda performer: performer.hold(0.8, Phoneme.A), True),
        (lambda performer: performer.forget_coming(0.8), True),
        (lambda performer: performer.jump_to([TimedFrame(0.7, Phoneme.SILENCE, 0.0)], 0.8), False),
    ],
    ids=["close", "hold", "forget", "jump"],
)
def test_what_was_known_of_the_future_does_not_come_after_it_was_stopped(act: Act, opened: bool) -> None:
    performer = saying_a(1.0)
    before = performer.at(0.8).weights
    act(performer)
    after = performer.at(3.0).weights
    assert before[JAW] > 0.2
    np.testing.assert_allclose(after, before if opened else ARKIT.weights()[Phoneme.SILENCE], atol=0.01)


@pytest.mark.parametrize("before", [0.0, 0.01, 0.06, 0.08])
def test_a_mouth_that_is_ahead_of_a_vowel_closes_when_it_is_stopped_before_that(before: float) -> None:
    performer = Performer(ARKIT, MOUTH_ALONE)
    performer.add([TimedFrame(k * FRAME_PERIOD, Phoneme.A if k >= 50 else Phoneme.SILENCE, 1.0) for k in range(99)])
    stopped = 0.5 - before
    assert performer.at(stopped).weights[JAW] > 0
    performer.hold(stopped, Phoneme.SILENCE)
    performer.close_mouth(stopped)
    np.testing.assert_allclose(performer.at(stopped + 0.5).weights, ARKIT.weights()[Phoneme.SILENCE], atol=1e-6)


def test_who_jumps_stands_as_somebody_who_has_said_what_comes_before() -> None:
    frames = said(speech())[:140]
    now = frames[-1].time + FRAME_PERIOD
    followed, jumped = Performer(ARKIT, MOUTH_ALONE), saying_a(0.5)
    followed.add(frames)
    jumped.at(0.4)
    jumped.jump_to(frames[-100:], now)
    spread = ARKIT.motion.randomness  # they vary shapes and times in their own ways
    np.testing.assert_allclose(jumped.at(now).weights, followed.at(now).weights, atol=3 * spread)


def test_a_live_mouth_closes_when_nothing_comes_any_more_and_another_one_waits() -> None:
    shut = {}
    for live in (True, False):
        performer = Performer(ARKIT, MOUTH_ALONE)
        for k in range(50):
            performer.add([TimedFrame(k * FRAME_PERIOD, Phoneme.A, 1.0)], (k + 1) * FRAME_PERIOD, live=live)
        assert performer.at(0.5 + 0.9 * CLOSE_AFTER).weights[JAW] > 0.2
        shut[live] = bool(performer.at(0.5 + CLOSE_AFTER + 1.0).weights[JAW] < 1e-6)
    assert shut == {True: True, False: False}


def test_another_table_goes_on_from_where_such_a_mouth_would_be() -> None:
    vrm = load_table("vrm")
    performer, other = saying_a(1.0), Performer(vrm, MOUTH_ALONE)
    other.add([TimedFrame(k * FRAME_PERIOD, Phoneme.A, 1.0) for k in range(80)])
    performer.at(0.79)
    performer.configure(vrm, MOUTH_ALONE)
    np.testing.assert_allclose(performer.at(0.79).weights, other.at(0.79).weights, atol=1e-6)


def test_what_is_asked_for_wins_and_is_said_until_it_is_asked_no_more() -> None:
    performer = saying_a(2.0)
    performer.at(0.5)
    assert performer.pop_said() == [(Phoneme.A, 1.0, ""), (Phoneme.A, 1.0, "")]
    performer.set_phonemes({Phoneme.U: 0.5, Phoneme.I: 0.25}, 0.0)
    rows = ARKIT.weights()
    np.testing.assert_allclose(performer.at(1.0).weights, 0.5 * rows[Phoneme.U] + 0.25 * rows[Phoneme.I], atol=1e-3)
    assert performer.pop_said() == [(Phoneme.U, 0.5, "")]
    performer.set_phonemes({}, 0.0)
    assert performer.at(1.5).weights[JAW] > 0.2
    assert performer.pop_said() == [(Phoneme.A, 1.0, "")]


def test_a_forced_shape_keeps_the_eyes_open() -> None:
    performer, free = saying_a(30.0, IdleMotion()), saying_a(30.0, IdleMotion())
    performer.visemes.set("u", 1.0, Mode.FORCE_RESET)
    times = np.arange(0.5, 20.0, 1 / RATE).tolist()
    assert max(performer.at(time).blink for time in times) < 0.01
    assert max(free.at(time).blink for time in times) > 0.9


class Nodding:
    """A track that opens the jaw to the clock's tenths, shifts the shoulders, and may turn the head."""

    movestates = ("shoulderShiftLeft", *reversed(ARKIT.movestates))

    def __init__(self, *, turns: bool) -> None:
        self._turns = turns

    def weights(self, time: float) -> Weights:
        weights = np.zeros(len(self.movestates), np.float32)
        weights[0], weights[self.movestates.index("jawOpen")] = 1.0, time / 10
        return weights

    def head(self, time: float) -> HeadPose | None:
        return HeadPose(0.0, -time, 0.0) if self._turns else None


def test_a_track_turns_the_head_and_moves_what_the_table_names() -> None:
    performer = Performer(ARKIT)
    performer.play(Nodding(turns=True), start=1.0)
    face = performer.at(3.0)
    assert face.weights[JAW] == pytest.approx(0.2)
    assert np.count_nonzero(face.weights) == 1
    assert face.head == HeadPose(0.0, -2.0, 0.0)
    extended = replace(ARKIT, movestates=(*ARKIT.movestates, "shoulderShiftLeft"))
    performer.configure(extended, IdleMotion(head=False))
    face = performer.at(3.0)
    assert (face.weights[JAW], face.weights[-1]) == pytest.approx((0.2, 1.0))
    assert face.head == HeadPose()


def test_a_head_that_a_track_leaves_alone_goes_with_what_is_heard() -> None:
    performer, other = Performer(ARKIT), Performer(ARKIT)
    performer.play(Nodding(turns=False))
    for each in (performer, other):
        each.add([TimedFrame(0.0, Phoneme.A, 1.0, 120.0)])
    assert performer.at(0.5).head == other.at(0.5).head != HeadPose()
    performer.play(None)
    assert performer.at(0.5).weights == pytest.approx(other.at(0.5).weights)


def test_a_table_with_movestates_that_a_track_lacks_goes_on_by_what_is_heard() -> None:
    performer = Performer(load_table("vrm"))
    performer.play(Nodding(turns=True))
    assert not performer.at(3.0).weights.any()
