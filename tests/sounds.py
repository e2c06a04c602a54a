"""Sounds whose analysis is known beforehand: float32, mono, 44.1 kHz."""

import numpy as np
from numpy.typing import NDArray

from phonemeengine.settings import SAMPLE_RATE

Sound = NDArray[np.float32]


def tone(frequency: float, seconds: float, amplitude: float = 1.0) -> Sound:
    """A sine that begins at phase 0."""
    time = np.arange(round(seconds * SAMPLE_RATE)) / SAMPLE_RATE
    return (amplitude * np.sin(2 * np.pi * frequency * time)).astype(np.float32)


def silence(seconds: float) -> Sound:
    """Digital silence."""
    return np.zeros(round(seconds * SAMPLE_RATE), np.float32)


def noise(seconds: float, amplitude: float = 0.1, seed: int = 0) -> Sound:
    """White noise with a standard deviation of `amplitude`."""
    generator = np.random.default_rng(seed)
    return (amplitude * generator.standard_normal(round(seconds * SAMPLE_RATE))).astype(np.float32)


def vowel(formants: tuple[float, ...], seconds: float, f0: float = 120.0, amplitude: float = 0.5) -> Sound:
    """A pulse train through two-pole resonators at the formants (80 Hz wide), as a synthetic vowel."""
    n = round(seconds * SAMPLE_RATE)
    frequencies = np.fft.rfftfreq(n, 1 / SAMPLE_RATE)
    pulses = np.zeros(n)
    pulses[np.arange(0, n, SAMPLE_RATE / f0).astype(int) % n] = 1
    spectrum = np.fft.rfft(pulses)
    for formant in formants:
        spectrum /= (formant**2 - frequencies**2 + 1j * frequencies * 80) / formant**2
    wave = np.fft.irfft(spectrum, n)
    return (amplitude * wave / np.abs(wave).max()).astype(np.float32)
