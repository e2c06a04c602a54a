"""Changes of rules that are tried on labelled frames before they are made."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.calibration.fits.limit_search import RuleTrials, with_rule, with_rule_off
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.rules import Condition, Rule
from phonemeengine.settings import AnalysisSettings

NAMES = ("energy", "volume")
REST = Rule(Phoneme.O, ())
PRESET = Preset(recogniser="rules", settings=AnalysisSettings(statistics=False), rules=(REST,))


def trials(truth: np.ndarray, values: np.ndarray) -> RuleTrials:
    return RuleTrials(Features(NAMES, values.astype(np.float32)), truth.astype(np.uint8), np.array([0, len(truth)]))


@pytest.fixture
def values() -> np.ndarray:
    return np.random.default_rng(5).uniform(0, 1, (4000, 2))


@pytest.mark.parametrize("sign", "<>")
def test_the_comparison_that_made_the_labels_is_proposed_for_a_new_rule(values, sign):
    inside = values[:, 0] < 0.3 if sign == "<" else values[:, 0] > 0.3
    tried = trials(np.where(inside, Phoneme.A, Phoneme.O), values)
    draft = with_rule(PRESET, 0, Rule(Phoneme.A, ()))
    proposed = tried.proposed(draft, 0, "energy")
    assert (proposed.variable, proposed.sign) == ("energy", sign)
    assert proposed.limit == pytest.approx(0.3, abs=0.02)
    after = tried.agreement(with_rule(PRESET, 0, Rule(Phoneme.A, (proposed,))))
    assert after.macro_f1 > 0.95
    assert after.gains_over(tried.agreement(PRESET))[Phoneme.A] > 0.9


def test_a_condition_more_narrows_a_rule_that_takes_too_much(values):
    truth = np.where((values > 0.5).all(axis=1), Phoneme.A, Phoneme.O)
    wide = Rule(Phoneme.A, (Condition("energy", ">", limit=0.5),))
    tried, preset = trials(truth, values), with_rule(PRESET, 0, wide)
    proposed = tried.proposed(preset, 0, "volume")
    assert proposed.sign == ">"
    assert proposed.limit == pytest.approx(0.5, abs=0.03)
    narrowed = replace(wide, conditions=(*wide.conditions, proposed))
    assert tried.agreement(with_rule(PRESET, 0, narrowed)).macro_f1 > tried.agreement(preset).macro_f1 + 0.1


def test_the_middle_value_is_proposed_where_the_rule_decides_nothing(values):
    tried = trials(np.full(len(values), Phoneme.UNIDENTIFIED), values)
    proposed = tried.proposed(with_rule(PRESET, 0, Rule(Phoneme.A, ())), 0, "volume")
    assert proposed.limit == pytest.approx(np.median(values[:, 1]), rel=1e-3)


def test_a_rule_that_is_off_recognises_nothing(values):
    tried = trials(np.full(len(values), Phoneme.A), values)
    both = with_rule(PRESET, 0, Rule(Phoneme.A, ()))
    assert tried.agreement(both).accuracy == 1
    assert tried.agreement(with_rule_off(both, 0)).accuracy == 0


def test_what_is_tried_on_parts_of_sound_is_as_on_the_whole(values):
    truth = np.where(values[:, 0] > 0.5, Phoneme.A, Phoneme.O).astype(np.uint8)
    features = Features(NAMES, values.astype(np.float32))
    turned = Features(("volume", "pitch", "energy"), features.values[:, [1, 1, 0]])
    first, rest = slice(1500), slice(1500, None)
    parts = RuleTrials.of(
        [
            (features.part(first), truth[first], np.array([0, 700, 1500])),
            (turned.part(rest), truth[rest], np.array([0, 2500])),
        ]
    )
    preset = with_rule(PRESET, 0, Rule(Phoneme.A, (Condition("energy", ">", limit=0.4),)))
    assert parts.features.names == NAMES
    counts = [tried.agreement(preset).counts.tolist() for tried in (parts, trials(truth, values))]
    assert counts[0] == counts[1]
