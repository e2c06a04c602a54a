"""The real program ends: by its user, by the system, by a crash; what was there comes back, or was asked about."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.desktop.edit_and_quit import CALIBRATE, CLOSED
from tests.desktop.hands import CARDS

PATIENCE = 120
"""Seconds after which a program that does not end hangs, also on a busy machine."""


def run(home: Path, way: str, sound: str, *words: object) -> tuple[int, list[str]]:
    """Run the program at the hands of `edit_and_quit`; gives its exit code, and what it said."""
    home.mkdir(exist_ok=True)
    places = {name: str(home / name) for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    ended = subprocess.run(
        [sys.executable, "-m", "tests.desktop.edit_and_quit", way, sound, *map(str, words)],
        env={**os.environ, "HOME": str(home), "QT_QPA_PLATFORM": "offscreen", **places},
        timeout=PATIENCE,
        capture_output=True,
        text=True,
        check=False,
    )
    said = (ended.stdout + ended.stderr).splitlines()
    return ended.returncode, [line for line in said if "propagateSizeHints" not in line]


def seen_at_the_next_start(home: Path) -> dict[str, Any]:
    """Start once more, with the sound of the last time, and give what the window shows."""
    code, said = run(home, "look", CARDS.name)
    assert (code, len(said)) == (0, 1), said
    shown: dict[str, Any] = json.loads(said[0])
    return shown


@pytest.mark.parametrize(
    "ways", [("SIGTERM",), pytest.param(("SIGTERM", "SIGINT", "SIGHUP"), marks=pytest.mark.long)]
)
def test_a_signal_ends_it_at_once_and_page_docks_sound_and_edits_come_back(tmp_path, ways):
    kept = []
    for way in ways:
        home = tmp_path / way
        assert run(home, way, CARDS.name, CARDS) == (0, [])
        files = [*home.rglob("unsaved-*.toml"), *home.rglob("*.conf"), *home.rglob("*.ini")]
        kept.append({path.name: path.read_text().replace(str(home), "") for path in files})
        assert len(kept[-1]) > 1
    assert all(each == kept[0] for each in kept)
    seen = seen_at_the_next_start(tmp_path / "SIGTERM")
    assert (seen["modified"], seen["offer"], seen["page"]) == (True, "Discard Changes", CALIBRATE)
    assert "were restored from the last session" in seen["banner"]
    again = seen_at_the_next_start(tmp_path / "SIGTERM")  # the edits were discarded since, by the question at the end
    assert (again["modified"], again["banner"]) == (False, "")
    assert again["switches"] != seen["switches"]
    for each in (seen, again):
        assert "Filters" in each["docks"]
        assert CLOSED not in each["docks"]
    (log,) = [path.read_text() for path in (tmp_path / "SIGTERM").rglob("phonemeanalyser.log")]
    assert "ERROR" not in log
    assert "Traceback" not in log


@pytest.mark.long
def test_edits_outlive_a_program_that_is_killed(tmp_path):
    assert run(tmp_path, "kill", CARDS.name, CARDS) == (-signal.SIGKILL, [])
    seen = seen_at_the_next_start(tmp_path)
    assert (seen["modified"], seen["page"]) == (True, CALIBRATE)
