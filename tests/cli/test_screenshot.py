"""`phonemeanalyser screenshot`: the real window as a picture."""

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile
from PySide6.QtCore import QEvent
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from phonemeanalyser.cli.main import main
from phonemeanalyser.desktop.window import MainWindow
from phonemeengine.settings import SAMPLE_RATE
from tests.bad_files import BAD_FILES
from tests.conftest import SPEECH
from tests.tables import Capsys, refused


@pytest.fixture(autouse=True)
def no_window_stays(qapp: QApplication) -> Iterator[None]:
    """Retire the windows of pictures that failed, and delete them all."""
    yield
    for window in qapp.topLevelWidgets():
        if isinstance(window, MainWindow):
            window.close_without_asking()
    qapp.sendPostedEvents(None, QEvent.Type.DeferredDelete)  # processEvents leaves these


def picture(qapp: QApplication, sound: Path, name: str, *words: str) -> np.ndarray:
    """Take a picture of the window in this process; shape (height, width, 4), uint8."""
    png = sound.parent / f"{name}.png"
    assert main(["screenshot", str(sound), "-o", str(png), *words]) == 0
    return pixels_in(png)


def pixels_in(png: Path) -> np.ndarray:
    image = QImage(str(png)).convertToFormat(QImage.Format.Format_RGB32)
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4).copy()


def share_that_differs(one: np.ndarray, other: np.ndarray) -> float:
    return float((one != other).any(axis=2).mean())


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Speech-like sound in a file."""
    path = tmp_path_factory.mktemp("said") / "speech.wav"
    soundfile.write(path, SPEECH, SAMPLE_RATE, subtype="FLOAT")
    return path


@pytest.fixture(scope="module")
def usual(qapp: QApplication, said: Path) -> np.ndarray:
    """The picture of that sound in the light theme, without another option."""
    return picture(qapp, said, "usual", "--theme", "light")


def test_a_picture_has_a_size_and_shows_something(usual: np.ndarray) -> None:
    assert usual.shape[:2] == (800, 1280)
    assert len(np.unique(usual.reshape(-1, 4), axis=0)) > 50
    assert usual[:, :, :3].mean() > 160


def test_the_window_speaks_the_language_that_is_asked_for_and_else_english(
    qapp: QApplication, said: Path, usual: np.ndarray
) -> None:
    german = picture(qapp, said, "de", "--language", "de", "--theme", "light")
    menus = np.s_[:20, 250:]
    assert share_that_differs(usual[menus], german[menus]) > 0.01
    with pytest.raises(SystemExit):
        main(["screenshot", str(said), "-o", "no.png", "--language", "klingon"])


def test_later_pictures_show_more_and_without_a_time_they_show_the_end(
    qapp: QApplication, said: Path, usual: np.ndarray
) -> None:
    start, beyond = (picture(qapp, said, at, "--at", at, "--theme", "light") for at in ("0", "1000"))
    assert share_that_differs(usual, beyond) == 0
    assert share_that_differs(usual, start) > 0.005


def test_of_a_bad_file_there_is_no_picture(qapp: QApplication, tmp_path: Path, capsys: Capsys) -> None:
    bad = BAD_FILES["truncated_flac"](tmp_path)
    assert refused(capsys, "screenshot", bad, "-o", tmp_path / "none.png").startswith(f"{bad.name}: ")
    assert not (tmp_path / "none.png").exists()


def test_with_a_broken_preset_there_is_no_picture(qapp: QApplication, sound: Path, capsys: Capsys) -> None:
    (sound.parent / "broken.toml").write_text("broken")
    words = ("screenshot", sound, "-o", sound.parent / "none.png", "--preset", sound.parent / "broken.toml")
    assert refused(capsys, *words).startswith("broken.toml: ")
    assert not (sound.parent / "none.png").exists()


def test_a_place_that_cannot_be_written_is_refused(qapp: QApplication, sound: Path, capsys: Capsys) -> None:
    sentence = refused(capsys, "screenshot", sound, "-o", sound.parent / "nowhere" / "none.png")
    assert sentence.endswith("the picture could not be written; choose another location with -o")


def test_the_program_takes_a_picture_of_any_size_and_theme_without_a_display(sound: Path, tmp_path: Path) -> None:
    words = ["screenshot", str(sound), "-o", str(tmp_path / "window.png"), "--theme", "dark", "--size", "1600x1000"]
    command = [sys.executable, "-m", "phonemeanalyser", *words]
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path), "TMPDIR": str(tmp_path)}
    before = set(tmp_path.iterdir())
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, env=environment, check=False)
    assert (done.returncode, done.stdout) == (0, "")
    assert "Traceback" not in done.stderr
    dark = pixels_in(tmp_path / "window.png")
    assert dark.shape[:2] == (1000, 1600)
    assert dark[:, :, :3].mean() < 90
    left = {path.name for path in set(tmp_path.iterdir()) - before if not path.name.startswith(".")}
    assert left == {"window.png"}
