"""Which of the recorded examples of a unit is taken: any, the nearest in length, or those that fit best together."""

from collections.abc import Sequence
from enum import StrEnum
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PerformanceError
from phonemeengine.performance.halves import TRAITS, RecordedHalves, Recordings, traits_of
from phonemeengine.performance.search import PlacedUnit
from phonemeengine.performance.sentence import Sentence
from phonemeengine.performance.table_file import Example, PerformanceTable
from phonemeengine.performance.units import duration_of

N_CANDIDATES = 10
"""Examples of a unit that a way through the sentence may take: those of the nearest durations."""
BAND = 0.15
"""Share of a duration by which those of others may differ from it."""
TRAIT_WEIGHTS = {
    "duration": 0.4, "energy": 0.1, "pitch": 0.05, "stress": 0.15, "word": 0.05, "syllable": 0.05,
    "lips beside": 1.0, "rounding beside": 0.7, "opening beside": 0.7, "spreading beside": 0.4,
}  # fmt: skip
"""What a difference of each trait costs, beside differences of weights where two examples meet."""
_TRAIT_WEIGHTS = np.array([TRAIT_WEIGHTS[name] for name in TRAITS], np.float32)
_LONGEST = 1e9

Chosen = tuple[RecordedHalves, Example]
"""An example and its recording."""


class ExampleChoice(StrEnum):
    """How one of several examples is chosen."""

    VITERBI = "viterbi"
    NEAREST = "nearest"
    BAND = "band"
    RANDOM = "random"


def chosen_examples(
    placed: Sequence[PlacedUnit],
    sentence: Sentence,
    table: PerformanceTable,
    recordings: Recordings,
    choice: ExampleChoice,
    seed: Sequence[int],
) -> list[Chosen]:
    """Return an example for each unit of a sentence.

    Parameters
    ----------
    placed : the units.
    table, recordings : where the examples are.
    seed : whole numbers from 0, of what is left to chance; equal ones choose alike.

    Raises
    ------
    PerformanceError : the table is damaged.
    """
    candidates = [_candidates(unit, duration_of(unit.unit, sentence), table, choice) for unit in placed]
    if choice is not ExampleChoice.VITERBI:
        chance = np.random.default_rng([*seed])
        candidates = [(few[chance.integers(len(few))],) for few in candidates]
    chosen = [
        [_found(example, unit, table, recordings) for example in few]
        for unit, few in zip(placed, candidates, strict=True)
    ]
    return [few[0] for few in chosen] if choice is not ExampleChoice.VITERBI else _best_way(placed, chosen, sentence)


def _candidates(
    placed: PlacedUnit, duration: float, table: PerformanceTable, choice: ExampleChoice
) -> tuple[Example, ...]:  # fmt: skip
    """Return the examples among which is chosen, at least one."""
    found: tuple[Example, ...] = ()
    if choice is ExampleChoice.RANDOM:
        found = table.within(placed.kind, placed.names, 0.0, _LONGEST)
    if choice is ExampleChoice.BAND:
        found = table.within(placed.kind, placed.names, duration * (1 - BAND), duration * (1 + BAND))
    n = N_CANDIDATES if choice is ExampleChoice.VITERBI else 1
    found = found or table.nearest(placed.kind, placed.names, duration, n)
    if not found:
        raise _damage(table)
    return found


def _found(example: Example, placed: PlacedUnit, table: PerformanceTable, recordings: Recordings) -> Chosen:
    """Return an example with its recording, in which it must be."""
    halves, unit = recordings[example.recording], placed.unit
    if example.last - example.first != unit.last - unit.first or not 0 <= example.first < example.last <= len(halves):
        raise _damage(table)
    return halves, example


def _damage(table: PerformanceTable) -> PerformanceError:
    return PerformanceError(
        f"{table.about.name}: this table of performances is damaged (a unit is not in its recording); build it anew "
        "with `phonemeanalyser performance build`"
    )


def _best_way(placed: Sequence[PlacedUnit], chosen: Sequence[Sequence[Chosen]], sentence: Sentence) -> list[Chosen]:
    """Return the way of the least cost: of the examples beside what is asked for, and of each beside the next one.

    A. Hunt and A. Black, Unit selection in a concatenative speech synthesis system (1996); A. Viterbi (1967).
    """
    wanted = traits_of(sentence)
    costs = [
        _target_costs(few, wanted[unit.unit.first : unit.unit.last]) for unit, few in zip(placed, chosen, strict=True)
    ]
    total, ways = costs[0], []
    for (before, after), own in zip(pairwise(chosen), costs[1:], strict=True):
        joined = total[:, None] + _join_costs(before, after)
        ways.append(joined.argmin(axis=0))
        total = joined.min(axis=0) + own
    best = [int(total.argmin())]
    for way in reversed(ways):
        best.append(int(way[best[-1]]))
    return [few[k] for few, k in zip(chosen, reversed(best), strict=True)]


def _target_costs(chosen: Sequence[Chosen], wanted: Float32Array) -> Float32Array:
    """Return how far the traits of examples are from what is wanted, shape (n_examples,)."""
    traits = np.stack([halves.traits[example.first : example.last] for halves, example in chosen])
    costs: Float32Array = (np.abs(traits - wanted) @ _TRAIT_WEIGHTS).sum(axis=1)
    return costs


def _join_costs(before: Sequence[Chosen], after: Sequence[Chosen]) -> Float32Array:
    """Return how far faces are from each other where an example meets the next one, shape (n_before, n_after)."""
    ends = np.stack([halves.joints[example.last] for halves, example in before])
    starts = np.stack([halves.joints[example.first] for halves, example in after])
    costs: Float32Array = np.abs(ends[:, None] - starts).sum(axis=2)
    return costs
