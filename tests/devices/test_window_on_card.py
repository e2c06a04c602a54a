"""The window on a real sound server that dies while it records, and comes back."""

import time
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from phonemeanalyser.cli.window import DEMO
from tests.devices.programs import HERE, PATIENCE, Program, followed, samples_of
from tests.devices.test_server_trouble import AWAY, SLACK, play
from tests.fakes.virtual_sound import VirtualSound
from tests.waiting import let_pass


def said(program: Program, since: float, true: Callable[[dict[str, Any]], bool]) -> list[dict[str, Any]]:
    """What the window said since a moment and what was so."""
    return [line for line in program.log if line["time"] > since and true(line)]


def wait_for(program: Program, true: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Wait until the window says something, from now on."""
    since = time.monotonic()
    program.wait_for(lambda: said(program, since, true))
    return said(program, since, true)[0]


@pytest.fixture
def window(card: VirtualSound, takes: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Program]:
    """A window that records."""
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    program = Program(takes.parent, card, HERE / "window_on_card.py", takes, DEMO)
    try:
        wait_for(program, lambda line: line["label"].startswith("● ") and line["late_ms"] is not None)
        yield program
    finally:
        program.process.kill()
        program.process.wait(PATIENCE)


def test_the_window_says_what_it_hears_and_how_late_it_is(window: Program, card: VirtualSound, takes: Path) -> None:
    line = wait_for(window, lambda line: bool(line["devices"]) and "Latency" in line["right"])
    assert line["left"].strip().startswith("Microphone: ")
    assert "44 100 Hz" in line["left"]
    lost = line["lost"]
    assert lost < 0.005 or f"{lost:.2f} s lost" in line["right"]
    assert line["banner"] == "" or line["banner"].startswith("The microphone is back: ")
    play(card, window, *takes.glob("*.wav"), 1)
    assert window.end() == 0, window.errors
    assert window.log[-1]["banner"].startswith("Recorded ")


@pytest.mark.long
def test_a_server_that_dies_is_said_and_recording_goes_on_by_itself(
    window: Program, card: VirtualSound, takes: Path
) -> None:
    (take,) = takes.glob("*.wav")
    before = play(card, window, take, 1)
    card.kill()
    killed = time.monotonic()
    trouble = wait_for(
        window, lambda line: line["banner"].endswith("; the recording continues once the signal is back.")
    )
    assert trouble["label"].startswith("waiting ")
    assert trouble["late_ms"] is None
    let_pass(AWAY)
    card.restart()
    restarted = time.monotonic()
    well = wait_for(window, lambda line: line["label"].startswith("● ") and "is back" in line["banner"])
    after = play(card, window, take, 2)
    assert window.end() == 0, window.errors
    lines = said(window, killed, lambda line: line["time"] < well["time"])
    pauses = [b["time"] - a["time"] for a, b in pairwise(lines)]
    print(f"lost {well['lost']:.2f} s, longest pause of the window {max(pauses):.2f} s")
    assert max(pauses) < AWAY  # it did not stand still until the server was there again
    assert restarted - killed - SLACK < well["lost"] < well["time"] - killed + SLACK
    followed(np.concatenate([before, after]), samples_of(take))
