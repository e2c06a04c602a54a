"""Outputs: the clock that stands in for a sound card, and what is asked of a sound card."""

import threading
import time
from functools import partial
from typing import Any

import numpy as np
import pytest

from phonemeengine.audio import stream
from phonemeengine.audio.output import AHEAD, CardOutput, ClockOutput, open_output
from phonemeengine.errors import DeviceError
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.portaudio import FakePortAudio, FakeStream, PortAudioError
from tests.waiting import Clock

SECOND = np.zeros((AHEAD, 1), np.float32)


# -- the clock ------------------------------------------------------------------------------------------------


def test_time_passes_only_while_the_clock_runs(clock: Clock) -> None:
    output = ClockOutput(clock=clock)
    output.write(SECOND)
    clock.now += 5
    assert output.heard == 0
    output.run(running=True)
    clock.now += 0.05
    assert output.heard == pytest.approx(0.05 * SAMPLE_RATE)
    output.run(running=False)
    clock.now += 5
    assert output.heard == pytest.approx(0.05 * SAMPLE_RATE)
    output.run(running=True)
    clock.now += 0.03
    assert output.heard == pytest.approx(0.08 * SAMPLE_RATE)


def test_running_twice_is_running_once(clock: Clock) -> None:
    output = ClockOutput(clock=clock)
    output.write(SECOND)
    output.run(running=True)
    clock.now += 0.05
    output.run(running=True)
    clock.now += 0.05
    assert output.heard == pytest.approx(0.1 * SAMPLE_RATE)


def test_nothing_is_heard_that_was_not_written(clock: Clock) -> None:
    output = ClockOutput(clock=clock)
    output.run(running=True)
    clock.now += 10
    assert output.heard == 0
    output.write(SECOND[:1000])
    clock.now += 10
    assert output.heard == 1000
    clock.now += 10
    output.write(SECOND[:1000])
    assert output.heard == 1000  # time in which there was nothing to hear is not made up for
    clock.now += 0.01
    assert output.heard == pytest.approx(1441)


def test_room_is_what_may_be_written_ahead(clock: Clock) -> None:
    output = ClockOutput(clock=clock)
    assert output.room == AHEAD
    output.write(SECOND)
    assert output.room == 0
    output.run(running=True)
    clock.now += 0.01
    assert output.room == pytest.approx(441, abs=1)


def test_what_is_skipped_is_over_at_once(clock: Clock) -> None:
    output = ClockOutput(clock=clock)
    output.write(SECOND)
    output.run(running=True)
    clock.now += 0.01
    output.skip()
    assert (output.heard, output.room) == (AHEAD, AHEAD)
    clock.now += 1
    output.write(SECOND[:500])
    assert output.heard == AHEAD
    clock.now += 1
    assert output.heard == AHEAD + 500


def test_the_clock_keeps_time_though_two_threads_ask_it() -> None:
    output = ClockOutput()
    output.n_written = 10 * SAMPLE_RATE
    start = time.monotonic()
    output.run(running=True)
    seen: list[list[float]] = [[], []]

    def ask(found: list[float]) -> None:
        while time.monotonic() < start + 0.2:
            found.append(output.heard)

    threads = [threading.Thread(target=ask, args=(found,)) for found in seen]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(found == sorted(found) for found in seen)
    assert output.heard <= (time.monotonic() - start) * SAMPLE_RATE + 1


# -- the sound card, as far as it can be known without one ----------------------------------------------------


@pytest.fixture
def portaudio(portaudio: FakePortAudio) -> FakePortAudio:
    portaudio.plug("a card")
    portaudio.default.device = (0, 0)
    return portaudio


@pytest.fixture
def card(portaudio: FakePortAudio) -> CardOutput:
    return CardOutput(2)


@pytest.fixture
def playing(card: CardOutput, portaudio: FakePortAudio) -> FakeStream:
    """The stream that the card opened."""
    return portaudio.streams[-1]


def numbered(n: int) -> np.ndarray:
    return np.repeat(np.arange(1, n + 1, dtype=np.float32)[:, np.newaxis], 2, axis=1)


def test_a_card_plays_what_is_written_as_loud_as_is_asked(card: CardOutput, playing: FakeStream) -> None:
    card.write(numbered(300))
    assert not playing.ask(100).any()  # not running yet
    card.run(running=True)
    np.testing.assert_array_equal(playing.ask(100), numbered(300)[:100])
    card.gain = 0.5
    np.testing.assert_array_equal(playing.ask(100), numbered(300)[100:200] / 2)
    out = playing.ask(200)
    assert not out[100:].any()
    assert (card.name, card.is_card, card.lost, card.n_written, card.room) == ("a card", True, False, 300, AHEAD)


