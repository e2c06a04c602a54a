"""What listens and plays for long takes no more than at its beginning, and nobody waits for it."""

from pathlib import Path

import numpy as np
import pytest

from phonemeanalyser.cli.window import DEMO
from tests.devices.programs import HERE, Program
from tests.fakes.virtual_sound import VirtualSound

pytestmark = pytest.mark.long

N_STARTS = 200
SETTLED = 50
"""Starts after which everything that is loaded once is loaded."""

N_LAST = 20
"""A thread of the sound server's library may take a moment to end; what leaks is there after each of the last."""


def test_many_starts_and_stops_leave_nothing_behind_while_a_game_polls(card: VirtualSound, tmp_path: Path) -> None:
    starts = Program(tmp_path, card, HERE / "start_and_stop.py", N_STARTS)
    game = Program(tmp_path, card, HERE / "poll_sound.py", DEMO)
    assert game.end(None) == 0, game.errors
    check_the_game(game)
    for n in range(10, N_STARTS + 1, 10):
        starts.wait_for(lambda n=n: len(starts.log) >= n or starts.process.poll() == 0)
    assert starts.end(None) == 0, starts.errors
    check_the_starts(starts)


def check_the_starts(starts: Program) -> None:
    log = starts.log
    assert len(log) == N_STARTS
    assert all(line["heard"] for line in log)
    settled, last = log[SETTLED], log[-1]
    print(f"after {SETTLED} starts: {settled}; after {N_STARTS}: {last}")
    for what in ("threads", "python_threads", "files"):
        assert min(line[what] for line in log[-N_LAST:]) <= settled[what]
    assert last["memory_kb"] - settled["memory_kb"] < 4000


def check_the_game(game: Program) -> None:
    (seen,) = game.log
    waits = 1000 * np.array(seen["waits"])
    print(
        f"polls: median {np.median(waits):.3f} ms, p99 {np.percentile(waits, 99):.3f} ms, most {waits.max():.2f} ms"
    )
    assert len(set(seen["phonemes"])) > 3
