"""Takes a picture of the page of the head: run by screenshots.py."""

import sys
import tempfile
from pathlib import Path

from PySide6.QtCore import QSettings

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeengine.audio.output import ClockOutput
from tools.bench.desktop import live_for

DEMO = Path(__file__).resolve().parents[2] / "phonemeanalyser" / "demo" / "demo.flac"
TALK = 2


def main(out: Path, theme: str, width: int, height: int, at: float, language: str) -> None:
    """Have the head say the demo up to a time, and save what the page shows then."""
    with tempfile.TemporaryDirectory() as folder:
        settings = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        settings.setValue("theme", theme)
        settings.setValue("language", language)
        microphone = Microphone(journal=Path(folder) / "journal", folder=Path(folder) / "Recordings")
        desktop = Desktop(make_application(), settings, lambda _n: ClockOutput(), microphone)
        desktop.window.resize(width, height)
        desktop.window.show()
        desktop.session.open(DEMO)
        desktop.window.show_page(TALK)
        desktop.talking.set_blinks(False)
        while desktop.talking.face.states is None:
            live_for(0.1)
        desktop.session.analyse_until(at)
        live_for(0.3)
        desktop.window.redraw.refresh_all()
        desktop.window.redraw.timer.stop()  # for a picture without jagged edges
        live_for(1.0)
        desktop.talking.set_blinks(True)
        desktop.window.grab().save(str(out), "PNG")
        desktop.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5]), sys.argv[6])
