"""The listener when something goes wrong: it says so, tries again, counts what it missed, and never hangs."""

import threading

import numpy as np
import pytest

from phonemeengine.audio.stream import STALLED, InputChoice
from phonemeengine.live.listener import Status
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.fakes.microphones import REFUSAL, HandDrivenMicrophone, Hear, frames_in, offline
from tests.fakes.players import SPEECH, agree, frames_of
from tests.waiting import Clock, wait_for

N = 50 * HOP
"""Samples of half a second."""
N_FRAMES = frames_in(N)


def test_a_microphone_that_is_missing_is_said_and_tried_until_it_is_there(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(None, None, None, microphone)
    microphone.give(SPEECH[:N])
    hearing.wait(N_FRAMES)
    assert len(hearing.openers.asked) == 4
    assert hearing.listener.status == Status(listening=True, words="moved by hand")
    assert hearing.listener.lost_seconds == 0  # it began to listen when the first sound came
    assert frames_of(hearing.taken)[0] == 0


def test_the_status_says_why_nothing_is_heard(hear: Hear) -> None:
    hearing = hear()
    hearing.wait_words(f"{REFUSAL}; trying again every 2 s")
    assert not hearing.listener.status.listening
    assert (hearing.listener.rate, hearing.listener.n_channels, hearing.listener.seconds) == (0, 0, 0)


def test_another_choice_is_tried_at_once_and_a_slider_that_moves_tries_for_none(hear: Hear) -> None:
    hearing = hear(None, retry_period=1000.0)
    hearing.wait_words(REFUSAL)
    for _ in range(50):
        hearing.listener.set_preset(hearing.listener.preset)
    hearing.openers.waiting.append(HandDrivenMicrophone(name="the other"))
    hearing.listener.choose(InputChoice("the other"))
    hearing.wait_words("the other")
    assert [choice.label for choice in hearing.openers.asked] == ["", "the other"]


def test_a_microphone_from_which_nothing_comes_is_never_said_to_be_heard(hear: Hear, clock: Clock) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, clock=clock)
    hearing.wait_words("waiting for a signal from moved by hand")
    assert not hearing.listener.status.listening
    microphone.give(SPEECH[:N])
    hearing.wait(N_FRAMES)
    assert hearing.listener.status.listening
    clock.now += 0.6
    assert hearing.listener.status == Status(
        listening=False,
        words="no signal from moved by hand for 1 s; trying again every 2 s",
        trouble="no signal from moved by hand; trying again every 2 s",
    )
    clock.now += 5.0
    assert hearing.listener.status.trouble == "no signal from moved by hand; trying again every 2 s"


@pytest.mark.parametrize(("how", "value"), [("lost", True), ("quiet", STALLED + 0.1)])
def test_a_microphone_that_goes_is_let_go_and_the_frames_number_on_by_the_clock(
    hear: Hear, clock: Clock, how: str, value: float
) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(name="the same again")
    hearing = hear(first, pitch=True, clock=clock)
    first.give(SPEECH[:N], N)  # at once, so that it began half a second ago
    hearing.wait(N_FRAMES)
    setattr(first, how, value)
    hearing.wait_words(REFUSAL)
    assert first.closed.wait(60)
    assert not hearing.listener.status.listening
    clock.now += 3.0
    assert hearing.listener.lost_seconds == pytest.approx(3.0)
    assert hearing.listener.seconds == pytest.approx(N_FRAMES / 100)
    hearing.openers.waiting.append(second)
    hearing.listener._pause.set()
    hearing.wait_words("waiting for a signal from the same again")
    second.give(SPEECH[:N], HOP)
    hearing.wait(2 * N_FRAMES)
    gap = 50 + 300 - 1 - N_FRAMES  # its first block of 10 ms began 10 ms before it came
    assert frames_of(hearing.taken)[N_FRAMES:] == list(range(N_FRAMES + gap, 2 * N_FRAMES + gap))
    assert hearing.listener.lost_seconds == pytest.approx(3.0 - 0.01)
    later = [analysis for analysis in hearing.taken if analysis.start >= N_FRAMES]
    agree(later, offline(SPEECH[:N]))


