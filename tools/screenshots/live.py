"""Takes a picture of the window while it listens to the microphone: run by screenshots.py on a virtual sound card."""

import sys
import tempfile
from pathlib import Path

from PySide6.QtCore import QEventLoop, QSettings, QTimer

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.session import Session
from phonemeanalyser.desktop.session.sources import SourceKind
from tools.bench.desktop import live_for

PATIENCE_MS = 15_000


def main(out: Path, theme: str, width: int, height: int, seconds: float) -> None:
    """Record until so much is on disk, and save what the window looks like."""
    with tempfile.TemporaryDirectory() as folder:
        settings = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        settings.setValue("theme", theme)
        settings.setValue("language", "en")
        microphone = Microphone(journal=Path(folder) / "journal", folder=Path(folder) / "Recordings")
        desktop = Desktop(make_application(), settings, microphone=microphone)
        desktop.window.resize(width, height)
        desktop.window.show()
        microphone.refresh_devices()
        desktop.session.set_source(SourceKind.MICROPHONE)
        desktop.session.toggle_recording()
        _wait_until_recorded(desktop.session, seconds)
        desktop.window.banner.show_error("")
        desktop.window.grab().save(str(out), "PNG")
        desktop.close()


def _wait_until_recorded(session: Session, seconds: float) -> None:
    loop, timer = QEventLoop(), QTimer()
    timer.timeout.connect(lambda: session.microphone.recorded_seconds >= seconds and loop.quit())
    timer.start(20)
    QTimer.singleShot(PATIENCE_MS, loop.quit)
    loop.exec()
    live_for(0.1)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5]))
