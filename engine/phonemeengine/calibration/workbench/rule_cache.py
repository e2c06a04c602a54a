"""Rules asked of the same frames again and again: what a new limit does not touch is remembered.

It gives exactly what `RuleRecogniser` gives, but keeps for each comparison what it says of every frame. A limit that
is dragged changes one comparison, so only that and the rules that ask it are worked out anew.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Rule, RuleRecogniser


@dataclass(frozen=True)
class _ConditionKey:
    """A comparison of a variable with a limit: ``>``, ``<``, or whether its margin is more or not less than a share.

    Attributes
    ----------
    variable, sign, limit : the comparison.
    least : by what share of the limit it must hold at least (negative: may fail at most); None where it must hold.
    beyond : whether it must hold by more than `least`.
    """

    variable: str
    sign: str
    limit: float
    least: float | None = None
    beyond: bool = False


class RuleCache:
    """Asks rules of the same frames with ever other limits.

    Parameters
    ----------
    values : by variable, float32, shape (n_frames,), as a recogniser would get them.
    n_frames : how many frames there are.
    """

    def __init__(self, values: Mapping[str, Float32Array], n_frames: int) -> None:
        self._values = values
        self._n_frames = n_frames
        self._holding = _Memory()
        self._near_misses = _Memory()

    def recognised(self, recogniser: RuleRecogniser) -> UInt8Array:
        """Return the codes that `RuleRecogniser.recognise` gives, shape (n_frames,)."""
        self._holding.begin()
        codes = np.full(self._n_frames, Phoneme.UNIDENTIFIED, np.uint8)
        for rule in reversed(recogniser.rules):
            holds = self._all(self._holding, _condition_keys(rule, recogniser)).view(np.uint8)
            codes *= 1 - holds  # far quicker than to choose frame by frame
            codes += holds * np.uint8(rule.phoneme)
        return codes

    def may_stay(self, recogniser: RuleRecogniser, hysteresis: float) -> BoolArray:
        """Return where `RuleRecogniser.deficits` are at most `hysteresis`; shape (n_phonemes, n_frames).

        A phoneme may stay where the comparisons of one of its rules fail by no more than that, and no rule before
        that one holds by more.
        """
        self._near_misses.begin()
        stays = np.zeros((len(Phoneme), self._n_frames), bool)
        free = np.ones(self._n_frames, bool)
        for rule in recogniser.rules:
            nearly = self._all(self._near_misses, _condition_keys(rule, recogniser, -hysteresis))
            stays[rule.phoneme] |= nearly & free
            free &= ~self._all(self._near_misses, _condition_keys(rule, recogniser, hysteresis, beyond=True))
        return stays

    def _all(self, memory: "_Memory", keys: tuple[_ConditionKey, ...]) -> BoolArray:
        """Return where all of these hold."""
        if not keys:
            return np.ones(self._n_frames, bool)

        def answered() -> BoolArray:
            answer: BoolArray = np.logical_and.reduce([memory.recall(k, partial(self._answer, k)) for k in keys])
            return answer

        return memory.recall(keys, answered)

    def _answer(self, key: _ConditionKey) -> BoolArray:
        values, limit = self._values[key.variable], np.float32(key.limit)
        if key.least is None:
            return np.asarray(values > limit if key.sign == ">" else values < limit)
        margins = (values - limit if key.sign == ">" else limit - values) / np.maximum(np.abs(limit), 1e-9)
        return np.asarray(margins > key.least if key.beyond else margins >= key.least)


class _Memory:
    """Remembers what was worked out for the last question of each kind, and forgets what is no longer asked."""

    def __init__(self) -> None:
        self._before: dict[Hashable, BoolArray] = {}
        self._now: dict[Hashable, BoolArray] = {}

    def begin(self) -> None:
        """Keep only what has been asked since the last beginning."""
        self._before, self._now = self._now, {}

    def recall(self, key: Hashable, work_out: Callable[[], BoolArray]) -> BoolArray:
        """Return what was said of the same, or work it out."""
        answer = self._now.get(key)
        if answer is None:
            answer = self._before.get(key)
        if answer is None:
            answer = work_out()
        self._now[key] = answer
        return answer


def _condition_keys(
    rule: Rule, recogniser: RuleRecogniser, least: float | None = None, *, beyond: bool = False
) -> tuple[_ConditionKey, ...]:
    return tuple(
        _ConditionKey(c.variable, c.sign, recogniser.limit_of(c), least, beyond=beyond) for c in rule.conditions
    )