def test_a_sample_is_heard_when_it_leaves_the_card(card: CardOutput, playing: FakeStream) -> None:
    card.write(numbered(2000))
    card.run(running=True)
    assert card.heard == 0
    playing.ask(1000, latency=0.05)
    assert card.heard == 0
    playing.time += 0.05
    assert card.heard == pytest.approx(0)
    playing.time += 0.01
    assert card.heard == pytest.approx(441)
    playing.time += 10
    assert card.heard == 1000  # and never more than was given out


def test_a_paused_card_is_silent_and_keeps_its_place(card: CardOutput, playing: FakeStream) -> None:
    card.write(numbered(2000))
    card.run(running=True)
    playing.ask(1000)
    playing.time += 0.01
    card.run(running=False)
    playing.time += 1
    assert card.heard == pytest.approx(441)
    assert not playing.ask(100).any()
    card.run(running=True)
    np.testing.assert_array_equal(playing.ask(100), numbered(2000)[1000:1100])


def test_what_is_skipped_is_never_played(card: CardOutput, playing: FakeStream) -> None:
    card.write(numbered(2000))
    card.run(running=True)
    playing.ask(500)
    card.skip()
    assert card.heard == 2000
    assert not playing.ask(100).any()
    card.write(numbered(50))
    np.testing.assert_array_equal(playing.ask(50), numbered(50))
    playing.time += 1
    assert card.heard == 2050


def test_a_lost_card_says_so_and_knows_where_it_was(card: CardOutput, playing: FakeStream) -> None:
    card.write(numbered(5000))
    card.run(running=True)
    for _ in range(4):
        playing.ask(1000)
        playing.time += 1000 / SAMPLE_RATE
    before = card.heard
    del playing.time  # the clock of a dead stream must not be asked
    playing.vanish()
    assert card.lost
    assert card.heard == pytest.approx(before) == 4000


def test_a_card_that_is_closed_is_not_lost(card: CardOutput, playing: FakeStream) -> None:
    card.close()
    assert playing.closed
    assert not card.lost


def test_a_card_that_sleeps_is_not_lost_until_it_asks_for_nothing_for_long(
    portaudio: FakePortAudio, clock: Clock
) -> None:
    card = CardOutput(2, clock=clock)
    portaudio.streams[-1].ask(100)  # what it takes in advance
    clock.now += 2.5  # PulseAudio's null sink sleeps for 2 s before its first sound
    assert (card.lost, card.alive) == (False, False)
    clock.now += stream.STALLED
    assert card.lost
    portaudio.streams[-1].ask(100)  # it asks again: a paused card does so all the time
    assert (card.lost, card.alive) == (False, True)
    clock.now += 2.5
    assert not card.lost
    clock.now += stream.STALLED
    assert card.lost
    card.close()
    assert (card.lost, card.alive) == (False, False)


def test_a_card_is_alive_once_it_asks_for_more_than_it_takes_in_advance(
    portaudio: FakePortAudio, clock: Clock
) -> None:
    card = CardOutput(2, clock=clock)
    portaudio.streams[-1].ask(100)
    assert not card.alive
    clock.now += 0.2
    portaudio.streams[-1].ask(100)
    assert card.alive
    portaudio.streams[-1].vanish()
    assert (card.alive, card.lost) == (False, True)


def test_without_a_card_the_clock_plays(portaudio: FakePortAudio) -> None:
    def refuse(**_: Any) -> None:
        raise PortAudioError("Error querying device -1\nand more")

    portaudio.OutputStream = refuse
    with pytest.raises(DeviceError, match=r"not be opened \(Error querying device -1\); check that it is connected"):
        CardOutput(1)
    assert isinstance(open_output(1), ClockOutput)


def test_without_portaudio_the_clock_plays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "sounddevice", None)
    with pytest.raises(DeviceError, match="pip install sounddevice"):
        CardOutput(1)
    assert isinstance(open_output(1), ClockOutput)


def test_a_card_that_opens_and_does_not_start_is_let_go(portaudio: FakePortAudio) -> None:
    made: list[FakeStream] = []

    class Stubborn(FakeStream):
        def start(self) -> None:
            made.append(self)
            raise PortAudioError("Unanticipated host error")

    portaudio.OutputStream = partial(Stubborn, portaudio)
    assert isinstance(open_output(1), ClockOutput)
    assert made[0].closed
