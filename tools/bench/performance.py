"""Sentences that a table of recorded faces says: how near to what the performer does, smooth, closed, and soon.

The corpus is that of the synthetic performer. Sentences that are left out of the table are said by it, and by a rule
driver that is fitted to the same recordings: the mean pose of each phone at its middle, half a cosine between two.
"""

import json
import math
import statistics
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine import (
    Animation,
    Movestate,
    PerformanceOptions,
    PerformanceTable,
    PerformanceTrack,
    Transcript,
    Voice,
    load_head,
    make_corpus,
    speak,
)
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.labels.utterance import Utterance, shifted
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.performance.choice import ExampleChoice
from phonemeengine.performance.corpus import find_recordings, read_performance
from phonemeengine.performance.driver import FACE, MOUTH, PerformanceDriver, PerformancePart
from phonemeengine.performance.making import sentences
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import write_table
from tools.bench.figures import Absolute, Figure, answer_of
from tools.bench.memory import resident_megabytes

VOICE = Voice("en-us")
MINUTES, N_LEFT_OUT = 13, 25
"""Of the corpus; sentences that are not in the table, which is longer than ten minutes all the same."""
COLUMNS = [k for k, name in enumerate(ARKIT) if name.startswith(MOUTH)]
JAW = COLUMNS.index(ARKIT.index("jawOpen"))
BARE = frozenset({PerformancePart.POSES, PerformancePart.ENERGY})
"""What changes a face on purpose."""
ERROR, RANGE, ROUND_TRIP, INSIDE, RECORDED, OPEN = 0.7, 0.9, 0.02, 3.0, 1.0, 0.02
NEAREST, VITERBI, LOOKED_UP = 0.05, 0.12, 0.02
"""Seconds for ten words, and to look a sentence up."""
SHUT = 0.005
"""Between the lips in units of the head, a sixtieth of what the widest open jaw parts them by."""
PICTURES = 30.0
SOONER, LATER, MOST_MB = 60.0, 600.0, 8
"""Seconds of speech after which memory is measured, and what growth is still none."""


def figures() -> list[Figure]:
    """Measure in a process of its own."""
    found = answer_of("performance")
    error, rules = found["viterbi"]["error"], found["rules"]
    return [
        Figure(
            f"{N_LEFT_OUT} sentences left out of {found['minutes']:.1f} min, error",
            f"{error:.4f}",
            f"fitted rules, {rules:.4f}",
            error / rules,
            limit=ERROR,
        ),
        Figure(
            "the same, nearest durations",
            f"{found['nearest']['error']:.4f}",
            f"fitted rules, {rules:.4f}",
            found["nearest"]["error"] / rules,
        ),
        Figure(
            "range of their jaws",
            f"{found['viterbi']['jaw']:.2f} of the performer's",
            f"{RANGE:g}",
            RANGE / found["viterbi"]["jaw"],
            limit=1.0,
        ),
        _limited("sentences of the table said again, error", found["round_trip"], ROUND_TRIP, "{:.4f}"),
        _limited("jerk at joins, beside that within units", found["jerk"]["inside"], INSIDE, "{:.2f}"),
        _limited("the same, beside that of recordings", found["jerk"]["recorded"], RECORDED, "{:.2f}"),
        _limited(f"p, b, m with open lips at {PICTURES:g} pictures a second", found["open"], OPEN, "{:.1%}"),
        _timed("ten words, nearest", found["nearest"]["seconds"], NEAREST),
        _timed("ten words, Viterbi", found["viterbi"]["seconds"], VITERBI),
        _timed("a sentence looked up, Viterbi", found["looked_up"], LOOKED_UP),
        _limited(f"memory from {SOONER / 60:g} to {LATER / 60:g} min of text", found["growth"], MOST_MB, "{:.1f} MB"),
    ]


def _limited(name: str, measured: float, limit: float, form: str) -> Figure:
    return Figure(name, form.format(measured), form.format(limit), measured / limit, limit=1.0)


def _timed(name: str, seconds: float, limit: float) -> Figure:
    return Figure(
        name, f"{1000 * seconds:.1f} ms", f"{1000 * limit:g} ms", seconds / limit, limit=1.0, absolute=Absolute.TIME
    )


