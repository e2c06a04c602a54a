"""How long a table of an hour of recordings is built, the memory that takes, and how soon a sentence is looked up."""

import json
import statistics
import tempfile
import time
from pathlib import Path

from phonemeengine import PerformanceTable, Voice, build_table, make_corpus, speak
from phonemeengine.performance.making import sentences
from phonemeengine.performance.units import duration_of, units_of
from tools.bench.figures import Absolute, Figure, answer_of
from tools.bench.memory import resident_megabytes

VOICE = Voice("en-us")
SMALL, LARGE = 1, 6
"""Minutes of the corpora; the time for an hour is that for the larger one, ten times."""
LIMIT = 60.0
"""Seconds for an hour."""
LOOKED_UP = 0.02
"""Seconds for a sentence: ten examples of each of its units."""
MOST_MB = 8
"""Growth from the small corpus to the large one that is still none."""
N_SENTENCES = 20


def figures() -> list[Figure]:
    """Measure in a process of its own."""
    answer = answer_of("performance_table")
    hour, looked_up = answer["seconds"] * 60 / LARGE, statistics.median(answer["looked_up"])
    growth = answer["growth"]
    return [
        Figure(
            "table of an hour of recordings",
            f"{hour:.0f} s",
            f"{LIMIT:g} s",
            hour / LIMIT,
            limit=1.0,
            absolute=Absolute.TIME,
        ),
        Figure(
            f"building it, memory from {SMALL} to {LARGE} min",
            f"{growth:.1f} MB",
            f"{MOST_MB} MB",
            growth / MOST_MB,
            limit=1.0,
        ),
        Figure(
            "all units of a sentence, ten examples each",
            f"{1000 * looked_up:.1f} ms",
            f"{1000 * LOOKED_UP:g} ms",
            looked_up / LOOKED_UP,
            limit=1.0,
            absolute=Absolute.TIME,
        ),
    ]


def main() -> None:
    """Measure, and print it as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        small, large = (_made(Path(folder) / f"{minutes}", minutes) for minutes in (SMALL, LARGE))
        build_table(small, small.with_suffix(".sqlite"))
        before = resident_megabytes()
        begin = time.monotonic()
        build_table(large, large.with_suffix(".sqlite"))
        seconds, growth = time.monotonic() - begin, resident_megabytes() - before
        with PerformanceTable.open(large.with_suffix(".sqlite")) as table:
            looked_up = [_looked_up(table, number) for number in range(1, N_SENTENCES + 1)]
    print(json.dumps({"seconds": seconds, "growth": growth, "looked_up": looked_up}))


def _made(folder: Path, minutes: int) -> Path:
    make_corpus(folder, sentences(minutes), lambda text: speak(text, VOICE), seconds=60 * minutes)
    return folder


def _looked_up(table: PerformanceTable, number: int) -> float:
    """Look up all units of a recording; seconds."""
    phones = table.recording(number).phones
    units = [*units_of(phones)]
    begin = time.monotonic()
    for unit in units:
        table.nearest(unit.kind, unit.names, duration_of(unit, phones), 10)
    return time.monotonic() - begin


if __name__ == "__main__":
    main()
