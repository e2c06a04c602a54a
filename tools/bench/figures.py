"""What a figure is, and how it is measured."""

import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path
from typing import Any

import numpy as np

import phonemeanalyser
from phonemeengine.audio.files import SoundReader
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import Sound
from tools.bench import PINS

ROOT = Path(__file__).resolve().parents[2]
DEMO = Path(phonemeanalyser.__file__).parent / "demo" / "demo.flac"
HEADINGS = ("figure", "measured", "reference", "ratio", "limit", "aim", "verdict")


class Absolute(Enum):
    """What an absolute limit limits: time, which is longer on a busy machine too, or the work of the processor."""

    TIME = "by the clock"
    WORK = "of the processor"


@dataclass(frozen=True)
class Figure:
    """A ratio to a reference, with the most it may be and the most it should be; None where nothing is asked.

    An absolute limit is a time or a share of a core, which depends on the machine.
    """

    name: str
    measured: str
    reference: str
    ratio: float
    limit: float | None = None
    aim: float | None = None
    absolute: Absolute | None = None

    def here(self, slowness: Mapping[Absolute, float]) -> "Figure":
        """Give it with its limit scaled by how much slower this machine is than the one the limits were set for."""
        if self.absolute is None or self.limit is None:
            return self
        return replace(self, limit=self.limit * slowness[self.absolute])

    @property
    def verdict(self) -> str:
        """How it stands, in words."""
        if self.limit is not None and self.ratio > self.limit:
            return "OVER THE LIMIT"
        if self.aim is not None and self.ratio > self.aim:
            return "misses the aim"
        return "ok"


def table_of(figures: Sequence[Figure]) -> Iterator[str]:
    """Write figures as lines of a table."""
    rows: list[tuple[str, ...]] = [HEADINGS]
    for f in figures:
        numbers = ("-" if number is None else f"{number:.2f}" for number in (f.ratio, f.limit, f.aim))
        rows.append((f.name, f.measured, f.reference, *numbers, f.verdict))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def interleaved(n_rounds: int, *acts: Callable[[], object]) -> list[list[float]]:
    """Time some acts in turns (A B A B ...), after one round that does not count; seconds, a list for each."""
    for act in acts:
        act()
    return [list(times) for times in zip(*([_seconds(act) for act in acts] for _ in range(n_rounds)), strict=True)]


def ratio_of(measured: Sequence[float], reference: Sequence[float]) -> float:
    """Give the median of the ratios of each pair."""
    return statistics.median(a / b for a, b in zip(measured, reference, strict=True))


def shown(times: Sequence[float], n: int = 1) -> str:
    """Write the median of some times, shared by `n`, in the unit that suits it."""
    seconds = statistics.median(times) / n
    scale, unit = next((s, u) for s, u in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")) if seconds >= s or u == "µs")
    return f"{seconds / scale:.2f} {unit}"


def speech(seconds: float) -> Sound:
    """Give the demo recording, again and again, float32 at 44.1 kHz."""
    with SoundReader(DEMO) as reader:
        return np.resize(np.concatenate(list(reader.blocks(SAMPLE_RATE))), round(seconds * SAMPLE_RATE))


def child_environment(own: Mapping[str, str] = os.environ) -> dict[str, str]:
    """Give the environment of a process of its own: no display, and as many threads as it would have anyway."""
    kept = {name: value for name, value in own.items() if name not in PINS}
    return kept | {"QT_QPA_PLATFORM": "offscreen"}


def answer_of(module: str, own: Mapping[str, str] = os.environ) -> dict[str, Any]:
    """Run a module of this package in a process of its own, and give what it prints, which is JSON."""
    words, environment = [sys.executable, "-m", f"tools.bench.{module}"], child_environment(own)
    done = subprocess.run(words, env=environment, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    answer: dict[str, Any] = json.loads(done.stdout)
    return answer


def _seconds(act: Callable[[], object]) -> float:
    began = time.perf_counter()
    act()
    return time.perf_counter() - began
