"""What is read from scores: how much each phoneme falls short, and why the likeliest one was named."""

import numpy as np
import pytest

from phonemeengine.errors import SettingsError
from phonemeengine.features.variables import Features, Variable, check_user_variables
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import SCORES, ScoredRecogniser, scores_in


def scored(**scores: float) -> Features:
    """A frame with these scores beside one measured variable; all others are 0."""
    values = np.zeros((1, 1 + len(SCORES)), np.float32)
    for name, score in scores.items():
        values[0, 1 + SCORES.index(name)] = score
    return Features(("volume", *SCORES), values)


def test_each_phoneme_has_a_score_in_the_order_of_the_phonemes() -> None:
    assert SCORES[Phoneme.SILENCE] == "p_silence"
    assert SCORES[Phoneme.O] == "p_o"
    assert len(SCORES) == len(Phoneme)


def test_a_phoneme_falls_short_by_what_the_likeliest_one_has_more() -> None:
    deficits = ScoredRecogniser().deficits(scored(p_a=0.5, p_e=0.375, p_o=0.125))
    assert deficits is not None
    assert deficits[0, [Phoneme.A, Phoneme.E, Phoneme.O, Phoneme.M]].tolist() == [0, 0.125, 0.375, 0.5]


def test_the_decision_compares_the_likeliest_with_the_next_one() -> None:
    trace = ScoredRecogniser().explain(scored(p_a=0.5, p_e=0.375, p_o=0.125), 0)
    first, second = trace.comparisons[:2]
    assert (trace.phoneme, trace.rule) == (Phoneme.A, "a")
    assert (first.rule, first.variable, first.value, first.sign) == ("a", "p_a", 0.5, ">")
    assert (first.threshold, first.limit, first.margin) == ("p_e", 0.375, 0.125)
    assert (second.rule, second.threshold, second.margin) == ("e", "p_a", -0.125)


def test_frames_that_nobody_has_scored_yet_are_explained_without_reasons() -> None:
    plain = Features(("volume",), np.zeros((2, 1), np.float32))
    assert scores_in(plain) is None
    assert ScoredRecogniser().deficits(plain) is None
    assert ScoredRecogniser().explain(plain, 1).comparisons == ()


@pytest.mark.parametrize("name", ["p_silence", "p_sch", "p_o"])
def test_a_users_variable_cannot_take_the_name_of_a_score(name: str) -> None:
    with pytest.raises(SettingsError, match=rf"a variable named {name} exists already; choose another name"):
        check_user_variables((Variable(name, 100, 200),))
