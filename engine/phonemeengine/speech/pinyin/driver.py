"""The pinyin mouth: moves from the shape of a syllable's onset to that of its rime, and to rest in pauses."""

import math
from bisect import bisect_right
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.morpher import EasedMovement, shares_of
from phonemeengine.speech.pinyin.spring import SpringMass
from phonemeengine.speech.pinyin.table import REST, PinyinTable
from phonemeengine.speech.pinyin.timing import Plan, PlanKind

AFTERWARDS = 0.3
"""Seconds in which the mouth comes to rest after the last row."""


class PinyinMouth:
    """A mouth that says a plan: the weights of its movestates at any time.

    In each part of a syllable it moves along half a cosine from where it was to the part's shape, for the first share
    of the part that the table calls reach, and holds the shape for the rest. With a spring, a mass is drawn to the
    part's shape instead, from the part's start on.

    Parameters
    ----------
    plan : what is said.
    table : its shapes, and how the mouth goes there.

    Attributes
    ----------
    movestates : their names, in the order of the weights.
    rests_from : when it has come to rest after the last row, seconds.
    """

    def __init__(self, plan: Plan, table: PinyinTable) -> None:
        self.movestates = table.mouth.movestates
        shapes = table.weights()
        rows = {name: row for row, name in enumerate(shapes)}
        self._rows = np.array(list(shapes.values()))
        self._movements = [EasedMovement(-math.inf, 0.0, rows[REST]), *_movements_of(plan, table.reach, rows)]
        self._starts = [movement.start for movement in self._movements]
        self.rests_from = plan.duration + (AFTERWARDS if table.spring else self._movements[-1].duration)
        self._spring = None if table.spring is None else SpringMass(self._target, table.spring)

    def weights(self, time: float) -> Float32Array:
        """Return the weights at a time, seconds, float32, shape (n_movestates,), 1 for the whole movement."""
        return self._eased(time) if self._spring is None else self._spring.at(time)

    def head(self, time: float) -> None:
        """Let the head follow the sound."""

    def _eased(self, time: float) -> Float32Array:
        begun = bisect_right(self._starts, time)
        mixed = shares_of(self._movements[max(begun - 2, 0) : begun], time)
        shares = np.array([share for _, share in mixed], np.float32)
        weights: Float32Array = shares @ self._rows[[movement.row for movement, _ in mixed]]
        return weights

    def _target(self, time: float) -> Float32Array:
        shape: Float32Array = self._rows[self._movements[bisect_right(self._starts, time) - 1].row]
        return shape


def _movements_of(plan: Plan, reach: float, rows: dict[str, int]) -> Iterator[EasedMovement]:
    """Return the movement of each part; it has ended before the next one begins."""
    for row in plan.rows:
        bounds = (row.start, row.turn, row.end) if len(row.shapes) == 2 else (row.start, row.end)
        for shape, (start, end) in zip(row.shapes, pairwise(bounds), strict=True):
            length = end - start if row.kind is not PlanKind.PAUSE else min(end - start, plan.longest_closing)
            yield EasedMovement(start, reach * length, rows[shape])
    yield EasedMovement(plan.duration, reach * AFTERWARDS, rows[REST])
