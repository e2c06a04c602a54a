"""`phonemeanalyser listen` and `phonemeanalyser record` as a shell uses them."""

import json
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.cli.window import DEMO
from phonemeengine.audio.wav import HEADER
from tests.devices.programs import PATIENCE, SETTLED, Program, counted_in, recorder, samples_of
from tests.fakes.virtual_sound import VirtualSound
from tests.waiting import let_pass

SENTENCE = "phonemeanalyser: "
LOUD = 100
"""Samples beyond are speech, of 32768."""


def refusal_of(program: Program) -> str:
    """The one sentence with which a program ends that could not do its work."""
    assert program.end(None) == 1
    assert program.out == []
    (sentence,) = program.errors
    assert sentence.startswith(SENTENCE)
    assert ". " not in sentence
    return sentence


def commands(folder: Path) -> list[list[str]]:
    return [["listen"], ["listen", "--list-devices"], ["record", str(folder / "take.wav")]]


def test_without_any_device_each_command_ends_with_one_sentence(card: VirtualSound, takes: Path) -> None:
    card.kill()
    programs = [Program(takes, card, "-m", "phonemeanalyser", *words) for words in commands(takes)]
    for program in programs:
        assert "no microphone was found" in refusal_of(program)
    assert not (takes / "take.wav").exists()


def test_an_unknown_device_is_refused_with_those_that_are_there(card: VirtualSound, takes: Path) -> None:
    words = ["record", str(takes / "take.wav"), "--device", "Grammophon"]
    sentence = refusal_of(Program(takes, card, "-m", "phonemeanalyser", *words))
    assert "'Grammophon' is not connected" in sentence
    assert "default · ALSA" in sentence
    assert not (takes / "take.wav").exists()


def test_a_channel_that_a_device_lacks_is_refused(card: VirtualSound, takes: Path) -> None:
    program = Program(takes, card, "-m", "phonemeanalyser", "listen", "--channel", "999")
    assert program.end(None) in {1, 2}
    assert "999" in program.errors[-1]
    assert not any("Traceback" in line for line in program.errors)


@pytest.mark.long
def test_a_text_is_heard_to_its_end_on_a_card_that_sleeps(tmp_path: Path) -> None:
    words = ["-m", "phonemeanalyser", "speak", "The first sentence is heard. And so is the second one.", "--language"]
    spoken = tmp_path / "spoken.wav"
    with VirtualSound(sleepy=True) as card:
        assert Program(tmp_path, card, *words, "en-us", "-o", spoken).end(None) == 0
        recording = card.record_speaker(tmp_path / "heard.wav")
        for _ in range(3):  # it sleeps for up to 2 s, and sometimes hardly
            speak = Program(tmp_path, card, *words, "en-us")
            assert speak.end(None) == 0, speak.errors
            assert speak.out == ["The first sentence is heard.", "And so is the second one."]
        let_pass(SETTLED)  # until the recorder has taken everything
        recording.terminate()
        recording.wait(PATIENCE)
    heard = np.fromfile(tmp_path / "heard.wav", np.int16, offset=44).reshape(-1, 2)[:, 0]
    n_spoken = np.count_nonzero(np.abs(soundfile.read(spoken, dtype="int16")[0]) > LOUD)
    assert np.count_nonzero(np.abs(heard) > LOUD) == pytest.approx(3 * n_spoken, rel=0.02)


def test_a_text_that_no_card_plays_is_refused(card: VirtualSound, takes: Path) -> None:
    card.kill()
    assert "name it with -o" in refusal_of(Program(takes, card, "-m", "phonemeanalyser", "speak", "你好"))


def test_a_signal_ends_listening_and_recording_in_good_order(card: VirtualSound, takes: Path) -> None:
    listen = Program(takes, card, "-m", "phonemeanalyser", "listen")
    take = takes / "take.wav"
    record = recorder(takes, card, take, "--phonemes")
    listen.wait_for(lambda: listen.out)
    record.wait_for(lambda: take.exists() and take.stat().st_size > HEADER + 3 * 5000)
    assert listen.end(signal.SIGTERM) == record.end(signal.SIGINT) == 0
    assert len(samples_of(take)) > 4410
    assert (takes / "take.csv").read_text().count("\n") >= 2
    assert counted_in(record.errors[-1]) >= 0
    assert all(line.startswith(SENTENCE) for line in listen.errors)
    assert not list(card.journal.glob("*"))


def test_a_reader_that_leaves_ends_listening_without_noise(card: VirtualSound, tmp_path: Path) -> None:
    listen = subprocess.Popen(
        [sys.executable, "-m", "phonemeanalyser", "listen", "--format", "json"],
        env=card.environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert listen.stdout is not None
    assert listen.stderr is not None
    with listen:
        first = json.loads(listen.stdout.readline())
        listen.stdout.close()
        card.play_into_microphone(speech(tmp_path)).wait(PATIENCE)
        assert listen.wait(PATIENCE) == 0
        said = listen.stderr.read().splitlines()
    assert set(first) == {"time_s", "phoneme", "intensity", "confidence", "latency_ms"}
    assert all(line.startswith(SENTENCE) for line in said)


def speech(folder: Path) -> Path:
    """Two seconds of the demo, as a file that the sound server plays."""
    samples, rate = soundfile.read(DEMO, dtype="int16", stop=2 * 44_100)
    soundfile.write(folder / "speech.wav", samples, rate)
    return folder / "speech.wav"
