"""Whisper's mel bands from the windows of the analysis, against those of its own preparation at 16 kHz."""

import numpy as np
import pytest

from phonemeengine.audio.resampling import resample_whole
from phonemeengine.dsp.framing import Framer
from phonemeengine.encoder.whisper import ENCODER_RATE, log_mel_spectrogram, whisper_log_mels
from phonemeengine.settings import SAMPLE_RATE


def windows_of(samples):
    framer = Framer()
    return np.concatenate([framer.cut_frames(samples), framer.finish()])


@pytest.fixture(scope="module")
def sound():
    generator = np.random.default_rng(1)
    times = np.arange(SAMPLE_RATE) / SAMPLE_RATE
    glide = np.sin(2 * np.pi * (300 * times + 1500 * times**2))
    noise = resample_whole(generator.standard_normal(ENCODER_RATE).astype(np.float32), ENCODER_RATE, SAMPLE_RATE)
    return (0.3 * glide + 0.05 * noise[: len(times)]).astype(np.float32)


def test_they_equal_those_of_the_resampled_sound(sound):
    theirs = 4 * log_mel_spectrogram(resample_whole(sound, SAMPLE_RATE, ENCODER_RATE)).T - 4
    ours = whisper_log_mels(windows_of(sound))
    inner = slice(5, 95)  # the ends are reflected there and silent here
    # the resampler takes the last few bands away
    assert np.abs(ours[inner, :75] - theirs[inner, :75]).max() < 0.1


def test_silence_has_the_least_power():
    np.testing.assert_allclose(whisper_log_mels(np.zeros((3, 2048), np.float32)), -10, rtol=1e-6)  # as libm rounds


def test_a_warp_moves_a_tone_to_a_higher_band():
    times = np.arange(SAMPLE_RATE // 2) / SAMPLE_RATE
    low, high = (np.sin(2 * np.pi * f * times).astype(np.float32) for f in (1000, 1200))
    warped = whisper_log_mels(windows_of(high), 1.2)[20].argmax()
    assert warped == whisper_log_mels(windows_of(low))[20].argmax()
