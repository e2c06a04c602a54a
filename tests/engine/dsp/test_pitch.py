"""The fundamental frequency: known sounds read their frequency, and Praat agrees."""

from pathlib import Path

import numpy as np
import parselmouth
import pytest
import soundfile

from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.pitch import fundamental_of
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE, WINDOW
from tests.sounds import Sound, noise, silence, tone, vowel

FREQUENCIES = (70, 97.3, 150, 261.6, 480)
VOWELS = {"a": (700.0, 1200.0, 2500.0), "i": (280.0, 2250.0, 2900.0), "u": (310.0, 800.0, 2300.0)}


def fundamental_in(sound: Sound) -> Sound:
    framer = Framer()
    return fundamental_of(np.concatenate([framer.cut_frames(sound), framer.finish()]))


def praat_in(sound: Sound, n_frames: int) -> Sound:
    """Ask Praat at the middle of each frame; 0 where it hears no voice."""
    praat = parselmouth.Sound(sound.astype(float), SAMPLE_RATE)
    pitch = praat.to_pitch_ac(time_step=FRAME_PERIOD, pitch_floor=60, pitch_ceiling=500)
    times = (np.arange(n_frames) + 0.5) * FRAME_PERIOD
    return np.nan_to_num([pitch.get_value_at_time(time) for time in times])


def pulses(frequency: float, seconds: float) -> Sound:
    wave = silence(seconds)
    wave[np.arange(0, len(wave), SAMPLE_RATE / frequency).astype(int)] = 0.9
    return wave


def agreement(sounds: list[Sound]) -> tuple[float, float, float]:
    """Give the median error, the share within 5 %, and the share of equal voicing, over all frames."""
    ours = [fundamental_in(sound) for sound in sounds]
    praat = np.concatenate([praat_in(s, len(f)) for s, f in zip(sounds, ours, strict=True)])
    found = np.concatenate(ours)
    both = (found > 0) & (praat > 0)
    errors = np.abs(found[both] / praat[both] - 1)
    return float(np.median(errors)), float(np.mean(errors < 0.05)), float(np.mean((found > 0) == (praat > 0)))


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_a_tone_has_its_own_frequency(frequency: float):
    found = fundamental_in(tone(frequency, 0.3, 0.5))[4:-4]
    np.testing.assert_allclose(found, frequency, rtol=0.005)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_a_pulse_train_has_the_frequency_of_its_pulses(frequency: float):
    found = fundamental_in(pulses(frequency, 0.3))[4:-4]
    np.testing.assert_allclose(found, frequency, rtol=0.005)


@pytest.mark.parametrize("frequency", FREQUENCIES)
@pytest.mark.parametrize("formants", VOWELS.values(), ids=VOWELS)
def test_a_vowel_has_the_frequency_of_its_voice(frequency: float, formants: tuple[float, ...]):
    found = fundamental_in(vowel(formants, 0.3, frequency))[4:-4]
    np.testing.assert_allclose(found, frequency, rtol=0.005)


@pytest.mark.parametrize("loudness", [0.005, 0.1, 1.0])
def test_loudness_does_not_change_the_frequency(loudness: float):
    found = fundamental_in(vowel(VOWELS["a"], 0.3, 150, loudness))[4:-4]
    np.testing.assert_allclose(found, 150, rtol=0.005)


def test_a_constant_offset_does_not_change_the_frequency():
    found = fundamental_in(tone(200, 0.3, 0.3) + np.float32(0.5))[4:-4]
    np.testing.assert_allclose(found, 200, rtol=0.005)


def test_noise_has_no_fundamental():
    assert np.mean(fundamental_in(noise(2, 0.1)) > 0) < 0.02


def test_silence_has_no_fundamental():
    assert not fundamental_in(silence(0.2)).any()


def test_what_is_hardly_there_has_no_fundamental():
    assert not fundamental_in(tone(200, 0.2, 0.0005)).any()


def sine_windows(frequency: float, loudness: float) -> Sound:
    """Give windows of a sine at twelve phases."""
    phases = np.arange(12)[:, np.newaxis] * (2 * np.pi / 12)
    return (loudness * np.sin(2 * np.pi * frequency * np.arange(WINDOW) / SAMPLE_RATE + phases)).astype(np.float32)


def each_alone(windows: Sound) -> Sound:
    return np.concatenate([fundamental_of(window[np.newaxis]) for window in windows])


@pytest.mark.parametrize("loudness", [0.05, 1.0])
def test_a_tone_beyond_the_range_of_voices_is_no_voice_at_any_phase(loudness: float):
    frequencies = [505, 517, 550, 600, 700, 750, 909, 1000, 1001, 1250, 1750, 1999, 2010, 2500, 3000, 4256, 5000]
    voiced = [f for f in frequencies if each_alone(sine_windows(f, loudness)).any()]
    assert voiced == []


@pytest.mark.parametrize("frequency", [60, 495, 500])
def test_a_tone_at_the_ends_of_the_range_has_its_own_frequency_at_any_phase(frequency: float):
    np.testing.assert_allclose(each_alone(sine_windows(frequency, 0.5)), frequency, rtol=0.005)


@pytest.mark.parametrize("frequency", [20, 57])
def test_a_hum_below_the_range_of_voices_is_no_voice(frequency: float):
    assert not each_alone(sine_windows(frequency, 0.5)).any()


@pytest.mark.parametrize("frequency", [100, 220])
def test_a_voice_in_some_noise_keeps_its_frequency(frequency: float):
    found = fundamental_in(vowel(VOWELS["a"], 1, frequency) + noise(1, 0.03))[4:-4]
    assert np.mean(np.abs(found / frequency - 1) < 0.02) > 0.95


def glide(low: float, high: float, seconds: float) -> Sound:
    """A buzz of ten harmonics that glides upwards."""
    time = np.arange(round(seconds * SAMPLE_RATE)) / SAMPLE_RATE
    phase = 2 * np.pi * (low * time + (high - low) * time**2 / (2 * seconds))
    return (0.1 * sum(np.sin(k * phase) / k for k in range(1, 11))).astype(np.float32)


def test_praat_agrees_on_synthetic_voices():
    pause = silence(0.3)
    sounds = [vowel(formants, 0.6, f0) for formants in VOWELS.values() for f0 in (85, 130, 210, 320)]
    sounds += [glide(90, 180, 1), glide(180, 350, 1), np.concatenate((pause, glide(120, 140, 0.5), pause))]
    sounds += [noise(0.5)]
    error, close, voicing = agreement(sounds)
    assert error < 0.001
    assert close > 0.99
    assert voicing > 0.93


@pytest.mark.parametrize(
    ("speaker", "apart", "close_enough", "equal_voicing"),
    [("slt", 0.002, 0.985, 0.93), ("kal", 0.002, 0.965, 0.89), ("nsh", 0.0025, 0.95, 0.89)],
)
def test_praat_agrees_on_recorded_voices(
    corpus: Path, speaker: str, apart: float, close_enough: float, equal_voicing: float
):
    paths = sorted((corpus / "festival" / speaker).glob("*.flac"))[:8]
    error, close, voicing = agreement([soundfile.read(path, dtype="float32")[0] for path in paths])
    assert error < apart
    assert close > close_enough
    assert voicing > equal_voicing
