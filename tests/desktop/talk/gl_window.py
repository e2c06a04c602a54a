"""Shows the page of the head in a window with OpenGL, and prints how it was drawn: run under Xvfb by a test."""

import json
import sys
import tempfile
from pathlib import Path

from PySide6.QtCore import QSettings

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.talk.head import head_surface
from phonemeanalyser.desktop.window import TALK
from phonemeengine.audio.output import ClockOutput
from tools.bench.desktop import live_for

PATIENCE = 60
"""Seconds."""


def main() -> None:
    """Take the software for a graphics card, show the head in both themes, and print what is seen in its middle."""
    app = make_application()
    software = not head_surface.has_graphics_card()
    head_surface.has_graphics_card = lambda: True
    with tempfile.TemporaryDirectory() as folder:
        settings = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        settings.setValue("language", "en")
        microphone = Microphone(journal=Path(folder) / "journal", folder=Path(folder) / "takes")
        desktop = Desktop(app, settings, lambda _n: ClockOutput(), microphone)
        desktop.window.resize(1024, 700)  # which software draws in half the time
        desktop.window.show()
        desktop.window.show_page(TALK)
        seen = [_seen(desktop), (desktop.set_theme("dark"), _seen(desktop))[1]]
        desktop.close()
    json.dump({"software": software, "seen": seen}, sys.stdout)


def _seen(desktop: Desktop) -> dict[str, object]:
    head = desktop.window.talk.head
    for _ in range(10 * PATIENCE):
        if head.surface is not None and head.surface.n_drawn > 1:
            break
        live_for(0.1)
    assert head.surface is not None
    image = head.surface.grabFramebuffer()  # type: ignore[union-attr]
    pixels = [image.pixelColor(image.width() // 2, image.height() // 2), image.pixelColor(3, 3)]
    return {
        "kind": type(head.surface).__name__,
        "middle": [pixels[0].red(), pixels[0].green(), pixels[0].blue()],
        "corner": [pixels[1].red(), pixels[1].green(), pixels[1].blue()],
    }


if __name__ == "__main__":
    main()
