"""The window in a process of its own, without a display, with a clock in place of a sound card."""

from pathlib import Path

import soundfile
from PySide6.QtCore import QEventLoop, QSettings, QTimer

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeengine.audio.output import ClockOutput
from phonemeengine.settings import SAMPLE_RATE
from tools.bench.figures import speech


def shown_desktop(folder: Path) -> Desktop:
    """Show the window, 1280 x 800, with settings of its own in a folder."""
    settings = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
    desktop = Desktop(make_application(), settings, lambda _n_channels: ClockOutput())
    desktop.window.resize(1280, 800)
    desktop.window.show()
    live_for(1.0)
    return desktop


def live_for(seconds: float) -> None:
    """Let the window live."""
    loop = QEventLoop()
    QTimer.singleShot(round(1000 * seconds), loop.quit)
    loop.exec()


def written_speech(folder: Path, seconds: float) -> Path:
    """Write speech to a file."""
    path = folder / "speech.wav"
    soundfile.write(path, speech(seconds), SAMPLE_RATE)
    return path
