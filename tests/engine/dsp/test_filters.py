"""Filters do what their formula says."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.dsp.spectrum import (
    FrequencyShaper,
    SpectrumAnalyser,
    TimeSmoother,
    denoise,
    high_pass_gains,
    low_pass_gains,
    normalise,
    pre_emphasis,
)
from phonemeengine.errors import SettingsError
from phonemeengine.settings import BIN_WIDTH, WINDOW, AnalysisSettings
from tests.sounds import Sound, tone


def some_spectra(n_frames: int, n_bins: int = 16, seed: int = 0) -> Sound:
    return np.random.default_rng(seed).random((n_frames, n_bins)).astype(np.float32)


@pytest.mark.parametrize("a", [0.5, 0.97, 1.0])
@pytest.mark.parametrize("k", [20, 200, 900])
def test_pre_emphasis_has_the_gain_of_its_formula(a: float, k: int):
    wave = tone(k * BIN_WIDTH, WINDOW / 44_100)[None]
    transform = SpectrumAnalyser(AnalysisSettings(filters=frozenset()))
    gain = (transform.magnitudes_of(pre_emphasis(wave, a)) * transform.scale)[0, k]
    assert gain == pytest.approx(abs(1 - a * np.exp(-2j * np.pi * k / WINDOW)), abs=1e-3)


def test_pre_emphasis_by_hand():
    wave = np.array([[4, 4, 8, 0]], np.float32)
    np.testing.assert_allclose(pre_emphasis(wave, 0.5), [[2, 2, 6, -4]])
    np.testing.assert_array_equal(wave, [[4, 4, 8, 0]])


@given(strength=st.floats(0, 1))
def test_a_flat_spectrum_stays_flat_under_the_blur(strength: float):
    flat = np.full((2, 16), 0.7, np.float32)
    shaper = FrequencyShaper(strength, np.ones(16, np.float32))
    np.testing.assert_allclose(shaper.shape(flat), flat, rtol=1e-6)


@given(strength=st.floats(0, 1), seed=st.integers(0, 1000))
def test_the_blur_keeps_the_sum_of_the_amplitudes(strength: float, seed: int):
    spectra = some_spectra(3, seed=seed)
    blurred = FrequencyShaper(strength, np.ones(16, np.float32)).shape(spectra)
    np.testing.assert_allclose(blurred.sum(axis=1), spectra.sum(axis=1), rtol=1e-5)


def test_the_strongest_blur_is_the_mean_of_three_neighbours():
    spectra = np.array([[0, 0, 3, 0, 0]], np.float32)
    np.testing.assert_allclose(FrequencyShaper(1, np.ones(5, np.float32)).shape(spectra), [[0, 1, 1, 1, 0]])


@given(strength=st.floats(0, 1), seed=st.integers(0, 1000))
def test_the_pass_filters_act_after_the_blur(strength: float, seed: int):
    spectra = some_spectra(4, seed=seed)
    gains = some_spectra(1, seed=seed + 1)[0]
    edged = np.pad(spectra, ((0, 0), (1, 1)), mode="edge")
    side = strength / 3
    blurred = (1 - 2 * side) * spectra + side * edged[:, :-2] + side * edged[:, 2:]
    before = spectra.copy()
    np.testing.assert_allclose(FrequencyShaper(strength, gains).shape(spectra), blurred * gains, rtol=1e-4, atol=1e-6)
    np.testing.assert_array_equal(spectra, before)


def recursion(spectra: Sound, strength: float) -> Sound:
    last = np.zeros(spectra.shape[1])
    out = []
    for spectrum in spectra:
        last = strength * last + (1 - strength) * spectrum
        out.append(last)
    return np.array(out, np.float32)


@given(strength=st.floats(0, 1), cuts=st.lists(st.integers(1, 99), max_size=8, unique=True))
def test_time_smoothing_is_the_recursion_for_any_cutting(strength: float, cuts: list[int]):
    spectra = some_spectra(100)
    smoother = TimeSmoother(strength)
    smoothed = np.concatenate([smoother.smooth(part) for part in np.split(spectra, sorted(cuts))])
    np.testing.assert_allclose(smoothed, recursion(spectra, strength), rtol=1e-4, atol=1e-7)


@pytest.mark.parametrize("strength", [0.1, 0.3, 0.5, 0.9])
def test_a_smoothed_sound_dies_away_alike_for_any_cutting(strength: float):
    """Normalising shows even the faintest rest of a sound, so it must not vanish earlier in a long block."""
    spectra = np.zeros((100, 16), np.float32)
    spectra[:3] = some_spectra(3)
    whole = normalise(TimeSmoother(strength).smooth(spectra))
    smoother = TimeSmoother(strength)
    single = normalise(np.concatenate([smoother.smooth(spectra[k : k + 1]) for k in range(100)]))
    np.testing.assert_allclose(whole, single, atol=1e-4)


def test_a_steady_spectrum_is_approached_and_kept():
    steady = np.full((200, 4), 0.5, np.float32)
    smoothed = TimeSmoother(0.8).smooth(steady)
    assert np.all(np.diff(smoothed[:, 0]) >= -1e-6)
    np.testing.assert_allclose(smoothed[0], 0.1, rtol=1e-6)
    np.testing.assert_allclose(smoothed[-1], 0.5, rtol=1e-5)


def test_the_high_pass_rises_from_its_start_to_its_end():
    gains = high_pass_gains(10, 10.0, 20, 60)
    np.testing.assert_allclose(gains, [0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1])


def test_the_low_pass_falls_from_its_start_to_its_end():
    gains = low_pass_gains(10, 10.0, 20, 60)
    np.testing.assert_allclose(gains, [1, 1, 1, 0.75, 0.5, 0.25, 0, 0, 0, 0])


def test_a_ramp_of_no_width_is_a_step():
    np.testing.assert_array_equal(high_pass_gains(4, 10.0, 20, 20), [0, 0, 1, 1])
    np.testing.assert_array_equal(low_pass_gains(4, 10.0, 20, 20), [1, 1, 0, 0])
    np.testing.assert_array_equal(high_pass_gains(4, 10.0, 0, 0), [1, 1, 1, 1])


def test_denoising_removes_only_what_lies_below_the_threshold():
    spectra = np.array([[0.1, 0.2, 0.3, 0.0]], np.float32)
    np.testing.assert_array_equal(denoise(spectra, 0.2), np.array([[0, 0.2, 0.3, 0]], np.float32))
    np.testing.assert_array_equal(denoise(spectra, 0.0), spectra)


@given(loudness=st.floats(1e-6, 1e6), seed=st.integers(0, 100))
def test_a_normalised_spectrum_has_its_largest_amplitude_at_one(loudness: float, seed: int):
    spectra = some_spectra(5, seed=seed)
    normalised = normalise(spectra * np.float32(loudness))
    np.testing.assert_allclose(normalised.max(axis=1), 1, rtol=1e-6)
    np.testing.assert_allclose(normalised, normalise(spectra), rtol=1e-4)


@pytest.mark.parametrize("maximum", [0.5, 1.0, 80.0])
def test_the_largest_amplitude_becomes_the_maximum_that_is_asked_for(maximum: float):
    spectra = some_spectra(5)
    scaled = normalise(spectra, maximum)
    np.testing.assert_allclose(scaled.max(axis=1), maximum, rtol=1e-6)
    np.testing.assert_allclose(scaled, maximum * normalise(spectra), rtol=1e-5)
    assert normalise(spectra[0], maximum).max() == pytest.approx(maximum)
    assert not normalise(np.zeros(16, np.float32), maximum).any()


@pytest.mark.parametrize("maximum", [0, -1, math.nan, math.inf])
def test_a_maximum_that_is_no_amplitude_is_refused(maximum: float):
    with pytest.raises(SettingsError, match=f"must be above 0, got {maximum:g}"):
        normalise(some_spectra(1), maximum)


def test_a_silent_spectrum_stays_zero_when_normalised():
    spectra = np.zeros((2, 4), np.float32)
    spectra[1, 2] = 0.25
    np.testing.assert_array_equal(normalise(spectra), [[0, 0, 0, 0], [0, 0, 1, 0]])
