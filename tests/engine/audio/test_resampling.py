"""A sound keeps its shape, its place and its length at 44.1 kHz, and the resampler knows what it holds back."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.audio.resampling import Resampler
from phonemeengine.settings import SAMPLE_RATE

RATES = [48_000, 16_000, 96_000, 8_000, 22_050, 192_000]
CLICK = 1.0
"""Time of the click, seconds."""


def clicks(rate: int, n_channels: int = 1) -> np.ndarray:
    sound = np.zeros((2 * rate, n_channels), np.float32)
    sound[int(CLICK * rate)] = 1
    return sound


def place_of_peak(sound: np.ndarray) -> float:
    """Where a band-limited click has its top, samples; between samples, on the spectrum of 16 times as many."""
    spectrum = np.fft.rfft(sound)
    return int(np.argmax(np.fft.irfft(spectrum, 16 * len(sound)))) / 16


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("steady", [False, True])
def test_the_delay_says_how_far_the_newest_sample_lags_behind(rate: int, steady: bool) -> None:
    resampler = Resampler(rate, 1, steady=steady)
    assert resampler.delay == pytest.approx(0, abs=2 / SAMPLE_RATE)
    blocks, delays = [], []
    for start in range(0, 2 * rate, rate // 100):
        blocks.append(resampler.resample(clicks(rate)[start : start + rate // 100]))
        delays.append(resampler.delay)
    late = place_of_peak(np.concatenate(blocks)[:, 0]) - CLICK * SAMPLE_RATE
    n_out = np.cumsum([len(block) for block in blocks])
    n_in = np.minimum(np.arange(1, len(blocks) + 1) * (rate // 100), 2 * rate)
    np.testing.assert_allclose(delays, n_in / rate - (n_out - late) / SAMPLE_RATE, atol=1 / SAMPLE_RATE)


@pytest.mark.parametrize("rate", RATES)
def test_a_steady_resampler_holds_back_the_same_at_any_time(rate: int) -> None:
    resampler = Resampler(rate, 2, steady=True)
    delays = []
    for _ in range(100):
        resampler.resample(np.zeros((rate // 100, 2), np.float32))
        delays.append(resampler.delay)
    assert np.ptp(delays[10:]) < 2 / SAMPLE_RATE
    assert delays[-1] < 0.031 * 8000 / min(rate, 40_000) + 0.001


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("steady", [False, True])
def test_a_tone_keeps_its_frequency_and_its_amplitude(rate: int, steady: bool) -> None:
    time = np.arange(2 * rate) / rate
    sound = (0.5 * np.sin(2 * np.pi * 1000 * time)).astype(np.float32)[:, np.newaxis]
    found = Resampler(rate, 1, steady=steady).resample(sound, last=True)[:, 0]
    assert len(found) == 2 * SAMPLE_RATE
    amplitudes = np.abs(np.fft.rfft(found[SAMPLE_RATE // 2 : -SAMPLE_RATE // 2])) / (SAMPLE_RATE / 2)
    assert amplitudes[1000] == pytest.approx(0.5, rel=1e-3)
    amplitudes[1000] = 0
    assert amplitudes.max() < 1e-4


@pytest.mark.parametrize("steady", [False, True])
def test_what_44100_hz_cannot_hold_vanishes(steady: bool) -> None:
    time = np.arange(96_000) / 96_000
    sound = np.sin(2 * np.pi * 30_000 * time).astype(np.float32)[:, np.newaxis]
    found = Resampler(96_000, 1, steady=steady).resample(sound, last=True)[4410:-4410]
    assert np.abs(found).max() < 1e-4


@given(cuts=st.lists(st.integers(1, 5000), min_size=1, max_size=6), steady=st.booleans())
def test_the_result_does_not_depend_on_the_cutting(cuts: list[int], steady: bool) -> None:
    sound = np.random.default_rng(0).standard_normal((24_000, 2)).astype(np.float32)
    whole = Resampler(48_000, 2, steady=steady).resample(sound, last=True)
    resampler, parts, start = Resampler(48_000, 2, steady=steady), [], 0
    while start < len(sound):
        n = cuts[len(parts) % len(cuts)]
        parts.append(resampler.resample(sound[start : start + n], last=start + n >= len(sound)))
        start += n
    np.testing.assert_allclose(np.concatenate(parts), whole, atol=1e-5)
