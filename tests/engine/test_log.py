"""What happens to devices, sound and recordings is logged, and nothing unless somebody listens."""

import logging
import re
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeengine.audio.dropouts import DropoutMeter
from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.stream import InputChoice
from phonemeengine.live.player import Player
from phonemeengine.settings import HOP, SAMPLE_RATE
from tests.fakes.microphones import REFUSAL, HandDrivenMicrophone, Hear, frames_in
from tests.fakes.outputs import HandDrivenOutput, Outputs
from tests.fakes.players import PRESET, SPEECH, ForgetfulPlayer
from tests.fakes.recorders import begun, recorder_to, samples_of_16_bits
from tests.waiting import wait_for

N = 20 * HOP
Log = Callable[[], list[str]]


@pytest.fixture
def log(caplog: pytest.LogCaptureFixture) -> Log:
    """What the engine has logged, each with its level."""
    caplog.set_level(logging.INFO, "phonemeengine")
    return lambda: [f"{record.levelname} {record.getMessage()}" for record in caplog.records]


def test_a_microphone_is_logged_as_it_comes_and_goes_and_once_while_it_is_away(hear: Hear, log: Log) -> None:
    first, second = HandDrivenMicrophone(), HandDrivenMicrophone(48_000, 2, name="the other")
    hearing = hear(first, None, None, second)
    first.give(SPEECH[:N])
    hearing.wait(frames_in(N))
    first.lost = True
    wait_for(lambda: len(hearing.openers.asked) == 4, "the other microphone")
    second.quiet = 6.0
    hearing.wait_words(REFUSAL)
    hearing.listener.choose(InputChoice("a third"))
    hearing.listener.close()
    away = f"WARNING {REFUSAL}; trying again every 2 s"
    assert [line for line in log() if "listening has ended" not in line][:5] == [
        "INFO moved by hand is open: 44100 Hz, 1 channels",
        "INFO moved by hand is let go: moved by hand was disconnected; trying again every 2 s",
        away,
        "INFO the other is open: 48000 Hz, 2 channels",
        "INFO the other is let go: no signal from the other; trying again every 2 s",
    ]
    assert re.fullmatch(r"INFO listening has ended; \d+\.\d\d s lost, 0 frames dropped", log()[-1])


def test_lost_sound_is_logged_with_what_is_lost_so_far(log: Log) -> None:
    meter = DropoutMeter(1000)
    for k in range(2000):
        if not 500 <= k < 600:
            meter.observe(100 + k / 100, 10)
    assert meter.n_lost == 1000
    assert log() == ["WARNING sound was lost by the device, 1.000 s so far"]


def test_frames_that_nobody_takes_are_logged_once(hear: Hear, log: Log) -> None:
    microphone = HandDrivenMicrophone()
    hearing = hear(microphone, most_waiting=3)
    microphone.give(SPEECH[:N])
    wait_for(lambda: hearing.listener.n_dropped > 5, "dropped frames")
    assert log().count("WARNING frames are dropped, since the program does not take them") == 1


def test_a_player_logs_its_card_and_that_it_goes(tmp_path: Path, log: Log) -> None:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE)
    cards = [HandDrivenOutput()]
    player = Player(SoundReader(tmp_path / "speech.wav"), PRESET, lambda _n: cards[0])
    player.play()
    wait_for(lambda: cards[0].running, "the card")
    cards[0].lost = True
    wait_for(lambda: bool(player.take_analyses()) or not player.has_card, "the clock")
    player.close()
    assert log() == [
        "INFO playing on moved by hand",
        "WARNING moved by hand: on with No audio device (silent playback)",
    ]


def test_frames_of_a_file_that_nobody_takes_are_logged_once(tmp_path: Path, log: Log) -> None:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE)
    player = ForgetfulPlayer(SoundReader(tmp_path / "speech.wav"), PRESET, Outputs())
    player.play()
    wait_for(lambda: player.n_dropped > 10, "dropped frames")
    player.close()
    assert log().count("WARNING frames are dropped, since the program does not take them") == 1


def test_a_recording_is_logged_from_its_beginning_over_its_gaps_to_its_end(tmp_path: Path, log: Log) -> None:
    take = tmp_path / "take.wav"
    with recorder_to(take, tmp_path) as recorder:
        recorder.write(np.zeros((4410, 1), np.float32), SAMPLE_RATE, 0.0)
        recorder.write(np.zeros((4410, 1), np.float32), SAMPLE_RATE, 1.1, 1.0)
    assert log() == [
        f"INFO recording to {take} begins: 44100 Hz, 1 channels",
        f"WARNING {take} has a gap of 1.00 s",
        f"INFO recording to {take} has ended: 0.20 s",
    ]


def test_a_recording_that_fails_is_logged_with_the_sentence_that_the_user_sees(tmp_path: Path, log: Log) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    recording = begun(folder / "take.wav", journal=tmp_path / "journal", rescue=tmp_path / "rescue")
    recording.write(samples_of_16_bits(0, 4410))
    wait_for(lambda: recording.seconds > 0, "the disk")
    folder.rename(tmp_path / "elsewhere")
    wait_for(lambda: recording.failure is not None, "the failure")
    recording.close()
    assert f"ERROR {recording.failure}" in log()
    assert log()[-1] == f"INFO recording to {recording.path} has ended: 0.10 s"


def test_what_cannot_be_recorded_is_logged(tmp_path: Path, log: Log) -> None:
    with recorder_to(tmp_path / "take.mp3", tmp_path) as recorder:
        recorder.write(np.zeros((4410, 1), np.float32), SAMPLE_RATE, 0.0)
    assert log() == [f"ERROR {recorder.failure}"]


def test_the_engine_is_silent_unless_somebody_listens() -> None:
    program = "import logging, phonemeengine; logging.getLogger('phonemeengine.live').error('heard by nobody')"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout + done.stderr == ""


def test_where_the_sound_system_calls_back_nothing_is_logged() -> None:
    for name in ("input", "output", "stream"):
        assert not {"logging", "_log"} & set(vars(import_module(f"phonemeengine.audio.{name}")))
