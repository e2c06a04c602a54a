"""What two seconds of silence say about a room: noise of a known level gives known amplitudes."""

from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.analyser import Analyser
from phonemeengine.calibration.takes.room_noise import MARGIN, SHARE, measure_room
from phonemeengine.errors import TakeError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import FACTORY, load_preset
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import AnalysisSettings, Decimation, Filter
from tests.sounds import noise, silence, tone, vowel

ROOM = 0.001
PLAIN = Preset(settings=AnalysisSettings(filters=frozenset({Filter.QUANTISE, Filter.DENOISE, Filter.NORMALISE})))
THESIS = load_preset(FACTORY / "thesis.toml")


def test_the_amplitudes_of_white_noise_are_those_of_rayleigh():
    # of n samples of noise with standard deviation s, a bin has the amplitude 2 |X| / n, Rayleigh with s sqrt(2 / n)
    room = measure_room(noise(4.0, ROOM), PLAIN)
    n, n_bins = PLAIN.settings.n_samples, PLAIN.settings.n_bins
    scale = ROOM * (2 / n) ** 0.5
    highest = scale * (-2 * np.log(1 - SHARE ** (1 / n_bins))) ** 0.5
    assert room.bounds["silence_max_energy"].value / MARGIN == pytest.approx(highest, rel=0.15)
    assert room.bounds["denoise_threshold"] == room.bounds["silence_max_energy"]
    mean, deviation = scale * (np.pi / 2) ** 0.5, scale * (2 - np.pi / 2) ** 0.5
    energy = n_bins * mean + 2.33 * n_bins**0.5 * deviation
    assert room.bounds["silence_energy"].value / MARGIN == pytest.approx(energy, rel=0.05)
    assert room.bounds["silence_zero_crossings"].value / MARGIN == pytest.approx(1023.5 + 2.33 * 22.6, rel=0.03)
    assert room.level == pytest.approx(ROOM, rel=0.01)


def test_thresholds_grow_with_the_room():
    soft, loud = (measure_room(noise(2.0, level), THESIS).bounds for level in (ROOM, 10 * ROOM))
    for name in ("denoise_threshold", "silence_energy", "silence_max_energy"):
        assert loud[name].value == pytest.approx(10 * soft[name].value, rel=1e-3)
    assert loud["silence_zero_crossings"] == soft["silence_zero_crossings"]


@pytest.mark.parametrize("decimation", list(Decimation))
@pytest.mark.parametrize("name", ["thesis.toml", "thesis-anti-aliased.toml"])
def test_the_room_is_silence_afterwards_and_a_voice_is_not(name, decimation):
    preset = load_preset(FACTORY / name)
    preset = replace(preset, settings=replace(preset.settings, decimation=decimation))
    room = measure_room(noise(2.0, 0.003, seed=1), preset)
    fitted = room.set_silence(preset)
    another = Analyser(fitted).push(noise(3.0, 0.003, seed=2)).phonemes[5:]
    assert np.mean(another == Phoneme.SILENCE) > 0.95
    voice = vowel((750, 1250), 1.0) + noise(1.0, 0.003, seed=3)
    assert np.mean(Analyser(fitted).push(voice).phonemes[5:] == Phoneme.SILENCE) == 0
    sure = room.silence_accuracy(fitted, voice)
    assert sure.room_silent.value > 0.95
    assert sure.room_silent.low < sure.room_silent.value <= sure.room_silent.high
    assert sure.speech_silent.value == 0
    assert room.silence_accuracy(fitted).speech_silent is None


def test_without_denoising_the_room_is_silence_too():
    settings = replace(THESIS.settings, filters=THESIS.settings.filters - {Filter.DENOISE})
    preset = replace(THESIS, settings=settings)
    room = measure_room(noise(2.0, ROOM), preset)
    assert room.silence_accuracy(room.set_silence(preset)).room_silent.value > 0.95


def test_only_the_thresholds_of_silence_change():
    fitted = measure_room(noise(2.0, ROOM), THESIS).set_silence(THESIS)
    assert fitted.settings == THESIS.settings.with_numbers(denoise_threshold=fitted.settings.denoise_threshold)
    for name, value in vars(THESIS.thresholds).items():
        assert name.startswith("silence") or getattr(fitted.thresholds, name) == value, name


def test_bounds_hold_the_value_and_narrow_with_more_silence():
    short, long = (measure_room(noise(seconds, ROOM), THESIS) for seconds in (1.0, 16.0))
    for name in ("denoise_threshold", "silence_energy", "silence_max_energy"):
        for room in (short, long):
            assert room.bounds[name].low <= room.bounds[name].value <= room.bounds[name].high
    spreads = [room.bounds["silence_energy"].high - room.bounds["silence_energy"].low for room in (short, long)]
    assert spreads[1] < 0.7 * spreads[0]


