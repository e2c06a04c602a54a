import numpy as np
import pytest

from phonemeengine.performance.smoothing import MonotoneCubics

ZERO = np.zeros(1, np.intp)


def curve(xs: list[float], ys: list[float], at: list[float]) -> list[float]:
    return MonotoneCubics(np.array(xs), np.array(ys), ZERO).at(np.array(at), np.zeros(len(at), np.intp)).tolist()


def test_a_straight_line_stays_straight_and_goes_on_beyond_its_ends() -> None:
    assert curve([0, 1, 3], [1, 3, 7], [-2, 0, 0.3, 2.9, 5]) == pytest.approx([-3, 1, 1.6, 6.8, 11])


def test_a_curve_meets_its_points_and_never_turns_back() -> None:
    xs, ys = [0.0, 1, 2, 3, 4], [0.0, 0.1, 5, 5, 9]
    assert curve(xs, ys, xs) == pytest.approx(ys)
    fine = np.linspace(0, 4, 400)
    assert np.diff(curve(xs, ys, fine.tolist())).min() >= -1e-12


def test_several_curves_know_nothing_of_each_other() -> None:
    alone = curve([0, 1, 3], [0, 2, 3], [-1, 0.5, 2, 4])
    three = MonotoneCubics(
        np.array([5.0, 6, 0, 1, 3, 2, 9]), np.array([9.0, 9, 0, 2, 3, -5, 70]), np.array([0, 2, 5])
    )
    assert three.at(np.array([-1, 0.5, 2, 4]), np.ones(4, np.intp)).tolist() == pytest.approx(alone)
    assert three.at(np.array([5.5, 5.5]), np.array([0, 2])).tolist() == pytest.approx([9, 32.5])
