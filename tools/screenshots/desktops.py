"""The window whose pictures are taken: without the user's settings, on a clock in place of a sound card."""

import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import QSettings

from phonemeanalyser.desktop.app import Desktop, make_application
from phonemeanalyser.desktop.session.microphone import Microphone
from phonemeanalyser.desktop.session.preset import PresetModel
from phonemeengine.audio.output import ClockOutput
from phonemeengine.presets.files import FACTORY
from tools.bench.desktop import live_for

DEMO = Path(__file__).resolve().parents[2] / "phonemeanalyser" / "demo" / "demo.flac"
ANALYSE, CALIBRATE, TALK = range(3)
"""Pages of the window."""


@contextmanager
def shown_desktop(
    size: tuple[int, int],
    theme: str = "light",
    language: str = "en",
    preset: str = "learned",
    output: Callable[[], ClockOutput] = ClockOutput,
) -> Iterator[tuple[Desktop, Path]]:
    """Show the window, and yield it with a folder of its own; both are gone afterwards."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        settings = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
        settings.setValue("theme", theme)
        settings.setValue("language", language)
        microphone = Microphone(journal=folder / "journal", folder=folder / "Recordings")
        model = PresetModel(FACTORY / f"{preset}.toml")
        desktop = Desktop(make_application(), settings, lambda _n: output(), microphone, model)
        desktop.window.resize(*size)
        desktop.window.show()
        try:
            yield desktop, folder
            while desktop.session.busy:  # a thread that still analyses may abort the program at its end
                live_for(0.1)
        finally:
            desktop.close()
