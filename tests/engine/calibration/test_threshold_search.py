"""The search for thresholds and for the table of successors, on numbers whose best answer is known."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.calibration.fits.threshold_search import LEAST_FOUND, Fit, ThresholdSearch
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES, confusion_of, macro_f1_of
from phonemeengine.calibration.workbench.batch_smoother import counted_table, last_identified, successors_of
from phonemeengine.features.variables import Features
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.rules import CONDITIONS, ThesisRules, Thresholds
from phonemeengine.recognition.segments import PhonemeSmoother

NAMES = tuple(dict.fromkeys(c.variable for c in CONDITIONS))
HALVES = Thresholds(**dict.fromkeys((c.threshold for c in CONDITIONS), 0.5))
LADDER = replace(HALVES, u_o1=0.75, o_o1=0.5, i_o1=0.25)
A, E, M, U, SZ = Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.U, Phoneme.SZ
SILENCE, UNKNOWN = Phoneme.SILENCE, Phoneme.UNIDENTIFIED


def random_features(n: int, seed: int) -> Features:
    generator = np.random.default_rng(seed)
    return Features(NAMES, generator.random((n, len(NAMES)), np.float32))


def fit_of(features: Features, truth: np.ndarray, n_starts: int) -> Fit:
    first = np.arange(len(truth)) % 1000 == 0
    return ThresholdSearch(features, truth, first).best_of(n_starts, np.random.default_rng(1))


def codes(*phonemes: Phoneme) -> np.ndarray:
    return np.array(phonemes, np.uint8)


def test_a_search_is_as_good_on_its_frames_as_it_says():
    features = random_features(4000, 1)
    rules = ThesisRules(LADDER)
    truth = np.where(np.arange(4000) % 7 == 0, np.uint8(E), rules.phonemes_of(features))
    fit = fit_of(features, truth, 3)
    answers = ThesisRules(fit.thresholds).phonemes_of(features)
    parts = np.split(answers, range(1000, 4000, 1000))
    calmed = np.concatenate([PhonemeSmoother(0, fit.successors).smooth(part) for part in parts])
    known = truth != UNKNOWN
    score = float(macro_f1_of(confusion_of(truth[known], calmed[known]), SCORED_PHONEMES))
    assert score == pytest.approx(fit.score, abs=1e-9)


def test_a_search_finds_the_thresholds_that_made_the_labels():
    features = random_features(4000, 2)
    fit = fit_of(features, ThesisRules(LADDER).phonemes_of(features), 8)
    assert fit.score > 0.9
    assert fit.thresholds.ae_ae1 == pytest.approx(0.5, abs=0.06)
    assert fit.thresholds.u_o1 == pytest.approx(0.75, abs=0.06)


def test_every_rule_finds_some_of_its_phoneme_even_where_labels_are_chance():
    features = random_features(6000, 3)
    truth = np.random.default_rng(3).choice(np.array(SCORED_PHONEMES, np.uint8), 6000)
    thresholds = fit_of(features, truth, 4).thresholds
    assert thresholds.u_o1 > thresholds.o_o1 > thresholds.i_o1
    hits = confusion_of(truth, ThesisRules(thresholds).phonemes_of(features)).diagonal()[list(SCORED_PHONEMES)]
    assert np.mean(hits > 0.5 * LEAST_FOUND * 600) > 0.8


def test_what_was_identified_last_is_remembered_to_the_end_of_a_recording():
    answers = codes(UNKNOWN, A, UNKNOWN, UNKNOWN, M, UNKNOWN, UNKNOWN)
    first = np.array([True, False, False, False, False, True, False])
    assert last_identified(answers, first).tolist() == [SILENCE, A, A, A, M, SILENCE, SILENCE]


def test_a_successor_is_the_class_of_which_the_largest_share_is_found_there():
    last = np.repeat(codes(A, M), 1000)
    truth = np.repeat(codes(E, U, SZ), (600, 400, 1000)).astype(np.int64)
    totals = np.zeros(len(Phoneme), np.int64)
    totals[[E, U, SZ]] = 6000, 1000, 2000
    table = successors_of(counted_table(last, truth, totals))
    assert (table[A], table[M]) == (U, SZ)  # after a: 10 % of e, but 40 % of u


def test_a_phoneme_that_nothing_was_seen_after_gets_the_likeliest_after_any():
    truth = np.full(100, U, np.int64)
    totals = np.full(len(Phoneme), 200, np.int64)
    table = successors_of(counted_table(np.full(100, A, np.uint8), truth, totals))
    assert set(table.values()) == {U}


def test_nothing_is_followed_by_an_unidentified_frame():
    nothing = np.zeros(0, np.int64)
    totals = np.zeros(len(Phoneme), np.int64)
    totals[UNKNOWN] = 100
    assert UNKNOWN not in successors_of(counted_table(nothing.astype(np.uint8), nothing, totals)).values()
