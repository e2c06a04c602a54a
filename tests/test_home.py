"""No test, nor any program that a test starts, reads or writes what the user has set, kept or recorded."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from phonemeengine.encoder.model_folder import FOLDER_VARIABLE
from phonemeengine.storage.paths import cache_folder, data_folder, presets_folder, recordings_folder
from tests.conftest import ROOT
from tests.homes import environment_of

LONG_AGO, LATER = 1_000_000_000, 1_100_000_000
WHAT_READ_IT = (
    "tests/examples/test_examples.py::test_every_sound_of_a_folder_gets_the_cues_that_rhubarb_would_write",
    "tests/engine/batch/test_fingerprint.py::test_another_process_makes_the_same",
    "tests/server/test_files.py::test_a_file_is_what_the_command_line_writes[rhubarb-json]",
    "tests/desktop/test_window_pages.py::test_the_first_picture_does_not_wait_for_the_calibration",
    "tests/desktop/test_crash.py",
)
"""Tests whose programs heard files with the user's model, or open the window as it is."""


def full_home(home: Path, whisper: Path) -> None:
    """Fill a home with all that a user of the program may have; each was last read long before it was written."""
    for name, content in {
        ".local/share/PhonemeAnalyser/whisper-folder.txt": str(whisper),
        ".local/share/PhonemeAnalyser/unfinished/1.json": "{}",
        ".local/share/PhonemeAnalyser/PhonemeAnalyser/unsaved-1.toml": "",
        ".cache/PhonemeAnalyser/espeak": "",
        ".config/PhonemeAnalyser/PhonemeAnalyser.ini": "[General]\nlanguage=de\n",
        "Documents/PhonemeAnalyser/presets/mine.toml": "",
        "Music/PhonemeAnalyser/take.wav": "",
    }.items():
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text(content)
    for path in kept_in(home):
        os.utime(path, (LONG_AGO, LATER))


def kept_in(home: Path) -> list[Path]:
    return sorted(path for path in home.rglob("*") if "PhonemeAnalyser" in path.parts and path.is_file())


def times_in(home: Path, name: str) -> dict[Path, float]:
    """Return when each file was last read (``st_atime``) or written (``st_mtime``)."""
    return {path.relative_to(home): getattr(path.stat(), name) for path in kept_in(home)}


def keeps_times_of_reading(folder: Path) -> bool:
    """Return whether this disk notes when a file was read."""
    probe = folder / "probe"
    probe.write_text("x")
    os.utime(probe, (LONG_AGO, LATER))
    probe.read_text()
    return probe.stat().st_atime != LONG_AGO


def test_what_the_program_keeps_lies_in_the_home_of_this_run():
    home = Path(os.environ["HOME"])
    assert home.name.startswith("phonemeanalyser-home-")
    for folder in (Path.home(), data_folder(), cache_folder(), presets_folder(), recordings_folder()):
        assert folder.is_relative_to(home)


@pytest.mark.parametrize("read_it", [WHAT_READ_IT[:1], pytest.param(WHAT_READ_IT[1:], marks=pytest.mark.long)])
def test_programs_of_tests_leave_a_full_home_alone(tmp_path, whisper_folder, read_it):
    home = tmp_path / "home"
    full_home(home, whisper_folder)
    environment = os.environ | environment_of(home)
    for name in (FOLDER_VARIABLE, "PYTEST_XDIST_WORKER", "PYTEST_CURRENT_TEST"):
        environment.pop(name, None)
    words = ["-m", "pytest", "-q", "-p", "no:cacheprovider", "--basetemp", str(tmp_path / "inner"), *read_it]
    done = subprocess.run(
        [sys.executable, *words], cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    written, read = times_in(home, "st_mtime"), times_in(home, "st_atime")
    assert len(written) == 7
    assert set(written.values()) == {LATER}
    assert set(read.values()) == {LONG_AGO} or not keeps_times_of_reading(tmp_path)
