"""Rules: a list of comparisons for each phoneme; the first rule whose comparisons all hold names the phoneme.

The thesis rules are a table here, compared with the preset's thresholds; extended rules are the preset's own. Rules
that can never fire, that always do, or that no frame reaches are found.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.arrays import LARGEST_FLOAT32, BoolArray, Float32Array, IndexArray, UInt8Array
from phonemeengine.dsp.pitch import HIGHEST, LOWEST
from phonemeengine.errors import SettingsError
from phonemeengine.features.variables import PITCH_SET_COLUMNS, Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import Recognition, RuleComparison, Trace

RULE_FIELDS = (
    ("silence_zero_crossings", "silence_energy", "silence_max_energy", "silence_szsch1"),
    ("szsch_szsch1", "sz_s1"),
    ("p_max_energy", "p_energy_n", "p_p1", "p_p2"),
    ("ae_ae1", "a_a1"),
    ("ouim_ae1", "u_o1", "o_o1", "i_o1"),
)
FILTER_FIELDS = ("time_smooth", "frequency_smooth", "high_pass_start", "high_pass_end", "denoise_threshold")
LAYOUT = (FILTER_FIELDS, *RULE_FIELDS)
"""The lines of a PhonemeData file."""


@dataclass(frozen=True, kw_only=True)
class Thresholds:
    """The 16 numbers that the thesis rules compare with; the first part of a name is the rule.

    Units are those of the variables: counts per window, amplitudes, or sums of normalised amplitudes.

    Raises
    ------
    SettingsError : a number is not finite, or too large for float32.
    """

    silence_zero_crossings: float = 220.0
    silence_energy: float = 0.1
    silence_max_energy: float = 0.01
    silence_szsch1: float = 10.0
    szsch_szsch1: float = 15.0
    sz_s1: float = 15.0
    p_max_energy: float = 0.1
    p_energy_n: float = 20.0
    p_p1: float = 1.0
    p_p2: float = 0.05
    ae_ae1: float = 0.3
    a_a1: float = 6.0
    ouim_ae1: float = 0.3
    u_o1: float = 6.0
    o_o1: float = 4.0
    i_o1: float = 2.5

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not abs(value) <= LARGEST_FLOAT32:
                raise SettingsError(f"{field.name} must be a finite number within ±3.4e38, got {value}; correct it")


@dataclass(frozen=True, kw_only=True)
class PhonemeData(Thresholds):
    """The 21 numbers of a PhonemeData file: the thresholds and five parameters of the filters.

    The high-pass bounds are bins of 21.53 Hz here, as the old files have them.
    """

    time_smooth: float = 0.0
    frequency_smooth: float = 0.0
    high_pass_start: float = 5.0
    high_pass_end: float = 7.0
    denoise_threshold: float = 0.0


@dataclass(frozen=True)
class PitchSet:
    """The 21 numbers for voices of a range of pitch, such as those of women (section 3.2 of the thesis).

    Attributes
    ----------
    name : what people call it, such as "woman".
    low, high : the range of the fundamental frequency, Hz; `low` belongs to it and `high` does not.
    data : the numbers.

    Raises
    ------
    SettingsError : it has no name, or the range is empty or lies outside 60..500 Hz.
    """

    name: str
    low: float
    high: float
    data: PhonemeData

    def __post_init__(self) -> None:
        if not self.name.strip():
            raise SettingsError("a pitch set has no name; give it one, such as woman")
        if not LOWEST <= self.low < self.high <= HIGHEST:
            raise SettingsError(
                f"the pitch set {self.name[:40]!r} must range upwards within {LOWEST:g}..{HIGHEST:g} Hz, got "
                f"{self.low:g}..{self.high:g} Hz; correct it"
            )


@dataclass(frozen=True)
class Condition:
    """A comparison of a variable with a threshold of the preset, such as ``m_a1 < a_a1``, or with a number.

    Attributes
    ----------
    variable : what is measured.
    sign : ``<`` or ``>``.
    threshold : name of a threshold; empty where `limit` is the number.
    limit : the number.
    enabled : whether it is asked; one that is switched off is kept, and always holds.
    """

    variable: str
    sign: str
    threshold: str = ""
    limit: float = 0.0
    enabled: bool = True

    @override
    def __str__(self) -> str:
        return f"{self.variable} {self.sign} {self.threshold or self.limit}"


@dataclass(frozen=True)
class Rule:
    """A phoneme, and the conditions that must all hold for it; one that is switched off is kept, and never fires."""

    phoneme: Phoneme
    conditions: tuple[Condition, ...]
    enabled: bool = True


def _rule(phoneme: Phoneme, *conditions: str) -> Rule:
    parts = [condition.split() for condition in conditions]
    return Rule(phoneme, tuple(Condition(variable, sign, threshold) for variable, sign, threshold in parts))


RULES: tuple[Rule, ...] = (
    _rule(
        Phoneme.SILENCE,
        "zero_crossings < silence_zero_crossings",
        "energy < silence_energy",
        "max_energy < silence_max_energy",
        "m_szsch1 < silence_szsch1",
    ),
    _rule(Phoneme.SZ, "m_szsch1 > szsch_szsch1", "m_s1 > sz_s1"),
    _rule(Phoneme.SCH, "m_szsch1 > szsch_szsch1"),
    _rule(Phoneme.P, "max_energy > p_max_energy", "energy_n > p_energy_n", "m_p1 > p_p1", "m_p2 < p_p2"),
    _rule(Phoneme.A, "m_ae1 > ae_ae1", "m_a1 < a_a1"),
    _rule(Phoneme.E, "m_ae1 > ae_ae1"),
    _rule(Phoneme.U, "m_ae1 < ouim_ae1", "m_o1 > u_o1"),
    _rule(Phoneme.O, "m_ae1 < ouim_ae1", "m_o1 > o_o1"),
    _rule(Phoneme.I, "m_ae1 < ouim_ae1", "m_o1 > i_o1"),
    _rule(Phoneme.M, "m_ae1 < ouim_ae1"),
)
"""The rules of the thesis."""

CONDITIONS: tuple[Condition, ...] = tuple(dict.fromkeys(c for rule in RULES for c in rule.conditions))
"""Every comparison of the thesis rules once."""

DEFAULT_RULE = Rule(Phoneme.UNIDENTIFIED, ())
"""What fires where no other rule does."""

_SIGNS = {">": 1, "<": -1}
Answer = TypeVar("Answer", np.uint8, np.float32)


def active_rules(rules: Sequence[Rule]) -> tuple[Rule, ...]:
    """Return what is asked of some rules: those that are switched on, with the conditions that are."""
    return tuple(
        replace(rule, conditions=tuple(c for c in rule.conditions if c.enabled)) for rule in rules if rule.enabled
    )


def rule_labels(rules: Sequence[Rule]) -> tuple[str, ...]:
    """Return what traces call each rule: its phoneme, with a number where several active rules have the same.

    One that is switched off has an empty label.
    """
    totals = Counter(rule.phoneme for rule in rules if rule.enabled)
    seen: Counter[Phoneme] = Counter()
    labels = []
    for rule in rules:
        seen[rule.phoneme] += rule.enabled
        number = f" {seen[rule.phoneme]}" if totals[rule.phoneme] > 1 else ""
        labels.append(f"{rule.phoneme.label}{number}" if rule.enabled else "")
    return tuple(labels)


class RuleRecogniser:
    """Recognises by rules; says which one fired, and by what margins.

    All comparisons of a block are one; what a value exceeds its limit by is the margin, positive where it holds.

    Parameters
    ----------
    rules : in the order in which they apply; what is switched off in them is left out.
    thresholds : the numbers that conditions name.
    """

    look_ahead = 0
    scores: tuple[str, ...] = ()

    def __init__(self, rules: Sequence[Rule], thresholds: Thresholds) -> None:
        # A block is recognised without a loop over frames or rules: column c of a matrix says whether condition c
        # fails, and `members` adds these up for each rule.
        self._rules = (*active_rules(rules), DEFAULT_RULE)
        self._conditions = tuple(dict.fromkeys(c for rule in rules for c in rule.conditions))
        self._limits_of = {c: limit_of(c, thresholds) for c in self._conditions}
        self._condition_columns = self._columns_of_rules()
        members = np.zeros((len(self._conditions) + 1, len(self._rules)), np.float32)
        members[self._condition_columns.T, np.arange(len(self._rules))] = 1
        self._members = members[:-1]
        self._labels = rule_labels(self._rules)
        self._phonemes = np.array([rule.phoneme for rule in self._rules], np.uint8)
        self._by_phoneme = np.argsort(self._phonemes, kind="stable")
        self._named, self._firsts = np.unique(self._phonemes[self._by_phoneme], return_index=True)
        self._names: tuple[str, ...] = ()

    @property
    def used_thresholds(self) -> frozenset[str]:
        """The fields of `Thresholds` that it compares with."""
        return frozenset(c.threshold for c in self._conditions if c.threshold)

    @property
    def rules(self) -> tuple[Rule, ...]:
        """What it asks, in this order; the last one always holds."""
        return self._rules

    def limit_of(self, condition: Condition) -> float:
        """Return what one of its conditions compares with."""
        return self._limits_of[condition]

    def recognise(self, _windows: Float32Array, features: Features) -> Recognition:
        """Recognise a block."""
        return Recognition(self.phonemes_of(features))

    def phonemes_of(self, features: Features) -> UInt8Array:
        """Return which phoneme each frame's variables are, shape (n_frames,)."""
        # a rule holds with no failure; argmin takes the first of equals, so the order of the rules decides, and the
        # last rule, which asks nothing, always has none
        failures = (self._compared(features) <= self._limits).dot(self._members)
        phonemes: UInt8Array = self._phonemes[failures.argmin(axis=1)]
        return phonemes

    def deficits(self, features: Features) -> Float32Array:
        """Return how much the limits would have to give way until each phoneme is named, as a share of them.

        For a rule to fire, its own comparisons must hold, and of each rule before it one must fail; the phoneme that
        is named falls short by 0. Returns float32, shape (n_frames, n_phonemes).
        """
        # relative, so that limits of counts and of amplitudes compare; 1e-9 stands in for a limit of 0
        margins = (self._compared(features) - self._limits) / np.maximum(np.abs(self._limits), 1e-9)
        of_conditions = np.full((len(self._conditions) + 1, len(margins)), np.inf, np.float32)
        of_conditions[:-1] = margins.T  # frames last: whole rows are compared, which is far quicker
        # A rule is as strong as its weakest condition. The padding is infinitely strong, and so is the last rule.
        strengths = of_conditions[self._condition_columns].min(axis=1)
        # What fires earlier wins: to name a rule, the strongest one before it has to be brought down as well.
        in_the_way = np.maximum.accumulate(strengths, axis=0)[:-1]
        # the greater of both, and not the sum: all limits give way by the same share at once
        costs = np.maximum(-strengths, 0)
        costs[1:] = np.maximum(costs[1:], in_the_way)
        # the cheapest of the rules of each phoneme; those are neighbours after sorting, so `reduceat` finds it
        least = np.full((len(Phoneme), len(margins)), np.inf, np.float32)
        least[self._named] = np.minimum.reduceat(costs[self._by_phoneme], self._firsts, axis=0)
        return least.T

    def explain(self, features: Features, k: int) -> Trace:
        """Return why frame `k` of a block is recognised as it is: all comparisons down to the rule that fired.

        A frame on which a variable of the rules was not measured yet is unidentified without comparisons.
        """
        if not {c.variable for c in self._conditions} <= set(features.names):
            return Trace(DEFAULT_RULE.phoneme, DEFAULT_RULE.phoneme.label, ())
        row = Features(features.names, features.values[k : k + 1])
        margins = (self._compared(row) - self._limits)[0]
        fired = int((margins <= 0).dot(self._members).argmin())
        values, of_condition = row.frame(0), dict(zip(self._conditions, margins.tolist(), strict=True))
        comparisons = tuple(
            RuleComparison(
                rule=self._labels[number],
                variable=c.variable,
                value=values[c.variable],
                sign=c.sign,
                threshold=c.threshold,
                limit=self._limits_of[c],
                margin=of_condition[c],
            )
            for number, rule in enumerate(self._rules[: fired + 1])
            for c in rule.conditions
        )
        return Trace(self._rules[fired].phoneme, self._labels[fired], comparisons)

    def _columns_of_rules(self) -> IndexArray:
        """Return the conditions of each rule by number, shape (n_rules, n_asked); the last number always holds."""
        numbers = {c: k for k, c in enumerate(self._conditions)}
        columns = np.full((len(self._rules), max(1, *(len(r.conditions) for r in self._rules))), len(numbers))
        for k, rule in enumerate(self._rules):
            columns[k, : len(rule.conditions)] = [numbers[c] for c in rule.conditions]
        return columns

    def _compared(self, features: Features) -> Float32Array:
        """Return what must exceed the limits for a comparison to hold: values, those of `<` with their sign turned.

        Shape (n_frames, n_conditions).
        """
        # Each column of the matrix picks one variable, with the sign that turns `<` into `>`: one product serves all
        # conditions. Presets rarely change while a sound runs, so it is kept.
        if features.names != self._names:
            self._names = features.names
            self._signed = np.zeros((len(features.names), len(self._conditions)), np.float32)
            for k, c in enumerate(self._conditions):
                self._signed[features.names.index(c.variable), k] = _SIGNS[c.sign]
            self._limits = np.array([[_SIGNS[c.sign] * self._limits_of[c] for c in self._conditions]], np.float32)
        compared: Float32Array = features.values.dot(self._signed)
        return compared


