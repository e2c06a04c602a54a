from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.arrays import Float32Array
from phonemeengine.performance.smoothing import (
    TO_REST,
    USUAL_FILTERS,
    bounded,
    brought_to_rest,
    gains_of,
    smoothed,
    without_outliers,
)
from tests.engine.performance.sentences import phones_in

RATE = 60.0
SENTENCE = phones_in("ma.ma tu")
TIMES = np.arange(round(SENTENCE[-1].end * RATE) + 1) / RATE


def wave(hertz: float, n: int = len(TIMES)) -> Float32Array:
    return (0.5 + 0.3 * np.cos(2 * np.pi * hertz * np.arange(n) / RATE)).astype(np.float32)[:, None]


def test_a_straight_movement_stays_as_it_is() -> None:
    ramp = np.linspace(0, 1, len(TIMES), dtype=np.float32)[:, None]
    assert smoothed(ramp, SENTENCE, TIMES) == pytest.approx(ramp, abs=1e-6)


def test_slow_movements_stay_and_trembling_goes() -> None:
    inner = slice(6, -6)
    assert np.ptp(smoothed(wave(1.0), SENTENCE, TIMES)[inner]) > 0.8 * np.ptp(wave(1.0)[inner])
    jerks = [np.abs(np.diff(face, 3, axis=0)).mean() for face in (wave(20.0), smoothed(wave(20.0), SENTENCE, TIMES))]
    assert jerks[1] < 0.05 * jerks[0]


def test_the_phrase_is_filtered_as_a_butterworth_filter_does_forwards_and_backwards() -> None:
    from scipy.signal import butter, sosfiltfilt  # it takes seconds, as test files are read by each process

    long = phones_in("m", 4.0)  # so slow that the phrase's cut-off is the least, and syllables are long
    silent = tuple(replace(phone, word=-1, syllable=-1) for phone in long)
    times = np.arange(round(long[-1].end * RATE) + 1) / RATE
    noise = np.random.default_rng(1).standard_normal((len(times), 2))
    expected = sosfiltfilt(butter(2, USUAL_FILTERS.phrase, fs=RATE, output="sos"), noise, axis=0)
    found = smoothed(noise.astype(np.float32), silent, times)
    assert found[60:-60] == pytest.approx(expected[60:-60], abs=1e-3)


def test_a_syllable_is_smoothed_within_its_bounds() -> None:
    phones = phones_in("mama.tutu", 0.1)
    times = np.arange(round(phones[-1].end * RATE) + 1) / RATE
    step = (times > 0.5).astype(np.float32)[:, None]  # where the syllables meet
    found = smoothed(step, phones, times)
    only_phrase = smoothed(step, tuple(replace(p, word=0, syllable=0) for p in phones), times)
    assert np.ptp(np.diff(found, axis=0)) > np.ptp(np.diff(only_phrase, axis=0))


def test_a_frame_that_a_tracker_lost_is_bridged_and_a_movement_is_not() -> None:
    weights = np.concatenate([wave(3.0)] * 2, axis=1)
    spoilt = weights.copy()
    spoilt[20, 0] += 0.6
    assert without_outliers(spoilt) == pytest.approx(weights, abs=0.02)
    assert without_outliers(weights) == pytest.approx(weights)


def test_weights_stay_within_their_bounds() -> None:
    assert bounded(np.array([[-0.2, 0.4, 1.3]], np.float32)).tolist() == [[0.0, np.float32(0.4), 1.0]]


def test_a_face_comes_to_rest_after_the_last_phone() -> None:
    end = SENTENCE[-1].start
    found = brought_to_rest(np.ones((5, 1), np.float32), SENTENCE, end + np.array([-0.1, 0, TO_REST / 2, TO_REST, 1]))
    assert found[:, 0] == pytest.approx([1, 1, 0.5, 0, 0])


def test_louder_syllables_open_the_jaw_farther_within_limits() -> None:
    """12 dB above the mean are half as much again, and the limits are 0.7 and 1.4."""
    levels = {"m": -90.0, "a": -20.0, "t": -90.0, "u": -20.0}
    even = tuple(replace(phone, energy=levels.get(phone.name, -99.0)) for phone in SENTENCE)
    assert gains_of(even, TIMES) == pytest.approx(1)
    louder = tuple(replace(p, energy=p.energy + 9.0 * (p.name == "u")) for p in even)  # the mean grows by 3 dB
    middles = np.array([phone.middle for phone in SENTENCE if phone.name in "au"])
    assert gains_of(louder, middles) == pytest.approx([0.875, 0.875, 1.25])
    shouted = tuple(replace(p, energy=p.energy + 90.0 * (p.name == "u")) for p in even)
    assert gains_of(shouted, middles) == pytest.approx([0.7, 0.7, 1.4])
    assert gains_of(SENTENCE[:1], TIMES) == pytest.approx(1)
