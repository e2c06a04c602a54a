"""Confidence: a curve that says what share of answers is right, and how that is measured."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.analyser import Analyser, latest_reading
from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.calibration.scores.evaluation import confidence_of, predict, score
from phonemeengine.errors import PresetError
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.recognition.scores import (
    UNFITTED,
    ConfidenceCurve,
    calibration_errors,
    fit_confidence,
    separations_of,
)
from phonemeengine.settings import SAMPLE_RATE, ModelKind
from tests.conftest import CORPUS
from tests.corpora import speech

N = 40_000


def answers(seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """A recogniser that is surer than it is right: of answers with the score s, s squared are right."""
    generator = np.random.default_rng(seed)
    scores = generator.random(N).astype(np.float32)
    return scores, generator.random(N) < scores**2


def test_a_fitted_curve_says_what_share_is_right():
    scores, right = answers()
    curve = fit_confidence(scores, right)
    asked = np.linspace(0.05, 0.95, 19).astype(np.float32)
    np.testing.assert_allclose(curve.of(asked), asked**2, atol=0.03)
    others, also_right = answers(1)
    assert max(calibration_errors(curve.of(others), also_right)) < 0.03
    error, gap = calibration_errors(others, also_right)
    assert error == pytest.approx(1 / 6, abs=0.01)  # the mean of s - s squared
    assert gap == pytest.approx(0.25, abs=0.02)


@given(st.lists(st.tuples(st.floats(0, 1, width=32), st.booleans()), min_size=1, max_size=200))
def test_whatever_was_right_the_curve_rises_and_keeps_the_mean(pairs: list[tuple[float, bool]]):
    scores, right = np.array([s for s, _ in pairs], np.float32), np.array([r for _, r in pairs])
    curve = fit_confidence(scores, right)
    assert (np.diff(curve.shares) >= 0).all()
    assert (np.diff(curve.scores) > 0).all()
    assert ((curve.of(scores) >= 0) & (curve.of(scores) <= 1)).all()


def test_one_share_holds_for_every_score():
    curve = ConfidenceCurve((1.0,), (0.3,))
    assert curve.of(np.array([0, 0.4, 1], np.float32)).tolist() == pytest.approx([0.3, 0.3, 0.3])


@pytest.mark.parametrize(
    ("scores", "shares"),
    [
        ((), ()),
        ((0.6, 0.5), (0, 1)),
        ((0, 1), (0.8, 0.2)),
        ((0, 2), (0, 1)),
        ((0, float("nan")), (0, 1)),
        (tuple(k / 20 for k in range(17)), tuple(k / 20 for k in range(17))),
    ],
)
def test_what_is_no_curve_is_refused(scores: tuple[float, ...], shares: tuple[float, ...]):
    with pytest.raises(PresetError, match="rising scores and as many shares"):
        ConfidenceCurve(scores, shares)


def test_nothing_to_compare_is_not_a_number():
    assert all(np.isnan(calibration_errors(np.zeros(0, np.float32), np.zeros(0, bool))))


@pytest.mark.parametrize("name", ["learned", "templates"])
def test_every_frame_has_a_confidence_and_a_poll_gives_the_last_one(name: str):
    halved = replace(load_preset(name), confidences={ModelKind.REAL_TIME: ConfidenceCurve((0.0, 1.0), (0.0, 0.5))})
    analysis = Analyser(halved).push(speech())
    assert analysis.confidences.shape == (len(analysis),)
    assert analysis.confidences.dtype == np.float32
    assert ((analysis.confidences >= 0) & (analysis.confidences <= 0.5)).all()
    assert latest_reading(analysis).confidence == pytest.approx(analysis.confidences[-1])
    sure = replace(halved, confidences={})
    np.testing.assert_allclose(Analyser(sure).push(speech()).confidences, 2 * analysis.confidences, atol=1e-6)


def test_rules_are_surer_the_farther_a_frame_is_from_all_limits_and_silent_where_they_were_not_measured():
    thesis = load_preset("thesis")
    analysis = Analyser(thesis).push(speech())
    assert analysis.confidences.std() > 0.1
    assert latest_reading(analysis).confidence == pytest.approx(analysis.confidences[-1])
    digital_silence = Analyser(thesis).push(np.zeros(SAMPLE_RATE, np.float32))
    assert (digital_silence.confidences > np.median(analysis.confidences) + 0.2).all()
    unmeasured = Analyser(replace(thesis, confidences={})).push(speech())
    assert np.isnan(unmeasured.confidences).all()
    assert latest_reading(unmeasured).confidence is None


def test_a_phoneme_is_the_farther_from_giving_way_the_more_the_nearest_other_one_lacks():
    deficits = np.array([[0, 1, 3], [2, 0, 0.25], [0, np.inf, np.inf], [np.inf, 0, 1]], np.float32)
    assert separations_of(deficits, np.array([0, 1, 0, 0], np.uint8)).tolist() == pytest.approx([0.75, 0.6, 1, 0])
    assert separations_of(deficits[:2], np.array([1, 0], np.uint8)).tolist() == pytest.approx([0.25, 1 / 6])


@pytest.mark.long
@pytest.mark.parametrize("name", ["thesis", "extended"])
def test_a_curve_of_rules_holds_for_speakers_whom_it_was_not_fitted_to_and_tells_right_from_wrong(name: str):
    bare = replace(load_preset(name), confidences={ModelKind.REAL_TIME: UNFITTED})
    predictions = [predict(utterance, bare) for utterance in read_corpus(CORPUS)]
    sure, right = [], []
    for speaker in {p.utterance.speaker for p in predictions}:
        heard = [p for p in predictions if p.utterance.speaker == speaker]
        curve = confidence_of([p for p in predictions if p.utterance.speaker != speaker])
        sure += [curve.of(p.confidences[p.labels.certain]) for p in heard]
        right += [p.right[p.labels.certain] for p in heard]
    shares, hits = np.concatenate(sure), np.concatenate(right)
    assert calibration_errors(shares, hits)[0] < 0.05
    high = shares > np.median(shares)
    assert hits[high].mean() > 1.8 * hits[~high].mean()


@pytest.mark.parametrize(
    ("name", "least", "changes"),
    [
        ("extended", 0.61, 1.51),
        pytest.param("thesis", 0.355, np.inf, marks=pytest.mark.long),
        *(pytest.param(f"thesis-{k}", 0.3, np.inf, marks=pytest.mark.long) for k in ("calm", "anti-aliased")),
        pytest.param("templates", 0.59, 1.51, marks=pytest.mark.long),
    ],
)
def test_presets_reach_their_figures_and_their_confidence_holds_on_speech_that_they_were_not_measured_on(
    name: str, least: float, changes: float
):
    overall = score(load_preset(name), read_corpus(CORPUS)).overall
    assert overall.scores.macro_f1 > least
    assert overall.scores.changes_per_s <= changes * overall.scores.label_changes_per_s
    assert overall.calibration_error < 0.08
    assert overall.largest_gap < 0.15


def test_a_preset_keeps_its_curves(tmp_path: Path):
    preset = replace(
        load_preset("thesis"),
        confidences={
            ModelKind.REAL_TIME: ConfidenceCurve((0.2, 0.9), (0.1, 0.7)),
            ModelKind.OFFLINE: ConfidenceCurve((0.5,), (0.4,)),
        },
    )
    save_preset(preset, tmp_path / "mine.toml")
    assert load_preset(tmp_path / "mine.toml") == preset
    text = (tmp_path / "mine.toml").read_text().replace("0.9", "0.1")
    (tmp_path / "mine.toml").write_text(text)
    with pytest.raises(PresetError, match="rising scores and as many shares"):
        load_preset(tmp_path / "mine.toml")
