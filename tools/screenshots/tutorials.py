"""Makes the pictures of the tutorials, of the window at their steps: run by screenshots.py."""

import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import soundfile
from PySide6.QtWidgets import QDialog, QTabWidget, QWidget

from phonemeanalyser.desktop.app import Desktop
from phonemeanalyser.desktop.export_dialog import ExportDialog
from phonemeanalyser.desktop.talk.expression.expression_panel import OscPanel
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.virtual_sound import VirtualSound
from tools.bench.desktop import live_for
from tools.screenshots.desktops import ANALYSE, CALIBRATE, DEMO, TALK, shown_desktop

SIZE = 1280, 800
THRESHOLD, VARIABLE, TUNED = "sz_s1", "m_s1", 22.0
"""What the tutorial tunes, the variable that it is compared with, and the value at which sh is recognised better."""
NOISE, NOISE_SECONDS = 0.0005, 300
"""Background noise of the microphone, amplitude and length."""
TEXT = """She sells sea shells, maybe, on the shore near my house. Papa, may I have some more apple juice, please?
Who knew the cool pool would be so full of frogs in June?"""


def main(folder: Path) -> None:
    """Make them all."""
    with shown_desktop(SIZE, preset="thesis-calm") as (desktop, _):
        tune_thresholds(desktop, folder)
    with VirtualSound() as sound:
        os.environ.update(sound.environment)
        with shown_desktop(SIZE) as (desktop, own):
            calibrate(desktop, sound, own, folder)
    with shown_desktop(SIZE) as (desktop, own):
        animate(desktop, own, folder)


def tune_thresholds(desktop: Desktop, folder: Path) -> None:
    """Save an error and its decision, and the Calibrate page after the threshold was moved."""
    desktop.session.open(DEMO)
    _wait_while(desktop, lambda: desktop.session.busy)
    desktop.window.show_page(ANALYSE)
    desktop.window.label_dialogs.next_error()
    _save(desktop, desktop.window, folder / "tutorial-error.png")
    calibration = desktop.calibration
    desktop.window.show_page(CALIBRATE)
    calibration.recordings.load([DEMO.parent])
    _wait_while(desktop, lambda: calibration.recordings.busy or calibration.workbench.measuring.busy)
    calibration.workbench.choose(VARIABLE)
    desktop.preset.tune(THRESHOLD, TUNED)
    desktop.preset.end_edit()
    _save(desktop, desktop.window, folder / "tutorial-thresholds.png")


def calibrate(desktop: Desktop, sound: VirtualSound, own: Path, folder: Path) -> None:
    """Keep quiet as the guided calibration asks, and save what it asks for next."""
    calibration, guide = desktop.calibration, desktop.calibration.guide
    calibration.takes.open(own / "My Takes")
    desktop.window.show_page(CALIBRATE)
    noise = NOISE * np.random.default_rng(1).standard_normal(NOISE_SECONDS * SAMPLE_RATE)
    soundfile.write(own / "noise.wav", noise, SAMPLE_RATE)
    playing = sound.play_into_microphone(own / "noise.wav")
    calibration.begin_guide()
    _wait_while(desktop, lambda: not desktop.session.microphone.listening)
    guide.start()
    _wait_while(desktop, lambda: guide.index == 0)
    _save(desktop, desktop.window, folder / "tutorial-guide.png")
    guide.cancel()
    playing.terminate()
    playing.wait()


def animate(desktop: Desktop, own: Path, folder: Path) -> None:
    """Save the Talk page with the words of the demo, and the dialogs for exporting and shipping."""
    desktop.session.open(Path(shutil.copy(DEMO, own / "talk.flac")))
    desktop.window.show_page(TALK)
    desktop.talking.set_blinks(False)
    _wait_while(desktop, lambda: desktop.talking.face.states is None or desktop.session.busy)
    text = desktop.talking.text
    text.set_text(TEXT)
    text.set_language("en-us")
    text.align()
    _wait_while(desktop, lambda: text.busy)
    desktop.session.analyse_until(0.99)
    _save(desktop, desktop.window, folder / "tutorial-words.png")
    _save_osc(desktop, folder / "unreal-osc.png")
    for show, name in (
        (desktop.window.dialogs.show_export, "tutorial-export.png"),
        (desktop.window.dialogs.presets.show_ship, "tutorial-ship.png"),
    ):
        show()
        dialog = desktop.window.findChild(QDialog)
        assert isinstance(dialog, QDialog)
        _save(desktop, dialog, folder / name)
        if name == "tutorial-export.png":
            _save_curves(desktop, dialog, folder / "unreal-export.png")
        dialog.reject()
        live_for(0.1)


def _save_curves(desktop: Desktop, dialog: QDialog, out: Path) -> None:
    """Save the dialog for exporting with the format of Live Link Face, and its preview."""
    assert isinstance(dialog, ExportDialog)
    kind = dialog.choices.kind
    kind.setCurrentIndex(kind.findData("livelink-csv"))
    dialog.look.click()
    _wait_while(desktop, lambda: "EyeBlinkLeft" not in dialog.preview.toPlainText())
    _save(desktop, dialog, out)


def _save_osc(desktop: Desktop, out: Path) -> None:
    """Save the page Talk while it sends OSC."""
    (tabs,) = (found for found in desktop.window.findChildren(QTabWidget) if found.tabText(2) == "Output")
    tabs.setCurrentIndex(2)
    (panel,) = desktop.window.findChildren(OscPanel)
    panel.address.setText("127.0.0.1:39539")
    panel.switch.click()
    _save(desktop, desktop.window, out)
    panel.switch.click()
    tabs.setCurrentIndex(0)


def _wait_while(desktop: Desktop, busy: Callable[[], bool]) -> None:
    live_for(0.5)
    while busy():
        live_for(0.1)
    desktop.window.banner.show_error("")


def _save(desktop: Desktop, shown: QWidget, out: Path) -> None:
    live_for(1.5)
    desktop.window.banner.show_error("")
    live_for(0.2)
    shown.grab().save(str(out), "PNG")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
