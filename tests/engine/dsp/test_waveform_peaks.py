"""The outline of a long waveform: no peak is lost at any scale, whatever blocks the sound came in."""

import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.dsp.waveform_peaks import FACTOR, FINEST, WaveformPeaks, zero_crossing_near
from tests.sounds import noise, silence

SOUND = noise(20.0, 0.1, seed=3)


def peaks_of(sound: np.ndarray, block: int = 50_000) -> WaveformPeaks:
    peaks = WaveformPeaks()
    for k in range(0, len(sound), block):
        peaks.push(sound[k : k + block])
    return peaks


WHOLE = peaks_of(SOUND)


@settings(deadline=None)
@given(st.floats(0, 1), st.floats(0, 1), st.integers(1, 900))
def test_each_column_covers_its_samples_and_little_more(one: float, other: float, n: int):
    first, last = sorted((one * len(SOUND), other * len(SOUND) + 1))
    found = WHOLE.between(first, last, n)
    width = (last - first) / n
    slack = max(FINEST, FINEST * FACTOR ** max(0, int(np.log(max(width / FINEST, 1)) / np.log(FACTOR))))
    for k in range(0, n, max(1, n // 7)):
        begin, end = first + k * width, first + (k + 1) * width
        inner = SOUND[int(np.ceil(begin)) : int(end)]
        outer = SOUND[max(0, int(begin) - slack) : int(end) + slack + 1]
        if len(inner):
            assert outer.min() <= found.low[k] <= inner.min()
            assert inner.max() <= found.high[k] <= outer.max()


@pytest.mark.parametrize("block", [1, 100, FINEST, 1000, 441])
def test_it_does_not_matter_in_what_blocks_the_sound_came(block: int):
    sound = SOUND[:5000]
    one, other = peaks_of(sound, block).between(0, 5000, 7), peaks_of(sound).between(0, 5000, 7)
    np.testing.assert_array_equal(one.low, other.low)
    np.testing.assert_array_equal(one.high, other.high)


def test_one_click_is_seen_in_an_hour():
    peaks = WaveformPeaks()
    for k in range(60):
        minute = silence(60.0)
        if k == 41:
            minute[12_345] = -0.7
        peaks.push(minute)
    found = peaks.between(0, peaks.n_samples, 1000)
    assert found.low.min() == np.float32(-0.7)
    assert abs(int(found.low.argmin()) - round((41 * 60 + 0.28) / 3.6)) <= 1
    assert (found.high == 0).all()


def test_beyond_the_sound_there_is_nothing():
    found = WHOLE.between(-100_000, len(SOUND) + 100_000, 20)
    assert np.isnan(found.low[[0, 19]]).all()
    assert not np.isnan(found.low[3:17]).any()
    assert np.isnan(WaveformPeaks().between(0, 1000, 3).high).all()


def test_what_came_last_is_seen_at_once():
    peaks = peaks_of(silence(1.0))
    peaks.between(0, 44_100, 10)
    peaks.push(np.array([0.9], np.float32))
    assert peaks.between(44_000, 44_101, 1).high[0] == np.float32(0.9)


def test_one_thread_may_look_while_another_writes() -> None:
    peaks, faults = WaveformPeaks(), []

    def look() -> None:
        try:
            while peaks.n_samples < 400 * 5000:
                assert len(peaks.between(0, 2e6, 300).low) == 300
        except Exception as fault:  # noqa: BLE001 - any is told
            faults.append(fault)

    looking = threading.Thread(target=look)
    looking.start()
    for _ in range(400):
        peaks.push(np.ones(5000, np.float32))
    looking.join()
    assert faults == []


def test_sections_of_one_sample_give_the_exact_outline():
    peaks = WaveformPeaks(1)
    peaks.push(SOUND[:1000])
    found = peaks.between(0, 1000, 100)
    columns = SOUND[:1000].reshape(100, 10)
    assert np.array_equal(found.low, columns.min(axis=1))
    assert np.array_equal(found.high, columns.max(axis=1))


def test_the_nearest_zero_crossing_lies_between_two_samples():
    wave = np.array([0.5, 0.25, -0.75, -0.5, 0.5, 1.0], np.float32)
    assert zero_crossing_near(wave, 1.5, 2.0) == pytest.approx(1.25)
    assert zero_crossing_near(wave, 3.0, 2.0) == pytest.approx(3.5)
    assert zero_crossing_near(wave, 2.4, 0.5) is None
    assert zero_crossing_near(silence(0.1), 100.0, 5.0) is None
