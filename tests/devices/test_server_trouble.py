"""A sound server that dies, comes back, or stands still, while a microphone is recorded."""

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from engine.audio.files import SoundReader
from tests.devices.programs import Program, Samples, listener, pcm_noise, place_of, samples_of
from tests.virtual_sound import VirtualSound

SECONDS = 1.5
"""Length of the noises that are played before the trouble and after it."""
QUICK = 1.0
"""Seconds within which trouble must be seen."""
SOON = 3.0
"""Seconds within which all must be well again once the server is."""


def play(card: VirtualSound, folder: Path, seed: int) -> Samples:
    """Have the microphone hear a noise, to its end."""
    path = folder / f"noise {seed}.wav"
    pcm = pcm_noise(path, SECONDS, seed)
    assert card.play_into_microphone(path).wait(30) == 0
    time.sleep(0.6)
    return pcm


def looks(program: Program, since: float, listening: bool) -> list[dict[str, Any]]:
    """What the program said since a moment, while it was listening or while it was not."""
    return [line for line in program.log if line.get("time", 0.0) > since and line["listening"] is listening]


def check_whole(pcm: Samples, recorded: Samples) -> int:
    """Every sample of a noise is in a recording, none twice; gives its place."""
    place = place_of(pcm, recorded)
    assert np.array_equal(recorded[place : place + len(pcm)], pcm)
    return place


def away(program: Program, since: float) -> float:
    """Wait until the program says that nothing comes, and give how long after a moment it did."""
    program.wait_for(lambda: looks(program, since, listening=False))
    return float(looks(program, since, listening=False)[0]["time"]) - since


def back(program: Program, since: float) -> float:
    """Wait until the program says that it listens again, and give how long after a moment it did."""
    program.wait_for(lambda: looks(program, since, listening=True))
    return float(looks(program, since, listening=True)[0]["time"]) - since


def finish(program: Program, take: Path) -> tuple[Samples, float]:
    """End the program; its recording, and what it counted as lost."""
    assert program.end() == 0, program.errors
    assert all(line["failure"] is None for line in program.log[:-1])
    return samples_of(take), float(program.log[-1]["lost"])


def test_a_server_that_dies_ends_nothing_and_recording_goes_on_when_it_is_back(
    card: VirtualSound, takes: Path
) -> None:
    take = takes / "take.wav"
    program = listener(takes, card, take)
    before = play(card, takes, 1)
    card.kill()
    killed = time.monotonic()
    seen = away(program, killed)
    time.sleep(1.5)
    with SoundReader(take) as reader:
        assert reader.duration > SECONDS
    check_whole(before, samples_of(take))
    assert not looks(program, killed + seen, listening=True)
    card.restart()
    restarted = time.monotonic()
    again = back(program, restarted)
    gap = restarted + again - killed
    after = play(card, takes, 2)
    recorded, lost = finish(program, take)
    print(f"seen after {seen:.2f} s, back {again:.2f} s after the restart; gap {gap:.2f} s, lost {lost:.2f} s")
    assert seen < QUICK
    assert again < SOON
    assert abs(lost - gap) < max(0.3, 0.1 * gap)
    assert check_whole(before, recorded) < check_whole(after, recorded)


@pytest.mark.parametrize("seconds", [1.0, 5.0])
def test_a_suspended_microphone_is_told_of_and_goes_on(seconds: float, card: VirtualSound, takes: Path) -> None:
    take = takes / "take.wav"
    program = listener(takes, card, take)
    before = play(card, takes, 1)
    card.suspend_microphone(True)
    suspended = time.monotonic()
    seen = away(program, suspended)
    words = looks(program, suspended, listening=False)[0]["words"]
    time.sleep(max(0.0, suspended + seconds - time.monotonic()))
    card.suspend_microphone(False)
    resumed = time.monotonic()
    again = back(program, resumed)
    gap = resumed - suspended
    after = play(card, takes, 2)
    time.sleep(1.5)
    recorded, lost = finish(program, take)
    print(f"{words!r} after {seen:.2f} s, back after {again:.2f} s; gap {gap:.2f} s, lost {lost:.2f} s")
    assert "nothing comes from" in words
    assert seen < QUICK
    assert again < SOON
    assert gap - 0.2 < lost < gap + again + 0.3
    assert check_whole(before, recorded) < check_whole(after, recorded)


def test_what_could_not_be_heard_is_counted_to_a_few_milliseconds(card: VirtualSound, takes: Path) -> None:
    def trouble(_program: Program) -> None:
        card.suspend_microphone(True)
        time.sleep(0.8)
        card.suspend_microphone(False)

    missing, lost = missing_and_lost(card, takes, trouble)
    assert missing > 0.5
    assert abs(lost - missing) < 0.01


def test_a_process_that_stood_still_hears_on_or_counts_what_it_lost(card: VirtualSound, takes: Path) -> None:
    def trouble(program: Program) -> None:
        os.kill(program.process.pid, signal.SIGSTOP)
        time.sleep(1.5)
        os.kill(program.process.pid, signal.SIGCONT)

    missing, lost = missing_and_lost(card, takes, trouble)
    assert abs(lost - missing) < 0.01


def missing_and_lost(card: VirtualSound, takes: Path, trouble: Callable[[Program], None]) -> tuple[float, float]:
    """Have trouble while a noise is heard; how much of it the recording lacks, and how much was counted as lost."""
    take, path = takes / "take.wav", takes / "noise.wav"
    program = listener(takes, card, take)
    pcm = pcm_noise(path, 6.0, 1)
    player = card.play_into_microphone(path)
    time.sleep(1.5)
    trouble(program)
    assert player.wait(30) == 0
    time.sleep(0.6)
    recorded, lost = finish(program, take)
    n_before = n_alike(recorded[place_of(pcm, recorded) :], pcm)
    n_after = n_alike(recorded[::-1][place_of(pcm[::-1], recorded[::-1]) :], pcm[::-1])
    missing = max(0, len(pcm) - n_before - n_after) / 44_100
    print(f"missing in the recording: {missing:.4f} s, counted as lost: {lost:.4f} s")
    return missing, lost


def n_alike(one: Samples, other: Samples) -> int:
    """How many samples are the same from the beginning on."""
    n = min(len(one), len(other))
    different = np.flatnonzero(one[:n] != other[:n])
    return int(different[0]) if len(different) else n
