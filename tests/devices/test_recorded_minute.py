"""Recording from a real sound server: every sample of a minute, and of what was played until a process was killed."""

import time
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import numpy as np

from engine.audio.files import SoundReader
from engine.audio.journal import unfinished
from tests.devices.conftest import Minute
from tests.devices.programs import SIGNATURE, Program, Samples, pcm_noise, place_of, recorder, samples_of
from tests.virtual_sound import VirtualSound

N_KILLS = 20
LONGEST = 6.0
"""Seconds of sound within which the processes are killed."""


def test_what_a_killed_program_recorded_lacks_at_most_the_last_second(card: VirtualSound, takes: Path) -> None:
    pcm = pcm_noise(takes / "noise.wav", LONGEST + 2, seed=1)
    paths = [takes / f"{k}{'.flac' if k % 2 else '.wav'}" for k in range(N_KILLS)]
    with ThreadPoolExecutor(4) as threads:
        programs = list(threads.map(lambda path: recorder(takes, card, path), paths))
    began = time.monotonic()
    player = card.play_into_microphone(takes / "noise.wav")
    moments = np.sort(np.random.default_rng(3).uniform(0.5, LONGEST, N_KILLS))
    killed = [kill(program, began + moment) - began for program, moment in zip(programs, moments, strict=True)]
    player.kill()
    player.wait(5)
    kept = [seconds_kept(path, pcm) for path in paths]
    offered = {recording.path: recording.seconds for recording in unfinished(card.journal)}
    assert set(offered) == set(paths)
    for path in paths:
        with SoundReader(path) as reader:
            assert reader.duration == offered[path]
    lacking = np.array(killed) - kept
    print(
        f"lacking at {N_KILLS} kills: {lacking.min():.2f}..{lacking.max():.2f} s, median {np.median(lacking):.2f} s"
    )
    assert lacking.max() <= 1


def kill(program: Program, moment: float) -> float:
    """Kill a program at a moment, and give the moment."""
    time.sleep(max(0.0, moment - time.monotonic()))
    program.process.kill()
    moment = time.monotonic()
    program.process.wait(5)
    return moment


def seconds_kept(path: Path, pcm: Samples) -> float:
    """How much of the noise a recording holds, all of which must be right."""
    recorded = samples_of(path)
    if not np.any(recorded):
        return 0.0
    place = int(np.flatnonzero(recorded)[0])
    kept = recorded[place:]
    assert not np.any(recorded[:place])
    assert np.array_equal(kept, pcm[: len(kept)])
    return len(kept) / 44_100


def test_the_first_sound_of_a_running_microphone_is_recorded_at_once(card: VirtualSound, takes: Path) -> None:
    pcm = pcm_noise(takes / "noise.wav", 4.0, seed=2)
    player = card.play_into_microphone(takes / "noise.wav")
    program = recorder(takes, card, takes / "take.wav", "--seconds", "1.5")
    assert program.end(None) == 0
    player.kill()
    player.wait(5)
    recorded = samples_of(takes / "take.wav")
    assert abs(len(recorded) - round(1.5 * 44_100)) <= 1
    heard = recorded[int(np.flatnonzero(recorded)[0]) :]
    place = place_of(heard[:SIGNATURE], pcm)
    assert np.array_equal(heard, pcm[place : place + len(heard)])


def test_a_minute_is_recorded_sample_by_sample(minute: Future[Minute]) -> None:
    done = minute.result()
    assert done.codes == [0, 0]
    for path, said in zip(done.takes, done.said, strict=True):
        recorded = samples_of(path)
        place = place_of(done.pcm, recorded)
        assert np.array_equal(recorded[place : place + len(done.pcm)], done.pcm)
        assert not np.any(recorded[:place])
        assert not np.any(recorded[place + len(done.pcm) :])
        print(said)
        assert said.endswith("nothing lost")