def test_sound_that_came_before_the_microphone_went_is_still_heard(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    microphone.give(SPEECH[:N])
    microphone.lost = True
    hearing = hear(microphone)
    hearing.wait(N_FRAMES)
    hearing.wait_words(REFUSAL)
    assert microphone.closed.is_set()


def test_what_the_device_loses_is_counted_over_all_devices(hear: Hear, clock: Clock) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(48_000)
    hearing = hear(first, clock=clock)
    first.give(SPEECH[:N])
    hearing.wait(N_FRAMES)
    first.n_lost = 4410
    assert hearing.listener.lost_seconds == pytest.approx(0.1)
    hearing.openers.waiting.append(second)
    hearing.listener.choose(InputChoice("another"))
    assert first.closed.wait(60)
    clock.now += 5.0
    hearing.wait_words("waiting for a signal")
    second.give(SPEECH[:480], 480)
    wait_for(lambda: hearing.listener.rate == 48_000, "the second")
    second.n_lost = 9600
    assert hearing.listener.lost_seconds == pytest.approx(0.3)
    hearing.listener.close()
    assert hearing.listener.lost_seconds == pytest.approx(0.3)
    clock.now += 5.0
    assert hearing.listener.lost_seconds == pytest.approx(0.3)


def test_what_a_device_lost_before_it_went_is_not_counted_again_with_its_absence(hear: Hear, clock: Clock) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone()
    hearing = hear(first, second, clock=clock)
    first.give(SPEECH[:N], N)
    hearing.wait(N_FRAMES)
    first.n_lost = SAMPLE_RATE  # the card stood still for a second
    clock.now += 1.0
    first.give(SPEECH[N : N + HOP])
    hearing.wait(N_FRAMES + 1)
    first.lost = True
    hearing.wait_words("waiting for a signal")
    clock.now += 2.0
    second.give(SPEECH[:N], HOP)
    hearing.wait(2 * N_FRAMES + 1)
    assert hearing.listener.lost_seconds == pytest.approx(3.0, abs=0.02)
    assert frames_of(hearing.taken)[N_FRAMES + 1] == pytest.approx(350, abs=3)


def test_changing_the_microphone_loses_nothing_and_the_frames_number_on(hear: Hear, clock: Clock) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(name="the other")
    hearing = hear(first, second, clock=clock)
    first.give(SPEECH[:N], N)
    hearing.wait(N_FRAMES)
    clock.now += 1.0
    hearing.listener.choose(InputChoice("the other"))
    hearing.wait_words("waiting for a signal from the other")
    second.give(SPEECH[:N], N)
    hearing.wait(2 * N_FRAMES)
    assert frames_of(hearing.taken)[N_FRAMES:] == list(range(100, 100 + N_FRAMES))
    assert hearing.listener.lost_seconds == 0
    assert [choice.label for choice in hearing.openers.asked] == ["", "the other"]


def test_a_bug_is_raised_once_and_ends_the_listening_truthfully(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()

    def fail(*_: object) -> None:
        raise ZeroDivisionError("a bug")

    hearing = hear(microphone, on_sound=fail)
    hearing.wait_words("waiting for")
    microphone.give(SPEECH[:N])
    assert microphone.closed.wait(60)
    hearing.wait_words("not listening")
    with pytest.raises(ZeroDivisionError):
        hearing.listener.take_analyses()
    assert hearing.listener.take_analyses() == []
    assert not hearing.listener.status.listening
    hearing.listener.close()


def test_an_opener_that_hangs_holds_nobody_up(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone)
    hearing.wait_words("waiting for")
    hearing.openers.may_answer.clear()
    listener = hearing.listener
    microphone.lost = True
    wait_for(lambda: len(hearing.openers.asked) == 2, "the second try")  # it hangs now
    for _ in range(100):
        (
            listener.poll(),
            listener.take_analyses(),
            listener.level,
            listener.latency,
            listener.lost_seconds,
            listener.age_of(3),
        )
        assert not listener.status.listening
    listener.choose(InputChoice("another"))
    listener.record(None)
    listener.close()
    assert hearing.openers.hangs
    assert listener.status.words == "not listening"
    late = HandDrivenMicrophone()
    hearing.openers.waiting.append(late)
    hearing.openers.may_answer.set()
    assert late.closed.wait(60)  # what it opened too late is let go
    listener._thread.join(60)
    assert not listener._thread.is_alive()


def test_closing_ends_the_thread_and_lets_the_microphone_go(hear: Hear) -> None:
    before = set(threading.enumerate())
    for state in ("missing", "waiting", "listening"):
        microphone = HandDrivenMicrophone()
        hearing = hear(None if state == "missing" else microphone)
        hearing.wait_words(REFUSAL if state == "missing" else "waiting for")
        if state == "listening":
            microphone.give(SPEECH[:N])
            hearing.wait(N_FRAMES)
        hearing.listener.close()
        hearing.listener.close()
        assert microphone.closed.is_set() == (state != "missing")
        assert not hearing.listener.status.listening
    assert set(threading.enumerate()) == before


def test_what_is_missing_when_it_is_closed_stays_counted(hear: Hear, clock: Clock) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, clock=clock)
    microphone.give(SPEECH[:N], N)
    hearing.wait(N_FRAMES)
    microphone.lost = True
    hearing.wait_words(REFUSAL)
    clock.now += 4.0
    hearing.listener.close()
    clock.now += 4.0
    assert hearing.listener.lost_seconds == pytest.approx(4.0)


def test_frames_go_on_even_if_the_device_runs_faster_than_the_clock(hear: Hear, clock: Clock) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone()
    hearing = hear(first, second, clock=clock)
    first.give(np.zeros(SAMPLE_RATE, np.float32))  # a second, and the clock stands still
    hearing.wait(frames_in(SAMPLE_RATE))
    first.lost = True
    hearing.wait_words("waiting for")
    clock.now += 0.01
    second.give(np.zeros(N, np.float32))
    hearing.wait(frames_in(SAMPLE_RATE) + N_FRAMES)
    assert frames_of(hearing.taken) == list(range(frames_in(SAMPLE_RATE) + N_FRAMES))
    assert hearing.listener.lost_seconds == 0
