"""Playing on a real sound server: a virtual sound card, and what comes out of it."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from tests.devices.programs import followed
from tests.fakes.virtual_sound import VirtualSound
from tests.sounds import noise
from tests.waiting import let_pass

DRIVER = Path(__file__).with_name("play_on_card.py")
SECONDS = 3.0
TRIES = 5
BLOCK = 0.02
"""Seconds of sound that are written at a time."""


def play(path: Path, sound: VirtualSound) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, str(DRIVER), str(path)],
        env=sound.environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict, np.ndarray, np.ndarray]:
    """What the player saw, what the speaker gave, and what was in the file; again where a busy card came too late."""
    pcm = np.clip(noise(SECONDS, 0.1) * 32767, -32768, 32767).astype(np.int16)
    for _ in range(TRIES):
        seen, heard = play_once(tmp_path_factory.mktemp("card"), pcm)
        if followed(pcm.astype(np.int64), heard).missing == 0:
            break
    return seen, heard, pcm


def play_once(folder: Path, pcm: np.ndarray) -> tuple[dict, np.ndarray]:
    soundfile.write(folder / "noise.wav", pcm, 44_100)
    with VirtualSound() as sound:
        recorder = sound.record_speaker(folder / "heard.wav")
        let_pass(0.3)
        player = play(folder / "noise.wav", sound)
        out, errors = player.communicate(timeout=240)
        let_pass(1.0)
        recorder.terminate()
        recorder.wait(60)
    assert player.returncode == 0, errors
    heard = np.fromfile(folder / "heard.wav", np.int16, offset=44).reshape(-1, 2)[:, 0]
    return json.loads(out.splitlines()[-1]), heard.astype(np.int64)


def test_the_sound_card_is_found_and_everything_is_heard(played):
    seen, _, _ = played
    assert seen["card"]
    assert seen["finished"]
    assert seen["dropped"] == 0
    assert seen["frames"] == list(range(len(seen["frames"])))
    assert len(seen["frames"]) == round(SECONDS * 100)


def test_what_comes_out_of_the_speaker_is_the_file_bit_by_bit(played):
    _, heard, pcm = played
    assert followed(pcm.astype(np.int64), heard).missing == 0


def test_the_picture_follows_the_stream_not_the_arrival_of_blocks(played):
    seen, _, _ = played
    times, positions = np.array(seen["seen"]).T
    moving = (positions > 0.2) & (positions < SECONDS - 0.2)
    assert np.all(np.diff(positions) >= -1e-9)
    behind = np.abs(np.diff(times[moving]) - np.diff(positions[moving]))
    assert np.median(behind) < BLOCK / 10  # from look to look it goes on as time does, not from block to block
    assert seen["early"] == 0


def test_a_frame_is_handed_out_when_its_middle_is_heard(played):
    late = np.array(played[0]["late"])
    assert late.min() > -0.001
    print(f"median {1000 * np.median(late):.1f} ms late")


def test_a_server_that_dies_leaves_the_picture_going_on_without_sound(tmp_path):
    soundfile.write(tmp_path / "noise.wav", noise(SECONDS, 0.1), 44_100)
    with VirtualSound() as sound:
        player = play(tmp_path / "noise.wav", sound)
        let_pass(1.8)
        sound.kill()
        out, errors = player.communicate(timeout=240)
    assert player.returncode == 0, errors
    seen = json.loads(out.splitlines()[-1])
    assert seen["finished"]
    assert not seen["card"]
    assert sorted(set(seen["frames"])) == list(range(round(SECONDS * 100)))
