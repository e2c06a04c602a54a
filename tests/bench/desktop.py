"""The window in a process of its own, without a display, with a clock in place of a sound card."""

from pathlib import Path

import soundfile
from PySide6.QtCore import QSettings, QTimer
from PySide6.QtWidgets import QApplication

from engine.audio.stream import ClockOutput
from engine.settings import SAMPLE_RATE
from phonemeanalyser.app import Desktop, make_application
from tests.bench.figures import speech


def shown_desktop(folder: Path) -> tuple[QApplication, Desktop]:
    """Show the window, 1280 x 800, with settings of its own in a folder."""
    app = make_application()
    settings = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
    desktop = Desktop(app, settings, lambda _n_channels: ClockOutput())
    desktop.window.resize(1280, 800)
    desktop.window.show()
    live_for(app, 1.0)
    return app, desktop


def live_for(app: QApplication, seconds: float) -> None:
    """Let the window live."""
    QTimer.singleShot(round(1000 * seconds), app.quit)
    app.exec()


def written_speech(folder: Path, seconds: float) -> Path:
    """Write speech to a file."""
    path = folder / "speech.wav"
    soundfile.write(path, speech(seconds), SAMPLE_RATE)
    return path
