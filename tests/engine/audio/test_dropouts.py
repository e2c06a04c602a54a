"""Lost samples are told from jitter and drift, by the count against the clock."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.audio.dropouts import LEAST, DropoutMeter

RATE = 48_000
BLOCK = 480
Lateness = Callable[[int], float]


def fed(
    seconds: float, late: Lateness = lambda _k: 0.0, *, drift: float = 0.0, lost: tuple[int, ...] = ()
) -> tuple[DropoutMeter, list[tuple[float, int]]]:
    """Feed blocks of 10 ms whose last sample is there at its time or later, but for the lost ones; what was when."""
    meter, seen, came = DropoutMeter(RATE), [(0.0, 0)], 0.0
    for k in range(round(seconds * RATE / BLOCK)):
        came = max(came, 500 + (k + 1) * BLOCK / RATE * (1 + drift) + late(k))
        if k not in lost:
            meter.observe(came, BLOCK)
        if meter.n_lost != seen[-1][1]:
            seen.append((came - 500, meter.n_lost))
    return meter, seen[1:]


def test_a_perfect_clock_loses_nothing_and_says_when_each_sample_was_captured() -> None:
    meter, seen = fed(20)
    assert (seen, meter.n_lost, meter.n_samples) == ([], 0, 20 * RATE)
    assert meter.begun == pytest.approx(500, abs=1e-6)
    assert meter.time_of(RATE) == pytest.approx(501, abs=1e-6)


@given(seed=st.integers(0, 2**32), most=st.floats(0, 0.03), burst=st.integers(0, 60))
def test_blocks_that_come_late_are_not_lost(seed: int, most: float, burst: int) -> None:
    random = np.random.default_rng(seed)
    late = random.uniform(0, most, 1500)
    start = random.integers(0, 1400)
    late[start : start + burst] += np.arange(burst, 0, -1) * 0.01  # a busy machine takes them all at once
    meter, _ = fed(15, lambda k: float(late[k]))
    assert meter.n_lost == 0
    assert meter.time_of(0) == pytest.approx(500, abs=0.005)


@pytest.mark.parametrize("ppm", [-50, *(pytest.param(ppm, marks=pytest.mark.long) for ppm in (-200, 50, 200))])
def test_an_hour_of_a_clock_that_runs_otherwise_is_no_loss(ppm: int) -> None:
    late = np.random.default_rng(1).exponential(0.002, 360_000)
    meter, _ = fed(3600, lambda k: float(late[k]), drift=ppm * 1e-6)
    assert meter.n_lost == 0
    now = 3600 * RATE
    assert meter.time_of(now) == pytest.approx(500 + 3600 * (1 + ppm * 1e-6), abs=0.002)


@given(at=st.integers(150, 700), n=st.integers(1, 100))
def test_lost_blocks_are_counted_exactly_within_three_seconds(at: int, n: int) -> None:
    _, seen = fed(20, lost=tuple(range(at, at + n)))
    ((when, n_lost),) = seen
    assert n_lost == n * BLOCK
    assert 1 < when - (at + n) / 100 <= 3.02


@given(seed=st.integers(0, 2**32))
def test_a_loss_is_counted_as_exactly_as_the_jitter_allows(seed: int) -> None:
    late = np.random.default_rng(seed).exponential(0.002, 2000)
    meter, _ = fed(20, lambda k: float(late[k]), lost=tuple(range(900, 910)))
    assert meter.n_lost == pytest.approx(4800, abs=0.001 * RATE)


def test_many_losses_add_up() -> None:
    lost = tuple(k for start in range(500, 6000, 500) for k in range(start, start + 3))
    meter, seen = fed(65, lost=lost)
    assert (len(seen), meter.n_lost) == (11, len(lost) * BLOCK)
    assert meter.n_samples + meter.n_lost == 65 * RATE
    assert meter.time_of(64 * RATE) == pytest.approx(564, abs=0.001)


def test_losses_close_to_each_other_are_all_counted_in_the_end() -> None:
    lost = (500, 560, 610, 640, 700, 777)
    assert fed(20, lost=lost)[0].n_lost == len(lost) * BLOCK


def test_a_machine_that_stands_still_for_three_seconds_and_gets_everything_then_lost_nothing() -> None:
    meter, _ = fed(20, lambda k: max(0.0, (700 - k) / 100) if 400 <= k < 700 else 0.0)
    assert meter.n_lost == 0


def test_a_phase_that_shifts_by_a_few_milliseconds_is_no_loss() -> None:
    meter, seen = fed(20, lambda k: 0.005 if k > 800 else 0.0)
    assert (meter.n_lost, seen) == (0, [])


def test_samples_that_come_after_all_were_not_lost() -> None:
    meter, seen = fed(20, lambda k: 0.020 if 600 < k < 1400 else 0.0)
    assert seen
    assert meter.n_lost < 0.001 * RATE


def test_a_loss_before_and_after_a_delay_is_still_counted() -> None:
    lost = (*range(400, 410), *range(2600, 2603))
    meter, _ = fed(40, lambda k: 0.020 if 1200 < k < 2000 else 0.0, lost=lost)
    assert abs(meter.n_lost - len(lost) * BLOCK) < LEAST * RATE
