"""Recording from a real sound server: every sample of a minute, and of what was played until a process was killed."""

from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.audio.journal import interrupted_recordings
from tests.devices.conftest import Minute
from tests.devices.programs import (
    PATIENCE,
    SIGNATURE,
    UNSEEN,
    Program,
    counted_in,
    followed,
    pcm_noise,
    place_of,
    recorder,
    samples_of,
    seconds_of,
)
from tests.fakes.virtual_sound import VirtualSound

N_KILLS = 8
LONGEST = 6.0
"""Seconds of sound within which the processes are killed."""
LONG = 120.0
"""Seconds that play until a program has begun, however long that takes."""


@pytest.mark.long
def test_a_killed_program_leaves_all_that_was_on_the_disk(card: VirtualSound, takes: Path) -> None:
    pcm = pcm_noise(takes / "noise.wav", LONGEST + 2, seed=1)
    paths = [takes / f"{k}{'.flac' if k % 2 else '.wav'}" for k in range(N_KILLS)]
    with ThreadPoolExecutor(4) as threads:
        programs = list(threads.map(lambda path: recorder(takes, card, path), paths))
    player = card.play_into_microphone(takes / "noise.wav")
    lengths = np.sort(np.random.default_rng(3).uniform(0.5, LONGEST, N_KILLS))
    on_disk = [kill(*each) for each in zip(programs, paths, lengths, strict=True)]
    player.kill()
    player.wait(PATIENCE)
    offered = {recording.path: recording.seconds for recording in interrupted_recordings(card.journal)}
    assert set(offered) == set(paths)
    for path, seconds in zip(paths, on_disk, strict=True):
        assert seconds_of(path) == offered[path] >= seconds
        followed(pcm, samples_of(path))


def kill(program: Program, path: Path, seconds: float) -> float:
    """Kill a program once it has recorded so much on the disk, and give how much it was just before."""
    program.wait_for(lambda: path.exists() and seconds_of(path) > seconds)
    on_disk = seconds_of(path)
    program.process.kill()
    program.process.wait(PATIENCE)
    return on_disk


def test_the_first_sound_of_a_running_microphone_is_recorded_at_once(card: VirtualSound, takes: Path) -> None:
    pcm = pcm_noise(takes / "noise.wav", LONG, seed=2)
    player = card.play_into_microphone(takes / "noise.wav")
    program = recorder(takes, card, takes / "take.wav", "--seconds", "1.5")
    assert program.end(None) == 0
    player.kill()
    player.wait(PATIENCE)
    recorded = samples_of(takes / "take.wav")
    counted = counted_in(program.errors[-1])
    assert 1.5 - counted - UNSEEN < len(recorded) / 44_100 <= 1.5 + 1 / 44_100
    heard = recorded[int(np.flatnonzero(recorded)[0]) :]
    assert len(heard) > 44_100
    assert followed(pcm[place_of(heard[:SIGNATURE], pcm) :], heard).skipped <= counted + UNSEEN


@pytest.mark.long
def test_a_minute_is_recorded_sample_by_sample_but_for_what_is_counted_as_lost(minute: Future[Minute]) -> None:
    done = minute.result()
    assert done.codes == [0, 0]
    for path, said in zip(done.takes, done.said, strict=True):
        print(said)
        assert followed(done.pcm, samples_of(path)).missing <= counted_in(said) + UNSEEN
