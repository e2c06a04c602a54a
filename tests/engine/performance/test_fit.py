"""Examples are fitted to a sentence: a channel that is a ramp shows which moment of the recording is seen when."""

import numpy as np
import pytest

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.performance.choice import Chosen, PlacedUnit
from phonemeengine.performance.halves import RecordedHalves, bounds_of, traits_of
from phonemeengine.performance.smoothing import crossed, fitted
from phonemeengine.performance.table_file import Example
from phonemeengine.performance.units import Unit, UnitKind
from tests.engine.performance.sentences import phones_in

RATE = 100.0


def ramp_of(words: str, length: float, offset: float = 0.0) -> RecordedHalves:
    """Give a recording whose only channel is its time, and an offset."""
    phones = phones_in(words, length)
    times = np.arange(round(phones[-1].end * RATE) + 1) / RATE
    weights = (times + offset).astype(np.float32)[:, None]
    joints = np.zeros((2 * len(phones) + 1, 2), np.float32)
    return RecordedHalves(words, RATE, weights, bounds_of(phones), traits_of(phones), joints)


def unit(first: int, last: int) -> PlacedUnit:
    return PlacedUnit(Unit(UnitKind.DIPHONE, (), first, last), UnitKind.DIPHONE, ())


def example(halves: RecordedHalves, first: int, last: int) -> Chosen:
    return halves, Example(1, first, last, 0.0)


def shown(placed: list[PlacedUnit], chosen: list[Chosen], bounds: Float64Array, times: list[float]) -> Float32Array:
    return fitted(placed, chosen, bounds, np.array(times))[:, 0]


def test_a_recording_at_twice_the_speed_is_its_ramp_twice_as_steep() -> None:
    bounds = bounds_of(phones_in("ma", 0.1))
    found = shown([unit(0, 8)], [example(ramp_of("ma", 0.2), 0, 8)], bounds, [0.0, 0.05, 0.13, 0.31, 0.4])
    assert found == pytest.approx([0.0, 0.1, 0.26, 0.62, 0.8], abs=1e-6)


def test_every_bound_of_a_phone_meets_that_of_the_sentence() -> None:
    bounds = np.array([0.0, 0.1, 0.15, 0.3, 0.32, 0.4, 0.7, 0.75, 0.8])
    recording = ramp_of("ma", 0.2)
    found = shown([unit(0, 8)], [example(recording, 0, 8)], bounds, bounds.tolist())
    assert found == pytest.approx(recording.bounds, abs=1e-6)
    fine = np.linspace(0, 0.8, 500).tolist()
    assert np.diff(shown([unit(0, 8)], [example(recording, 0, 8)], bounds, fine)).min() >= 0


def test_neighbours_are_cross_faded_over_half_of_each_half_that_meets() -> None:
    bounds = bounds_of(phones_in("ma", 0.1))  # the middle of m, half 3, is at 0.15
    chosen = [example(ramp_of("ma", 0.1), 0, 3), example(ramp_of("ma", 0.1, offset=1.0), 3, 8)]
    times = [0.1, 0.125, 0.15, 0.175, 0.2]
    found = shown([unit(0, 3), unit(3, 8)], chosen, bounds, times)
    assert found - np.array(times) == pytest.approx([0, 0, 0.5, 1, 1], abs=1e-6)


def test_beyond_its_ends_an_example_runs_on_as_fast_as_there() -> None:
    bounds = bounds_of(phones_in("ma", 0.1))
    fast, slow = ramp_of("ma", 0.2), ramp_of("ma", 0.05)
    times = np.array([0.13, 0.14, 0.16, 0.17])
    found = shown([unit(0, 3), unit(3, 8)], [example(fast, 0, 3), example(slow, 3, 8)], bounds, times.tolist())
    share = crossed(times, 0.125, 0.175)
    assert found == pytest.approx((1 - share) * 2 * times + share * times / 2, abs=1e-6)


def test_halves_without_neighbours_of_their_own_meet_at_both_ends() -> None:
    bounds = bounds_of(phones_in("ma", 0.1))
    same = ramp_of("ma", 0.1)
    placed = [unit(k, k + 1) for k in range(8)]
    times = np.linspace(0, 0.4, 83)
    found = shown(placed, [example(same, k, k + 1) for k in range(8)], bounds, times.tolist())
    assert found == pytest.approx(times, abs=1e-6)
