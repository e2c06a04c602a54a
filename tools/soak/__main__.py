"""Listens to a virtual microphone for a long time, and says whether anything was lost or grew."""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.virtual_sound import VirtualSound
from tools.soak.known_sound import KnownPlayer, KnownSound, heard_exactly

SETTLED = 120.0
"""Seconds after which nothing may grow any more; a third of a shorter soak."""
GROWTH = 2.0
"""MB that the memory may grow: arrays of one size come and go."""
STRAY = 0.1
"""Seconds by which the count of samples may differ from the clock."""
LEAD = 5.0
"""Seconds of silence that may stand before the sound: it begins when the listening has."""
UNFINISHED = 4
"""Frames whose windows reach beyond the newest sample."""

State = dict[str, Any]


@dataclass(frozen=True)
class Row:
    """What was seen, and whether it is well; None where nothing is asked."""

    name: str
    seen: str
    well: bool | None = None

    @property
    def verdict(self) -> str:
        """How it stands, in words."""
        return "" if self.well is None else "ok" if self.well else "WRONG"


def main() -> None:
    """Print the table; exit with 1 if something is wrong."""
    parser = argparse.ArgumentParser(prog="python -m tools.soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=20.0, help="how long (default: 20)")
    seconds = 60 * parser.parse_args().minutes
    sound = KnownSound()
    with tempfile.TemporaryDirectory() as folder:
        states = _listened(Path(folder), sound, seconds)
        n_exact = heard_exactly(Path(folder) / "soak.wav", sound)
    print()
    sys.exit(print_rows(_rows(states, n_exact, seconds)))


def print_rows(rows: Iterable[Row]) -> bool:
    """Print a table; return whether something is wrong."""
    rows = list(rows)
    for row in rows:
        print(f"{row.name:<34}{row.seen:<60}{row.verdict}".rstrip())
    return any(row.well is False for row in rows)


def _listened(folder: Path, sound: KnownSound, seconds: float) -> list[State]:
    """Have a process listen to the sound; give what it said each second, and last at its end."""
    words = [sys.executable, "-m", "tools.soak.listening", str(folder), str(seconds)]
    states: list[State] = []
    with VirtualSound() as card:
        child = subprocess.Popen(words, env=card.environment, stdout=subprocess.PIPE, text=True)
        assert child.stdout is not None
        states.append(json.loads(child.stdout.readline()))  # it listens: now the sound may begin
        with KnownPlayer(sound, card):
            for line in child.stdout:
                states.append(json.loads(line))
                if len(states) % 60 == 0:
                    seen, now = states[-1], time.strftime("%H:%M:%S")
                    print(f"{now}  {seen['heard']:.0f} s heard, {seen['lost']:g} s lost ...", flush=True)
        if child.wait():
            sys.exit("the listening process failed")
    return states


def _rows(states: list[State], n_exact: int, seconds: float) -> Iterator[Row]:
    first, last = states[0], states[-1]
    during = states[:-1]
    settled = [s for s in during if s["heard"] >= min(SETTLED, seconds / 3)]
    recorded, frames = last["recorded"], last["frames"]
    share = (during[-1]["processor"] - first["processor"]) / (during[-1]["clock"] - first["clock"])
    stray = (during[-1]["heard"] - first["heard"]) - (during[-1]["clock"] - first["clock"])
    yield Row("heard and recorded", f"{recorded / 60:.1f} min", last["failure"] is None and recorded > seconds - 5)
    yield Row("lost by the sound card", f"{last['lost'] * SAMPLE_RATE:.0f} samples", last["lost"] == 0)
    yield Row("against the clock", f"{1000 * stray:+.0f} ms", abs(stray) < STRAY)
    well = last["missing"] == last["dropped"] == 0 and 0 <= 100 * recorded - frames <= UNFINISHED
    yield Row("analyses", f"{frames}, {last['missing']} missing, {last['dropped']} dropped", well)
    well = n_exact >= (recorded - LEAD) * SAMPLE_RATE
    yield Row("recording", f"{n_exact} samples of the sound, bit-exact", well)
    growth = _middle(settled[-30:], "megabytes") - _middle(settled[:30], "megabytes")
    yield Row("memory", f"{_span(settled, 'megabytes')} MB, grown by {growth:.1f} MB", growth < GROWTH)
    for name in ("threads", "files"):
        yield Row(name, _span(settled, name), len({s[name] for s in settled}) == 1)
    median, late = last["ages"]
    yield Row("from mid-frame to phoneme", f"median {1000 * median:.1f} ms, p99 {1000 * late:.1f} ms")
    yield Row("latency as the program states it", f"{1000 * _middle(settled, 'latency'):.1f} ms")
    yield Row("processor, with the recording", f"{share:.1%} of a core")


def _middle(states: list[State], name: str) -> float:
    return statistics.median(s[name] for s in states)


def _span(states: list[State], name: str) -> str:
    """Write the least and the most, or the one value that there is."""
    least, most = (f"{edge(s[name] for s in states):.4g}" for edge in (min, max))
    return least if least == most else f"{least} to {most}"


if __name__ == "__main__":
    main()
