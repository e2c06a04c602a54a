"""Variables are measured over the bins they name, in the way they name."""

import numpy as np
import pytest

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.dsp.mel import mel_edges
from phonemeengine.errors import SettingsError
from phonemeengine.features.variables import (
    BAND_VARIABLES,
    BUILT_IN_NAMES,
    BandFeatures,
    Features,
    Kind,
    Spectrum,
    Variable,
    check_user_variables,
    peak_levels_of,
    zero_crossings_of,
)
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, HOP, SAMPLE_RATE, WINDOW, AnalysisSettings, Filter
from tests.sounds import Sound, noise, tone, vowel

BINS = np.arange(256) * BIN_WIDTH
SPEC_TABLE = {
    "energy_n": (0, 255, Kind.SUM),
    "m_szsch1": (80, 130, Kind.SUM),
    "m_s1": (175, 240, Kind.SUM),
    "m_p1": (3, 5, Kind.SUM),
    "m_p2": (200, 220, Kind.MAX),
    "m_ae1": (50, 100, Kind.MAX),
    "m_a1": (12, 27, Kind.SUM),
    "m_o1": (8, 18, Kind.SUM),
}


def measured(variable: Variable, spectra: Sound) -> Sound:
    meter = BandFeatures((variable.name,), (variable,), BINS)
    return meter.append_maxima(spectra).dot(meter.weights(variable.source))[:, 0]


def analysed(sound: Sound, **preset) -> Analysis:
    return Analyser(Preset(**preset)).push(sound)


@pytest.mark.parametrize("frequency", [100, 440, 1000, 5000])
def test_a_sine_crosses_zero_twice_in_every_period(frequency: float):
    frame = tone(frequency, WINDOW / SAMPLE_RATE)[None]
    per_second = zero_crossings_of(frame)[0] * SAMPLE_RATE / WINDOW
    assert per_second == pytest.approx(2 * frequency, abs=1.01 * SAMPLE_RATE / WINDOW)


def test_a_one_kilohertz_sine_crosses_zero_two_thousand_times_a_second():
    frames = tone(1000, 1)[: 21 * WINDOW].reshape(21, WINDOW)
    assert zero_crossings_of(frames).mean() * SAMPLE_RATE / WINDOW == pytest.approx(2000, rel=0.01)


def test_silence_and_a_constant_cross_nothing():
    for level in (0, 0.5, -0.5):
        assert zero_crossings_of(np.full((1, WINDOW), level, np.float32))[0] == 0


