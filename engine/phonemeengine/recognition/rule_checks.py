"""What is wrong with rules: those that can never fire, those that always do, and those that no frame reaches."""

from collections.abc import Sequence
from enum import StrEnum

import numpy as np

from phonemeengine.arrays import BoolArray
from phonemeengine.features.measure import Features
from phonemeengine.recognition.phoneme_data import Thresholds
from phonemeengine.recognition.rules import Condition, Rule, limit_of

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
