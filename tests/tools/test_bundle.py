"""The parts of ``make bundle`` that need no minutes; the workflow ``release`` runs the whole program."""

import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT
from tools.bundle.making import SIZE, pack, write_icon

START = ROOT / "tools" / "bundle" / "start.py"


def run(*words: str) -> str:
    return subprocess.run([sys.executable, str(START), *words], capture_output=True, text=True, check=True).stdout


@pytest.mark.usefixtures("qapp")
def test_the_icon_is_as_large_as_it_says(tmp_path):
    from PySide6.QtGui import QImage

    write_icon(tmp_path / "icon.png")
    picture = QImage(str(tmp_path / "icon.png"))
    assert (picture.width(), picture.height()) == (SIZE, SIZE)
    assert picture.pixelColor(2, 2).alpha() == 0
    assert picture.pixelColor(SIZE // 2, 60).alpha() == 255


def test_a_bundled_program_runs_commands_and_as_python_does_code():
    assert run("--version").startswith("phonemeanalyser ")
    assert run("-c", "import sys; print(__name__, sys.argv)", "a") == "__main__ ['-c', 'a']\n"


@pytest.mark.skipif(sys.platform != "linux", reason="the archive of Linux")
def test_two_archives_of_the_same_folder_have_the_same_bytes(tmp_path):
    for name in ("one", "two"):
        folder = tmp_path / name / "program"
        (folder / "inner").mkdir(parents=True)
        (folder / "run").write_text("#!/bin/sh\n")
        (folder / "run").chmod(0o755)
        (folder / "inner" / "library").write_bytes(bytes(range(256)))
        (folder / "link").symlink_to("inner/library")
        os.utime(folder / "run", (1e9 + len(name), hash(name) % 1e9))
    one, two = (pack(tmp_path / name / "program", tmp_path / name / "all", 1_700_000_000) for name in ("one", "two"))
    assert one.read_bytes() == two.read_bytes()
    subprocess.run(["tar", "-xf", one, "-C", tmp_path], check=True)
    assert (tmp_path / "program" / "link").read_bytes() == bytes(range(256))
    assert os.access(tmp_path / "program" / "run", os.X_OK)
