"""A sound server that dies, comes back, or stands still, while a microphone is recorded."""

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from phonemeengine.audio.files import SoundReader
from tests.devices.programs import (
    PATIENCE,
    SETTLED,
    UNSEEN,
    Program,
    Samples,
    followed,
    listener,
    pcm_noise,
    samples_of,
)
from tests.fakes.virtual_sound import VirtualSound
from tests.waiting import let_pass

SECONDS = 1.0
"""Length of the noises that are played before the trouble and after it."""
AWAY = 2.0
"""Seconds for which a server stays away."""
SLACK = 0.8
"""Seconds by which the moments that a busy machine tells may be wrong."""
CLOSE = 0.1
"""Seconds by which a loss may be counted wrongly on a busy machine; `test_loss` knows how exactly it is counted."""


def play(card: VirtualSound, program: Program, take: Path, seed: int) -> Samples:
    """Have the microphone hear a noise to its end; all of it is in the take, but for what is counted as lost."""
    path, lost = take.with_name(f"noise {seed}.wav"), program.log[-1]["lost"]
    pcm = pcm_noise(path, SECONDS, seed)
    before = len(samples_of(take))
    assert card.play_into_microphone(path).wait(PATIENCE) == 0
    settled = time.monotonic() + SETTLED

    def arrived() -> bool:
        return followed(pcm, samples_of(take)[before:]).missing == 0 or program.log[-1]["time"] > settled

    program.wait_for(arrived)
    assert followed(pcm, samples_of(take)[before:]).missing <= program.log[-1]["lost"] - lost + UNSEEN
    return pcm


def looks(program: Program, since: float, listening: bool) -> list[dict[str, Any]]:
    """What the program said since a moment, while it was listening or while it was not."""
    return [line for line in program.log if line.get("time", 0.0) > since and line["listening"] is listening]


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


@pytest.mark.parametrize("seconds", [1.0, pytest.param(5.0, marks=pytest.mark.long)])
def test_recording_goes_on_after_a_microphone_was_suspended_and_after_its_server_died(
    seconds: float, card: VirtualSound, takes: Path
) -> None:
    take = takes / "take.wav"
    program = listener(takes, card, take)
    heard = [play(card, program, take, 1)]
    card.suspend_microphone(True)
    suspended = time.monotonic()
    seen = away(program, suspended)
    words = looks(program, suspended, listening=False)[0]["words"]
    assert "no signal from" in words
    let_pass(max(0.0, suspended + seconds - time.monotonic()))
    card.suspend_microphone(False)
    resumed = time.monotonic()
    again = back(program, resumed)
    heard.append(play(card, program, take, 2))
    program.wait_for(lambda: program.log[-1]["time"] > resumed + again + SETTLED)
    lost = float(program.log[-1]["lost"])
    print(f"{words!r} after {seen:.2f} s, back after {again:.2f} s; lost {lost:.2f} s")
    assert resumed - suspended - SLACK < lost < resumed - suspended + again + SLACK
    card.kill()
    killed = time.monotonic()
    seen = away(program, killed)
    let_pass(AWAY)
    with SoundReader(take) as reader:
        assert reader.duration > 2 * SECONDS
    assert not looks(program, killed + seen, listening=True)
    card.restart()
    restarted = time.monotonic()
    again = back(program, restarted)
    heard.append(play(card, program, take, 3))
    recorded, lost_in_all = finish(program, take)
    print(f"seen after {seen:.2f} s, back {again:.2f} s after the restart; lost {lost_in_all - lost:.2f} s")
    assert restarted - killed - SLACK < lost_in_all - lost < restarted - killed + again + SLACK
    followed(np.concatenate(heard), recorded)


@pytest.mark.long
def test_what_could_not_be_heard_is_counted(card: VirtualSound, takes: Path) -> None:
    def trouble(_program: Program) -> None:
        card.suspend_microphone(True)
        let_pass(0.8)
        card.suspend_microphone(False)

    missing, lost = missing_and_lost(card, takes, trouble)
    assert missing > 0.5
    assert abs(lost - missing) < CLOSE


@pytest.mark.long
def test_a_process_that_stood_still_hears_on_or_counts_what_it_lost(card: VirtualSound, takes: Path) -> None:
    def trouble(program: Program) -> None:
        os.kill(program.process.pid, signal.SIGSTOP)
        let_pass(1.5)
        os.kill(program.process.pid, signal.SIGCONT)

    missing, lost = missing_and_lost(card, takes, trouble)
    assert abs(lost - missing) < CLOSE


def missing_and_lost(card: VirtualSound, takes: Path, trouble: Callable[[Program], None]) -> tuple[float, float]:
    """Have trouble while a noise is heard; how much of it the recording lacks, and how much was counted as lost."""
    take, path = takes / "take.wav", takes / "noise.wav"
    program = listener(takes, card, take)
    pcm = pcm_noise(path, 6.0, 1)
    player = card.play_into_microphone(path)
    program.wait_for(lambda: np.count_nonzero(samples_of(take)) > 44_100)
    trouble(program)
    assert player.wait(PATIENCE) == 0
    let_pass(SETTLED)
    recorded, lost = finish(program, take)
    missing = followed(pcm, recorded).missing
    print(f"missing in the recording: {missing:.4f} s, counted as lost: {lost:.4f} s")
    return missing, lost
