"""Waveforms that go round, with a peak of 1: the sine, the noises, the sweep and the vowel of the tone generator."""

import math
from functools import lru_cache
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.tone.settings import Formant, Tone, ToneKind
from phonemeengine.settings import SAMPLE_RATE

NOISE_SAMPLES = 1 << 19
"""Length of a noise before it comes again (11.9 s)."""

NOISE_SEED = 2003

LOWEST_HEARD = 20.0
"""Pink noise, whose power would grow without end towards 0 Hz, begins here, Hz."""

TABLE = 1 << 14
"""Samples in the period of a vowel: at least 80 in one of its highest partial's."""

HIGHEST_PARTIAL = 10_000.0
"""A voice has no partials above this, Hz."""

RAMP = 0.005
"""A sweep fades in and out for so long, seconds."""


class Waveform(Protocol):
    """Something that repeats.

    Attributes
    ----------
    rate : rounds in a second, Hz.
    """

    @property
    def rate(self) -> float:
        """Rounds in a second, Hz."""
        ...

    def at(self, cycles: Float64Array) -> Float64Array:
        """Return the values, ±1, after a number of rounds, of which only the fraction counts."""
        ...


def waveform_of(tone: Tone) -> Waveform:
    """Return the waveform of a tone, without its level."""
    match tone.kind:
        case ToneKind.SINE:
            return Sine(tone.frequency)
        case ToneKind.SWEEP:
            return Sweep(tone.low, tone.high, tone.sweep_seconds)
        case ToneKind.VOWEL:
            return Vowel(tone.f0, tone.formants)
        case _:
            return WhiteNoise(pink=tone.kind is ToneKind.PINK_NOISE)


class Sine:
    """A sine, from phase 0."""

    def __init__(self, frequency: float) -> None:
        self.rate = frequency

    def at(self, cycles: Float64Array) -> Float64Array:
        """Return the values after a number of rounds."""
        return np.asarray(np.sin(2 * np.pi * (cycles % 1.0)))


class Sweep:
    """A sine whose frequency rises by equal intervals in equal times (an exponential chirp), then begins again.

    Its phase is the integral of ``low (high / low)^u`` over the share u of the sweep; see Farina (2000),
    Simultaneous measurement of impulse response and distortion with a swept-sine technique.
    """

    def __init__(self, low: float, high: float, seconds: float) -> None:
        self.rate = 1 / seconds
        self._ratio = math.log(high / low)
        self._cycles = low * seconds / self._ratio
        self._ramp = RAMP / seconds

    def at(self, cycles: Float64Array) -> Float64Array:
        """Return the values after a number of rounds; it fades out before the end, and in again."""
        share = cycles % 1.0
        phase = self._cycles * np.expm1(self._ratio * share)
        edge = np.minimum(np.minimum(share, 1 - share) / self._ramp, 1.0)
        return np.asarray((0.5 - 0.5 * np.cos(np.pi * edge)) * np.sin(2 * np.pi * (phase % 1.0)))


class WhiteNoise:
    """Gaussian noise of 11.9 s that goes round without a seam: white, or pink (-3 dB per octave, from 20 Hz)."""

    rate = SAMPLE_RATE / NOISE_SAMPLES

    def __init__(self, *, pink: bool) -> None:
        self._samples = _noise(pink)

    def at(self, cycles: Float64Array) -> Float64Array:
        """Return the values after a number of rounds."""
        nearest = np.rint(cycles % 1.0 * NOISE_SAMPLES).astype(np.int64)
        return self._samples[nearest % NOISE_SAMPLES].astype(float)


class Vowel:
    """A voice through formants one after the other."""

    def __init__(self, f0: float, formants: tuple[Formant, ...]) -> None:
        self.rate = f0
        self._table = _vowel_period(f0, formants)

    def at(self, cycles: Float64Array) -> Float64Array:
        """Return the values after a number of rounds, between those of the table on a straight line."""
        place = cycles % 1.0 * TABLE
        before = np.minimum(place.astype(np.int64), TABLE - 1)
        low = self._table[before]
        return np.asarray(low + (place - before) * (self._table[before + 1] - low))


def partials_of(f0: float, formants: tuple[Formant, ...]) -> NDArray[np.complex128]:
    """Return amplitude and phase of the partials of a vowel, from f0 to 10 kHz.

    The glottis falls by 12 dB per octave and the lips raise by 6, so the source falls by 6, as ``1 / s``. Each
    formant is a pole pair ``p p* / ((s - p)(s - p*))``, ``p = -pi B + 2 pi i F``, with the gain 1 at 0 Hz, and they
    follow one another: Fant (1960), Acoustic Theory of Speech Production; Klatt (1980), the cascade branch.

    Returns
    -------
    complex, shape (n_partials,): the k-th is that of k f0; only their ratios mean something.
    """
    number = np.arange(1, int(HIGHEST_PARTIAL // f0) + 1)
    s = 2j * np.pi * f0 * number
    partials = f0 / s
    for formant in formants:
        pole = complex(-math.pi * formant.bandwidth, 2 * math.pi * formant.frequency)
        partials *= abs(pole) ** 2 / ((s - pole) * (s - pole.conjugate()))
    return np.asarray(partials, np.complex128)


def _vowel_period(f0: float, formants: tuple[Formant, ...]) -> Float64Array:
    """Add up the partials over one period, shape (TABLE + 1,), the last value being the first."""
    partials = partials_of(f0, formants)
    spectrum = np.zeros(TABLE // 2 + 1, complex)
    spectrum[1 : len(partials) + 1] = partials
    period = np.fft.irfft(spectrum, TABLE)
    period /= np.abs(period).max()
    return np.append(period, period[0])


@lru_cache(maxsize=2)
def _noise(pink: bool) -> Float32Array:
    """Draw a period of noise; it is the same each time."""
    drawn = np.random.default_rng(NOISE_SEED).standard_normal(NOISE_SAMPLES)
    spectrum = np.fft.rfft(drawn)
    frequencies = np.fft.rfftfreq(NOISE_SAMPLES, 1 / SAMPLE_RATE)
    spectrum[0] = 0.0
    if pink:
        spectrum[frequencies < LOWEST_HEARD] = 0.0
        spectrum[1:] /= np.sqrt(frequencies[1:])
    period = np.fft.irfft(spectrum, NOISE_SAMPLES)
    return np.asarray(period / np.abs(period).max(), np.float32)
