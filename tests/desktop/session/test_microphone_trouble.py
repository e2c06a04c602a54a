"""The microphone's model when the microphone is missing, vanishes or hangs, and when its latency is measured."""

import time
from collections.abc import Callable

import numpy as np
import pytest

from phonemeengine.audio.stream import InputChoice
from phonemeengine.live.loopback import Loopback
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.desktop.studio import DESK, Studio
from tests.fakes.microphones import REFUSAL, HandDrivenMicrophone
from tests.fakes.players import PRESET
from tests.fakes.recorders import hops_of_16_bits as known
from tests.fakes.recorders import samples_in
from tests.sounds import noise

MEASURED = Loopback(round_trip=0.12, capture=0.031, spread=0.002, n_detected=8, n_played=8)


# -- trouble ------------------------------------------------------------------------------------------


def test_a_missing_microphone_is_told_once_and_so_is_its_coming(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    studio = open_studio()
    studio.model.listen(PRESET)
    refusal = f"{REFUSAL[0].upper()}{REFUSAL[1:]}; trying again every 2 s."
    studio.until(lambda: refusal in studio.failed)
    n_asked = len(studio.openers.asked)
    studio.until(lambda: len(studio.openers.asked) > n_asked + 3)
    assert [told for told in studio.failed if told != "Opening the microphone."] == [refusal]  # that where it is slow
    studio.openers.waiting.append(mic)
    studio.feed(mic, noise(0.2))
    studio.until(lambda: studio.told)
    assert studio.told == ["The microphone is back: Desk · ALSA."]


def test_a_microphone_that_comes_back_is_recorded_on_and_the_gap_is_counted(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    back = HandDrivenMicrophone(name=DESK.label)
    studio = open_studio(mic)
    studio.model.listen(PRESET)
    studio.model.begin_recording()
    began = time.monotonic()
    studio.feed(mic, known(0, 20)[:, 0])
    mic.lost = True
    studio.until(lambda: studio.failed)
    assert studio.failed[0].endswith("; the recording continues once the signal is back.")
    assert (studio.model.recording, studio.model.listening) == (True, False)
    assert studio.model.latency is None
    studio.openers.waiting.append(back)
    studio.feed(back, known(20, 20)[:, 0])
    assert 0 < studio.model.listener.lost_seconds <= time.monotonic() - began
    studio.model.end_recording()
    studio.until(lambda: studio.recorded)
    np.testing.assert_array_equal(samples_in(studio.take), known(0, 40))
    assert studio.gaps == [f"with 1 gap of {studio.model.listener.lost_seconds:.2f} s marked in it"]
    assert studio.take.read_bytes().count(f"gap of {studio.model.listener.lost_seconds:.2f} s".encode()) == 1


def test_silence_takes_the_place_of_the_gap_where_that_is_chosen(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    back = HandDrivenMicrophone(name=DESK.label)
    studio = open_studio(mic)
    studio.model.fill_gaps = True
    studio.model.listen(PRESET)
    studio.model.begin_recording()
    studio.feed(mic, known(0, 20)[:, 0])
    mic.lost = True
    studio.until(lambda: studio.failed)
    studio.openers.waiting.append(back)
    studio.feed(back, known(20, 20)[:, 0])
    studio.model.end_recording()
    studio.until(lambda: studio.recorded)
    found = samples_in(studio.take)
    n_silent = round(studio.model.listener.lost_seconds * SAMPLE_RATE)
    assert len(found) == 40 * HOP + n_silent
    assert not found[20 * HOP : 20 * HOP + n_silent].any()
    np.testing.assert_array_equal(found[20 * HOP + n_silent :], known(20, 20))
    assert studio.gaps[0].endswith(f": 0.40 s of sound, {n_silent / SAMPLE_RATE:.2f} s of silence")


def test_a_microphone_that_hangs_when_it_is_opened_holds_nobody_up(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    studio = open_studio(mic)
    studio.openers.may_answer.clear()
    studio.model.listen(PRESET)
    studio.until(lambda: studio.failed)
    assert studio.failed == ["Opening the microphone."]
    studio.model.stop()
    assert studio.model.listener.take_analyses() == []
    studio.model.close()
    assert studio.openers.hangs
    studio.openers.may_answer.set()
    assert mic.closed.wait(60)


# -- latency by clicks --------------------------------------------------------------------------------


def test_what_clicks_measured_takes_the_place_of_the_cards_word_until_another_is_chosen(
    open_studio: Callable[..., Studio], mic: HandDrivenMicrophone
) -> None:
    back, third = HandDrivenMicrophone(), HandDrivenMicrophone()
    studio = open_studio(mic, back, third)
    studio.measure = lambda _choice: MEASURED
    studio.model.listen(PRESET)
    studio.feed(mic, noise(0.2))
    assert studio.model.latency.capture == mic.delay
    studio.model.measure()
    studio.until(lambda: studio.told)
    assert "Round-trip latency 120 ms (8 of 8 clicks detected" in studio.told[0]
    studio.feed(back, noise(0.2))
    assert studio.model.latency.capture == MEASURED.capture
    studio.model.choose(InputChoice("Headset"))
    studio.feed(third, noise(0.2))
    assert studio.model.latency.capture == third.delay


def test_nothing_is_recorded_while_clicks_are_played_which_is_said(studio: Studio) -> None:
    studio.measure = lambda _choice: MEASURED
    studio.model.measure()
    studio.model.begin_recording()
    assert not studio.model.recording
    assert studio.failed == [
        "Recording did not start, since the latency is being measured. Try again in a few seconds."
    ]
    assert studio.model.words == "measuring latency"
    studio.until(lambda: studio.model.active)


@pytest.mark.usefixtures("portaudio")
def test_without_a_device_the_latency_is_not_measured_which_is_one_sentence(
    open_studio: Callable[..., Studio],
) -> None:
    studio = open_studio()
    studio.model.measure()
    studio.until(lambda: studio.failed)
    assert studio.failed == [
        "The latency could not be measured: no microphone was found; connect one, or check that the audio system is "
        "running."
    ]
    assert not studio.model.active
    assert not studio.model.latency_test.running
