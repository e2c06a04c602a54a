"""A sound that is recognised anew without being heard: as if it had been."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine import ModelKind, SoundReader, load_preset
from phonemeengine.inspection.whole_sound import RetunedSound, SoundTracks, analyse_whole, tracks_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import Filter
from tests.conftest import ROOT

CARDS = ROOT / "tests" / "data" / "cards.flac"


def analysed(preset: Preset) -> SoundTracks:
    with SoundReader(CARDS) as reader:
        tracks = tracks_of(reader)
    analyse_whole(lambda: SoundReader(CARDS), preset, tracks)
    return tracks


def changed(preset: Preset, what: str) -> Preset:
    settings = preset.settings
    if what == "threshold":
        return replace(preset, thresholds=replace(preset.thresholds, silence_energy=0.4, o_o1=0.9))
    if what == "sensitivity":
        return replace(preset, sensitivities={Phoneme.A: 1.5, Phoneme.SILENCE: -1.0})
    if what == "calm":
        return replace(preset, settings=replace(settings, statistics=True, minimum_hold=0.06, hysteresis=0.3))
    return replace(preset, settings=replace(settings, statistics=False, intensity_low=-30.0))


@pytest.mark.parametrize("name", ["thesis", "extended", "learned"])
@pytest.mark.parametrize("what", ["threshold", "sensitivity", "calm", "bare"])
def test_it_says_what_the_analysis_says(name: str, what: str) -> None:
    preset = load_preset(name)
    other = changed(preset, what)
    tracks, expected = analysed(preset), analysed(other)
    sound = RetunedSound(tracks, preset)
    if not sound.retune(other):
        assert (name, what) == ("learned", "threshold")  # the preset's recogniser does not compare with those
        return
    for part in ("recognised", "phonemes"):
        np.testing.assert_array_equal(getattr(tracks, part), getattr(expected, part), err_msg=part)
    np.testing.assert_allclose(tracks.confidences(), expected.confidences(), rtol=1e-3, atol=1e-4)
    np.testing.assert_array_equal(tracks.confidences(slice(40, 70)), tracks.confidences()[40:70])
    for part in ("intensities", "values"):
        np.testing.assert_allclose(getattr(tracks, part), getattr(expected, part), rtol=1e-3, atol=1e-4, err_msg=part)
    assert sound.retune(preset)
    np.testing.assert_array_equal(tracks.phonemes, analysed(preset).phonemes)


def test_another_front_end_recogniser_or_model_needs_the_sound() -> None:
    preset = load_preset("thesis")
    sound = RetunedSound(analysed(preset), preset)
    assert not sound.retune(replace(preset, settings=preset.settings.with_filter(Filter.MEL, on=True)))
    assert not sound.retune(load_preset("learned"))
    assert not sound.retune(replace(preset, file_model=ModelKind.OFFLINE))
