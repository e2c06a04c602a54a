"""How speech holds expressions back."""

import pytest

from phonemeengine.mouth.expression.composer import Inhibition, InhibitionTimes


def test_it_rises_in_a_tenth_of_a_second_and_falls_in_half_a_second():
    inhibition = Inhibition()
    inhibition.expect([(1.0, 2.0)])
    values = [inhibition.at(time) for time in (0.99, 1.05, 1.1, 2.0, 2.25, 2.5)]
    assert values == pytest.approx([0, 0.5, 1, 1, 0.5, 0], abs=1e-9)


def test_a_short_pause_does_not_end_speech_and_a_long_one_does():
    short, long = Inhibition(), Inhibition()
    short.expect([(1.0, 2.0), (2.4, 3.0)])
    long.expect([(1.0, 2.0), (2.6, 3.0)])
    assert short.at(2.3) == 1
    assert long.at(2.3) < 0.4


def test_it_turns_back_from_wherever_it_stands():
    inhibition = Inhibition(InhibitionTimes(pause=0.0))
    inhibition.expect([(0.0, 1.0), (1.25, 2.0)])
    assert inhibition.at(1.25) == pytest.approx(0.5)
    assert inhibition.at(1.3) == pytest.approx(0.75)
    assert inhibition.at(1.36) == 1


def test_live_speech_ends_once_nobody_has_spoken_for_a_pause():
    inhibition = Inhibition()
    for k in range(200):
        inhibition.add(k / 100, speaks=k < 50)
    assert inhibition.at(0.99) == 1
    assert inhibition.at(1.25) == pytest.approx(0.5, abs=0.02)
    assert inhibition.at(1.6) == 0


def test_what_is_heard_of_speech_that_is_known_says_nothing_new():
    inhibition = Inhibition()
    inhibition.expect([(0.0, 1.0)])
    for k in range(150):
        inhibition.add(k / 100, speaks=True)
    assert inhibition.at(1.5) == 0
