"""The presets that ship with the program: what each tick does, and that twins are twins."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.analyser import Analyser
from phonemeengine.errors import PresetError
from phonemeengine.presets.files import (
    FACTORY,
    FACTORY_PRESETS,
    beyond_phoneme_data,
    factory_preset,
    load_preset,
    own_presets,
    save_preset,
)
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.spec import BUILT_IN
from phonemeengine.settings import AnalysisSettings, Filter
from phonemeengine.storage.paths import presets_folder
from tests.sounds import noise, vowel

SOUND = (vowel((750.0, 1250.0, 2500.0), 0.5) + noise(0.5, 0.02, seed=1)).astype(np.float32)
SUCCESSORS = "the table of successors"
ALL = [*FACTORY_PRESETS, FACTORY / "thesis.phonemedata"]


def test_all_factory_presets_are_listed():
    assert {path.name for path in FACTORY_PRESETS} == {path.name for path in FACTORY.glob("*.toml")}
    assert {spec.factory_preset for spec in BUILT_IN.values()} <= {path.name for path in FACTORY_PRESETS}


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.name)
def test_every_ticked_filter_of_a_factory_preset_acts(path: Path):
    preset = load_preset(path)
    spectra = Analyser(preset).push(SOUND).spectra
    for step in preset.settings.filters:
        without = replace(preset, settings=preset.settings.with_filter(step, False))
        other = Analyser(without).push(SOUND).spectra
        assert other.shape != spectra.shape or not np.allclose(other, spectra), step


@pytest.mark.parametrize("step", Filter)
def test_a_filter_that_is_switched_on_acts(step: Filter):
    off = AnalysisSettings(filters=frozenset())
    before, after = (Analyser(Preset(settings=s)).push(SOUND) for s in (off, off.with_filter(step, True)))
    assert (
        before.spectra.shape != after.spectra.shape
        or not np.allclose(before.spectra, after.spectra)
        or after.mel is not None
    )


def test_a_strength_above_0_switches_its_filter_on_and_0_switches_it_off():
    blurred = AnalysisSettings().with_numbers(time_smooth=0.4)
    assert blurred.has(Filter.TIME_SMOOTH)
    assert not blurred.with_numbers(time_smooth=0.0).has(Filter.TIME_SMOOTH)
    passed = replace(AnalysisSettings(), filters=frozenset()).with_numbers(high_pass_end=300.0, time_smooth=0.0)
    assert passed.filters == frozenset()


@pytest.mark.parametrize("path", FACTORY_PRESETS, ids=lambda path: path.stem)
def test_a_factory_preset_says_in_one_line_what_it_is(path: Path):
    summary = load_preset(path).summary
    assert 30 < len(summary) < 110
    assert summary.endswith(".")


def test_thesis_toml_and_thesis_phonemedata_are_twins():
    thesis, twin = load_preset(FACTORY / "thesis.toml"), load_preset(FACTORY / "thesis.phonemedata")
    assert replace(thesis, name=twin.name, notes="", confidences={}) == twin
    assert thesis.settings.hysteresis == 0
    assert thesis.settings.statistics


def test_the_calm_variant_is_the_thesis_with_hysteresis():
    thesis, calm = load_preset(FACTORY / "thesis.toml"), load_preset(FACTORY / "thesis-calm.toml")
    settings = replace(thesis.settings, hysteresis=calm.settings.hysteresis)
    expected = replace(thesis, settings=settings, name=calm.name, notes=calm.notes, confidences=calm.confidences)
    assert expected == calm
    assert calm.settings.hysteresis > 0


def test_phoneme_data_means_one_thing(tmp_path):
    path = tmp_path / "mine.phonemedata"
    for preset in (load_preset(FACTORY / "extended.toml"), load_preset(FACTORY / "thesis.toml")):
        save_preset(preset, path)
        expected = Preset(name="mine").with_phoneme_data(preset.phoneme_data)
        assert load_preset(path) == expected
        assert expected.recogniser == "thesis"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("thesis", {"notes"}),
        ("thesis-calm", {"hold and hysteresis", "notes"}),
        ("thesis-anti-aliased", {"filters other than the thesis's", "hold and hysteresis", SUCCESSORS, "notes"}),
        ("templates", {"the recogniser templates", "hold and hysteresis", "templates", SUCCESSORS, "notes"}),
    ],
)
def test_it_is_said_what_a_phoneme_data_file_cannot_hold(name: str, words: set[str]):
    assert set(beyond_phoneme_data(load_preset(name))) == words


def test_what_a_phoneme_data_file_holds_is_nothing_beyond_it():
    assert beyond_phoneme_data(load_preset(FACTORY / "thesis.phonemedata")) == ()


def test_a_preset_can_be_given_by_path_text_or_name(home):
    presets_folder().mkdir(parents=True)
    save_preset(Preset(name="anna"), presets_folder() / "anna.toml")
    assert (
        load_preset("learned") == load_preset(str(FACTORY / "learned.toml")) == load_preset(FACTORY / "learned.toml")
    )
    assert load_preset("anna").name == "anna"
    assert own_presets() == (presets_folder() / "anna.toml",)
    with pytest.raises(PresetError, match=r"nobody: there is no such preset; name a file, or one of .*learned"):
        load_preset("nobody")


def test_every_recogniser_of_the_program_has_a_factory_preset():
    for name in BUILT_IN:
        preset = factory_preset(name)
        assert preset is not None
        assert preset.recogniser == name
