"""Rules of a preset's own: what they name, by how much others fall short, and why."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.errors import PresetError
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Condition, Rule, RuleRecogniser, Thresholds, rule_labels

NAMES = ("x", "y", "z")
RULES = (
    Rule(Phoneme.A, (Condition("x", ">", limit=4.0), Condition("y", "<", limit=2.0))),
    Rule(Phoneme.O, (Condition("x", ">", limit=2.0),)),
    Rule(Phoneme.A, (Condition("z", ">", limit=-8.0),)),
)

eighths = st.integers(-64, 64).map(lambda k: k / 8)
limits = eighths.filter(lambda limit: limit != 0)
conditions = st.builds(Condition, st.sampled_from(NAMES), st.sampled_from("<>"), st.just(""), limits)
phonemes = st.sampled_from([p for p in Phoneme if p is not Phoneme.UNIDENTIFIED])
rule_lists = st.lists(
    st.builds(Rule, phonemes, st.lists(conditions, min_size=1, max_size=3).map(tuple)), min_size=1, max_size=6
)


def frame(*values: float) -> Features:
    return Features(NAMES, np.array([values], np.float32))


def named(rules: list[Rule], features: Features) -> Phoneme:
    return Phoneme(int(RuleRecogniser(rules, Thresholds()).phonemes_of(features)[0]))


def eased(rule: Rule, share: float) -> Rule:
    """The rule with each limit moved by a share of itself to where the comparison holds more easily."""
    ways = {">": -1, "<": 1}
    moved = (replace(c, limit=c.limit + ways[c.sign] * share * abs(c.limit)) for c in rule.conditions)
    return Rule(rule.phoneme, tuple(moved))


def given_way(rules: list[Rule], phoneme: Phoneme, share: float) -> set[Phoneme]:
    """What is named where one rule of a phoneme is eased by a share, and all before it are made as much harder."""
    return {
        named([*(eased(before, -share) for before in rules[:k]), eased(rule, share)], FRAMES[0])
        for k, rule in enumerate(rules)
        if rule.phoneme is phoneme
    }


FRAMES: list[Features] = [frame(0, 0, 0)]


def test_the_share_that_is_missing_is_known():
    # o holds by 3 against 2; for the first a, x lacks 1 of 4; for the second, o must fail, by half of its limit
    deficits = RuleRecogniser(RULES, Thresholds()).deficits(frame(3.0, 0.0, 0.0))[0]
    assert deficits[Phoneme.O] == 0
    assert deficits[Phoneme.A] == 0.25
    assert deficits[Phoneme.UNIDENTIFIED] == 1.0  # the last rule holds by 8 of 8
    assert np.isinf(deficits[Phoneme.E])


@given(rules=rule_lists, row=st.tuples(eighths, eighths, eighths))
def test_the_phoneme_that_is_named_falls_short_by_nothing(rules: list[Rule], row: tuple[float, ...]):
    features = frame(*row)
    deficits = RuleRecogniser(rules, Thresholds()).deficits(features)[0]
    assert deficits[named(rules, features)] == 0
    assert (deficits >= 0).all()


@given(rules=rule_lists, row=st.tuples(eighths, eighths, eighths))
def test_a_phoneme_is_named_where_the_limits_give_way_by_more_than_it_falls_short(
    rules: list[Rule], row: tuple[float, ...]
):
    FRAMES[0] = frame(*row)
    deficits = RuleRecogniser(rules, Thresholds()).deficits(FRAMES[0])[0]
    for phoneme in {rule.phoneme for rule in rules} - {named(rules, FRAMES[0])}:
        share, little = float(deficits[phoneme]), 1e-3 * (1 + float(deficits[phoneme]))
        assert phoneme in given_way(rules, phoneme, share + little)
        if share > little:
            assert phoneme not in given_way(rules, phoneme, share - little)


@given(rules=rule_lists, row=st.tuples(eighths, eighths, eighths))
def test_the_trace_shows_the_rule_and_the_margins(rules: list[Rule], row: tuple[float, ...]):
    features = frame(*row)
    trace = RuleRecogniser(rules, Thresholds()).explain(features, 0)
    assert trace.phoneme is named(rules, features)
    for c in trace.comparisons:
        assert c.margin == (c.value - c.limit if c.sign == ">" else c.limit - c.value)
    assert all(c.margin > 0 for c in trace.comparisons if c.rule == trace.rule)


def test_rules_of_one_phoneme_are_numbered_in_the_trace():
    trace = RuleRecogniser(RULES, Thresholds()).explain(frame(0.0, 0.0, 0.0), 0)
    assert (trace.phoneme, trace.rule) == (Phoneme.A, "a 2")
    assert [c.rule for c in trace.comparisons] == ["a 1", "a 1", "o", "a 2"]


def test_a_frame_without_the_rules_variables_is_explained_without_reasons():
    others = Features(("energy",), np.ones((1, 1), np.float32))
    assert RuleRecogniser(RULES, Thresholds()).explain(others, 0).comparisons == ()


def test_a_preset_whose_rules_are_missing_is_refused_in_one_sentence():
    with pytest.raises(PresetError, match=r"the recogniser 'rules' needs rules.*begin with the preset extended"):
        Preset(recogniser="rules")


def test_a_rule_that_is_switched_off_never_fires_and_stays_in_the_file(tmp_path):
    rules = [replace(RULES[0], enabled=False), *RULES[1:]]
    assert named(list(RULES), frame(5, 1, 0)) is Phoneme.A
    assert named(rules, frame(5, 1, 0)) is Phoneme.O
    assert rule_labels(rules) == ("", "o", "a")
    own = tuple(replace(rule, conditions=(Condition("energy", ">", limit=1.0),)) for rule in rules)
    path = tmp_path / "off.toml"
    save_preset(Preset(recogniser="rules", rules=own), path)
    assert "enabled = false" in path.read_text()
    assert load_preset(path).rules == own


def test_a_condition_that_is_switched_off_is_not_asked_and_stays_in_the_file(tmp_path):
    off = Condition("energy", ">", limit=1.0, enabled=False)
    rules = (Rule(Phoneme.A, (off, Condition("volume", ">", limit=0.5))), RULES[1])
    features = Features(("energy", "volume", "x"), np.array([[0, 0.6, 0]], np.float32))
    assert named(list(rules), features) is Phoneme.A
    path = tmp_path / "off.toml"
    save_preset(Preset(recogniser="rules", rules=rules[:1]), path)
    assert '"# energy > 1.0"' in path.read_text()
    assert load_preset(path).rules == rules[:1]
