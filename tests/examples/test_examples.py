"""The examples run as they are."""

import json
import os
import re
import runpy
import subprocess
import sys
from itertools import pairwise
from pathlib import Path

import pytest
import soundfile

from phonemeanalyser.server.service import ServerSettings
from phonemeengine import cues, load_preset
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import ROOT, SPEECH
from tests.server.servers import served

EXAMPLES = ROOT / "examples"
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
GAME = {"SDL_VIDEODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "1"}
"""No window, and no greeting."""
BROKEN = 'raise OSError("PortAudio library not found")'


def run(program: str, *words: object, code: int = 0, **environment: str) -> list[str]:
    """Run an example to its end; the lines that it prints, on standard error where it fails."""
    done = subprocess.run(
        [sys.executable, str(EXAMPLES / program), *map(str, words)],
        env=os.environ | environment,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == code, done.stderr
    return (done.stderr if code else done.stdout).splitlines()


def printed(capsys: pytest.CaptureFixture[str], program: str, *words: object) -> list[str]:
    """Run what an example does in this process; the lines that it prints."""
    capsys.readouterr()
    runpy.run_path(str(EXAMPLES / program))["main"](*map(str, words))
    return capsys.readouterr().out.splitlines()


def test_each_program_is_tried_here_or_on_a_sound_card() -> None:
    tried = Path(__file__).read_text() + (ROOT / "tests" / "devices" / "test_example_on_card.py").read_text()
    programs = [
        path.relative_to(EXAMPLES).as_posix() for path in EXAMPLES.rglob("*.py") if "__main__" in path.read_text()
    ]
    assert len(programs) == 7
    assert [name for name in programs if f'"{name}"' not in tried] == []


def test_samples_that_are_pushed_say_what_the_sound_says(capsys: pytest.CaptureFixture[str]) -> None:
    lines = printed(capsys, "push_samples.py", DEMO)
    words = [line.split()[-1] for line in lines]
    assert (words[0], *words[2:4]) == ("silence", "i", "sz")  # "She s..."
    assert words[1] in {"sch", "sz"}
    assert all(re.fullmatch(r" *\d+\.\d\d s  [a-z]+", line) for line in lines)
    assert all(one != other for one, other in pairwise(words))


def test_a_face_opens_its_mouth_for_speech_and_shuts_it_for_silence(capsys: pytest.CaptureFixture[str]) -> None:
    moved = [line.count("#") for line in printed(capsys, "drive_face.py", DEMO)]
    assert 115 <= len(moved) <= 119  # ten lines a second
    assert max(moved) > 10
    assert moved[-1] <= 1


def test_every_sound_of_a_folder_gets_the_cues_that_rhubarb_would_write(
    sound: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (sound.parent / "notes.txt").write_text("no sound")
    target = sound.with_suffix(".json")
    assert printed(capsys, "rhubarb_folder.py", sound.parent) == [str(target)]
    written = [cue["value"] for cue in json.loads(target.read_text())["mouthCues"]]
    assert set(written) <= {cue.shape for cue in cues(sound, load_preset("learned"), "rhubarb")}
    assert len(written) > 2


def test_a_recogniser_of_one_s_own_says_why() -> None:
    lines = [line.split() for line in run("own_recogniser/phonemeanalyser_loudness.py", DEMO)]
    assert {line[2] for line in lines} == {"silence", "a"}
    for _, _, phoneme, energy, limit in lines[1:]:
        assert phoneme == ("a" if float(energy) > float(limit) else "silence")


def test_a_server_is_asked_what_a_sound_says(sound: Path) -> None:
    with served(ServerSettings(port=0)) as address:
        words = [line.split() for line in run("ask_server.py", sound, address)]
        assert {line[2] for line in words} > {"silence", "a"}
        assert all(one[2] != other[2] for one, other in pairwise(words))
        sound.write_bytes(b"")
        run("ask_server.py", sound, address, code=1)


def test_a_mouth_moves_in_a_game_loop(tmp_path: Path) -> None:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE)
    (*_, last) = run("pygame_mouth.py", tmp_path / "speech.wav", **GAME)
    assert re.fullmatch(r"the jaw was open by [1-9]\d?% at most", last)


def test_without_portaudio_the_microphone_s_program_says_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "sounddevice.py").write_text(BROKEN)
    path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    said = run("poll_microphone.py", code=1, PYTHONPATH=path)
    assert said == ["audio cannot be played or recorded, since PortAudio is missing or broken; install libportaudio2"]


@pytest.mark.parametrize("program", ["push_samples.py", "pygame_mouth.py"])
def test_a_sound_that_is_not_there_is_one_sentence(program: str) -> None:
    assert run(program, "missing.wav", code=1, **GAME) == [
        "missing.wav: there is no such file; check its name and folder"
    ]
