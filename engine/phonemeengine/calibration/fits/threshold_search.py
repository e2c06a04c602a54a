"""Find the thresholds of the thesis rules, and the table of successors, that give the best macro F1.

A coordinate search: one threshold after the other takes the best of its candidates; after each round through all of
them the table of successors is counted anew, until neither helps. It starts anew from random thresholds, and the
best end counts. A threshold decides one condition, so two runs of the rules, with the condition everywhere true
and everywhere false, tell the exact score of every candidate at once.

Three demands keep every rule and every threshold alive: u, o and i share a variable, so their limits must descend; a
rule that finds too few frames of its own phoneme costs score, and so does a condition that excludes too few frames.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import (
    BoolArray,
    Float32Array,
    Float64Array,
    IndexArray,
    Int64Array,
    UInt8Array,
    UInt32Array,
)
from phonemeengine.calibration.scores.scoring import N_CODES, SCORED_PHONEMES
from phonemeengine.calibration.workbench.batch_smoother import counted_table, last_identified, successors_of
from phonemeengine.execution import Progress, no_progress, report_progress, subrange
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import CONDITIONS, RULES, Condition, Thresholds

N_CANDIDATES = 24
"""Few, since finer ones only fit better to the speakers that are there, not to others."""

OUTERMOST = 0.01
"""A threshold lies between this quantile of its variable over the frames of its rules' phonemes and the opposite
one, so that it bears on them."""

DESCENDING = ("u_o1", "o_o1", "i_o1")
"""Each of these leaves frames to the next one only where it is larger."""

LEAST_FOUND = 0.03
"""The share of its phoneme's frames that each rule must find by itself."""

LEAST_EXCLUDED = 0.0005
"""The share of all frames that each condition must exclude from its rules, all other conditions being as they are; a
threshold that excludes none says nothing."""

PRICE = 0.05
"""What each rule that finds none, and each condition that excludes none, costs in macro F1; one that reaches half of
its least share costs half."""

SIGNIFICANT_DIGITS = 4
LEAST_GAIN = 2e-4
MOST_ROUNDS = 20
PATIENCE = 2
"""Rounds without gain before the search gives up: a new table may cost at first."""

N_ANSWERS = 2 * N_CODES
"""What a rule says, or `N_CODES` more where the table of successors says it."""

Limits = dict[Condition, np.float32]

_BITS = {c: np.uint32(1 << k) for k, c in enumerate(CONDITIONS)}
_CLASSES = np.array(SCORED_PHONEMES)


def _answers_of_marks() -> UInt8Array:
    masks = np.arange(1 << len(CONDITIONS), dtype=np.uint32)
    answers = np.full(len(masks), Phoneme.UNIDENTIFIED, np.uint8)
    for rule in reversed(RULES):
        needed = np.uint32(sum(int(_BITS[c]) for c in rule.conditions))
        answers[(masks & needed) == needed] = rule.phoneme
    return answers


_ANSWERS = _answers_of_marks()
"""What the rules say for each pattern of conditions that hold; condition k is bit k."""


@dataclass(frozen=True)
class Fit:
    """The end of a search.

    Attributes
    ----------
    thresholds : the best that were found.
    successors : the table that belongs to them.
    score : their macro F1 on the frames that they were fitted to, less the price of idle rules and conditions.
    """

    thresholds: Thresholds
    successors: Mapping[Phoneme, Phoneme]
    score: float


