"""The rules of the thesis: a table of comparisons; the first rule whose comparisons all hold names the phoneme."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.features.measure import Features
from engine.phonemes import Phoneme
from engine.recognition.phoneme_data import Thresholds
from engine.recognition.trace import Comparison, Trace


@dataclass(frozen=True)
class Condition:
    """A comparison of a variable with a threshold, such as ``m_a1 < a_a1``."""

    variable: str
    sign: str
    threshold: str


@dataclass(frozen=True)
class Rule:
    """A phoneme, and the conditions that must all hold for it."""

    phoneme: Phoneme
    conditions: tuple[Condition, ...]


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
    _rule(
        Phoneme.P,
        "max_energy > p_max_energy",
        "energy_n > p_energy_n",
        "m_p1 > p_p1",
        "m_p2 < p_p2",
    ),
    _rule(Phoneme.A, "m_ae1 > ae_ae1", "m_a1 < a_a1"),
    _rule(Phoneme.E, "m_ae1 > ae_ae1"),
    _rule(Phoneme.U, "m_ae1 < ouim_ae1", "m_o1 > u_o1"),
    _rule(Phoneme.O, "m_ae1 < ouim_ae1", "m_o1 > o_o1"),
    _rule(Phoneme.I, "m_ae1 < ouim_ae1", "m_o1 > i_o1"),
    _rule(Phoneme.M, "m_ae1 < ouim_ae1"),
    _rule(Phoneme.UNIDENTIFIED),
)

CONDITIONS: tuple[Condition, ...] = tuple(dict.fromkeys(c for rule in RULES for c in rule.conditions))
"""Every comparison once."""

_MEMBERS = np.array([[c in rule.conditions for rule in RULES] for c in CONDITIONS], np.float32)
_PHONEMES = np.array([rule.phoneme for rule in RULES], np.uint8)
_SIGNS = {">": 1, "<": -1}


class ThesisRules:
    """The rules with one set of thresholds.

    All comparisons of a block are one; what a value exceeds its limit by is the margin, positive where it holds.
    """

    used_thresholds = frozenset(c.threshold for c in CONDITIONS)

    def __init__(self, thresholds: Thresholds) -> None:
        self._thresholds = thresholds
        self._names: tuple[str, ...] = ()

    def recognise(self, features: Features) -> NDArray[np.uint8]:
        """Recognise a block; returns codes of `Phoneme`, shape (n_frames,)."""
        failures = (self._compared(features) <= self._limits).dot(_MEMBERS)
        phonemes: NDArray[np.uint8] = _PHONEMES[failures.argmin(axis=1)]
        return phonemes

    def explain(self, features: Features, k: int) -> Trace:
        """Say why frame `k` of a block is recognised as it is: all comparisons down to the rule that fired."""
        row = Features(features.names, features.values[k : k + 1])
        margins = (self._compared(row) - self._limits)[0]
        fired = int((margins <= 0).dot(_MEMBERS).argmin())
        asked = [(rule, c) for rule in RULES[: fired + 1] for c in rule.conditions]
        comparisons = tuple(
            Comparison(
                rule=rule.phoneme.label,
                variable=c.variable,
                value=float(row[c.variable][0]),
                sign=c.sign,
                threshold=c.threshold,
                limit=float(getattr(self._thresholds, c.threshold)),
                margin=float(margins[CONDITIONS.index(c)]),
            )
            for rule, c in asked
        )
        phoneme = RULES[fired].phoneme
        return Trace(phoneme, phoneme.label, comparisons)

    def _compared(self, features: Features) -> NDArray[np.float32]:
        """What must exceed the limits for a comparison to hold: values, those of `<` with their sign turned.

        Shape (n_frames, n_conditions).
        """
        if features.names is not self._names:
            self._names = features.names
            self._signed = np.zeros((len(features.names), len(CONDITIONS)), np.float32)
            for k, c in enumerate(CONDITIONS):
                self._signed[features.names.index(c.variable), k] = _SIGNS[c.sign]
            limits = [_SIGNS[c.sign] * getattr(self._thresholds, c.threshold) for c in CONDITIONS]
            self._limits = np.array([limits], np.float32)
        compared: NDArray[np.float32] = features.values.dot(self._signed)
        return compared
