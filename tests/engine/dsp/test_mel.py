"""The mel bank: HTK's scale, triangles that overlap by half, weights that sum to one."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.dsp.mel import frequency_of, mel_bank, mel_edges, mel_of, mel_spectra_of
from phonemeengine.settings import BIN_WIDTH


@pytest.mark.parametrize(("hertz", "mel"), [(0, 0), (700, 781.17), (1000, 999.99), (4000, 2146.06), (8000, 2840.02)])
def test_the_mel_scale_is_that_of_htk(hertz: float, mel: float):
    assert float(mel_of(hertz)) == pytest.approx(mel, abs=0.01)


@given(hertz=st.floats(0, 22_050))
def test_hertz_to_mel_and_back_is_the_same_frequency(hertz: float):
    assert float(frequency_of(mel_of(hertz))) == pytest.approx(hertz, abs=1e-6)


def test_the_corners_are_equally_far_apart_in_mel():
    steps = np.diff(mel_of(mel_edges(40, 5512.5)))
    np.testing.assert_allclose(steps, steps[0])


@given(n_bands=st.integers(4, 80), n_bins=st.sampled_from([256, 512, 1024]))
def test_the_weights_of_every_band_sum_to_one(n_bands: int, n_bins: int):
    bank = mel_bank(n_bands, n_bins, BIN_WIDTH)
    assert bank.shape == (n_bins, n_bands)
    assert bank.min() >= 0
    np.testing.assert_allclose(bank.sum(axis=0), 1, rtol=1e-5)


@pytest.mark.parametrize("n_bands", [4, 20, 40, 80])
def test_a_flat_spectrum_stays_flat(n_bands: int):
    mel = mel_spectra_of(np.full((3, 256), 0.3, np.float32), n_bands, BIN_WIDTH)
    assert mel.shape == (3, n_bands)
    np.testing.assert_allclose(mel, 0.3, rtol=1e-5)


@pytest.mark.parametrize("k", [40, 60, 100, 150, 200, 240])
def test_a_tone_lands_in_the_band_around_it(k: int):
    spectrum = np.zeros((1, 256), np.float32)
    spectrum[0, k] = 1
    band = int(mel_spectra_of(spectrum, 20, BIN_WIDTH)[0].argmax())
    edges = mel_edges(20, 256 * BIN_WIDTH)
    assert edges[band] < k * BIN_WIDTH < edges[band + 2]
    peaks = mel_of(edges[1:-1])
    assert abs(peaks[band] - float(mel_of(k * BIN_WIDTH))) <= (peaks[1] - peaks[0]) * 0.75


def test_a_band_is_a_triangle_of_the_amplitudes_under_it():
    bank = mel_bank(10, 1024, BIN_WIDTH)[:, 6]
    low, peak, high = mel_edges(10, 1024 * BIN_WIDTH)[6:9]
    frequencies = np.arange(1024) * BIN_WIDTH
    triangle = np.interp(frequencies, [low, peak, high], [0, 1, 0])
    np.testing.assert_allclose(bank, triangle / triangle.sum(), atol=1e-7)
