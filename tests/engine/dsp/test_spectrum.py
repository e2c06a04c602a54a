"""Windows, decimation and amplitude spectra: a full-scale sine on a bin reads 1.0."""

import numpy as np
import pytest

from phonemeengine.dsp.spectrum import SpectrumAnalyser, decimate, window_of
from phonemeengine.settings import BIN_WIDTH, WINDOW, AnalysisSettings, Decimation, Filter, WindowFunction
from tests.sounds import Sound, noise, tone

STEPS = (1, 2, 4)


def frame_of(frequency: float, amplitude: float = 1.0) -> Sound:
    return tone(frequency, WINDOW / 44_100, amplitude)[None]


def spectrum_of(
    frame: Sound, step: int, kind: Decimation, window: WindowFunction = WindowFunction.RECTANGLE
) -> Sound:
    settings = AnalysisSettings(
        filters=frozenset({Filter.QUANTISE, Filter.WINDOW_FUNCTION}),
        quantise=step,
        decimation=kind,
        window_function=window,
    )
    transform = SpectrumAnalyser(settings)
    return (transform.magnitudes_of(transform.waveforms_of(frame)) * transform.scale)[0]


@pytest.mark.parametrize("window", WindowFunction)
@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("kind", Decimation)
@pytest.mark.parametrize("k", [10, 100, 240])
def test_a_full_scale_sine_on_a_bin_reads_one(window: WindowFunction, step: int, kind: Decimation, k: int):
    spectrum = spectrum_of(frame_of(k * BIN_WIDTH), step, kind, window)
    assert spectrum.argmax() == k
    assert spectrum[k] == pytest.approx(1, abs=2e-3)
    far = np.abs(np.arange(len(spectrum)) - k) > 10
    assert spectrum[far].max() < 5e-3


@pytest.mark.parametrize("window", WindowFunction)
@pytest.mark.parametrize("step", STEPS)
def test_a_constant_reads_its_value_on_bin_zero(window: WindowFunction, step: int):
    spectrum = spectrum_of(np.full((1, WINDOW), 0.5, np.float32), step, Decimation.PLAIN, window)
    assert spectrum[0] == pytest.approx(0.5, abs=1e-5)


@pytest.mark.parametrize("amplitude", [1.0, 0.1, 0.001])
def test_amplitudes_are_linear(amplitude: float):
    spectrum = spectrum_of(frame_of(50 * BIN_WIDTH, amplitude), 4, Decimation.PLAIN)
    assert spectrum[50] == pytest.approx(amplitude, rel=1e-4)


@pytest.mark.parametrize(("step", "n_bins"), [(1, 1024), (2, 512), (4, 256)])
def test_a_bin_is_equally_wide_in_every_quantisation(step: int, n_bins: int):
    for kind in Decimation:
        spectrum = spectrum_of(frame_of(1000), step, kind)
        assert len(spectrum) == n_bins
        assert spectrum.argmax() == round(1000 / BIN_WIDTH)


@pytest.mark.parametrize(("sound_bin", "lands_on"), [(312, 200), (272, 240), (337, 175), (432, 80), (600, 88)])
def test_plain_quantising_folds_high_sound_down(sound_bin: int, lands_on: int):
    spectrum = spectrum_of(frame_of(sound_bin * BIN_WIDTH), 4, Decimation.PLAIN)
    assert spectrum.argmax() == lands_on
    assert spectrum[lands_on] == pytest.approx(1, abs=1e-3)


@pytest.mark.parametrize(("step", "first_gone"), [(2, 512), (4, 256)])
def test_anti_aliased_quantising_removes_high_sound(step: int, first_gone: int):
    for k in (first_gone, first_gone + 1, first_gone + 88, 900):
        assert spectrum_of(frame_of(k * BIN_WIDTH), step, Decimation.ANTI_ALIASED).max() < 1e-5


@pytest.mark.parametrize("step", [2, 4])
def test_anti_aliased_quantising_removes_the_new_half_rate_in_every_phase(step: int):
    phase = 2 * np.pi * (1024 // step) * np.arange(WINDOW) / WINDOW
    for frame in (np.sin(phase), np.cos(phase), np.cos(phase + 1)):
        wave = decimate(frame[None].astype(np.float32), step, Decimation.ANTI_ALIASED)
        assert np.abs(wave).max() < 1e-5


@pytest.mark.parametrize("step", [2, 4])
def test_anti_aliased_quantising_leaves_low_bins_as_they_were(step: int):
    frame = noise(WINDOW / 44_100)[None]
    full = spectrum_of(frame, 1, Decimation.PLAIN)
    np.testing.assert_allclose(spectrum_of(frame, step, Decimation.ANTI_ALIASED), full[: 1024 // step], atol=1e-6)


def test_plain_quantising_keeps_every_nth_sample():
    frames = noise(3 * WINDOW / 44_100).reshape(3, WINDOW)
    for step in STEPS:
        np.testing.assert_array_equal(decimate(frames, step, Decimation.PLAIN), frames[:, ::step])


def test_spectra_agree_with_the_definition_of_the_fourier_transform():
    wave = noise(512 / 44_100).astype(np.float64)
    time = np.arange(512)
    expected = [abs(np.sum(wave * np.exp(-2j * np.pi * k * time / 512))) / 256 for k in range(256)]
    expected[0] /= 2
    transform = SpectrumAnalyser(AnalysisSettings())
    amplitudes = (transform.magnitudes_of(wave[None].astype(np.float32)) * transform.scale)[0]
    np.testing.assert_allclose(amplitudes, expected, atol=1e-6)


@pytest.mark.parametrize(
    ("window", "reference"),
    [
        (WindowFunction.RECTANGLE, "boxcar"),
        (WindowFunction.BARTLETT, "bartlett"),
        (WindowFunction.HANN, "hann"),
        (WindowFunction.HAMMING, "hamming"),
        (WindowFunction.BLACKMAN_HARRIS, "blackmanharris"),
    ],
)
def test_windows_are_those_of_the_books(window: WindowFunction, reference: str):
    from scipy.signal import windows  # it takes seconds, as test files are read by each process

    np.testing.assert_allclose(window_of(window, 512), getattr(windows, reference)(512), atol=1e-7)


@pytest.mark.parametrize("window", WindowFunction)
def test_windows_are_symmetric_and_at_most_one(window: WindowFunction):
    weights = window_of(window, 512)
    np.testing.assert_allclose(weights, weights[::-1], atol=1e-6)
    assert weights.min() > -1e-7
    assert weights.max() <= 1
    assert weights[256] > 0.99


def test_blackman_harris_hides_what_lies_far_away():
    between_bins = frame_of(100.5 * BIN_WIDTH)
    rectangle = spectrum_of(between_bins, 1, Decimation.PLAIN)
    harris = spectrum_of(between_bins, 1, Decimation.PLAIN, WindowFunction.BLACKMAN_HARRIS)
    assert rectangle[200] > 1e-3
    assert harris[200] < 1e-5
