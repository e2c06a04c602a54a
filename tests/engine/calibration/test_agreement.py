"""The figures that follow from how often which label has which answer."""

import math

import numpy as np
import pytest

from phonemeengine.calibration.scores.corpus import FrameLabels
from phonemeengine.calibration.scores.scoring import NOTHING_SCORED, Agreement, agreement_of, scores_of
from phonemeengine.labels.visemes import NO_VISEME
from phonemeengine.phonemes import Phoneme

SILENCE, A, E, P, M = Phoneme.SILENCE, Phoneme.A, Phoneme.E, Phoneme.P, Phoneme.M
NONE = Phoneme.UNIDENTIFIED


def agreement(*pairs: tuple[Phoneme, Phoneme, int]) -> Agreement:
    """Labels and answers, each for some frames, in this order."""
    truth, guess = (np.concatenate([np.full(p[2], p[k], np.uint8) for p in pairs]) for k in (0, 1))
    return agreement_of(truth, guess)


def test_each_figure_follows_from_the_counts():
    found = agreement(
        (SILENCE, SILENCE, 3), (SILENCE, A, 1), (A, A, 3), (A, E, 2), (E, Phoneme.I, 1), (NONE, SILENCE, 2)
    )
    assert found.seconds == pytest.approx(0.12)
    assert found.classes == (SILENCE, A, E)
    assert found.accuracy == pytest.approx(6 / 10)
    assert found.f1_of(A) == pytest.approx(2 * 3 / (5 + 4))
    assert found.f1_of(SILENCE) == pytest.approx(2 * 3 / (4 + 3))  # what is labelled as no phoneme does not count
    assert found.f1_of(E) == 0
    assert math.isnan(found.f1_of(M))
    assert found.macro_f1 == pytest.approx((2 / 3 + 6 / 7) / 3)
    assert found.viseme_accuracy == pytest.approx((3 + 3 + 1) / 12)  # e for i is the same mouth
    assert found.silence_recall == pytest.approx(3 / 4)
    assert found.false_silence == pytest.approx(2 / 8)
    assert found.changes_per_s == pytest.approx(4 / 0.12)
    assert found.label_changes_per_s == pytest.approx(3 / 0.12)


def test_agreements_of_recordings_add_up_to_what_is_scored_of_all():
    generator = np.random.default_rng(3)
    parts = [generator.integers(0, 11, (2, n), np.uint8) for n in (40, 1, 77)]
    whole = sum((agreement_of(truth, guess) for truth, guess in parts), NOTHING_SCORED)
    labels = [FrameLabels(truth, truth > 0, np.full(len(truth), NO_VISEME, np.uint8)) for truth, _ in parts]
    scores = scores_of([(said, guess) for said, (_, guess) in zip(labels, parts, strict=True)])
    for name in ("accuracy", "macro_f1", "viseme_accuracy", "silence_recall", "false_silence", "changes_per_s"):
        assert getattr(whole, name) == getattr(scores, name)
    assert whole.seconds == pytest.approx(60 * scores.minutes)


def test_one_class_alone_has_figures_and_what_is_not_there_has_none():
    found = agreement((SILENCE, SILENCE, 4), (SILENCE, A, 1))
    assert found.classes == (SILENCE,)
    assert found.macro_f1 == pytest.approx(8 / 9)
    assert math.isnan(found.false_silence)
    assert (found.accuracy, found.label_changes_per_s) == (0.8, 0)
    names = ("accuracy", "macro_f1", "viseme_accuracy", "silence_recall", "false_silence", "changes_per_s")
    assert all(math.isnan(getattr(NOTHING_SCORED, name)) for name in names)
    assert NOTHING_SCORED.classes == ()


def test_what_gained_and_what_lost_is_told_by_phoneme():
    before = agreement((A, A, 5), (A, E, 5), (E, E, 10), (SILENCE, SILENCE, 5))
    after = agreement((A, A, 10), (E, E, 5), (E, Phoneme.I, 5), (SILENCE, SILENCE, 5), (P, P, 1))
    gains = after.gains_over(before)
    assert list(gains) == [A, SILENCE, E]  # p was not labelled before
    assert gains[A] == pytest.approx(1 - 2 * 5 / 15)
    assert gains[SILENCE] == 0
    assert gains[E] == pytest.approx(2 * 5 / 15 - 2 * 10 / 25)


def test_the_worst_confusions_are_those_of_the_most_frames():
    found = agreement((A, A, 50), (A, E, 3), (E, NONE, 9), (NONE, E, 20), (SILENCE, M, 2))
    assert found.worst_confusions(2) == [(E, NONE, 9), (A, E, 3)]
    assert found.worst_confusions(9) == [(E, NONE, 9), (A, E, 3), (SILENCE, M, 2)]
    assert agreement((A, A, 50)).worst_confusions(2) == []
