"""The real program is left as a user leaves it: by the menu, and by the window's frame."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import pytest

PATIENCE = 120
"""Seconds after which a program that does not end hangs, also on a busy machine."""
AT_ONCE = 4


def edit_and_quit(home: Path, way: str) -> tuple[int, list[str]]:
    """Run the program at the hands of `edit_and_quit`; gives its exit code, and what it said."""
    home.mkdir()
    places = {name: str(home / name) for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    ended = subprocess.run(
        [sys.executable, "-m", "tests.desktop.edit_and_quit", way], timeout=PATIENCE, capture_output=True, text=True,
        env={**os.environ, "HOME": str(home), "QT_QPA_PLATFORM": "offscreen", **places}, check=False,
    )  # fmt: skip
    said = (ended.stdout + ended.stderr).splitlines()
    return ended.returncode, [line for line in said if "propagateSizeHints" not in line]


@pytest.mark.parametrize("way", ["menu", "frame"])
def test_it_ends_cleanly_after_edits_every_time(tmp_path, way):
    homes = [tmp_path / str(k) for k in range(10)]
    with ThreadPoolExecutor(AT_ONCE) as pool:
        ends = list(pool.map(partial(edit_and_quit, way=way), homes))
    assert ends == [(0, [])] * 10
    assert list(tmp_path.rglob("*.log")) == []
