"""Sounds under speech, made here: music, and the noises of a desk with keyboard, fan and mouse."""

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import SAMPLE_RATE

CHORDS = ((0, 4, 7), (0, 3, 7), (0, 4, 7, 11), (0, 3, 7, 10), (0, 5, 7))
"""Semitones above the root."""
PROGRESSION = (0, 5, 7, 9, 2, 4)
"""Roots of the chords of a key, semitones."""


def music(n: int, generator: np.random.Generator) -> Float32Array:
    """Return music, shape (n,), with a root mean square of 1: chords, a bass, a melody and drums, in a drawn key."""
    beat = int(SAMPLE_RATE * 60 / generator.uniform(70, 150))
    key, sound = generator.uniform(48, 60), np.zeros(n + 4 * beat)
    partials = 1 / np.arange(1, generator.integers(3, 12)) ** generator.uniform(0.8, 2)
    drums, melody = generator.uniform(0, 1.5), generator.uniform(0, 0.6)
    for first in range(0, n, 4 * beat):
        root = key + PROGRESSION[generator.integers(len(PROGRESSION))]
        chord = CHORDS[generator.integers(len(CHORDS))]
        for note in chord:
            _add(sound, first, 0.3 * _note(root + note, 4 * beat, partials, 1.0))
        for k in range(4):
            _add(sound, first + k * beat, 0.6 * _note(root - 12, beat, partials[:3], 0.3))
            _add(sound, first + k * beat, drums * (_kick(generator) if k % 2 == 0 else _snare(generator)))
            _add(sound, first + k * beat + beat // 2, 0.3 * drums * _hat(generator))
            step = chord[generator.integers(len(chord))] + 12 * generator.integers(1, 3)
            _add(sound, first + k * beat, melody * _note(root + step, beat, partials, 0.4))
    return _normal(sound[:n])


def desk(n: int, generator: np.random.Generator) -> Float32Array:
    """Return the noise of a desk, shape (n,), with a root mean square of 1: a fan that hums, and a keyboard."""
    times = np.arange(n) / SAMPLE_RATE
    hum = sum(
        generator.uniform(0, 1) / k * np.sin(2 * np.pi * k * generator.uniform(98, 102) * times) for k in range(1, 6)
    )
    sound = hum + 0.5 * _brown(n, generator)
    sound /= np.sqrt(np.mean(sound**2)) + 1e-12
    for first in np.flatnonzero(generator.random(n) < generator.uniform(0, 6) / SAMPLE_RATE):
        _add(sound, int(first), generator.uniform(3, 12) * _click(generator))
    return _normal(sound)


BACKGROUNDS = (music, desk)


def _add(sound: Float64Array, first: int, part: Float64Array) -> None:
    end = min(first + len(part), len(sound))
    if end > first:
        sound[first:end] += part[: end - first]


def _note(midi: float, n: int, partials: Float64Array, decay: float) -> Float64Array:
    """Return a plucked note: harmonics that decay, the higher ones sooner."""
    times = np.arange(n) / SAMPLE_RATE
    frequency = 440 * 2 ** ((midi - 69) / 12)
    tones = [
        height * np.exp(-times * (1 + 0.3 * k) / decay) * np.sin(2 * np.pi * (k + 1) * frequency * times)
        for k, height in enumerate(partials)
        if (k + 1) * frequency < SAMPLE_RATE / 2
    ]
    attack = np.minimum(times / 0.005, 1)
    return np.asarray(attack * sum(tones), float)


def _kick(_generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 5) / SAMPLE_RATE
    return np.asarray(np.exp(-times / 0.05) * np.sin(2 * np.pi * 50 * times + 20 * (1 - np.exp(-times / 0.02))))


def _snare(generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 6) / SAMPLE_RATE
    return np.asarray(
        np.exp(-times / 0.04) * (generator.standard_normal(len(times)) + np.sin(2 * np.pi * 190 * times))
    )


def _hat(generator: np.random.Generator) -> Float64Array:
    noise = generator.standard_normal(SAMPLE_RATE // 12)
    return np.asarray(np.exp(-np.arange(len(noise)) / SAMPLE_RATE / 0.02) * np.diff(noise, prepend=0.0))


def _click(generator: np.random.Generator) -> Float64Array:
    times = np.arange(SAMPLE_RATE // 50) / SAMPLE_RATE
    tone = np.sin(2 * np.pi * generator.uniform(1500, 5000) * times)
    return np.asarray(np.exp(-times / 0.002) * (generator.standard_normal(len(times)) + tone))


def _brown(n: int, generator: np.random.Generator) -> Float64Array:
    """Return noise that is weaker by 6 dB an octave above 100 Hz."""
    from scipy.signal import lfilter  # noqa: PLC0415 - it costs time at the start

    keep = np.exp(-2 * np.pi * 100 / SAMPLE_RATE)
    noise = lfilter([1], [1, -keep], generator.standard_normal(n))
    return np.asarray(noise / (np.sqrt(np.mean(noise**2)) + 1e-12))


def _normal(sound: Float64Array) -> Float32Array:
    return np.asarray(sound / (np.sqrt(np.mean(sound**2)) + 1e-12), np.float32)