class ThesisRules(RuleRecogniser):
    """The thesis rules with one set of thresholds."""

    def __init__(self, thresholds: Thresholds) -> None:
        super().__init__(RULES, thresholds)


class PitchSetRules(ThesisRules):
    """The thesis rules with the thresholds of that set of PhonemeData which the pitch of the voice chooses.

    Parameters
    ----------
    thresholds : where no set is chosen.
    sets : the thresholds of each set; a column of the features tells which one a frame has, from 1 on.
    """

    def __init__(self, thresholds: Thresholds, sets: Sequence[Thresholds]) -> None:
        super().__init__(thresholds)
        self.by_set = (ThesisRules(thresholds), *map(ThesisRules, sets))

    @override
    def phonemes_of(self, features: Features) -> UInt8Array:
        return self._chosen(features, lambda rules: rules.phonemes_of(features))

    @override
    def deficits(self, features: Features) -> Float32Array:
        return self._chosen(features, lambda rules: rules.deficits(features))

    @override
    def explain(self, features: Features, k: int) -> Trace:
        return self.by_set[int(self._numbers(features)[k])].explain(features, k)

    def _chosen(self, features: Features, answer: Callable[[RuleRecogniser], NDArray[Answer]]) -> NDArray[Answer]:
        numbers = self._numbers(features)
        answers = answer(self.by_set[0])
        for number in np.unique(numbers[numbers > 0]).tolist():
            chosen = numbers == number
            answers[chosen] = answer(self.by_set[int(number)])[chosen]
        return answers

    @staticmethod
    def _numbers(features: Features) -> Float32Array:
        """Return which set each frame has; none where that was not measured."""
        name = PITCH_SET_COLUMNS[1]
        found = features[name] if name in features.names else np.zeros(len(features.values), np.float32)
        return np.nan_to_num(found)