def test_bounds_hold_what_a_long_silence_gives():
    truth = measure_room(noise(60.0, ROOM, seed=99), THESIS).bounds
    rooms = [measure_room(noise(2.0, ROOM, seed), THESIS).bounds for seed in range(20)]
    for name in ("denoise_threshold", "silence_energy", "silence_zero_crossings"):
        assert np.mean([room[name].low <= truth[name].value <= room[name].high for room in rooms]) >= 0.8, name


def test_a_measurement_gives_the_same_each_time():
    sound = noise(2.0, ROOM)
    assert measure_room(sound, THESIS).bounds == measure_room(sound, THESIS).bounds


def test_a_room_that_hums_keeps_the_usual_limit_of_zero_crossings():
    room = measure_room(tone(50, 2.0, 0.003), THESIS)
    assert room.bounds["silence_zero_crossings"].value == 220
    assert room.silence_accuracy(room.set_silence(THESIS)).room_silent.value > 0.98


def test_a_microphone_that_delivers_nothing_is_told_and_still_gives_silence():
    room = measure_room(silence(2.0), THESIS)
    assert "digital silence" in room.notes[0]
    assert room.level == 0
    assert all(bound.value > 0 for bound in room.bounds.values())
    assert room.silence_accuracy(room.set_silence(THESIS)).room_silent.value == 1


def test_a_cough_in_the_silence_is_told():
    assert measure_room(noise(2.0, ROOM), THESIS).notes == ()
    sound = noise(2.0, ROOM)
    sound[44_100:48_510] += noise(0.1, 0.05)
    (note,) = measure_room(sound, THESIS).notes
    assert "34 dB above the background noise" in note


def test_a_roaring_room_gives_thresholds_that_a_preset_takes():
    room = measure_room(np.clip(noise(2.0, 1.0), -1, 1), THESIS)
    assert room.set_silence(THESIS).settings.denoise_threshold <= 1


@pytest.mark.parametrize("name", ["thesis", "extended", "learned", "templates"])
@pytest.mark.parametrize("level", [0.0005, 0.02])
def test_whatever_recognises_the_room_is_silence_and_what_was_said_is_not_lost(name, level):
    preset = load_preset(FACTORY / f"{name}.toml")
    room = measure_room(noise(2.0, level, seed=1), preset)
    voice = vowel((750, 1250), 1.0) + noise(1.0, level, seed=3)
    lost = room.silence_accuracy(preset, voice).speech_silent.value
    fitted = room.set_silence(preset, voice)
    sure = room.silence_accuracy(fitted, voice)
    assert sure.room_silent.value > 0.98
    assert sure.speech_silent.value <= lost + 0.02
    assert fitted.settings.denoise_threshold == room.bounds["denoise_threshold"].value
    assert room.set_silence(fitted, voice) == fitted  # measured twice is measured once


def test_a_louder_room_makes_silence_likelier_for_the_learned_and_its_level_higher_for_templates():
    learned, templates = (load_preset(FACTORY / f"{name}.toml") for name in ("learned", "templates"))
    hiss = [
        np.convolve(noise(2.0, level, seed=1), np.ones(6) / 6, "same").astype(np.float32) for level in (1e-4, 0.03)
    ]
    soft, loud = (measure_room(sound, learned).set_silence(learned) for sound in hiss)
    assert soft.sensitivities[Phoneme.SILENCE] <= loud.sensitivities[Phoneme.SILENCE]
    soft, loud = (measure_room(sound, templates).set_silence(templates).templates.silence_below for sound in hiss)
    assert soft == templates.templates.silence_below < loud


def test_a_room_as_loud_as_speech_does_not_swallow_the_takes():
    preset = load_preset(FACTORY / "templates.toml")
    voice = vowel((750, 1250), 1.0, amplitude=0.1)
    room = measure_room(noise(2.0, 0.1), preset)
    bold, careful = room.set_silence(preset), room.set_silence(preset, voice)
    assert room.silence_accuracy(bold, voice).speech_silent.value == 1
    assert room.silence_accuracy(careful, voice).speech_silent.value < 0.05


def test_a_room_that_is_as_loud_as_a_voice_is_told():
    (note,) = measure_room(vowel((750, 1250), 2.0), THESIS).notes
    assert note.startswith("The background noise was as loud as a voice (-")


@pytest.mark.parametrize(
    ("samples", "message"),
    [
        (noise(0.9), "measured for 1 s or more, got 0.90 s"),
        (np.zeros(0, np.float32), "got 0.00 s"),
        (np.full(88_200, np.nan, np.float32), "NaN or infinity"),
    ],
)
def test_too_little_silence_is_refused(samples, message):
    with pytest.raises(TakeError, match=message):
        measure_room(samples, THESIS)
