"""Sensitivities: log-odds that make a phoneme likelier than it was measured to be."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.errors import PresetError, SettingsError
from phonemeengine.features.variables import SCORES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.scores import Sensitivity
from tests.sounds import silence, vowel

SOUND = np.concatenate([silence(0.2), vowel((750.0, 1250.0, 2500.0), 0.6), silence(0.2)])


def analysed(preset: Preset) -> Analysis:
    return Analyser(replace(preset, settings=replace(preset.settings, look_ahead=0.0))).push(SOUND)


def columns(analysis: Analysis) -> np.ndarray:
    return np.stack([analysis.features[name] for name in SCORES], axis=1)


def test_a_sensitivity_of_one_makes_a_phoneme_e_times_likelier_beside_any_other():
    even = np.full((3, len(Phoneme)), 1 / len(Phoneme), np.float32)
    weighed = Sensitivity({Phoneme.A: 1.0}).apply(even)
    np.testing.assert_allclose(weighed[:, Phoneme.A] / weighed[:, Phoneme.I], np.e, rtol=1e-5)
    np.testing.assert_allclose(weighed.sum(axis=1), 1, rtol=1e-5)


@pytest.mark.parametrize("name", ["learned.toml", "templates.toml"])
def test_the_probabilities_of_a_preset_are_weighed_and_the_likeliest_is_named(name: str):
    preset = load_preset(FACTORY / name)
    plain = columns(analysed(preset))
    tuned = analysed(replace(preset, sensitivities={Phoneme.M: 6.0, Phoneme.SILENCE: -2.0}))
    factors = np.exp([{Phoneme.M: 6.0, Phoneme.SILENCE: -2.0}.get(p, 0.0) for p in Phoneme])
    expected = plain * factors / (plain * factors).sum(axis=1, keepdims=True)
    np.testing.assert_allclose(columns(tuned), expected, atol=2e-6)
    np.testing.assert_array_equal(tuned.recognised, columns(tuned).argmax(axis=1))
    assert np.count_nonzero(tuned.recognised == Phoneme.M) > np.count_nonzero(plain.argmax(axis=1) == Phoneme.M)


def test_an_edit_while_a_sound_goes_on_acts_from_the_next_frame():
    preset = load_preset(FACTORY / "templates.toml")
    analyser = Analyser(preset)
    analyser.push(SOUND)
    analyser.set_preset(replace(preset, sensitivities={Phoneme.SILENCE: 10.0}))
    assert (analyser.push(SOUND[:4410]).recognised == Phoneme.SILENCE).all()


def test_a_preset_file_keeps_sensitivities(tmp_path):
    preset = replace(load_preset(FACTORY / "templates.toml"), sensitivities={Phoneme.A: 0.75, Phoneme.SILENCE: -1.5})
    assert preset_from_toml(preset_to_toml(preset), tmp_path) == preset


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("oe = 1.0", r"\[sensitivities\]: there is no phoneme 'oe'; did you mean"),
        ("a = true", "a must be a number .* found True"),
        ("a = nan", "a must be a number within"),
        ("a = 11", "the sensitivity for a must lie within ±10, got 11"),
    ],
)
def test_a_wrong_sensitivity_is_named(line: str, words: str, tmp_path):
    text = preset_to_toml(load_preset(FACTORY / "templates.toml")) + f"\n[sensitivities]\n{line}\n"
    with pytest.raises(PresetError, match=words):
        preset_from_toml(text, tmp_path)


def test_the_api_refuses_an_impossible_sensitivity():
    with pytest.raises(SettingsError, match="within ±10, got inf"):
        Preset(sensitivities={Phoneme.A: float("inf")})
