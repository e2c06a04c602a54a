"""Fitting to recordings: never worse than before, and honest about voices that were not heard."""

from dataclasses import asdict, replace

import numpy as np
import pytest

from phonemeengine.calibration.fits.fitting import cross_validate, fit_preset, groups_of
from phonemeengine.calibration.fits.limit_search import LimitSearch
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, Confusion, confusion_of, macro_f1_of
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Cancelled
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.recognition.rules import Condition, Rule, RuleRecogniser, Thresholds
from tests.labelled import recordings

THESIS = load_preset(FACTORY / "thesis.toml")
A, E, M, U = Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.U
SILENCE, SZ, UNKNOWN = Phoneme.SILENCE, Phoneme.SZ, Phoneme.UNIDENTIFIED
STAY = {p: p for p in Phoneme}
RULES = (
    Rule(SILENCE, (Condition("volume", "<", limit=0.3),)),
    Rule(SZ, (Condition("zero_crossings", ">", limit=30.0),)),
    Rule(A, (Condition("m_ae1", ">", limit=0.9),)),
    Rule(U, (Condition("m_ae1", "<", limit=0.9),)),
)
OWN = replace(THESIS, recogniser="rules", rules=RULES)


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> LabelledFeatures:
    return LabelledFeatures(recordings(tmp_path_factory.mktemp("recordings")), THESIS)


def tree(low: float, high: float) -> tuple[Rule, ...]:
    """Below `low` it is m, above it u or e, parted by `high`."""
    return (
        Rule(M, (Condition("x", "<", limit=low),)),
        Rule(U, (Condition("x", ">", limit=low), Condition("y", "<", limit=high))),
        Rule(E, (Condition("x", ">", limit=low), Condition("y", ">", limit=high))),
    )


def search_of(features: Features, truth: np.ndarray) -> LimitSearch:
    return LimitSearch(features, truth, np.arange(len(truth)) % 500 == 0, Thresholds(), STAY)


def f1_of(rules: tuple[Rule, ...], features: Features, truth: np.ndarray) -> float:
    codes = RuleRecogniser(rules, Thresholds()).phonemes_of(features)
    return float(macro_f1_of(confusion_of(truth, codes), SCORED_PHONEMES))


def test_a_search_finds_the_limits_that_made_the_labels():
    features = Features(("x", "y"), np.random.default_rng(1).random((4000, 2), np.float32))
    truth = RuleRecogniser(tree(0.3, 0.7), Thresholds()).phonemes_of(features)
    found = search_of(features, truth).improve(tree(0.6, 0.2))
    assert found[0].conditions[0].limit == pytest.approx(0.3, abs=0.05)
    assert found[1].conditions[1].limit == pytest.approx(0.7, abs=0.05)
    assert f1_of(found, features, truth) > 0.9


def test_comparisons_with_the_same_number_stay_one_limit():
    features = Features(("x", "y"), np.random.default_rng(2).random((1000, 2), np.float32))
    truth = np.random.default_rng(2).choice(np.array([M, U, E], np.uint8), 1000)
    found = search_of(features, truth).improve(tree(0.6, 0.2))
    assert len({c.limit for rule in found for c in rule.conditions if c.variable == "x"}) == 1
    assert [rule.phoneme for rule in found] == [M, U, E]


def test_limits_that_cannot_be_bettered_stay_where_they_are():
    features = Features(("x", "y"), np.random.default_rng(4).random((1000, 2), np.float32))
    rules = tree(0.37, 0.61)
    truth = RuleRecogniser(rules, Thresholds()).phonemes_of(features)
    assert search_of(features, truth).improve(rules) == rules


def test_two_limits_of_one_variable_are_found_each_by_itself():
    features = Features(("x", "y"), np.random.default_rng(5).random((4000, 2), np.float32))
    made = (Rule(M, (Condition("x", "<", limit=0.2),)), Rule(U, (Condition("x", "<", limit=0.8),)), Rule(E, ()))
    begun = (Rule(M, (Condition("x", "<", limit=0.4),)), Rule(U, (Condition("x", "<", limit=0.6),)), Rule(E, ()))
    truth = RuleRecogniser(made, Thresholds()).phonemes_of(features)
    found = search_of(features, truth).improve(begun)
    assert [rule.conditions[0].limit for rule in found[:2]] == pytest.approx([0.2, 0.8], abs=0.04)


@pytest.mark.parametrize("seed", range(2))
def test_limits_are_never_worse_than_before_and_named_thresholds_stay(seed):
    generator = np.random.default_rng(seed)
    features = Features(("x", "y"), generator.random((600, 2), np.float32))
    truth = generator.choice(np.array([M, U, E, SILENCE], np.uint8), 600)
    rules = (Rule(SILENCE, (Condition("y", ">", threshold="ae_ae1"),)), *tree(*generator.random(2).tolist()))
    found = search_of(features, truth).improve(rules)
    assert f1_of(found, features, truth) >= f1_of(rules, features, truth)
    assert found[0] == rules[0]