class ThresholdSearch:
    """Fits to recordings that follow one another.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are not scored.
    first : bool, shape (n_frames,): where a recording begins; nothing is remembered from before.
    successors : the table that stays, where it is not to be counted anew.
    """

    def __init__(
        self,
        features: Features,
        truth: UInt8Array,
        first: BoolArray,
        successors: Mapping[Phoneme, Phoneme] | None = None,
    ) -> None:
        self._first = first
        self._kept = None if successors is None else np.array([successors.get(p, p) for p in Phoneme], np.uint8)
        self._known = truth != Phoneme.UNIDENTIFIED
        self._truth = truth[self._known].astype(np.int64)
        self._totals = np.bincount(self._truth, minlength=N_CODES)
        self._all_values = {c: np.ascontiguousarray(features[c.variable]) for c in CONDITIONS}
        self._values = {c: values[self._known] for c, values in self._all_values.items()}
        self._candidates = {c: self._candidates_of(c) for c in CONDITIONS}
        self._ranks = {
            c: np.searchsorted(self._candidates[c], values, side="left" if c.sign == ">" else "right")
            for c, values in self._values.items()
        }

    def best_of(self, n_starts: int, generator: np.random.Generator, progress: Progress = no_progress) -> Fit:
        """Search from some random starts and return the best end; `progress` is called with the share that is done.

        Raises
        ------
        Cancelled : `progress` did not want to go on.
        """
        starts = (subrange(progress, k / n_starts, (k + 1) / n_starts) for k in range(n_starts))
        return max((self._descend(generator, start) for start in starts), key=lambda fit: fit.score)

    def _descend(self, generator: np.random.Generator, progress: Progress) -> Fit:
        limits = self._start(generator)
        ends: list[Fit] = []
        for n in range(MOST_ROUNDS):
            report_progress(progress, n / MOST_ROUNDS)
            table, fillers = self._successors(limits)
            masks = _masks_of(self._values, limits)
            ends.append(Fit(_thresholds_of(limits), successors_of(table), self._score(masks, fillers)))
            if len(ends) > PATIENCE and ends[-1].score < max(e.score for e in ends[:-PATIENCE]) + LEAST_GAIN:
                break
            for k in generator.permutation(len(CONDITIONS)):
                masks = self._improve(CONDITIONS[k], limits, masks, fillers)
        return max(ends, key=lambda end: end.score)

    def _start(self, generator: np.random.Generator) -> Limits:
        """Draw each limit from that half of its candidates that lets more frames through to its rules."""
        limits = {}
        for c, candidates in self._candidates.items():
            middle = len(candidates) // 2
            limits[c] = generator.choice(candidates[: middle + 1] if c.sign == ">" else candidates[middle:])
        ladder = [c for name in DESCENDING for c in CONDITIONS if c.threshold == name]
        pool = np.unique(np.concatenate([self._candidates[c] for c in ladder]))
        drawn = generator.choice(pool, len(ladder), replace=len(pool) < len(ladder))
        return limits | dict(zip(ladder, sorted(drawn, reverse=True), strict=True))

    def _successors(self, limits: Limits) -> tuple[UInt8Array, UInt8Array]:
        """Count the table for these limits, and give what fills in at each scored frame."""
        answers = _ANSWERS[_masks_of(self._all_values, limits)]
        last = last_identified(answers, self._first)[self._known]
        unidentified = answers[self._known] == Phoneme.UNIDENTIFIED
        table = self._kept
        if table is None:
            table = counted_table(last[unidentified], self._truth[unidentified], self._totals)
        return table, (table[last] + N_CODES).astype(np.uint8)

    def _score(self, masks: UInt32Array, fillers: UInt8Array) -> float:
        answers = _ANSWERS[masks]
        excluded = [np.count_nonzero(_ANSWERS[masks | bit] != answers) for bit in _BITS.values()]
        score = float(self._scores(self._confusion(_filled(answers, fillers))))
        return score - float(self._price_of_idling(np.array(excluded)).sum())

    def _price_of_idling(self, excluded: Int64Array) -> Float64Array:
        return PRICE * np.clip(1 - excluded / (LEAST_EXCLUDED * len(self._truth)), 0, 1)

    def _improve(self, c: Condition, limits: Limits, masks: UInt32Array, fillers: UInt8Array) -> UInt32Array:
        scores = np.where(self._allowed(c, limits), self._scores_of_candidates(c, masks, fillers), -np.inf)
        now = scores[self._candidates[c] == limits[c]].max(initial=-np.inf)
        k = int(scores.argmax())
        if scores[k] <= now:
            return masks
        limits[c] = self._candidates[c][k]
        return (masks & ~_BITS[c]) | _mask_of(c, self._values[c], limits[c])

    def _allowed(self, c: Condition, limits: Limits) -> BoolArray:
        """Return which candidates keep the order of the thresholds that share a variable."""
        if c.threshold not in DESCENDING:
            return np.ones(len(self._candidates[c]), bool)
        k = DESCENDING.index(c.threshold)
        above = [limit for d, limit in limits.items() if d.threshold in DESCENDING[:k]]
        below = [limit for d, limit in limits.items() if d.threshold in DESCENDING[k + 1 :]]
        candidates = self._candidates[c]
        return np.asarray((candidates < min(above, default=np.inf)) & (candidates > max(below, default=-np.inf)))

    def _scores_of_candidates(self, c: Condition, masks: UInt32Array, fillers: UInt8Array) -> Float64Array:
        """Return the score with each candidate for one condition, all others as they are."""
        when_true, when_false = _ANSWERS[masks | _BITS[c]], _ANSWERS[masks & ~_BITS[c]]
        open_ = np.flatnonzero(when_true != when_false)
        when_true, when_false = _filled(when_true, fillers), _filled(when_false, fillers)
        below_true = self._counts_below(c, open_, when_true)
        below_false = self._counts_below(c, open_, when_false)
        settled = self._confusion(when_true) - below_true[-1]
        if c.sign == ">":
            true, false = below_true[-1] - below_true[:-1], below_false[:-1]
        else:
            true, false = below_true[:-1], below_false[-1] - below_false[:-1]
        return self._scores(settled + true + false) - self._price_of_idling(false.sum(axis=(1, 2)))

    def _counts_below(self, c: Condition, frames: IndexArray, answers: UInt8Array) -> Int64Array:
        """Count label and answer of the frames whose value lies below each candidate; the last row is all."""
        n = len(self._candidates[c]) + 1
        cells = self._ranks[c][frames] * N_CODES + self._truth[frames]
        counts = np.bincount(cells * N_ANSWERS + answers[frames], minlength=n * N_CODES * N_ANSWERS)
        return counts.reshape(n, N_CODES, N_ANSWERS).cumsum(axis=0)

    def _confusion(self, answers: UInt8Array) -> Int64Array:
        counts = np.bincount(self._truth * N_ANSWERS + answers, minlength=N_CODES * N_ANSWERS)
        return counts.reshape(N_CODES, N_ANSWERS)

    def _scores(self, confusion: Int64Array) -> Float64Array:
        """Return the macro F1 less the price, for counts of shape (..., N_CODES, N_ANSWERS)."""
        by_rule = confusion[..., :N_CODES]
        both = by_rule + confusion[..., N_CODES:]
        present = _CLASSES[self._totals[_CLASSES] > 0]
        totals = self._totals[present]
        hits = np.diagonal(both, axis1=-2, axis2=-1)[..., present]
        f1 = 2 * hits / (totals + both.sum(axis=-2)[..., present])
        found = np.diagonal(by_rule, axis1=-2, axis2=-1)[..., present] / totals
        missing = np.clip(1 - found / LEAST_FOUND, 0, 1).sum(axis=-1)
        return np.asarray(f1.mean(axis=-1) - PRICE * missing)

    def _candidates_of(self, c: Condition) -> Float32Array:
        """Spread thresholds evenly over the ranks of the values, rounded so that a file shows few digits."""
        values = self._values[c]
        own = values[np.isin(self._truth, [rule.phoneme for rule in RULES if c in rule.conditions])]
        ends = np.quantile(own if len(own) else values, (OUTERMOST, 1 - OUTERMOST))
        spread = np.quantile(values, np.linspace(0.002, 0.998, N_CANDIDATES))
        inside = spread[(spread >= ends[0]) & (spread <= ends[1])]
        rounded = [float(f"{value:.{SIGNIFICANT_DIGITS}g}") for value in (*ends, *inside)]
        return np.unique(np.array(rounded, np.float32))


def _thresholds_of(limits: Limits) -> Thresholds:
    return Thresholds(**{c.threshold: float(str(limits[c])) for c in CONDITIONS})


def _filled(answers: UInt8Array, fillers: UInt8Array) -> UInt8Array:
    return np.where(answers == Phoneme.UNIDENTIFIED, fillers, answers)


def _mask_of(c: Condition, values: Float32Array, limit: np.float32) -> UInt32Array:
    holds = values > limit if c.sign == ">" else values < limit
    masks: UInt32Array = holds * _BITS[c]
    return masks


def _masks_of(values: Mapping[Condition, Float32Array], limits: Limits) -> UInt32Array:
    """Tell for each frame which conditions hold, a bit each."""
    masks: UInt32Array = np.bitwise_or.reduce([_mask_of(c, values[c], limits[c]) for c in CONDITIONS])
    return masks