def test_crossings_are_counted_one_by_one():
    frame = np.zeros((1, WINDOW), np.float32)
    frame[0, :6] = [1, -1, 1, 0, -1, -1]
    assert zero_crossings_of(frame)[0] == 4
    alternating = np.tile(np.array([1, -1], np.float32), WINDOW // 2)[None]
    assert zero_crossings_of(alternating)[0] == WINDOW - 1


def test_the_peak_level_is_the_largest_sample_of_either_sign():
    frames = np.array([[0.1, -0.7, 0.3], [0.2, 0.4, -0.1], [0, 0, 0]], np.float32)
    np.testing.assert_array_equal(peak_levels_of(frames), np.array([0.7, 0.4, 0], np.float32))


@pytest.mark.parametrize("name", SPEC_TABLE)
def test_a_built_in_variable_covers_exactly_its_bins(name: str):
    first, last, kind = SPEC_TABLE[name]
    variable = next(v for v in BAND_VARIABLES if v.name == name)
    assert variable.kind is kind
    assert variable.source is Spectrum.NORMALISED
    one_at_a_time = np.eye(256, dtype=np.float32)
    inside = (np.arange(256) >= first) & (np.arange(256) <= last)
    np.testing.assert_array_equal(measured(variable, one_at_a_time), inside)


def test_every_variable_of_the_specification_is_there():
    whole_frame = {"zero_crossings", "volume", "energy", "max_energy", "f0"}
    assert {v.name for v in BAND_VARIABLES} == set(SPEC_TABLE)
    assert set(BUILT_IN_NAMES) == whole_frame | set(SPEC_TABLE)


@pytest.mark.parametrize(("kind", "value"), [(Kind.SUM, 0.9), (Kind.MAX, 0.5), (Kind.MEAN, 0.3)])
def test_sum_maximum_and_mean(kind: Kind, value: float):
    spectra = np.full((2, 256), 9, np.float32)
    spectra[:, 10:13] = [0.1, 0.5, 0.3]
    variable = Variable("mine", 10 * BIN_WIDTH, 12 * BIN_WIDTH, kind)
    np.testing.assert_allclose(measured(variable, spectra), value, rtol=1e-6)


@pytest.mark.parametrize("kind", Kind)
def test_a_range_without_a_bin_measures_nothing(kind: Kind):
    spectra = np.ones((2, 256), np.float32)
    for low, high in ((10.1 * BIN_WIDTH, 10.9 * BIN_WIDTH), (300 * BIN_WIDTH, 400 * BIN_WIDTH)):
        assert not measured(Variable("mine", low, high, kind), spectra).any()


@pytest.mark.parametrize("built_in", BAND_VARIABLES, ids=lambda v: v.name)
def test_a_variable_of_the_user_measures_as_the_built_in_one_of_its_range(built_in: Variable):
    mine = Variable("mine", built_in.low, built_in.high, built_in.kind)
    features = analysed(noise(0.3), variables=(mine,)).features
    np.testing.assert_allclose(features["mine"], features[built_in.name], rtol=1e-5)


def test_a_variable_sees_the_spectrum_it_names():
    low, high = 100 * BIN_WIDTH, 100 * BIN_WIDTH
    sources = (Spectrum.RAW, Spectrum.FILTERED, Spectrum.NORMALISED)
    variables = tuple(Variable(f"at_{s}", low, high, Kind.MAX, s) for s in sources)
    settings = AnalysisSettings(high_pass_start=0, high_pass_end=200 * BIN_WIDTH)
    features = analysed(tone(100 * BIN_WIDTH, 0.2, 0.5), settings=settings, variables=variables).features
    np.testing.assert_allclose(features["at_raw"][3:-3], 0.5, rtol=1e-3)
    np.testing.assert_allclose(features["at_filtered"][3:-3], 0.25, rtol=1e-3)
    np.testing.assert_allclose(features["at_normalised"][3:-3], 1, rtol=1e-3)


def test_a_variable_over_the_mel_spectrum_covers_the_bands_of_its_range():
    with_mel = AnalysisSettings(filters=frozenset({Filter.QUANTISE, Filter.MEL}), mel_bands=20)
    peaks = mel_edges(20, 256 * BIN_WIDTH)[1:-1]
    mine = Variable("mine", peaks[4], peaks[7], Kind.SUM, Spectrum.MEL)
    analysis = analysed(vowel((700, 1200), 0.2), settings=with_mel, variables=(mine,))
    np.testing.assert_allclose(analysis.features["mine"], analysis.mel[:, 4:8].sum(axis=1), rtol=1e-5)
    assert analysis.features["mine"].max() > 0
    without = analysed(vowel((700, 1200), 0.2), variables=(mine,))
    assert without.mel is None
    assert not without.features["mine"].any()


def test_energy_is_measured_before_denoising_and_normalising():
    settings = AnalysisSettings().with_numbers(denoise_threshold=1.0)
    features = analysed(tone(100 * BIN_WIDTH, 0.2, 0.5), settings=settings).features
    np.testing.assert_allclose(features["max_energy"][3:-3], 0.5, rtol=1e-3)
    np.testing.assert_allclose(features["energy"][3:-3], 0.5, rtol=0.05)
    assert not features["energy_n"][3:-3].any()


def test_zero_crossings_and_volume_are_measured_before_every_filter():
    settings = AnalysisSettings(filters=frozenset(Filter), pre_emphasis=1.0)
    sound = tone(10_000, 0.2, 0.25)
    features = analysed(sound, settings=settings).features
    np.testing.assert_allclose(features["volume"][3:-3], 0.25, rtol=1e-3)
    inner = slice(3, len(sound) // HOP - 3)
    np.testing.assert_allclose(features["zero_crossings"][inner], 2 * 10_000 * 2047 / SAMPLE_RATE, atol=1.5)


def test_features_are_found_by_name():
    features = Features(("a", "b"), np.array([[1, 2], [3, 4]], np.float32))
    np.testing.assert_array_equal(features["b"], [2, 4])
    assert features.frame(1) == {"a": 3, "b": 4}
    with pytest.raises(KeyError, match="c"):
        features["c"]


@pytest.mark.parametrize("name", ["", "9lives", "Upper", "with space", "m-dash", "ä", "a\n"])
def test_a_name_that_cannot_be_written_in_a_preset_is_refused(name: str):
    with pytest.raises(SettingsError, match="lower-case letters, digits and underscores, got"):
        Variable(name, 100, 200)


@pytest.mark.parametrize(("low", "high"), [(-1, 10), (10, 9), (0, 22_051), (float("nan"), 10), (0, float("inf"))])
def test_an_impossible_range_is_refused(low: float, high: float):
    with pytest.raises(SettingsError, match=r"must range within 0\.\.22050 Hz .* got"):
        Variable("mine", low, high)


@pytest.mark.parametrize("name", BUILT_IN_NAMES)
def test_a_built_in_name_is_taken(name: str):
    with pytest.raises(SettingsError, match=f"{name} exists already"):
        check_user_variables((Variable(name, 0, 1),))


def test_a_name_stands_only_once():
    with pytest.raises(SettingsError, match="mine exists already"):
        Preset(variables=(Variable("mine", 0, 1), Variable("mine", 2, 3)))
