"""The program that needs no Python: how large it is, and how soon its window is seen."""

import subprocess
import sys
import tempfile
from pathlib import Path

from tools.bench.figures import ROOT, Figure, child_environment, interleaved, ratio_of, shown

N_ROUNDS = 5
FOLDER = ROOT / "build" / "bundle"
LARGEST = 200.0
"""Megabytes, as it is handed on."""
FIRST_PAINT = Path(__file__).with_name("first_paint.py")


def figures() -> list[Figure]:
    """Measure in pairs the bundle that is there, or else one that is made now."""
    program = FOLDER / "PhonemeAnalyser" / "PhonemeAnalyser"
    if not program.is_file():
        subprocess.run([sys.executable, "-m", "tools.bundle", "-o", FOLDER], cwd=ROOT, check=True)
    (archive,) = FOLDER.glob("PhonemeAnalyser-*.tar.xz")
    megabytes = archive.stat().st_size / 1e6
    with tempfile.TemporaryDirectory() as folder:
        bundled, checkout = interleaved(
            N_ROUNDS,
            lambda: _run(str(program), "-c", FIRST_PAINT.read_text("utf-8"), folder),
            lambda: _run(sys.executable, "-m", "tools.bench.first_paint", folder),
        )
    ratio = ratio_of(bundled, checkout)
    return [
        Figure("program without Python, as one archive", f"{megabytes:.0f} MB", "200 MB", megabytes / LARGEST, 1.0),
        Figure("its first window", shown(bundled), f"from the checkout {shown(checkout)}", ratio, 1.5),
    ]


def _run(*command: str) -> None:
    subprocess.run(command, env=child_environment(), cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