def limit_of(condition: Condition, thresholds: Thresholds) -> float:
    """Return what a condition compares with."""
    return float(getattr(thresholds, condition.threshold) if condition.threshold else condition.limit)


Bounds = dict[tuple[str, str], float]
"""The narrowest limit by variable and sign."""


class RuleFault(StrEnum):
    """Why a rule is of no use, as the end of a sentence about it."""

    CONTRADICTORY = "can never hold: two conditions contradict each other"
    COVERED = "is never reached: an earlier rule holds wherever this one does"
    NEVER = "never holds in the loaded sound"
    ALWAYS = "always holds in the loaded sound: no later rule is reached"
    UNREACHED = "decides no frame of the loaded sound: earlier rules do"


def rule_faults(rules: Sequence[Rule], thresholds: Thresholds, *sounds: Features) -> tuple[RuleFault | None, ...]:
    """Return what is wrong with each rule; None where it is switched off, or nothing is.

    Parameters
    ----------
    rules : in the order in which they apply.
    thresholds : the numbers that conditions name.
    sounds : what was measured, to find rules that no frame needs; without any, or where a variable of a rule is not
        measured, only the rules themselves are looked at. A last rule without conditions takes what is left, if any.
    """
    found = [_faults_in(rules, thresholds, features) for features in sounds or (None,)]
    return tuple(_joined(set(of_rule)) for of_rule in zip(*found, strict=True))