def test_frames_that_are_nothing_that_is_scored_do_not_matter():
    features = Features(("x", "y"), np.random.default_rng(3).random((2000, 2), np.float32))
    truth = RuleRecogniser(tree(0.3, 0.7), Thresholds()).phonemes_of(features)
    found = search_of(features, truth).improve(tree(0.5, 0.5))
    odd = np.arange(2000) % 2 == 1
    doubled = Features(("x", "y"), np.repeat(features.values, 2, axis=0))
    twice = np.where(np.arange(4000) % 2 == 1, np.uint8(UNKNOWN), np.repeat(truth, 2))
    assert search_of(doubled, twice).improve(tree(0.5, 0.5)) == found
    assert odd.sum() == 1000


@pytest.mark.parametrize("preset", [THESIS, OWN], ids=["thesis", "rules"])
def test_a_fit_betters_a_preset_that_was_made_for_other_voices(bench, preset):
    report = fit_preset(bench, preset)
    assert report.after.macro_f1 > report.before.macro_f1 + 0.05
    assert report.gains
    assert report.left_out == "speaker"
    assert report.before == pytest.approx(bench.confusion(preset).scores())
    assert report.after == pytest.approx(bench.confusion(report.preset).scores())
    assert report.held_out is not None
    assert report.held_out.macro_f1 > report.before.macro_f1
    kept = replace(report.preset, thresholds=preset.thresholds, successors=preset.successors, rules=preset.rules)
    assert asdict(kept) == asdict(preset)


@pytest.mark.parametrize("preset", [pytest.param(THESIS, marks=pytest.mark.long), OWN], ids=["thesis", "rules"])
@pytest.mark.parametrize("hold", [pytest.param(0.0, marks=pytest.mark.long), 0.5])
def test_a_fit_is_never_worse_than_what_was_there(bench, preset, hold):
    settings = replace(preset.settings, minimum_hold=hold)  # of which the search knows nothing
    before = fit_preset(bench, replace(preset, settings=settings)).preset
    report = fit_preset(bench, before, seed=1)
    assert report.after.macro_f1 >= report.before.macro_f1
    assert report.gains or report.preset == before


def test_without_a_second_speaker_takes_are_left_out_and_with_one_take_nothing_is(bench):
    alone = [u for u in bench.utterances if u.speaker == "ada"]
    assert fit_preset(LabelledFeatures(alone, THESIS), OWN).left_out == "take"
    single = fit_preset(LabelledFeatures(alone[:1], THESIS), OWN)
    assert (single.left_out, single.held_out) == ("", None)


def test_what_is_left_out_is_answered_by_a_fit_that_has_not_seen_it():
    names = ["ada", "bob", "ada", "cyd"]
    fits = cross_validate(names, [["ada"], ["bob", "cyd"]], lambda chosen: tuple(np.flatnonzero(chosen).tolist()))
    assert fits == [(1, 3), (0, 2), (1, 3), (0, 2)]
    assert groups_of([*"abcabd"], 8) == [["a"], ["b"], ["c"], ["d"]]
    assert groups_of([*"abcd"], 3) == [["a", "d"], ["b"], ["c"]]


def test_figures_for_what_was_left_out_are_of_every_frame_once(bench):
    held = fit_preset(bench, OWN).held_out
    whole: Confusion = bench.confusion(OWN)
    assert held is not None
    assert held.minutes == pytest.approx(whole.scores().minutes)
    assert held.label_changes_per_s == pytest.approx(whole.agreement.label_changes_per_s)


@pytest.mark.parametrize("preset", [pytest.param(THESIS, marks=pytest.mark.long), OWN], ids=["thesis", "rules"])
def test_a_fit_says_how_far_it_is_and_ends_when_it_shall(bench, preset):
    told: list[float] = []
    fit_preset(bench, preset, lambda share: told.append(share) is None)
    assert told == sorted(told)
    assert told[-1] == 1.0
    for last in (0.1, 0.8):
        with pytest.raises(Cancelled):
            fit_preset(bench, preset, lambda share, last=last: share < last)


def test_a_recogniser_without_thresholds_is_not_fitted(bench, loudness):
    with pytest.raises(CorpusError, match="'loudness' has no thresholds to fit"):
        fit_preset(bench, replace(THESIS, recogniser="loudness"))


def test_recordings_without_labels_are_nothing_to_fit_to(bench):
    unlabelled = [replace(u, labels=tuple(replace(s, phoneme=UNKNOWN) for s in u.labels)) for u in bench.utterances]
    with pytest.raises(CorpusError, match="nothing to fit to"):
        fit_preset(LabelledFeatures(unlabelled, THESIS), THESIS)
    with pytest.raises(CorpusError, match="nothing to fit to"):
        fit_preset(LabelledFeatures((), THESIS), THESIS)


def test_labels_of_one_sound_alone_are_refused_since_every_frame_would_become_it(bench):
    known = {Phoneme.A, UNKNOWN}
    only_a = [
        replace(u, labels=tuple(s if s.phoneme in known else replace(s, phoneme=UNKNOWN) for s in u.labels))
        for u in bench.utterances
    ]
    with pytest.raises(CorpusError, match="at least two sounds, and the recordings have only a"):
        fit_preset(LabelledFeatures(only_a, THESIS), THESIS)
