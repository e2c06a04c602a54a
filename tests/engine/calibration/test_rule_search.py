"""Rules grown from labelled frames: what divides the phonemes is found, and stays readable."""

import numpy as np
import pytest

from phonemeengine.calibration.fits.rule_search import MOST_CONDITIONS, RuleSearch, best_phonemes, conditions_in
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import Rule, RuleRecogniser, Thresholds

N = 4000


def grown(names: tuple[str, ...], values: np.ndarray, truth: np.ndarray, most: int = 20) -> tuple[Rule, ...]:
    search = RuleSearch(Features(names, values.astype(np.float32)), truth, np.ones(len(truth)), names)
    return search.rules_of(search.grow(most))


def uniform(n: int, columns: int) -> np.ndarray:
    return np.random.default_rng(7).uniform(0, 1, (n, columns))


def test_the_variable_and_the_limit_that_divide_two_phonemes_are_found():
    values = uniform(N, 3)
    truth = np.where(values[:, 1] > 0.25, Phoneme.A, Phoneme.SILENCE).astype(np.uint8)
    quiet, loud = grown(("x", "y", "z"), values, truth, 2)
    assert (quiet.phoneme, loud.phoneme) == (Phoneme.SILENCE, Phoneme.A)
    assert [(c.variable, c.sign) for rule in (quiet, loud) for c in rule.conditions] == [("y", "<"), ("y", ">")]
    assert quiet.conditions[0].limit == pytest.approx(0.25, abs=0.02)


def test_a_corner_takes_one_rule_of_two_comparisons():
    values = uniform(N, 2)
    truth = np.where((values > 0.5).all(axis=1), Phoneme.I, Phoneme.M).astype(np.uint8)
    features = Features(("x", "y"), values.astype(np.float32))
    rules = grown(("x", "y"), values, truth, 3)
    assert sum(rule.phoneme is Phoneme.I for rule in rules) == 1
    answers = RuleRecogniser(rules, Thresholds()).phonemes_of(features)
    assert np.mean(answers == truth) > 0.97


def test_rules_stay_few_and_short_even_where_nothing_divides():
    values = uniform(N, 12)
    truth = np.random.default_rng(3).choice([Phoneme.A, Phoneme.E, Phoneme.O], N).astype(np.uint8)
    rules = grown(tuple("abcdefghijkl"), values, truth, 40)
    assert len(rules) <= 40
    assert max(len(rule.conditions) for rule in rules) <= MOST_CONDITIONS


def test_neighbours_that_say_the_same_are_one_rule():
    values = np.floor(20 * uniform(N, 1))
    truth = np.where(values[:, 0] > 9, Phoneme.A, Phoneme.SILENCE).astype(np.uint8)
    assert len(grown(("x",), values, truth, 30)) == 2


def test_a_count_lies_never_on_a_limit():
    values = np.floor(20 * uniform(N, 1))
    truth = np.where(values[:, 0] > 9, Phoneme.A, Phoneme.SILENCE).astype(np.uint8)
    rules = RuleRecogniser(grown(("x",), values, truth), Thresholds())
    answers = rules.phonemes_of(Features(("x",), values.astype(np.float32)))
    np.testing.assert_array_equal(answers, truth)


def test_frames_without_a_known_label_teach_nothing():
    values = uniform(N, 1)
    truth = np.where(values[:, 0] > 0.5, Phoneme.A, Phoneme.UNIDENTIFIED).astype(np.uint8)
    assert [rule.phoneme for rule in grown(("x",), values, truth)] == [Phoneme.A]


def test_a_leaf_takes_the_phoneme_that_the_macro_f1_gains_most_by():
    counts = np.zeros((2, len(Phoneme)))
    counts[0, Phoneme.A] = 90
    counts[1, [Phoneme.A, Phoneme.P]] = 12, 10  # more a than p, but there is no other p to be had
    assert best_phonemes(counts) == [Phoneme.A, Phoneme.P]


def divided(values: np.ndarray) -> np.ndarray:
    """Five sounds in a plane of which two variables tell."""
    x, y = values[:, 0], values[:, 1]
    inner = np.where(y > 0.7, Phoneme.I, np.where(x > 0.8, Phoneme.U, Phoneme.O))
    return np.where(x < 0.3, np.where(y < 0.4, Phoneme.SILENCE, Phoneme.SZ), inner).astype(np.uint8)


def test_a_decision_list_answers_as_all_comparisons_do_with_fewer():
    values = uniform(N, 3)
    features, truth = Features(("x", "y", "z"), values.astype(np.float32)), divided(values)
    search = RuleSearch(features, truth, np.ones(N), features.names)
    root = search.grow(12)
    rules, listed = search.rules_of(root), search.list_of(root)
    answers = [RuleRecogniser(some, Thresholds()).phonemes_of(features) for some in (rules, listed)]
    np.testing.assert_array_equal(*answers)
    assert np.mean(answers[0] == truth) > 0.95
    assert listed[-1].conditions == ()
    assert conditions_in(listed) < conditions_in(rules) / 2


@pytest.mark.parametrize("most", [0, 1, 4, 9])
def test_a_list_has_no_more_conditions_than_it_may(most):
    values = uniform(N, 3)
    features = Features(("x", "y", "z"), values.astype(np.float32))
    rules = RuleSearch(features, divided(values), np.ones(N), features.names).list_within(most)
    assert conditions_in(rules) <= most
    assert rules[-1].conditions == ()


def test_a_search_in_a_part_learns_from_nothing_else():
    values = uniform(N, 2)
    truth = divided(values)
    search = RuleSearch(Features(("x", "y"), values.astype(np.float32)), truth, np.ones(N), ("x", "y"))
    chosen = np.isin(truth, (Phoneme.SILENCE, Phoneme.SZ))
    assert {rule.phoneme for rule in search.part(chosen).list_within(9)} == {Phoneme.SILENCE, Phoneme.SZ}
    assert len({rule.phoneme for rule in search.list_within(9)}) == 5