def _joined(faults: set[RuleFault | None]) -> RuleFault | None:
    """Return what is wrong with a rule in several sounds together."""
    if len(faults) == 1:
        return faults.pop()
    return RuleFault.UNREACHED if faults == {RuleFault.NEVER, RuleFault.UNREACHED} else None


def _faults_in(rules: Sequence[Rule], thresholds: Thresholds, features: Features | None) -> list[RuleFault | None]:
    faults: list[RuleFault | None] = [None] * len(rules)
    earlier: list[Bounds] = []
    decided = np.zeros(0 if features is None else len(features.values), bool)
    for k, rule in enumerate(rules):
        if not rule.enabled:
            continue
        bounds = _bounds_of(rule, thresholds)
        faults[k] = _fault_of(bounds, earlier)
        holds = None if features is None or not len(decided) else _holding(rule, thresholds, features)
        if holds is not None:
            is_else = not bounds and not any(later.enabled for later in rules[k + 1 :])
            faults[k] = faults[k] or _fault_in(holds, decided, is_else=is_else)
            decided |= holds
        elif not bounds and any(later.enabled for later in rules[k + 1 :]):
            faults[k] = faults[k] or RuleFault.ALWAYS
        earlier.append(bounds)
    return faults


def _fault_of(bounds: Bounds, earlier: Sequence[Bounds]) -> RuleFault | None:
    """Return what is wrong with a rule whatever is measured."""
    if any(bounds.get((variable, "<"), np.inf) <= limit for (variable, sign), limit in bounds.items() if sign == ">"):
        return RuleFault.CONTRADICTORY
    return RuleFault.COVERED if any(_covers(other, bounds) for other in earlier) else None


