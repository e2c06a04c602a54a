"""The level meter: the peak falls at 20 dB a second, the highest stays for a while, clipping is remembered."""

import numpy as np
import pytest

from phonemeengine.audio import level
from phonemeengine.audio.level import Level, PeakMeter


def block(peak: float, n: int = 441) -> np.ndarray:
    samples = np.zeros((n, 2), np.float32)
    samples[n // 3, 1] = peak
    return samples


@pytest.fixture
def meter() -> PeakMeter:
    return PeakMeter()


def test_before_the_first_sound_everything_reads_nothing(meter: PeakMeter) -> None:
    assert meter.read(100.0) == Level(0.0, 0.0, None)


@pytest.mark.parametrize("peak", [0.5, -0.5])
def test_the_peak_is_the_largest_amplitude_of_either_sign_in_any_channel(meter: PeakMeter, peak: float) -> None:
    meter.add_samples(block(peak), 100.0)
    assert meter.read(100.0) == Level(0.5, 0.5, None)


def test_the_peak_falls_by_20_db_a_second_and_the_highest_is_held(meter: PeakMeter) -> None:
    meter.add_samples(block(0.8), 100.0)
    for after, peak in ((0.5, 0.8 * 10**-0.5), (1.0, 0.08), (1.4, 0.8 * 10**-1.4)):
        reading = meter.read(100.0 + after)
        assert reading.peak == pytest.approx(peak)
        assert reading.held == pytest.approx(0.8)
    late = meter.read(101.6)
    assert late.peak == late.held == pytest.approx(0.8 * 10**-1.6)


def test_reading_often_changes_nothing(meter: PeakMeter) -> None:
    other = PeakMeter()
    for k in range(300):
        for one in (meter, other):
            one.add_samples(block(0.9 if k == 20 else 0.001), 100 + k / 100)
        meter.read(100 + k / 100)
    assert meter.read(103.0) == other.read(103.0)


def test_a_louder_sound_takes_the_place_of_what_is_held(meter: PeakMeter) -> None:
    meter.add_samples(block(0.3), 100.0)
    meter.add_samples(block(0.6), 101.0)
    assert meter.read(102.4).held == pytest.approx(0.6)
    meter.add_samples(block(0.2), 102.6)
    assert meter.read(102.6).held == pytest.approx(0.2)
    assert meter.read(103.9).held == pytest.approx(0.2)


def test_silence_lets_the_meter_fall_and_not_jump(meter: PeakMeter) -> None:
    meter.add_samples(block(1.0), 100.0)
    meter.add_samples(block(0.0), 100.5)
    assert meter.read(101.0).peak == pytest.approx(0.1)


@pytest.mark.parametrize(("peak", "clips"), [(32767 / 32768, True), (-1.0, True), (1.2, True), (0.9997, False)])
def test_clipping_is_what_reaches_the_largest_16_bit_value(meter: PeakMeter, peak: float, clips: bool) -> None:
    meter.add_samples(block(peak), 100.0)
    assert meter.read(107.0).clipped_ago == (pytest.approx(7.0) if clips else None)


def test_the_newest_clipping_counts(meter: PeakMeter) -> None:
    for now in (100.0, 105.0):
        meter.add_samples(block(1.0), now)
    meter.add_samples(block(0.1), 108.0)
    assert meter.read(109.0).clipped_ago == pytest.approx(4.0)


def test_blocks_that_nobody_looks_at_take_no_more_room_than_a_little(meter: PeakMeter) -> None:
    meter.add_samples(block(1.0, 10), 0.0)
    for k in range(level.MOST_UNREAD):
        meter.add_samples(block(0.25, 10), 100 + k / 100)
    assert len(meter._unread) == level.MOST_UNREAD
    assert meter.read(110.0) == Level(pytest.approx(0.25, rel=0.03), 0.25, None)


def test_an_empty_block_is_no_sound(meter: PeakMeter) -> None:
    meter.add_samples(np.zeros((0, 1), np.float32), 100.0)
    assert meter.read(100.0).peak == 0
