"""Rules asked again and again: what is remembered never differs from what is worked out anew."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.calibration.workbench.retuner import RuleCache
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import RULES, Condition, Rule, RuleRecogniser, Thresholds

NAMES = ("x", "y", "z")
GRID = [k / 4 for k in range(-4, 5)]  # so that values meet their limits

conditions = st.builds(
    Condition, st.sampled_from(NAMES), st.sampled_from("<>"), limit=st.sampled_from([*GRID, 0.1, 1e-12])
)
rules = st.lists(
    st.builds(Rule, st.sampled_from(list(Phoneme)), st.lists(conditions, max_size=4).map(tuple)), max_size=6
)


def features_of(seed: int, n: int = 60) -> Features:
    generator = np.random.default_rng(seed)
    return Features(NAMES, generator.choice(np.array([*GRID, 0.1, 0.33], np.float32), (n, len(NAMES))))


def sheet_of(features: Features) -> RuleCache:
    return RuleCache({name: features[name] for name in features.names}, len(features.values))


@given(asked=st.lists(rules, min_size=1, max_size=4), seed=st.integers(0, 1000))
def test_what_is_remembered_names_the_same_phonemes(asked, seed):
    features = features_of(seed)
    sheet = sheet_of(features)
    for list_of_rules in asked:
        recogniser = RuleRecogniser(list_of_rules, Thresholds())
        assert sheet.recognised(recogniser).tolist() == recogniser.phonemes_of(features).tolist()


@given(asked=st.lists(rules, min_size=1, max_size=3), hysteresis=st.sampled_from([0.05, 0.1, 0.25, 0.5, 1.0]))
def test_what_is_remembered_lets_the_same_phonemes_stay(asked, hysteresis):
    features = features_of(7)
    sheet = sheet_of(features)
    for list_of_rules in asked:
        recogniser = RuleRecogniser(list_of_rules, Thresholds())
        expected = recogniser.deficits(features) <= hysteresis
        assert sheet.may_stay(recogniser, hysteresis).T.tolist() == expected.tolist()


def test_a_new_threshold_is_heard_at_once_and_the_old_one_comes_back():
    names = tuple(dict.fromkeys(c.variable for rule in RULES for c in rule.conditions))
    features = Features(names, np.random.default_rng(1).random((500, len(names)), np.float32))
    sheet = sheet_of(features)
    for limit in (0.2, 0.8, 0.2):
        recogniser = RuleRecogniser(RULES, Thresholds(ae_ae1=limit, silence_zero_crossings=0.0))
        named_a_or_e = np.isin(sheet.recognised(recogniser), (Phoneme.A, Phoneme.E, Phoneme.P))
        assert (np.array(features["m_ae1"] > np.float32(limit)) == named_a_or_e).all()
