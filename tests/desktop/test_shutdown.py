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


@pytest.mark.parametrize("way", ["frame", "busy"])
def test_it_ends_cleanly_after_edits_every_time(tmp_path, way):
    assert run(tmp_path, way, "demo.flac") == (0, [])
    (log,) = [path.read_text() for path in tmp_path.rglob("phonemeanalyser.log")]
    assert "ERROR" not in log
    assert "Traceback" not in log


def test_a_user_who_discards_his_edits_finds_page_docks_and_sound_again_but_no_edits(tmp_path):
    assert run(tmp_path, "menu", CARDS.name, CARDS) == (0, [])
    seen = seen_at_the_next_start(tmp_path)
    assert seen["page"] == CALIBRATE
    assert "Filters" in seen["docks"]
    assert CLOSED not in seen["docks"]
    assert (seen["modified"], seen["banner"]) == (False, "")


def test_a_signal_ends_it_at_once_and_page_docks_sound_and_edits_come_back(tmp_path):
    kept = []
    for way in ("SIGTERM", "SIGINT", "SIGHUP"):
        home = tmp_path / way
        assert run(home, way, CARDS.name, CARDS) == (0, [])
        files = [*home.rglob("unsaved-*.toml"), *home.rglob("*.conf"), *home.rglob("*.ini")]
        kept.append({path.name: path.read_text().replace(str(home), "") for path in files})
        assert len(kept[-1]) > 1
    assert kept[0] == kept[1] == kept[2]
    seen = seen_at_the_next_start(tmp_path / "SIGTERM")
    assert seen["page"] == CALIBRATE
    assert "Filters" in seen["docks"]
    assert CLOSED not in seen["docks"]
    assert seen["modified"]
    assert "were restored from the last session" in seen["banner"]
    assert seen["offer"] == "Discard Changes"


def test_edits_outlive_a_program_that_is_killed(tmp_path):
    assert run(tmp_path, "kill", CARDS.name, CARDS) == (-signal.SIGKILL, [])
    seen = seen_at_the_next_start(tmp_path)
    assert seen["modified"]
    assert seen["page"] == CALIBRATE
    assert seen_at_the_next_start(tmp_path)["switches"] != seen["switches"]  # they were discarded since
