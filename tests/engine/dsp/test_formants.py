"""Formants against Praat, against physics, and where there are none."""

import numpy as np
import parselmouth
import pytest

from phonemeengine.calibration.scores.corpus import read_corpus
from phonemeengine.dsp.formants import N_FORMANTS, formants_of, linear_prediction
from phonemeengine.errors import SettingsError
from phonemeengine.labels.utterance import CORE
from phonemeengine.phonemes import VOWELS
from phonemeengine.settings import SAMPLE_RATE
from tests.conftest import CORPUS
from tests.sounds import noise, silence, vowel


def test_in_vowels_of_people_and_voices_they_are_those_of_praat():
    errors, ceiling = [], 5000.0
    for utterance in read_corpus(CORPUS)[::7]:
        with utterance.opened() as reader:
            sound = reader.read_mono()
        ours = formants_of(sound, ceiling=ceiling).frequencies
        praat = parselmouth.Sound(sound.astype(float), SAMPLE_RATE).to_formant_burg(0.01, 5, ceiling, 0.025, 50)
        times = (np.arange(len(ours)) + 0.5) / 100
        for label in utterance.labels:
            if label.phoneme in VOWELS and label.certainty == CORE:
                for k in np.flatnonzero((times > label.start + 0.02) & (times < label.end - 0.02)):
                    theirs = [praat.get_value_at_time(n, times[k]) for n in (1, 2, 3)]
                    errors.append(np.abs(ours[k, :3] - theirs) / theirs)
    assert len(errors) > 500
    assert (np.nanmedian(errors, axis=0) < 0.01).all()
    assert (np.nanmean(np.array(errors) < 0.05, axis=0) > 0.85).all()


@pytest.mark.parametrize("formants", [(700.0, 1200.0, 2500.0), (300.0, 2300.0, 3000.0), (310.0, 900.0, 2300.0)])
def test_a_made_up_vowel_has_the_formants_it_was_made_of(formants: tuple[float, ...]):
    found = np.median(formants_of(vowel(formants, 0.5, f0=100)).frequencies[10:40], axis=0)
    for formant in formants:
        assert np.abs(found - formant).min() < 50  # half of what lies between two harmonics


def test_a_part_is_the_part_of_the_whole_and_frames_are_of_10_ms():
    sound = vowel((700.0, 1200.0, 2500.0), 12.0, f0=120) + noise(12.0, 0.001)
    whole = formants_of(sound)
    assert whole.frequencies.shape == whole.bandwidths.shape == (1200, N_FORMANTS)
    part = formants_of(sound, first_frame=995, n_frames=10)
    np.testing.assert_array_equal(part.frequencies, whole.frequencies[995:1005])
    assert formants_of(sound, first_frame=1300).frequencies.shape == (0, N_FORMANTS)


def test_frequencies_rise_bandwidths_are_positive_and_both_are_missing_together():
    frequencies, bandwidths = formants_of(noise(1.0, 0.1))
    assert (np.diff(frequencies, axis=1)[~np.isnan(np.diff(frequencies, axis=1))] > 0).all()
    assert (bandwidths[~np.isnan(bandwidths)] > 0).all()
    assert (np.isnan(frequencies) == np.isnan(bandwidths)).all()


def test_silence_has_none_and_an_empty_sound_no_frames():
    assert np.isnan(formants_of(silence(0.2)).frequencies).all()
    assert len(formants_of(silence(0.0)).frequencies) == 0


@pytest.mark.parametrize("ceiling", [2999.0, 10_001.0, float("nan")])
def test_a_ceiling_that_no_voice_has_is_refused(ceiling: float):
    with pytest.raises(SettingsError, match=r"the ceiling must lie in 3000\.\.10000 Hz"):
        formants_of(silence(0.1), ceiling=ceiling)


def test_the_filter_predicts_what_it_was_made_by():
    generator = np.random.default_rng(1)
    true = np.array([1.0, -1.2, 0.8])
    sound = np.zeros(4000)
    for k in range(2, len(sound)):
        sound[k] = -true[1:] @ sound[k - 2 : k][::-1] + generator.normal()
    assert linear_prediction(sound[np.newaxis], 2)[0] == pytest.approx(true, abs=0.03)
    assert linear_prediction(np.zeros((1, 100)), 2).tolist() == [[1, 0, 0]]
