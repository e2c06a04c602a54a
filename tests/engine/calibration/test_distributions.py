"""Distributions of variables, and how well a number tells phonemes apart: numbers that can be counted by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.calibration.workbench.distributions import (
    N_BINS,
    best_threshold,
    distribution_of,
    mean_separability,
    ranked_variables,
    separabilities,
    separability,
)
from phonemeengine.calibration.workbench.labelled_features import LabelledFeatures
from phonemeengine.errors import CorpusError
from phonemeengine.execution import Cancelled
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from tests.labelled import recording, recordings

THESIS = load_preset(FACTORY / "thesis.toml")
A, E, I, M, U = Phoneme.A, Phoneme.E, Phoneme.I, Phoneme.M, Phoneme.U  # noqa: E741
SILENCE, SZ = Phoneme.SILENCE, Phoneme.SZ

numbers = st.lists(st.integers(-4, 4), min_size=1, max_size=15)


def floats(*values: float) -> np.ndarray:
    return np.array(values, np.float32)


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> LabelledFeatures:
    return LabelledFeatures(recordings(tmp_path_factory.mktemp("recordings")), THESIS)


@given(values=numbers, others=numbers)
def test_separation_is_the_chance_that_one_frame_has_more_than_the_other(values, others):
    pairs = [(v, o) for v in values for o in others]
    larger = sum(1.0 if v > o else 0.5 if v == o else 0.0 for v, o in pairs) / len(pairs)
    found = separability(floats(*values), floats(*others))
    assert found == pytest.approx(max(larger, 1 - larger))
    phonemes = np.array([A] * len(values) + [E] * len(others), np.uint8)
    table = separabilities(floats(*values, *others), phonemes)
    assert table[A, E] == table[E, A] == pytest.approx(found)
    assert np.isnan(table[A, M])


def test_what_a_threshold_parts_wholly_is_separated_by_one_and_what_is_equal_by_a_half():
    assert separability(floats(1, 2), floats(3, 4, 5)) == 1
    assert separability(floats(7, 7), floats(7)) == 0.5
    assert np.isnan(separability(floats(), floats(1)))


def test_the_separation_of_several_phonemes_is_the_mean_over_their_pairs():
    phonemes = np.array([A, A, E, E, U, U], np.uint8)
    table = separabilities(floats(1, 2, 3, 4, 1, 2), phonemes)
    assert mean_separability(table, (A, E, U)) == pytest.approx((1 + 1 + 0.5) / 3)
    assert mean_separability(table, (A, E, M)) == 1
    assert np.isnan(mean_separability(table, (A, M)))


@pytest.mark.parametrize(
    ("values", "others", "expected"),
    [((1, 2, 3), (5, 6), 4.0), ((5, 6), (1, 2, 3), 4.0), ((1, 2, 9), (3, 4, 5), 2.5), ((2, 2), (2,), 2.0)],
)
def test_the_best_threshold_lies_in_the_gap_between_them(values, others, expected):
    assert best_threshold(floats(*values), floats(*others)) == expected


def test_a_distribution_tells_what_numpy_counts_in_the_frames_of_each_phoneme(bench):
    found = distribution_of(bench, "m_ae1")
    values, phonemes = bench.values("m_ae1"), bench.labels.phonemes
    assert set(found.spreads) == {SILENCE, SZ, A, E, I, Phoneme.O, U}
    for phoneme, spread in found.spreads.items():
        own = values[phonemes == phoneme]
        assert spread.n == len(own) == spread.counts.sum()
        told = (spread.minimum, spread.lower_quartile, spread.median, spread.upper_quartile, spread.maximum)
        assert told == pytest.approx(tuple(np.quantile(own, (0, 0.25, 0.5, 0.75, 1))))
        inside = (own > found.edges[0]) & (own < found.edges[-1])
        assert (spread.counts[1:-1] == np.histogram(own[inside], found.edges)[0][1:-1]).all()
    assert found.separations[A, I] == separability(values[phonemes == A], values[phonemes == I])


def test_loudness_is_shown_on_a_logarithmic_scale_and_a_count_on_a_linear_one(bench):
    loud, crossings = distribution_of(bench, "volume"), distribution_of(bench, "zero_crossings")
    assert loud.logarithmic
    assert np.diff(np.log(loud.edges)) == pytest.approx(np.log(loud.edges[-1] / loud.edges[0]) / N_BINS)
    assert not crossings.logarithmic
    assert np.diff(crossings.edges) == pytest.approx((crossings.edges[-1] - crossings.edges[0]) / N_BINS)


def test_a_variable_that_is_always_the_same_has_a_distribution_too(bench):
    nothing = distribution_of(bench, "f0")
    assert nothing.separation == 0.5
    assert {spread.maximum for spread in nothing.spreads.values()} == {0.0}
    assert np.all(np.diff(nothing.edges) > 0)


def test_only_certain_frames_count(tmp_path):
    heard = recording(tmp_path / "a.wav", [SILENCE, A, SZ], 0.5)
    doubtful = Label(0.5, 1.0, "a", A, "ambiguous")
    labels = (heard.labels[0], doubtful, heard.labels[2])
    bench = LabelledFeatures([type(heard)(heard.path, labels, "ada", "made")], THESIS)
    assert set(distribution_of(bench, "volume").spreads) == {SILENCE, SZ}


def test_zero_crossings_part_a_hiss_from_a_vowel_and_lead_the_ranking(bench):
    ranked = ranked_variables(bench, (SZ, A))
    assert {r.variable for r in ranked} == set(bench.variables)
    separations = [r.separation for r in ranked]
    assert separations == sorted(separations, reverse=True)
    assert next(r.separation for r in ranked if r.variable == "zero_crossings") > 0.95
    assert ranked[-1].variable == "f0"
    assert ranked[0].separation == pytest.approx(distribution_of(bench, ranked[0].variable).separations[SZ, A])


def test_the_ranking_for_all_phonemes_is_by_the_mean_over_all_pairs(bench):
    for found in ranked_variables(bench)[:3]:
        assert found.separation == pytest.approx(distribution_of(bench, found.variable).separation)


def test_a_ranking_ends_when_it_shall(bench):
    with pytest.raises(Cancelled):
        ranked_variables(bench, progress=lambda share: share < 0.5)


def test_a_variable_that_was_not_measured_has_no_distribution(bench):
    with pytest.raises(CorpusError, match="'nonsense'"):
        distribution_of(bench, "nonsense")


def test_without_frames_nothing_is_separated():
    empty = LabelledFeatures((), THESIS)
    found = distribution_of(empty, "volume")
    assert (found.spreads, len(found.edges)) == ({}, N_BINS + 1)
    assert np.isnan(found.separation)
    assert all(np.isnan(r.separation) for r in ranked_variables(empty))
