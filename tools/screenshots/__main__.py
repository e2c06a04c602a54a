"""Makes the pictures in `screenshots/` from the running program: `make screenshots`."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import soundfile

from tests.fakes.virtual_sound import VirtualSound

OFFSCREEN = {"QT_QPA_PLATFORM": "offscreen"}
ROOT = Path(__file__).resolve().parents[2]
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
PICTURES = {
    "window-light.png": ("1280x800", "light", "6.0", "en"),
    "window-dark.png": ("1280x800", "dark", "6.0", "en"),
    "window-large-light.png": ("1920x1080", "light", "9.4", "en"),
    "window-large-dark.png": ("1920x1080", "dark", "9.4", "en"),
    "window-german-light.png": ("1280x800", "light", "6.0", "de"),
}
LIVE = {"microphone-light.png": ("1280", "800", "light"), "microphone-dark.png": ("1280", "800", "dark")}
"""The window while it records the demo from a virtual microphone."""
N_TIMES = 5
"""Of the demo at the microphone, since a busy computer takes long to show the window."""
CALIBRATE = {"calibrate-light.png": ("1280", "800", "light"), "calibrate-large-dark.png": ("1920", "1080", "dark")}
"""The page of the calibration."""
TALK = {
    "talk-light.png": ("1280", "800", "light", "0.99", "en"),
    "talk-dark.png": ("1920", "1080", "dark", "0.75", "en"),
    "talk-german-light.png": ("1280", "800", "light", "0.99", "de"),
}
"""The page of the head, while it says the demo."""
COMPARE = {"compare-light.png": ("1280", "800", "light", "1.02", "en")}
"""Two heads that say a text in step, a recorded face and the rules."""
MOVING = "window.gif"
"""The window while it plays the demo, on two pages."""
HEAD = {
    "head-visemes.png": ("head", "light", "visemes"),
    "head-shapes.png": ("head", "light", "shapes"),
    "contact-sheet.png": ("contact_sheet", "light"),
}
"""The head that says a, e, i, o, u and m; all mouth shapes of both heads; and a sentence of the demo, sound by sound,
beside its labels."""


def main() -> None:
    """Make them all."""
    for name, (size, theme, at, language) in PICTURES.items():
        command = [sys.executable, "-m", "phonemeanalyser", "screenshot", str(DEMO), "-o"]
        look = ["--size", size, "--theme", theme, "--language", language]
        subprocess.run([*command, str(_place(name)), *look, "--at", at], check=True)
    for name, (width, height, theme) in CALIBRATE.items():
        command = [sys.executable, "-m", "tools.screenshots.calibrate", str(_place(name)), theme, width, height]
        subprocess.run(command, check=True, cwd=ROOT, env=os.environ | OFFSCREEN)
    for module, pictures in (("talk", TALK), ("compare", COMPARE)):
        for name, (width, height, theme, at, language) in pictures.items():
            place = str(_place(name))
            command = [sys.executable, "-m", f"tools.screenshots.{module}", place, theme, width, height, at, language]
            subprocess.run(command, check=True, cwd=ROOT, env=os.environ | OFFSCREEN)
    moving = [sys.executable, "-m", "tools.screenshots.moving", str(_place(MOVING))]
    subprocess.run(moving, check=True, cwd=ROOT, env=os.environ | OFFSCREEN)
    tutorials = [sys.executable, "-m", "tools.screenshots.tutorials", str(ROOT / "screenshots")]
    subprocess.run(tutorials, check=True, cwd=ROOT, env=os.environ | OFFSCREEN)
    for name, (module, *look) in HEAD.items():
        command = [sys.executable, "-m", f"tools.screenshots.{module}", str(_place(name)), *look]
        subprocess.run(command, check=True, cwd=ROOT)
    with tempfile.TemporaryDirectory() as folder, VirtualSound() as sound:
        wav = Path(folder) / "demo.wav"
        samples, rate = soundfile.read(DEMO)
        soundfile.write(wav, np.tile(samples, N_TIMES), rate)
        for name, (width, height, theme) in LIVE.items():
            voice = sound.play_into_microphone(wav)
            command = [sys.executable, "-m", "tools.screenshots.live", str(_place(name)), theme, width, height, "6.0"]
            subprocess.run(command, check=True, cwd=ROOT, env=sound.environment | OFFSCREEN)
            voice.terminate()
            voice.wait()


def _place(name: str) -> Path:
    print(ROOT / "screenshots" / name)
    return ROOT / "screenshots" / name


if __name__ == "__main__":
    main()
