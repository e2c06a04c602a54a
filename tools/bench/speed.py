"""How fast this machine is: limits that are times or shares of a core hold where a bare transform takes 4.5 µs."""

import statistics
import time
from collections.abc import Callable, Mapping

import numpy as np
import scipy.fft

from tests.sounds import Sound
from tools.bench.figures import Absolute

NAMED = 4.5e-6
"""What `scipy.fft.rfft` of 512 values takes where the limits were set, seconds."""
N_ROUNDS, N_TRANSFORMS = 200, 1000
N_BESIDE = 400
"""Transforms before and after an act whose work is scaled by itself."""
Speed = Mapping[Absolute, float]
"""What one transform takes, seconds."""


def bare_transform() -> Speed:
    """Measure what one transform of 512 values takes here."""
    wave = np.random.default_rng(0).standard_normal(512, np.float32)
    taken: dict[Absolute, list[float]] = {kind: [] for kind in Absolute}
    for _ in range(N_ROUNDS):
        began, worked = time.perf_counter(), time.process_time()
        for _ in range(N_TRANSFORMS):
            scipy.fft.rfft(wave)
        taken[Absolute.TIME].append(time.perf_counter() - began)
        taken[Absolute.WORK].append(time.process_time() - worked)
    return {kind: statistics.median(seconds) / N_TRANSFORMS for kind, seconds in taken.items()}


def scaled_work(act: Callable[[], object]) -> float:
    """Return the seconds of the processor that an act takes, as where the limits were set.

    The speed is that of transforms right before and after it, so that other programs, which come and go, count less.
    """
    wave = np.random.default_rng(0).standard_normal(512, np.float32)
    began = time.process_time()
    _transform(wave)
    before = time.process_time()
    act()
    after = time.process_time()
    _transform(wave)
    beside = before - began + time.process_time() - after
    return (after - before) * NAMED * 2 * N_BESIDE / beside


def _transform(wave: Sound) -> None:
    for _ in range(N_BESIDE):
        scipy.fft.rfft(wave)


def slowness(speed: Speed) -> Mapping[Absolute, float]:
    """Say how many times as long it takes as where the limits were set."""
    return {kind: seconds / NAMED for kind, seconds in speed.items()}


def in_words(speed: Speed) -> str:
    """Say what the speed of a machine means for the limits."""
    taken, slow = speed, slowness(speed)
    return (
        f"scipy.fft.rfft of 512 values takes {1e6 * taken[Absolute.TIME]:.2f} µs here, and "
        f"{1e6 * taken[Absolute.WORK]:.2f} µs of the processor, instead of {1e6 * NAMED:.1f} µs: limits of times are "
        f"scaled by {slow[Absolute.TIME]:.2f}, those of shares of a core by {slow[Absolute.WORK]:.2f}"
    )
