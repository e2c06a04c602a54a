"""Microphones by name: chosen by words, listed anew, and told apart."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from phonemeengine.audio.stream import (
    CardStream,
    Device,
    InputChoice,
    chosen_input,
    devices,
    inputs_of,
    openable_devices,
)
from phonemeengine.errors import DeviceError, SettingsError
from tests.fakes.portaudio import FakePortAudio


def device(name: str, n_inputs: int = 1, *, api: str = "ALSA", default: bool = False) -> Device:
    return Device(name, api, n_inputs, 2, 48_000, default)


YETI, YETI_JACK, BUILT_IN, SPEAKER = (
    device("Yeti"),
    device("Yeti", api="JACK"),
    device("Built-in (hw:0,0)", 2, default=True),
    device("Speaker", 0),
)
ALL = [SPEAKER, YETI, YETI_JACK, BUILT_IN]


def open_stream() -> CardStream:
    return CardStream("input", None, 44_100, 1, 0.1, lambda *_: None)


# -- choosing -------------------------------------------------------------------------------------------------


def test_only_what_records_is_offered_the_default_first() -> None:
    assert inputs_of(ALL) == [BUILT_IN, YETI, YETI_JACK]


@pytest.mark.parametrize(
    ("label", "wanted"),
    [
        ("", BUILT_IN),
        ("Yeti · JACK", YETI_JACK),
        ("Yeti · ALSA", YETI),
        ("Yeti", YETI),
        ("built-IN", BUILT_IN),
        ("jack", YETI_JACK),
    ],
)
def test_a_device_is_found_by_label_name_or_a_part_that_no_other_has(label: str, wanted: Device) -> None:
    assert chosen_input(InputChoice(label), ALL) is wanted


def test_a_name_that_is_whole_goes_before_one_that_contains_it() -> None:
    longer = device("Yeti Nano")
    assert chosen_input(InputChoice("Yeti"), [longer, YETI]) is YETI


def test_of_two_microphones_of_the_same_name_the_first_is_taken() -> None:
    one, other = device("USB Audio"), device("USB Audio")
    assert chosen_input(InputChoice("USB Audio · ALSA"), [one, other]) is one


def test_words_that_fit_several_are_refused_with_all_that_they_fit() -> None:
    two = [*ALL, Device("Yeti Pro", "ALSA", 2, 2, 48_000, is_default=False)]
    with pytest.raises(DeviceError) as refusal:
        chosen_input(InputChoice("yet"), two)
    assert str(refusal.value) == (
        "the microphone 'yet' fits several; choose one of: Yeti · ALSA, Yeti · JACK, Yeti Pro · ALSA"
    )


def test_of_one_microphone_under_several_systems_that_of_the_default_is_taken() -> None:
    assert chosen_input(InputChoice("yet"), ALL).label == "Yeti · ALSA"


def test_a_device_that_is_not_there_is_refused_with_all_that_are() -> None:
    with pytest.raises(DeviceError) as refusal:
        chosen_input(InputChoice("Speaker"), ALL)
    assert str(refusal.value) == (
        "the microphone 'Speaker' is not connected; choose one of: Built-in (hw:0,0) · ALSA, Yeti · ALSA, Yeti · JACK"
    )


def test_the_default_takes_its_place_where_the_user_likes_that() -> None:
    assert chosen_input(InputChoice("Gone", else_default=True), ALL) is BUILT_IN
    assert chosen_input(InputChoice("jack", else_default=True), ALL) is YETI_JACK


@pytest.mark.parametrize("choice", [InputChoice(), InputChoice("Yeti"), InputChoice(else_default=True)])
def test_without_any_microphone_it_says_so(choice: InputChoice) -> None:
    with pytest.raises(DeviceError, match=r"^no microphone was found; connect one, or check"):
        chosen_input(choice, [SPEAKER])


# -- listing --------------------------------------------------------------------------------------------------


def test_devices_are_listed_with_their_sound_system(portaudio: FakePortAudio) -> None:
    portaudio.plug("Yeti", 2, api=1, rate=44_100.0)
    portaudio.plug("Built-in")
    portaudio.default.device = (1, 0)
    assert devices() == [
        Device("Yeti", "JACK", 2, 0, 44_100, is_default=False),
        Device("Built-in", "ALSA", 1, 0, 48_000, is_default=True),
    ]


def test_what_is_plugged_in_later_is_listed_though_portaudio_keeps_its_list(portaudio: FakePortAudio) -> None:
    assert devices() == []
    portaudio.plug("Yeti")
    assert [d.name for d in devices()] == ["Yeti"]
    portaudio.plugged.clear()
    assert devices() == []


def test_the_list_is_made_anew_only_while_no_stream_is_open(portaudio: FakePortAudio) -> None:
    portaudio.plug("Yeti")
    portaudio.default.device = (0, -1)
    running = open_stream()
    before = portaudio.n_initialised
    portaudio.plug("Built-in")
    assert [d.name for d in openable_devices()] == ["Yeti"]
    second = open_stream()
    running.close()
    running.close()
    assert [d.name for d in openable_devices()] == ["Yeti"]
    assert portaudio.n_initialised == before
    second.close()
    assert [d.name for d in openable_devices()] == ["Yeti", "Built-in"]


def test_a_device_is_opened_by_the_number_that_it_has_now(portaudio: FakePortAudio) -> None:
    portaudio.plug("Yeti")
    (yeti,) = devices()
    portaudio.plugged.insert(0, portaudio.plugged[0] | {"name": "Built-in"})
    opened = CardStream("input", yeti, 44_100, 1, 0.1, lambda *_: None)
    assert (opened.name, portaudio.streams[0].device) == ("Yeti", 1)
    portaudio.plugged.clear()
    opened.close()
    with pytest.raises(DeviceError, match=r"could not be opened \(Yeti · ALSA is not there\)"):
        CardStream("input", yeti, 44_100, 1, 0.1, lambda *_: None)


def test_a_stream_that_cannot_be_opened_does_not_keep_the_list_as_it_was(portaudio: FakePortAudio) -> None:
    def refuse(_options: object) -> None:
        raise portaudio.PortAudioError("Device unavailable")

    portaudio.plug("Yeti")
    portaudio.default.device = (0, -1)
    portaudio.may_open = refuse
    with pytest.raises(DeviceError, match="Device unavailable"):
        open_stream()
    portaudio.plug("Built-in")
    assert len(devices()) == 2


def test_a_sound_system_that_does_not_answer_is_said_and_asked_again_later(portaudio: FakePortAudio) -> None:
    portaudio.plug("Yeti")
    portaudio.answers = False
    for _ in range(2):
        with pytest.raises(DeviceError, match=r"^the audio system does not respond \(Error initializing PortAudio"):
            devices()
    with pytest.raises(DeviceError, match="does not respond"):
        open_stream()
    portaudio.answers = True
    assert [d.name for d in devices()] == ["Yeti"]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("raise OSError('PortAudio library not found')", "install libportaudio2"),
        ("raise ImportError('no such package')", "pip install sounddevice"),
    ],
)
def test_what_is_missing_is_named_with_what_to_install(body: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "sounddevice.py").write_text(body)
    path = os.pathsep.join([str(tmp_path), *sys.path])
    program = "from phonemeengine.audio.stream import devices; devices()"  # alone: no other test's thread imports it
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | {"PYTHONPATH": path},
    )
    assert "DeviceError: audio cannot be played or recorded" in done.stderr
    assert words in done.stderr.splitlines()[-1]


@pytest.mark.parametrize(
    ("numbers", "words"),
    [
        ({"channel": -1}, "the channel must lie in 0..64, got -1"),
        ({"channel": 65}, "the channel must lie in 0..64, got 65"),
        ({"rate": 5}, "the sample rate must lie in"),
        ({"latency": 0.001}, "the latency must lie in 0.01..1 s, got 0.001"),
        ({"latency": float("nan")}, "the latency must lie in"),
    ],
)
def test_a_choice_that_no_device_can_have_is_refused(numbers: dict[str, float], words: str) -> None:
    with pytest.raises(SettingsError, match=words):
        InputChoice(**numbers)  # type: ignore[arg-type]
