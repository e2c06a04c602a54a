"""A sound card's input: every sample in its order, and what is known of when it was captured."""

import logging
import threading
from typing import Any

import numpy as np
import pytest

from phonemeengine.audio import stream
from phonemeengine.audio.input import CardInput
from phonemeengine.audio.stream import InputChoice
from phonemeengine.errors import DeviceError
from tests.fakes.portaudio import FakePortAudio, FakeStream, PortAudioError
from tests.waiting import Clock


@pytest.fixture
def portaudio(portaudio: FakePortAudio) -> FakePortAudio:
    portaudio.plug("Yeti", 2)
    portaudio.default.device = (0, -1)
    return portaudio


def opened(portaudio: FakePortAudio, *choice: Any, **clock: Clock) -> tuple[CardInput, FakeStream]:
    card = CardInput(InputChoice(*choice), **clock)
    return card, portaudio.streams[-1]


def numbered(first: int, n: int, n_channels: int = 1) -> np.ndarray:
    return np.arange(first * n_channels, (first + n) * n_channels, dtype=np.float32).reshape(n, n_channels)


@pytest.mark.parametrize(("channel", "n_channels"), [(1, 1), (2, 2), (0, 2)])
def test_all_samples_come_in_their_order(portaudio: FakePortAudio, channel: int, n_channels: int) -> None:
    card, source = opened(portaudio, "", channel)
    source.bring(numbered(0, 441, n_channels))
    first = card.read(0)
    source.bring(numbered(441, 100, n_channels))
    source.bring(numbered(541, 800, n_channels))
    rest = card.read(0)
    assert card.n_channels == source.options["channels"] == n_channels
    assert first.dtype == np.float32
    np.testing.assert_array_equal(np.concatenate([first, rest]), numbered(0, 1341, n_channels))
    assert card.read(0).shape == (0, n_channels)


def test_mixing_a_device_of_one_channel_takes_that_one(portaudio: FakePortAudio) -> None:
    portaudio.plugged[0]["max_input_channels"] = 1
    card, source = opened(portaudio, "", 0)
    assert card.n_channels == source.options["channels"] == 1


def test_a_channel_that_the_device_lacks_is_refused(portaudio: FakePortAudio) -> None:
    with pytest.raises(DeviceError) as refusal:
        opened(portaudio, "", 3)
    assert str(refusal.value) == "Yeti has 2 channels and so no channel 3; choose another"
    assert portaudio.streams == []


def test_44100_hz_is_taken_where_the_device_has_it(portaudio: FakePortAudio) -> None:
    card, source = opened(portaudio)
    assert card.rate == source.options["samplerate"] == 44_100
    assert card.name == "Yeti · ALSA"


def test_otherwise_the_rate_is_what_the_device_suggests(portaudio: FakePortAudio) -> None:
    def only_48000(options: dict[str, Any]) -> None:
        if options["samplerate"] != 48_000:
            raise PortAudioError("Invalid sample rate [PaErrorCode -9997]")

    portaudio.may_open = only_48000
    assert opened(portaudio)[0].rate == 48_000
    with pytest.raises(DeviceError, match="Invalid sample rate"):
        opened(portaudio, "", 1, 44_100)  # who asks for a rate gets no other


def test_a_rate_that_is_asked_for_is_opened(portaudio: FakePortAudio) -> None:
    assert opened(portaudio, "", 1, 16_000)[0].rate == 16_000


def test_the_callback_takes_no_lock_and_says_nothing(
    portaudio: FakePortAudio, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    card, source = opened(portaudio)
    caplog.set_level(logging.DEBUG)
    bringing = threading.Thread(target=lambda: source.bring(numbered(0, 441)), daemon=True)
    with stream._portaudio_lock:  # another thread lists devices at this very time
        bringing.start()
        bringing.join(60)
        assert not bringing.is_alive()
    assert (capfd.readouterr(), caplog.records) == (("", ""), [])
    assert len(card.read(0)) == 441


def test_a_device_that_brings_nothing_is_quiet_and_one_that_ends_is_lost(
    portaudio: FakePortAudio, clock: Clock
) -> None:
    card, source = opened(portaudio, clock=clock)
    clock.now += 1.5
    assert (card.quiet, card.lost) == (1.5, False)
    source.bring(np.zeros((441, 1)))
    clock.now += 0.25
    assert card.quiet == 0.25
    source.vanish()
    assert card.lost
    assert len(card.read(0)) == 441  # what came before is not lost with it


def test_a_device_that_is_closed_is_not_lost(portaudio: FakePortAudio) -> None:
    card, source = opened(portaudio)
    card.close()
    card.close()
    assert source.closed
    assert not card.lost


def test_the_delay_is_what_the_card_says_and_at_least_a_block(portaudio: FakePortAudio, clock: Clock) -> None:
    card, source = opened(portaudio, clock=clock)
    for age in (0.0, 0.03):
        for _ in range(1500):
            clock.now += 0.01
            source.bring(np.zeros((441, 1)), age)
            card.read(0)
        assert card.delay == pytest.approx(max(age, 0.01), abs=1e-4)


def test_a_sample_was_captured_before_it_came_by_what_the_card_keeps_back(
    portaudio: FakePortAudio, clock: Clock
) -> None:
    card, source = opened(portaudio, clock=clock)
    for _ in range(300):
        clock.now += 0.01
        source.bring(np.zeros((441, 1)), 0.03)
        card.read(0)
    assert clock.now == pytest.approx(1003)
    assert card.time_of(3 * 44_100) == pytest.approx(1003 - 0.02, abs=1e-3)  # it left the air 20 ms before its block
    assert card.time_of(0) == pytest.approx(1000 - 0.02, abs=1e-3)


def test_samples_that_the_card_lost_are_counted(portaudio: FakePortAudio, clock: Clock) -> None:
    card, source = opened(portaudio, clock=clock)
    for k in range(1000):
        clock.now += 0.01
        if not 400 <= k < 410:
            source.bring(np.zeros((441, 1)))
        card.read(0)
    assert card.n_lost == pytest.approx(4410, abs=1)
