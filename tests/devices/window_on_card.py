"""Records in the window until SIGTERM, then chooses the file again; prints what the window says all the time."""

import json
import signal
import sys
import time
from pathlib import Path

from PySide6.QtCore import QSettings

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.sources import SourceKind
from tests.waiting import let_pass

ending: list[int] = []
signal.signal(signal.SIGTERM, lambda number, _frame: ending.append(number))
takes, demo = Path(sys.argv[1]), Path(sys.argv[2])
app = make_application()
settings = QSettings(str(takes.parent / "settings.ini"), QSettings.Format.IniFormat)
settings.setValue("language", "en")
microphone = Microphone(journal=takes.parent / "unfinished", folder=takes)
desktop = Desktop(app, settings, microphone=microphone)
window = desktop.window


def choose_source(source: SourceKind) -> None:
    """Choose what is listened to, as a user does."""
    window.transport.source.activated.emit(window.transport.source.findData(source))


window.show()
window.dialogs.open_sound(demo)
choose_source(SourceKind.MICROPHONE)  # Record would ask whether to leave the file
window.menus.actions["Record"].trigger()


def say() -> str:
    """Print what the window says, and give what the banner says."""
    banner = window.banner.label.text() if window.banner.isVisible() else ""
    print(
        json.dumps(
            {
                "time": time.monotonic(),
                "banner": banner,
                "left": window.status.left.text(),
                "right": window.status.chips.words(),
                "label": window.transport.time.text(),
                "ticks": window.redraw.n_ticks,
                "lost": microphone.listener.lost_seconds,
                "late_ms": window.status.latency_ms,
                "frames": desktop.session.history.n,
                "devices": [device.label for device in microphone.devices],
            }
        ),
        flush=True,
    )
    return str(banner)


def live(seconds: float) -> None:
    """Let the window live for a while."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        app.processEvents()
        let_pass(0.002)


while not ending:
    live(0.05)
    say()
choose_source(SourceKind.FILE)
until = time.monotonic() + 60
while not say().startswith("Recorded") and time.monotonic() < until:
    live(0.05)
window.close()
desktop.close()