def _covers(other: Bounds, bounds: Bounds) -> bool:
    """Return whether all that a rule asks holds wherever another one holds."""
    return all(
        key in bounds and (bounds[key] <= limit if key[1] == "<" else bounds[key] >= limit)
        for key, limit in other.items()
    )


def _fault_in(holds: BoolArray, decided: BoolArray, *, is_else: bool) -> RuleFault | None:
    """Return what is wrong with a rule in what was measured, where earlier rules have decided some frames."""
    if not holds.any():
        return RuleFault.NEVER
    if is_else:
        return None
    if holds.all():
        return RuleFault.ALWAYS
    return None if np.any(holds & ~decided) else RuleFault.UNREACHED


def _bounds_of(rule: Rule, thresholds: Thresholds) -> Bounds:
    bounds: Bounds = {}
    for c in _asked(rule):
        key, limit = (c.variable, c.sign), limit_of(c, thresholds)
        narrower = min if c.sign == "<" else max
        bounds[key] = narrower(bounds.get(key, limit), limit)
    return bounds


def _holding(rule: Rule, thresholds: Thresholds, features: Features) -> BoolArray | None:
    """Return in which frames a rule holds; None where a variable of it is not measured."""
    holds = np.ones(len(features.values), bool)
    for c in _asked(rule):
        if c.variable not in features.names:
            return None
        values, limit = features[c.variable], np.float32(limit_of(c, thresholds))
        holds &= values > limit if c.sign == ">" else values < limit
    return holds


def _asked(rule: Rule) -> list[Condition]:
    return [c for c in rule.conditions if c.enabled]
