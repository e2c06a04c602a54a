"""Makes the pictures in `screenshots/` from the running program: `make screenshots`."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
PICTURES = {
    "window-light.png": ("1280x800", "light", "6.0"),
    "window-dark.png": ("1280x800", "dark", "6.0"),
    "window-large-light.png": ("1920x1080", "light", "9.4"),
    "window-large-dark.png": ("1920x1080", "dark", "9.4"),
}

if __name__ == "__main__":
    for name, (size, theme, at) in PICTURES.items():
        command = [sys.executable, "-m", "phonemeanalyser", "screenshot", str(DEMO), "-o"]
        subprocess.run(
            [*command, str(ROOT / "screenshots" / name), "--size", size, "--theme", theme, "--at", at], check=True
        )
        print(ROOT / "screenshots" / name)
