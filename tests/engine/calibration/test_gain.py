"""Whether a gain is more than chance: phones are drawn anew, and both figures must rise."""

import numpy as np
import pytest

from phonemeengine.calibration.scores.comparison import MOST_PARTS, gains_of
from phonemeengine.phonemes import Phoneme

CODES = {
    "_": Phoneme.SILENCE,
    "a": Phoneme.A,
    "e": Phoneme.E,
    "i": Phoneme.I,
    "o": Phoneme.O,
    "u": Phoneme.U,
    "m": Phoneme.M,
    "p": Phoneme.P,
}
SAID = "_aimoeupa_eiamoupie_"


def frames(phones: str, each: int = 8) -> np.ndarray:
    """Phones of 80 ms."""
    return np.repeat([CODES[c] for c in phones], each).astype(np.uint8)


def clear(before: str, after: str, said: str = SAID) -> bool:
    return gains_of([(frames(said), frames(before), frames(after))]).are_clear


def test_what_is_right_in_most_phones_that_were_wrong_is_a_clear_gain():
    assert clear("_" * len(SAID), SAID)


def test_nothing_changed_and_everything_lost_are_none():
    assert not clear(SAID, SAID)
    assert not clear(SAID, "_" * len(SAID))
    assert not gains_of([]).are_clear


def test_one_phone_more_of_twenty_may_be_chance():
    before = "_".join((SAID[:5], SAID[6:]))
    assert before != SAID
    assert not clear(before, SAID)


def test_sounds_that_rise_while_the_mouth_is_right_as_often_are_no_clear_gain():
    swapped = str.maketrans("eioump", "ieuopm")  # the mouths are those of what is said
    assert not clear(SAID.translate(swapped), SAID)


@pytest.mark.parametrize("seed", range(5))
def test_answers_that_are_as_often_right_by_chance_are_mostly_none(seed):
    chance = np.random.default_rng(seed)
    said = frames("".join(chance.choice(list("aeioump_"), 60)))
    phones = np.repeat(chance.random((2, 60)) < 0.3, 8, axis=1)
    before, after = (np.where(wrong, Phoneme.SZ, said).astype(np.uint8) for wrong in phones)
    assert not gains_of([(said, before, after)]).are_clear


def test_the_difference_is_that_of_the_figures_and_lies_in_its_range():
    said, before = frames("aeaeaeaeae"), frames("aeaeaeaeaa")
    shapes = gains_of([(said, before, said)]).viseme_accuracy
    assert shapes.difference == pytest.approx(0.1)  # one phone of ten
    assert shapes.low <= shapes.difference <= shapes.high
    assert not shapes.is_clear
    lost = gains_of([(said, said, frames("i" * 10))]).macro_f1
    assert lost.high < 0
    assert lost.is_clear


def test_long_recordings_are_drawn_in_parts():
    said = frames("ai" * MOST_PARTS, 1)
    before = frames("aa" * MOST_PARTS, 1)
    assert gains_of([(said, before, said)]).viseme_accuracy.difference == pytest.approx(0.5)
