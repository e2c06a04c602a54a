"""Rules of no use are found: by themselves, and in what was measured."""

import numpy as np
import pytest

from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.recognition.rules import RULES, Condition, Rule, RuleFault, Thresholds, rule_faults

GRID = Features(("x", "y"), np.array([(x, y) for x in range(10) for y in range(10)], np.float32))
REST = Rule(Phoneme.O, ())


def rule(*words: str, on: bool = True) -> Rule:
    parts = [text.split() for text in words]
    return Rule(Phoneme.A, tuple(Condition(v, sign, limit=float(limit)) for v, sign, limit in parts), on)


def faults(*rules: Rule, features: Features | None = GRID) -> tuple[RuleFault | None, ...]:
    return rule_faults(rules, Thresholds(), *([] if features is None else [features]))


def test_limits_that_contradict_each_other_are_found_without_sound():
    assert faults(rule("x > 5", "x < 3"), REST, features=None) == (RuleFault.CONTRADICTORY, None)
    assert faults(rule("x > 5", "x < 5"), REST, features=None) == (RuleFault.CONTRADICTORY, None)
    assert faults(rule("x > 5", "x < 6"), REST, features=None) == (None, None)


def test_a_rule_behind_one_that_holds_wherever_it_does_is_never_reached():
    assert faults(rule("x > 3"), rule("x > 5", "y < 2"), REST, features=None) == (None, RuleFault.COVERED, None)
    assert faults(rule("x > 5", "y < 2"), rule("x > 3"), REST, features=None) == (None, None, None)
    assert faults(REST, rule("x > 3"), features=None) == (RuleFault.ALWAYS, RuleFault.COVERED)


def test_what_never_or_always_holds_in_the_sound_is_found():
    assert faults(rule("x > 20"), rule("x > -1"), REST) == (RuleFault.NEVER, RuleFault.ALWAYS, None)


def test_several_rules_together_may_leave_nothing_to_a_later_one():
    assert faults(rule("x > 4"), rule("x < 6"), rule("y > 3"), REST) == (
        None, None, RuleFault.UNREACHED, None,
    )  # fmt: skip


def test_of_several_sounds_a_rule_is_of_use_if_it_is_in_one():
    rules = rule("x > 8"), rule("x > 4", "y < 5"), rule("y > 20"), REST
    low, high = (Features(GRID.names, GRID.values[part]) for part in (GRID.values[:, 0] < 4, GRID.values[:, 0] > 8))
    assert rule_faults(rules, Thresholds(), low)[:3] == (RuleFault.NEVER,) * 3
    assert rule_faults(rules, Thresholds(), high)[:3] == (RuleFault.ALWAYS, RuleFault.UNREACHED, RuleFault.NEVER)
    assert rule_faults(rules, Thresholds(), low, high)[:3] == (None, RuleFault.UNREACHED, RuleFault.NEVER)


def test_what_is_switched_off_is_neither_wrong_nor_in_the_way():
    off = Condition("x", "<", limit=3.0, enabled=False)
    kept = Rule(Phoneme.A, (Condition("x", ">", limit=5.0), off))
    assert faults(rule("x > 3", on=False), rule("x > 5"), kept, REST, features=None) == (
        None, None, RuleFault.COVERED, None,
    )  # fmt: skip


def test_a_rule_of_what_is_not_measured_is_looked_at_by_itself():
    assert faults(rule("z > 3"), rule("z > 3", "z < 2"), REST) == (None, RuleFault.CONTRADICTORY, None)


@pytest.mark.parametrize("name", ["thesis", "extended"])
def test_the_rules_of_the_factory_are_sound(name):
    preset = load_preset(FACTORY / f"{name}.toml")
    assert not any(rule_faults(preset.rules or RULES, preset.thresholds))
