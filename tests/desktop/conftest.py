"""What the tests of the desktop share."""

import os

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from engine.audio.stream import ClockOutput
from phonemeanalyser.app import Desktop


@pytest.fixture
def settings(tmp_path: Path) -> QSettings:
    """Settings that nobody else has."""
    return QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)


@pytest.fixture
def desktop(qapp: QApplication, settings: QSettings) -> Iterator[Desktop]:
    """The program without a sound card; its window is not shown yet."""
    desktop = Desktop(qapp, settings, lambda _n: ClockOutput())
    yield desktop
    desktop.session.close()
    desktop.window.retire()
