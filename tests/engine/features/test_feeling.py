"""How a voice sounds, estimated from voices whose manner is known because it was made."""

import numpy as np
import pytest

from phonemeengine.dsp.framing import Framer
from phonemeengine.features.feeling import FeelingEstimator, FeltFrames
from phonemeengine.settings import SAMPLE_RATE

SECONDS = 7.0
NEUTRAL = {"f0": 120.0, "swing": 2.0, "rate": 4.0, "level": 0.05, "slope": 1.5}
EXCITED = {"f0": 180.0, "swing": 5.0, "rate": 6.0, "level": 0.15, "slope": 0.8}
CALM = {"f0": 100.0, "swing": 0.5, "rate": 2.5, "level": 0.025, "slope": 2.0}


def voice(f0: float, swing: float, rate: float, level: float, slope: float) -> np.ndarray:
    """Return a pulse train with syllables: its harmonics fall with their number to the power of the slope."""
    t = np.arange(int(SECONDS * SAMPLE_RATE)) / SAMPLE_RATE
    phase = 2 * np.pi * np.cumsum(f0 * 2 ** (swing / 12 * np.sin(2 * np.pi * 0.6 * t))) / SAMPLE_RATE
    tone = sum(np.sin(k * phase) / k**slope for k in range(1, 16))
    syllables = 0.55 + 0.45 * np.sin(2 * np.pi * rate * t)
    sound = tone * syllables
    return (level * sound / np.sqrt(np.mean(sound**2))).astype(np.float32)


@pytest.fixture(scope="module")
def windows() -> np.ndarray:
    """A neutral voice, and then the same one excited."""
    return windows_of(voice(**NEUTRAL), voice(**EXCITED))


def windows_of(*parts: np.ndarray) -> np.ndarray:
    framer = Framer()
    return np.concatenate([framer.cut_frames(np.concatenate(parts)), framer.finish()])


def felt(windows: np.ndarray, cut: int = 512) -> FeltFrames:
    estimator = FeelingEstimator()
    return np.concatenate([estimator.follow(windows[k : k + cut]) for k in range(0, len(windows), cut)])


def test_excited_speech_is_more_active_than_usual_and_calm_speech_less(windows):
    half = len(windows) // 2
    excited, relaxed = felt(windows), felt(windows_of(voice(**NEUTRAL), voice(**CALM)))
    assert abs(excited[half - 200 : half, 0].mean()) < 0.15
    assert excited[half + 150 : half + 400, 0].mean() > 0.4
    assert relaxed[half + 150 : half + 400, 0].mean() < -0.3


def test_it_neither_depends_on_the_level_of_a_recording_nor_on_how_it_is_cut(windows):
    known = felt(windows)
    for gain in (0.1, 3.0):
        assert np.abs(felt(windows * np.float32(gain)) - known).max() < 0.05
    assert np.allclose(felt(windows[:300], 7), known[:300], atol=1e-4)


def test_it_is_uncertain_at_first_and_again_after_a_silence():
    found = felt(
        windows_of(np.zeros(SAMPLE_RATE, np.float32), voice(**NEUTRAL), np.zeros(5 * SAMPLE_RATE, np.float32))
    )
    assert found[50].tolist() == [0, 1, 0, 1]
    assert found[790, 1] < 0.4
    assert found[150, 1] > 0.8
    assert found[-1, 1] > 0.9
    assert (found[:, 3] >= found[:, 1]).all()  # pleasantness is the weaker guess
    noise = np.random.default_rng(1).normal(0, 0.05, 3 * SAMPLE_RATE).astype(np.float32)  # a whisper has no pitch
    assert felt(windows_of(noise))[-1, 1] > 0.9
