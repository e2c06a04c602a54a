"""The listener: what a microphone hears is analysed like a file, once, in order, and nothing waits for it."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.analyser import latest_reading
from phonemeengine.audio.stream import InputChoice
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Thresholds
from phonemeengine.settings import FRAME_PERIOD, HOP, SAMPLE_RATE
from tests.fakes.microphones import HandDrivenMicrophone, Hear, frames_in, middle_of, offline
from tests.fakes.players import PRESET, SPEECH, agree, frames_of, joined
from tests.sounds import silence, tone
from tests.waiting import Clock, wait_for

DEAF = replace(
    PRESET,
    thresholds=Thresholds(silence_zero_crossings=1e9, silence_energy=1e9, silence_max_energy=1e9, silence_szsch1=1e9),
)


@pytest.mark.parametrize("n", [64, 441, 1000, 20_000])
def test_what_is_heard_gives_the_same_as_a_file_of_it_however_it_comes(hear: Hear, n: int) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, pitch=True)
    microphone.give(SPEECH, n)
    hearing.wait(frames_in(len(SPEECH)))
    assert frames_of(hearing.taken) == list(range(frames_in(len(SPEECH))))
    agree(hearing.taken, offline(SPEECH))
    assert (hearing.listener.n_dropped, hearing.listener.lost_seconds) == (0, 0)
    wait_for(lambda: hearing.listener.seconds == pytest.approx(len(SPEECH) / SAMPLE_RATE), "what makes no frame")


def test_without_pitch_everything_else_is_the_same(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone)
    microphone.give(SPEECH)
    hearing.wait(frames_in(len(SPEECH)))
    found, whole = joined(hearing.taken), offline(SPEECH)
    np.testing.assert_array_equal(found.phonemes, whole.phonemes[: len(found)])
    assert not found.features["f0"].any()


@pytest.mark.parametrize("rate", [16_000, 48_000])
def test_another_rate_of_the_device_puts_every_sound_at_its_place(hear: Hear, rate: int) -> None:
    seconds = np.arange(rate) / rate
    burst = np.where((seconds >= 0.4) & (seconds < 0.6), 0.8 * np.sin(2 * np.pi * 1000 * seconds), 0)
    microphone = HandDrivenMicrophone(rate)
    delays: list[float] = []
    hearing = hear(
        microphone, on_analysis=lambda _: delays.append(hearing.listener.latency.capture - microphone.delay)
    )
    microphone.give(burst.astype(np.float32), rate // 100)
    wait_for(lambda: hearing.listener.seconds == 1.0, "the sound")
    wait_for(
        lambda: bool(hearing.taken.extend(hearing.listener.take_analyses()) or len(frames_of(hearing.taken)) > 90),
        "it",
    )
    found = joined(hearing.taken)
    expected = offline(np.concatenate((silence(0.4), tone(1000, 0.2, 0.8), silence(0.4)))).part(slice(len(found)))
    np.testing.assert_allclose(found.intensities, expected.intensities, atol=0.01)
    volumes, wanted = found.features["volume"], expected.features["volume"]
    inside = np.abs(np.arange(len(found)) - 49.5) < 8
    outside = np.abs(np.arange(len(found)) - 49.5) > 14
    np.testing.assert_allclose(volumes[inside], wanted[inside], atol=0.01)
    np.testing.assert_allclose(volumes[outside], 0, atol=0.001)
    np.testing.assert_array_equal(found.spectra[inside].argmax(axis=1), expected.spectra[inside].argmax(axis=1))
    assert hearing.listener.rate == rate
    assert 0 < min(delays) < max(delays) < 0.02  # however a sound falls, the resampler holds it back as long
    assert max(delays) - min(delays) < 0.003


@pytest.mark.parametrize(("channel", "share"), [(1, (1, 0)), (2, (0, 1)), (0, (0.5, 0.5))])
def test_the_chosen_channel_is_heard_and_0_is_the_mean_of_both(
    hear: Hear, channel: int, share: tuple[float, float]
) -> None:
    microphone = HandDrivenMicrophone(n_channels=2)
    hearing = hear(microphone, choice=InputChoice(channel=channel))
    left, right = tone(500, 0.5, 0.8), tone(1500, 0.5, 0.4)
    microphone.give(np.stack([left, right], axis=1))
    hearing.wait(frames_in(len(left)))
    expected = offline((share[0] * left + share[1] * right).astype(np.float32)).part(slice(frames_in(len(left))))
    np.testing.assert_allclose(joined(hearing.taken).spectra, expected.spectra, rtol=1e-3, atol=1e-4)
    assert hearing.listener.n_channels == (1 if channel else 2)


def test_another_preset_acts_from_the_next_block_on(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, preset=DEAF, pitch=True)
    sound = tone(700, 1.0, 0.5)
    microphone.give(sound[:22_050])
    hearing.wait(frames_in(22_050))
    assert set(joined(hearing.taken).recognised) == {Phoneme.SILENCE}
    hearing.listener.set_preset(PRESET)
    microphone.give(sound[22_050:])
    hearing.wait(frames_in(44_100))
    found, first = joined(hearing.taken), frames_in(22_050)
    expected = offline(sound).recognised[first : len(found)]
    assert (found.recognised[first + 1 :] == expected[1:]).all()  # one block may be under way
    assert Phoneme.SILENCE not in found.recognised[first + 1 :]


def test_a_listener_tells_its_preset(hear: Hear) -> None:
    listener = hear(HandDrivenMicrophone(), preset=DEAF).listener
    assert listener.preset is DEAF
    listener.set_preset(PRESET)
    assert listener.preset is PRESET


def test_polling_gives_the_newest_frame(hear: Hear, clock: Clock) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, clock=clock)
    assert hearing.listener.poll() == (Phoneme.SILENCE, 0.0, 0.0)
    microphone.give(SPEECH[: 30 * HOP])
    hearing.wait(frames_in(30 * HOP))
    whole = offline(SPEECH[: 30 * HOP])
    k = frames_in(30 * HOP) - 1
    assert whole.intensities[k] > 0
    newest = latest_reading(whole.part(slice(k, k + 1)))
    wanted = newest._replace(intensity=pytest.approx(newest.intensity, abs=1e-4))
    wait_for(lambda: hearing.listener.poll() == wanted, "the newest")


def test_a_mouth_does_not_stay_open_when_nothing_comes_any_more(hear: Hear, clock: Clock) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, clock=clock)
    microphone.give(SPEECH[: 30 * HOP])
    hearing.wait(frames_in(30 * HOP))
    wait_for(lambda: hearing.listener.poll().intensity > 0, "a voice")
    clock.now += 0.6
    assert hearing.listener.poll() == (Phoneme.SILENCE, 0.0, 0.0)


def test_every_block_is_told_as_soon_as_it_is_known(hear: Hear) -> None:
    told: list[int] = []
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, on_analysis=lambda analysis: told.extend(frames_of([analysis])))
    microphone.give(SPEECH)
    wait_for(lambda: len(told) == frames_in(len(SPEECH)), "the frames")
    hearing.wait(len(told))
    assert told == frames_of(hearing.taken)


def test_frames_that_nobody_takes_are_dropped_and_counted(hear: Hear) -> None:
    told: list[int] = []
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, on_analysis=lambda analysis: told.extend(frames_of([analysis])), most_waiting=5)
    microphone.give(SPEECH)
    wait_for(lambda: len(told) == frames_in(len(SPEECH)), "the frames")
    taken = frames_of(hearing.listener.take_analyses())
    assert taken == told[-5:]
    assert hearing.listener.n_dropped == len(told) - 5


def test_the_level_is_that_of_the_channel_that_is_heard(hear: Hear) -> None:
    microphone = HandDrivenMicrophone(n_channels=2)
    hearing = hear(microphone, choice=InputChoice(channel=2))
    microphone.give(np.stack([np.ones(4410, np.float32), np.full(4410, 0.25, np.float32)], axis=1))
    hearing.wait(frames_in(4410))
    level = hearing.listener.level
    assert (level.held, level.clipped_ago) == (0.25, None)


def test_the_age_of_a_frame_is_counted_from_its_middle(hear: Hear, clock: Clock) -> None:
    microphone = HandDrivenMicrophone(48_000)
    hearing = hear(microphone, clock=clock)
    microphone.give(np.zeros(4800, np.float32), 480)
    wait_for(lambda: hearing.listener.seconds == pytest.approx(0.1), "the sound")
    clock.now = microphone.begun + 0.1
    assert hearing.listener.age_of(3) == pytest.approx(0.1 - middle_of(3), abs=1e-4)
    microphone.n_lost = 4800
    assert hearing.listener.age_of(3) == pytest.approx(-middle_of(3), abs=1e-4)
    assert hearing.listener.lost_seconds == pytest.approx(0.1)


def test_the_latency_is_the_sum_of_what_a_sound_waits_for(hear: Hear) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone)
    assert hearing.listener.latency.capture == 0
    microphone.give(SPEECH)
    hearing.wait(frames_in(len(SPEECH)))
    latency = hearing.listener.latency
    assert (latency.capture, latency.window, latency.hop) == (0.02, 1024 / SAMPLE_RATE, FRAME_PERIOD / 2)
    assert 0 < latency.analysis < 1
    assert latency.total == pytest.approx(0.02 + 0.02322 + 0.005 + latency.analysis, abs=1e-4)
