"""Move the limits of a preset's own rules so that the macro F1 grows; try changes before they are made.

A coordinate search from the limits that are there: one limit after the other takes the best of its candidates, until
a round through all of them gains nothing. Comparisons of one variable with one number are one limit, whatever their
sign and rule, so what a tree divides stays divided. Two runs of the rules, with all values below the limit and all
above it, tell the score of every candidate at once.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, IndexArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores import scoring
from phonemeengine.calibration.workbench.batch_smoother import last_identified
from phonemeengine.calibration.workbench.retuner import Retuner, RuleCache
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Condition, Rule, RuleRecogniser, Thresholds, active_rules

N_CANDIDATES = 32
"""Few, since finer ones only fit better to the speakers that are there, not to others."""
SIGNIFICANT_DIGITS = 4
LEAST_GAIN = 1e-4
"""A limit moves only for so much macro F1."""
MOST_ROUNDS = 8

Limit = tuple[str, float]
"""A variable, and the number that it is compared with."""


class LimitSearch:
    """Fits the limits of rules to recordings that follow one another.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are not scored.
    first : bool, shape (n_frames,): where a recording begins; nothing is remembered from before.
    thresholds : what those comparisons ask for that name a threshold; they stay.
    successors : what replaces unidentified frames; it stays.
    """

    def __init__(
        self,
        features: Features,
        truth: UInt8Array,
        first: BoolArray,
        thresholds: Thresholds,
        successors: Mapping[Phoneme, Phoneme],
    ) -> None:
        self._values = {name: np.ascontiguousarray(features[name]) for name in features.names}
        self._rule_cache = RuleCache(self._values, len(truth))
        self._truth = truth
        self._first = first
        self._known = truth != Phoneme.UNIDENTIFIED
        self._thresholds = thresholds
        self._table = np.array([successors.get(p, p) for p in Phoneme], np.uint8)

    def improve(self, rules: Sequence[Rule], progress: Progress = no_progress) -> tuple[Rule, ...]:
        """Return the rules with better limits, or as they are; `progress` is called with the share that is done.

        Raises
        ------
        Cancelled : `progress` did not want to go on.
        """
        rules = tuple(rules)
        score = self._score(rules)
        limits = _limits_of(rules)
        for n in range(MOST_ROUNDS):
            before = score
            fillers = self._fillers(rules)
            for k, limit in enumerate(limits):
                report_progress(progress, (n + k / len(limits)) / MOST_ROUNDS)
                moved = self._best(limit, rules, fillers)
                better, gained = _moved(rules, limit, moved), 0.0
                if moved != limit[1] and (gained := self._score(better) - score) > LEAST_GAIN:
                    rules, limits[k], score = better, (limit[0], moved), score + gained
            if score - before <= LEAST_GAIN:
                break
        return rules

    def _best(self, limit: Limit, rules: tuple[Rule, ...], fillers: UInt8Array) -> float:
        """Return the best candidate for one limit, all others as they are."""
        values = self._values[limit[0]]
        taken = [number for variable, number in _limits_of(rules) if variable == limit[0]]
        candidates = np.setdiff1d(candidate_limits(values[self._known]), np.array(taken, np.float32))
        below, above = (self._answers_as_if(limit, rules, fillers, sign) for sign in "<>")
        open_ = self._known & (below != above)
        if not (open_.any() and len(candidates)):
            return limit[1]
        settled = scoring.confusion_of(self._truth[self._known & ~open_], below[self._known & ~open_])
        ranks = np.searchsorted(candidates, values[open_], side="right")
        truth = self._truth[open_]
        under = counts_by_rank(ranks, truth, below[open_], len(candidates) + 1).cumsum(axis=0)
        over = counts_by_rank(ranks, truth, above[open_], len(candidates) + 1).cumsum(axis=0)
        scores = scoring.macro_f1_of(settled + under[:-1] + over[-1] - over[:-1], scoring.SCORED_PHONEMES)
        return float(str(candidates[int(scores.argmax())]))

    def _answers_as_if(self, limit: Limit, rules: tuple[Rule, ...], fillers: UInt8Array, sign: str) -> UInt8Array:
        """Recognise as if all values of a variable were on one side of a limit."""
        kept = []
        for rule in active_rules(rules):
            others = [c for c in rule.conditions if _limit_of(c) != limit]
            if all(c.sign == sign for c in rule.conditions if _limit_of(c) == limit):
                kept.append(Rule(rule.phoneme, tuple(others)))
        answers = self._recognised(kept)
        return np.where(answers == Phoneme.UNIDENTIFIED, fillers, answers)

    def _fillers(self, rules: tuple[Rule, ...]) -> UInt8Array:
        """Return what fills in where the rules say nothing."""
        return self._table[last_identified(self._recognised(rules), self._first)]

    def _score(self, rules: tuple[Rule, ...]) -> float:
        answers = self._recognised(rules)
        unidentified = answers == Phoneme.UNIDENTIFIED
        answers = np.where(unidentified, self._table[last_identified(answers, self._first)], answers)
        return float(
            scoring.macro_f1_of(
                scoring.confusion_of(self._truth[self._known], answers[self._known]), scoring.SCORED_PHONEMES
            )
        )

    def _recognised(self, rules: Sequence[Rule]) -> UInt8Array:
        return self._rule_cache.recognised(RuleRecogniser(rules, self._thresholds))


def _limits_of(rules: Sequence[Rule]) -> list[Limit]:
    found = [_limit_of(c) for rule in active_rules(rules) for c in rule.conditions]
    return list(dict.fromkeys(limit for limit in found if limit is not None))


def _limit_of(condition: Condition) -> Limit | None:
    """Return what a comparison may have moved; None where it names a threshold."""
    return None if condition.threshold else (condition.variable, condition.limit)


def _moved(rules: Sequence[Rule], limit: Limit, number: float) -> tuple[Rule, ...]:
    def with_number(c: Condition) -> Condition:
        return replace(c, limit=number) if _limit_of(c) == limit else c

    return tuple(replace(rule, conditions=tuple(map(with_number, rule.conditions))) for rule in rules)


def counts_by_rank(ranks: IndexArray, truth: UInt8Array, answers: UInt8Array, n_ranks: int) -> Int64Array:
    """Count frames by rank, label and answer, shape (n_ranks, 11, 11)."""
    cells = (ranks * scoring.N_CODES + truth) * scoring.N_CODES + answers
    return np.bincount(cells, minlength=n_ranks * scoring.N_CODES**2).reshape(
        n_ranks, scoring.N_CODES, scoring.N_CODES
    )


def candidate_limits(values: Float32Array) -> Float32Array:
    """Spread limits evenly over the ranks of the values, rounded so that a file shows few digits."""
    spread = np.quantile(values, np.linspace(0.005, 0.995, N_CANDIDATES))
    return np.unique(np.array([float(f"{value:.{SIGNIFICANT_DIGITS}g}") for value in spread], np.float32))


class RuleTrials:
    """Labelled frames, and what presets with other rules recognise in them.

    Parameters
    ----------
    features : what was measured.
    truth : codes of `Phoneme`, shape (n_frames,); frames labelled unidentified are not scored.
    edges : the first frame of each sound, and the number of all frames.
    """

    def __init__(self, features: Features, truth: UInt8Array, edges: IndexArray) -> None:
        self.features = features
        self.truth = truth
        values = dict(zip(features.names, np.ascontiguousarray(features.values.T), strict=True))
        self._retuner = Retuner(values, np.full(len(truth), Phoneme.UNIDENTIFIED, np.uint8), None, edges)

    @classmethod
    def of(cls, parts: Sequence[tuple[Features, UInt8Array, IndexArray]]) -> "RuleTrials":
        """Return trials on parts of labelled sound, as the parameters; what not all have measured is left out."""
        names = tuple(n for n in parts[0][0].names if all(n in features.names for features, _, _ in parts))
        values = np.concatenate([np.stack([f[n] for n in names], axis=1) for f, _, _ in parts])
        starts = np.cumsum([0, *(edges[-1] for _, _, edges in parts)])
        edges = np.concatenate([e[:-1] + start for (_, _, e), start in zip(parts, starts, strict=False)])
        truth = np.concatenate([truth for _, truth, _ in parts])
        return cls(Features(names, values), truth, np.append(edges, starts[-1]))

    def agreement(self, preset: Preset) -> scoring.Agreement:
        """Return how a preset with rules agrees with the labels, after the statistics."""
        return scoring.agreement_of(self.truth, self._retuner.recognise(preset)[1])

    def proposed(self, preset: Preset, rule: int, variable: str) -> Condition:
        """Return the comparison of a variable by which a rule gains most, with all its others as they are.

        What counts is the macro F1 together with the F1 of the phoneme that the rule names.

        Where the rule decides no labelled frame, the limit is the middle one of all values.

        Parameters
        ----------
        preset : with the rule, which may be a new one that asks nothing yet.
        rule : the rule's number, from 0.
        variable : what it is to ask.
        """
        values, known = self.features[variable], self.truth != Phoneme.UNIDENTIFIED
        holds, fails = self._answers(preset), self._answers(with_rule_off(preset, rule))
        open_ = known & (holds != fails)
        candidates = candidate_limits(values[open_]) if open_.any() else np.zeros(0, np.float32)
        if not len(candidates):
            middle = float(np.median(values)) if len(values) else 0.0
            return Condition(variable, ">", limit=float(f"{middle:.{SIGNIFICANT_DIGITS}g}"))
        settled = scoring.confusion_of(self.truth[known & ~open_], holds[known & ~open_])
        ranks, truth = np.searchsorted(candidates, values[open_], side="right"), self.truth[open_]
        kept, lost = (
            counts_by_rank(ranks, truth, codes[open_], len(candidates) + 1).cumsum(axis=0) for codes in (holds, fails)
        )
        counts = [settled + below[:-1] + above[-1] - above[:-1] for below, above in ((kept, lost), (lost, kept))]
        own = (preset.rules[rule].phoneme,)
        scores = [
            scoring.macro_f1_of(c, scoring.SCORED_PHONEMES) + np.nan_to_num(scoring.macro_f1_of(c, own))
            for c in counts
        ]
        sign, best = divmod(int(np.argmax(scores)), len(candidates))
        return Condition(variable, "<>"[sign], limit=float(str(candidates[best])))

    def _answers(self, preset: Preset) -> UInt8Array:
        return self._retuner.recognise(preset)[0]


def with_rule(preset: Preset, at: int, rule: Rule) -> Preset:
    """Return the preset with another rule in front of rule `at`."""
    return replace(preset, rules=(*preset.rules[:at], rule, *preset.rules[at:]))


def with_rule_off(preset: Preset, rule: int) -> Preset:
    """Return the preset with one of its rules switched off."""
    rules = tuple(replace(r, enabled=r.enabled and k != rule) for k, r in enumerate(preset.rules))
    return replace(preset, rules=rules)
