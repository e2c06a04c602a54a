"""A variable divided by another says how much stronger one range is, however loud the sound."""

from pathlib import Path

import numpy as np
import pytest

from phonemeengine.analyser import Analyser
from phonemeengine.errors import SettingsError
from phonemeengine.features.variables import Kind, Spectrum, Variable, check_user_variables
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import BIN_WIDTH, AnalysisSettings
from tests.sounds import Sound, noise, silence, tone

LOW, HIGH = 46 * BIN_WIDTH, 140 * BIN_WIDTH
PLAIN = AnalysisSettings(filters=frozenset())
BELOW = Variable("below", LOW - 5, LOW + 5, Kind.MAX, Spectrum.RAW)
ABOVE = Variable("above", HIGH - 5, HIGH + 5, Kind.MAX, Spectrum.RAW, per="below")


def above_per_below(sound: Sound) -> Sound:
    features = Analyser(Preset(settings=PLAIN, variables=(ABOVE, BELOW))).push(sound).features
    return features["above"]


@pytest.mark.parametrize("loudness", [1.0, 0.01])
def test_a_third_of_a_tones_strength_reads_a_third_however_loud(loudness: float):
    sound = tone(LOW, 0.3, 0.6 * loudness) + tone(HIGH, 0.3, 0.2 * loudness)
    assert above_per_below(sound)[5:20] == pytest.approx(1 / 3, rel=0.01)


def test_silence_per_silence_is_nothing():
    assert not above_per_below(silence(0.2)).any()


def test_one_frame_at_a_time_measures_the_same():
    sound = noise(0.3)
    analyser = Analyser(Preset(settings=PLAIN, variables=(ABOVE, BELOW)))
    pieces = [analyser.push(part).features["above"] for part in np.array_split(sound, 41)]
    np.testing.assert_allclose(np.concatenate(pieces), above_per_below(sound), rtol=1e-4)


@pytest.mark.parametrize("divisor", ["nobody", "above"])
def test_a_divisor_must_be_measured_and_stand_by_itself(divisor: str):
    with pytest.raises(
        SettingsError, match=rf"is divided by '{divisor}', which is not measured or is divided itself"
    ):
        check_user_variables((BELOW, ABOVE, Variable("mine", 100, 200, per=divisor)))


def test_a_built_in_variable_may_divide():
    check_user_variables((Variable("mine", 100, 200, per="energy_n"),))


def test_a_preset_file_keeps_the_divisor_and_says_none_where_there_is_none():
    text = preset_to_toml(Preset(variables=(BELOW, ABOVE)))
    assert text.count("per = ") == 1
    assert preset_from_toml(text, Path()).variables == (BELOW, ABOVE)
