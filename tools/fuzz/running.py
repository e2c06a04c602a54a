"""Runs the readers in processes of their own, and starts another one after a crash or a hang."""

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HANG = 60.0
"""Seconds that one file may take; hundreds of times what the slowest takes, since other programs run as well."""


@dataclass(frozen=True)
class Failure:
    """A damaged file that was not handled: its number, and what happened."""

    number: int
    what: str


def run(n: int, seed: str, told: Callable[[int], None] = lambda _n: None) -> list[Failure]:
    """Read the damaged files 0..n; `told` is given how many are done, twice a second.

    Returns
    -------
    What failed, in order.
    """
    failures: list[Failure] = []
    begin = 0
    while begin < n:
        begin = _run_on(begin, n, seed, failures, told)
    return failures


def _run_on(begin: int, end: int, seed: str, failures: list[Failure], told: Callable[[int], None]) -> int:
    """Run one process as far as it gets; gives the number at which the next one begins."""
    with tempfile.TemporaryDirectory() as folder:
        now, errors = Path(folder) / "now", Path(folder) / "errors"
        now.write_bytes(b"%12d" % -1)
        words = [sys.executable, "-m", "tools.fuzz.reading", folder, seed, str(begin), str(end)]
        with errors.open("wb") as said, (Path(folder) / "found").open("w+", encoding="utf-8") as found:
            process = subprocess.Popen(words, cwd=ROOT, stdout=found, stderr=said)
            hung = watch(process, now, told)
            found.seek(0)
            failures += [Failure(*json.loads(line)) for line in found if line.endswith("\n")]
        number = int(now.read_bytes())
        if number < 0:
            raise RuntimeError(errors.read_text(encoding="utf-8", errors="replace"))
        if number < end:
            what = f"it hung for {HANG:g} s" if hung else f"the process ended with {process.returncode}"
            failures.append(Failure(number, what))
        return number + 1 if number < end else end


def watch(process: "subprocess.Popen[bytes]", now: Path, told: Callable[[int], None], patience: float = HANG) -> bool:
    """Wait for a process; kills it, and says so, if it stays at one file."""
    last, since = -1, time.monotonic()
    while process.poll() is None:
        time.sleep(0.1)
        number = int(now.read_bytes() or -1)
        told(max(number, 0))
        if number != last:
            last, since = number, time.monotonic()
        elif time.monotonic() - since > patience:
            process.kill()
            process.wait()
            return True
    return False