def main() -> None:
    """Measure, and print it as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        performances = _performances(Path(folder) / "corpus")
        left_out = performances[:: len(performances) // N_LEFT_OUT][:N_LEFT_OUT]
        kept = [performance for performance in performances if performance not in left_out]
        about = write_table(Path(folder) / "t.sqlite", kept)
        with PerformanceTable.open(Path(folder) / "t.sqlite") as table:
            found = {
                "minutes": about.duration / 60,
                "rules": _error(left_out, _rules_of(kept)),
                "viterbi": _compared(table, ExampleChoice.VITERBI, left_out),
                "nearest": _compared(table, ExampleChoice.NEAREST, left_out),
                "round_trip": _round_trip(table, kept[::5]),
                "jerk": _jerk(table, left_out),
                "open": _open(table, left_out),
                "looked_up": _looked_up(table, left_out),
                "growth": _growth(table),
            }
    print(json.dumps(found))


def _performances(folder: Path) -> list[Performance]:
    make_corpus(folder, sentences(1), lambda text: speak(text, VOICE), seconds=60 * MINUTES)
    return [read_performance(recording, synthetic=True)[0] for recording in find_recordings(folder).recordings]


Say = Callable[[Performance], Float32Array]
"""Gives the mouth of a sentence, a frame for each of its recording."""


def _recorded(performance: Performance) -> Float32Array:
    return performance.weights[:, [performance.channels.index(ARKIT[k]) for k in COLUMNS]]


def _times(performance: Performance) -> Float64Array:
    return np.arange(len(performance.weights)) / performance.rate


def _saying(driver: PerformanceDriver) -> Say:
    def say(performance: Performance) -> Float32Array:
        return driver.weights(performance.phones, 0, _times(performance), 1 / performance.rate)[:, COLUMNS]

    return say


def _rules_of(performances: Sequence[Performance]) -> Say:
    seen = defaultdict(list)
    for performance in performances:
        recorded = _recorded(performance)
        for phone in performance.phones:
            seen[phone.name].append(recorded[min(round(phone.middle * performance.rate), len(recorded) - 1)])
    poses = {name: np.mean(rows, axis=0) for name, rows in seen.items()}

    def say(performance: Performance) -> Float32Array:
        times, middles = _times(performance), np.array([phone.middle for phone in performance.phones])
        rows = np.array([poses[phone.name] for phone in performance.phones])
        k = np.clip(np.searchsorted(middles, times, "right") - 1, 0, len(middles) - 2)
        progress = np.clip((times - middles[k]) / (middles[k + 1] - middles[k]), 0, 1)
        share = (0.5 - 0.5 * np.cos(np.pi * progress))[:, None]
        found: Float32Array = rows[k] + share * (rows[k + 1] - rows[k])
        return found

    return say


def _error(performances: Sequence[Performance], say: Say) -> float:
    """Give the root mean square of the differences from what was recorded."""
    return math.sqrt(statistics.mean(float(np.mean((say(p) - _recorded(p)) ** 2)) for p in performances))


def _compared(table: PerformanceTable, choice: ExampleChoice, left_out: Sequence[Performance]) -> dict[str, float]:
    say = _saying(PerformanceDriver(table, PerformanceOptions(choice)))
    ranges = [np.ptp(say(p)[:, JAW]) / np.ptp(_recorded(p)[:, JAW]) for p in left_out]
    seconds = [_seconds(lambda p=p: say(p)) * 10 / len(p.words) for p in left_out]  # type: ignore[misc]
    return {"error": _error(left_out, say), "jaw": float(np.mean(ranges)), "seconds": statistics.median(seconds)}


def _seconds(act: Callable[[], object]) -> float:
    began = time.perf_counter()
    act()
    return time.perf_counter() - began


def _round_trip(table: PerformanceTable, kept: Sequence[Performance]) -> float:
    say = _saying(PerformanceDriver(table, PerformanceOptions(ExampleChoice.NEAREST, without=BARE)))
    return statistics.mean(_error([performance], say) for performance in kept)


def _jerk(table: PerformanceTable, left_out: Sequence[Performance]) -> dict[str, float]:
    """Give the mean third difference at joins, as a share of that within units, and of that of recordings."""
    driver = PerformanceDriver(table, PerformanceOptions(without=BARE))
    say, at_joins, inside, recorded = _saying(driver), [], [], []
    for performance in left_out:
        jerk = np.abs(np.diff(say(performance), 3, axis=0)).mean(axis=1)
        times = _times(performance)[:-3] + 1.5 / performance.rate
        joins = np.array([unit.start for unit in driver.units(performance.phones, 0)[1:]])
        near = np.abs(times[:, None] - joins).min(axis=1) <= 1 / performance.rate
        at_joins.append(jerk[near].mean())
        inside.append(jerk[~near].mean())
        recorded.append(np.abs(np.diff(_recorded(performance), 3, axis=0)).mean())
    mean = float(np.mean(at_joins))
    return {"inside": mean / float(np.mean(inside)), "recorded": mean / float(np.mean(recorded))}


@dataclass(frozen=True, eq=False)
class Lips:
    """How far lips are from each other: at rest, and how much farther each blend shape parts them."""

    rest: Float64Array
    parted: Float64Array

    @classmethod
    def of_head(cls) -> "Lips":
        """Find them in the head that ships: where the jaw takes a vertex from a neighbour that stays."""
        head = load_head()
        places, n = head.mesh.positions, len(head.mesh)
        moves = {state.name: _dense(state, n) for state in head.states}
        down = -moves["jawOpen"][:, 1]
        near = (np.abs(places[:, 0]) < 0.12) & (places[:, 2] > 0.9)
        lower = np.flatnonzero(near & (down > 0.25 * down.max()))
        upper = np.flatnonzero(near & (down < 0.05 * down.max()))
        apart = np.linalg.norm(places[lower][:, None] - places[upper], axis=2)
        rows, columns = np.nonzero(apart < 0.03)
        low, high = lower[rows], upper[columns]
        parted = np.array([moves[name][high, 1] - moves[name][low, 1] for name in ARKIT])
        return cls(places[high, 1] - places[low, 1], parted)

    def apart(self, animation: Animation) -> Float64Array:
        """Give how far they are apart in each frame, in the middle."""
        return np.median(self.rest + animation.weights @ self.parted, axis=1)


def _dense(state: Movestate, n: int) -> Float64Array:
    dense = np.zeros((n, 3))
    dense[state.numbers] = state.offsets
    return dense


def _open(table: PerformanceTable, left_out: Sequence[Performance]) -> float:
    """Give the share of p, b and m, from closure to end, in which no picture shows shut lips."""
    lips, shut = Lips.of_head(), []
    driver = PerformanceDriver(table)
    for performance in left_out:
        times = np.arange(0, performance.duration, 1 / (2 * PICTURES))
        weights = driver.weights(performance.phones, 0, times, 1 / PICTURES)[::2]
        moved = Animation(PICTURES, FACE, weights, np.zeros((len(weights), 3), np.float32))
        apart = lips.apart(moved.of_movestates(ARKIT))
        for phone in performance.phones:
            if phone.name in {"p", "b", "m"}:
                seen = apart[(times[::2] >= phone.start) & (times[::2] <= phone.end)]
                shut.append(seen.min(initial=1.0) <= SHUT)
    return 1 - float(np.mean(shut))


def _looked_up(table: PerformanceTable, left_out: Sequence[Performance]) -> float:
    driver = PerformanceDriver(table)
    return statistics.median(_seconds(lambda p=p: driver.units(p.phones, 0)) for p in left_out)  # type: ignore[misc]


def _growth(table: PerformanceTable) -> float:
    """Give by how many MB the process grows while a mouth says a long text."""
    utterance = _long()
    mouth = PerformanceTrack(utterance, Transcript("", utterance.duration), table).mouth()
    seen = []
    for start, end in ((0.0, SOONER), (SOONER, LATER)):
        for time_ in np.arange(start, end, 1 / PICTURES).tolist():
            mouth.weights(time_)
        seen.append(resident_megabytes())
    return seen[1] - seen[0]


def _long() -> Utterance:
    words, at = [], 0.0
    for text in sentences(2):
        if at > LATER:
            break
        said = speak(text, VOICE)[1]
        words += [shifted(word, at) for word in said.words]
        at += said.duration
    return Utterance(tuple(words), at)


if __name__ == "__main__":
    main()
