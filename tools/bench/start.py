"""From the command to the first picture of the window, against a bare Python that imports what windows need."""

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence

from tools.bench.figures import ROOT, Figure, child_environment, interleaved, ratio_of, shown

N_ROUNDS = 7
BARE = ("-c", "import PySide6.QtWidgets, pyqtgraph")
PROGRAM = ("-m", "tools.bench.first_paint")
N_SHOWN = 25
IMPORT_TIME = re.compile(r"import time: +(\d+) \| +(\d+) \|( +)(\S+)")


def figures() -> list[Figure]:
    """Measure in pairs."""
    with tempfile.TemporaryDirectory() as folder:
        program, bare = interleaved(N_ROUNDS, lambda: _run([*PROGRAM, folder]), lambda: _run(BARE))
    return [Figure("first window shown", shown(program), f"bare imports {shown(bare)}", ratio_of(program, bare), 1.8)]


def detail() -> Iterator[str]:
    """Give the slowest imports of the start: milliseconds in all, milliseconds of its own, and its name."""
    with tempfile.TemporaryDirectory() as folder:
        report = _run(["-X", "importtime", *PROGRAM, folder])
    found = [(int(total), int(own), name) for own, total, _, name in IMPORT_TIME.findall(report)]
    for total, own, name in sorted(found, reverse=True)[:N_SHOWN]:
        yield f"{total / 1000:8.0f} ms {own / 1000:8.0f} ms of its own  {name}"


def _run(words: Sequence[str]) -> str:
    done = subprocess.run(
        [sys.executable, *words], env=child_environment(), cwd=ROOT, stderr=subprocess.PIPE, text=True, check=False
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    return done.stderr
