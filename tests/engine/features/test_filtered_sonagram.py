"""The sonagram after the filters is what the analysis has as spectra."""

import numpy as np
import pytest

from phonemeengine.analyser import analyse_blocks, concatenate_analyses
from phonemeengine.dsp.sonagram import FLOOR, SonagramSettings
from phonemeengine.features.front_end import filtered_sonagram_of
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, HOP, AnalysisSettings, Filter
from tests.sounds import noise, tone

ON_BINS = SonagramSettings(high=200 * BIN_WIDTH, n_rows=201)
NOTHING = AnalysisSettings(filters=frozenset())
ALL = AnalysisSettings().with_filter(Filter.LOW_PASS, on=True)


@pytest.mark.parametrize("settings", [NOTHING, ALL])
def test_a_column_a_frame_is_the_spectrum_of_the_frame(settings: AnalysisSettings) -> None:
    sound = noise(1.0, 0.3)
    found = filtered_sonagram_of(sound, settings, ON_BINS, 0, 100, HOP)
    spectra = concatenate_analyses(list(analyse_blocks([sound], Preset(settings=settings)))).linear_spectra
    expected = np.maximum(20 * np.log10(np.maximum(spectra[:, :201], 1e-15)), FLOOR)
    np.testing.assert_allclose(found, expected, atol=0.01)


def test_wide_columns_are_means_and_narrow_ones_repeat() -> None:
    sound = noise(1.0, 0.3)
    frames = filtered_sonagram_of(sound, NOTHING, ON_BINS, 0, 100, HOP)
    wide = filtered_sonagram_of(sound, NOTHING, ON_BINS, 0, 10, 10 * HOP)
    np.testing.assert_allclose(wide, 10 * np.log10((10 ** (frames / 10)).reshape(10, 10, -1).mean(axis=1)), atol=0.01)
    narrow = filtered_sonagram_of(sound, NOTHING, ON_BINS, 5 * HOP, 20, HOP / 4)
    np.testing.assert_allclose(narrow, np.repeat(frames[5:10], 4, axis=0), atol=1e-4)


def test_a_filter_is_seen() -> None:
    sound = tone(5000, 0.5, 0.5)
    layout = SonagramSettings()
    settings = AnalysisSettings(filters=frozenset({Filter.LOW_PASS}), low_pass_start=1000, low_pass_end=1500)
    loud, gone = (filtered_sonagram_of(sound, s, layout, 0, 10, 5 * HOP).max() for s in (NOTHING, settings))
    assert loud > -12
    assert gone < loud - 40


def test_beyond_the_sound_nothing_is_heard() -> None:
    found = filtered_sonagram_of(tone(500, 0.1, 0.5), NOTHING, SonagramSettings(), 0, 20, HOP)
    assert (found[:10].max(axis=1) > -20).all()
    assert (found[10:] == FLOOR).all()
    assert (filtered_sonagram_of(np.zeros(0, np.float32), NOTHING, SonagramSettings(), 0, 3, HOP) == FLOOR).all()
