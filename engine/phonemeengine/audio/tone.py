"""A tone in place of a sound file: a stream at 44.1 kHz that has no end and can be changed while it plays."""

import math
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array
from phonemeengine.errors import SettingsError, check_range
from phonemeengine.settings import SAMPLE_RATE, Channel


class ToneKind(StrEnum):
    """What a tone generator can give."""

    SINE = "sine"
    WHITE_NOISE = "white_noise"
    PINK_NOISE = "pink_noise"
    SWEEP = "sweep"
    VOWEL = "vowel"


# name: (lowest, highest, unit) of every parameter that is a plain number
TONE_LIMITS: dict[str, tuple[float, float, str]] = {
    "level": (-80.0, 0.0, "dB"),
    "frequency": (20.0, 20_000.0, "Hz"),
    "low": (20.0, 20_000.0, "Hz"),
    "high": (20.0, 20_000.0, "Hz"),
    "sweep_seconds": (0.2, 120.0, "s"),
    "f0": (50.0, 500.0, "Hz"),
}

MOST_FORMANTS = 5
FORMANT_LIMITS = (100.0, 8_000.0)
"""Where a formant may lie, Hz."""
BANDWIDTH_LIMITS = (20.0, 1_000.0)
"""How wide a formant may be, Hz."""


@dataclass(frozen=True)
class Formant:
    """A resonance of the vocal tract.

    Parameters
    ----------
    frequency : 100..8000 Hz.
    bandwidth : width at -3 dB, 20..1000 Hz.

    Raises
    ------
    SettingsError : a value lies outside its range.
    """

    frequency: float
    bandwidth: float = 80.0

    def __post_init__(self) -> None:
        check_range("a formant's frequency", self.frequency, (*FORMANT_LIMITS, "Hz"))
        check_range("a formant's bandwidth", self.bandwidth, (*BANDWIDTH_LIMITS, "Hz"))


def _spoken(*frequencies: float) -> tuple[Formant, ...]:
    """Return three measured formants their bandwidths, and add the two that speech sounds share."""
    measured = (Formant(f, width) for f, width in zip(frequencies, (50.0, 70.0, 110.0), strict=True))
    return (*measured, Formant(3300.0, 250.0), Formant(3750.0, 200.0))


VOWEL_FORMANTS: dict[str, tuple[Formant, ...]] = {
    "a": _spoken(795, 1301, 2565),
    "e": _spoken(407, 2017, 2554),
    "i": _spoken(294, 2208, 2766),
    "o": _spoken(487, 911, 2481),
    "u": _spoken(339, 810, 2323),
}
"""Formants of the long vowels, which Dutch and German share.

The first three are the means of 50 men for aa ee ie oo oe in Pols, Tromp and Plomp (1973), Frequency analysis of
Dutch vowels from 50 male speakers, JASA 53(4); the fourth, the fifth and all bandwidths are the defaults of Klatt
(1980), Software for a cascade/parallel formant synthesizer, JASA 67(3), table I.
"""


@dataclass(frozen=True)
class Tone:
    """What a tone generator is to give; each kind heeds its own parameters, and keeps the others.

    Parameters
    ----------
    kind : the kind of the tone.
    level : the highest peak, -80..0 dB below full scale, whatever the kind. The RMS of a sine and of a sweep lies
        3 dB below it, that of the noises, which reach it once in twelve seconds, about 14 dB.
    frequency : of the sine, 20..20000 Hz.
    low, high : where the sweep begins and ends, 20..20000 Hz; it rises by equal intervals in equal times.
    sweep_seconds : how long the sweep takes before it begins again, 0.2..120 s.
    f0 : the voice's fundamental, 50..500 Hz.
    formants : one to five resonances through which the voice goes one after the other.

    Raises
    ------
    SettingsError : a value lies outside its range.
    """

    kind: ToneKind = ToneKind.SINE
    level: float = -12.0
    frequency: float = 1000.0
    low: float = 50.0
    high: float = 10_000.0
    sweep_seconds: float = 10.0
    f0: float = 120.0
    formants: tuple[Formant, ...] = VOWEL_FORMANTS["a"]

    def __post_init__(self) -> None:
        for name, limits in TONE_LIMITS.items():
            check_range(name, getattr(self, name), limits)
        if self.low >= self.high:
            raise SettingsError(
                f"a sweep must rise, got low {self.low:g} Hz and high {self.high:g} Hz; raise high or lower low"
            )
        check_range("the number of formants", len(self.formants), (1, MOST_FORMANTS, ""))


def vowel_of(formants: tuple[Formant, ...]) -> str | None:
    """Return the name under which formants stand in `VOWEL_FORMANTS`, or None."""
    return next((name for name, known in VOWEL_FORMANTS.items() if known == formants), None)


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


FADE = 220
"""Samples from one tone to the next (5 ms)."""


@dataclass(frozen=True)
class _Oscillator:
    """A waveform that goes round at a steady rate, so that it is known at every sample.

    Attributes
    ----------
    since, phase : a sample, and the share of a round that has passed there.
    """

    kind: ToneKind
    wave: Waveform
    gain: float
    since: int = 0
    phase: float = 0.0

    def cycles(self, samples: Int64Array) -> Float64Array:
        """Return how many rounds have passed at samples, but for whole ones.

        Whole seconds are reduced before they are multiplied, so that days later the phase is as exact as at first.
        """
        seconds, rest = np.divmod(samples - self.since, SAMPLE_RATE)
        whole = (self.wave.rate % 1.0) * seconds % 1.0
        return self.phase + whole + self.wave.rate * rest / SAMPLE_RATE

    def at(self, samples: Int64Array) -> Float64Array:
        """Return the sound at samples."""
        return self.gain * self.wave.at(self.cycles(samples))

    def begun(self, sample: int, phase: float) -> "_Oscillator":
        """Return the same with a given phase at a sample."""
        return _Oscillator(self.kind, self.wave, self.gain, sample, phase % 1.0)


class _Change:
    """The way from one voice to the next: a fade, during which one rate glides into the other if the kind stays."""

    def __init__(self, old: _Oscillator, new: _Oscillator, start: int) -> None:
        self._old = old
        self._start = start
        self._glides = old.kind is new.kind
        self._phase = float(old.cycles(np.array([start]))[0])
        self._rise = (new.wave.rate - old.wave.rate) / (2 * FADE)
        self.end = start + FADE
        end_phase = float(self._glided(np.array([float(FADE)]))[0])
        self.new = new.begun(self.end, end_phase) if self._glides else new.begun(start, 0.0)

    def at(self, samples: Int64Array) -> Float64Array:
        """Return the sound at samples from the start to the end."""
        steps = (samples - self._start).astype(float)
        share = 0.5 - 0.5 * np.cos(np.pi * steps / FADE)
        if not self._glides:
            return (1 - share) * self._old.at(samples) + share * self.new.at(samples)
        cycles = self._glided(steps)
        old, new = (voice.gain * voice.wave.at(cycles) for voice in (self._old, self.new))
        return (1 - share) * old + share * new

    def _glided(self, steps: Float64Array) -> Float64Array:
        """Integrate a rate that goes evenly from the old to the new within the fade."""
        return np.asarray(self._phase + (self._old.wave.rate + self._rise * steps) * steps / SAMPLE_RATE)


class ToneReader:
    """Gives a tone as a stream, in the manner of `SoundReader`.

    `set_tone` may be called from another thread than the rest. Until a tone is changed, the value of a sample
    depends on the sample only, however the stream was cut and wherever it was entered.

    Attributes
    ----------
    tone : what was asked for last.
    channel : always the mix; there is one channel.
    n_channels : 1.
    n_samples : where the stream ends: after 288 days.
    position : the next sample that `read` gives.
    """

    n_channels = 1
    n_samples = 1 << 40
    channel = Channel.MIX

    def __init__(self, tone: Tone) -> None:
        self.tone = tone
        self.position = 0
        self._asked = self._taken = self._voice = _voice_of(tone)
        self._change: _Change | None = None

    @property
    def duration(self) -> float:
        """Length of the stream, seconds: 288 days."""
        return self.n_samples / SAMPLE_RATE

    def set_tone(self, tone: Tone) -> None:
        """Go over to another tone within 5 ms from the next `read` on, without a click.

        A tone of the same kind goes on where the other was: its frequency glides, and so do level and formants. A
        tone of another kind begins at its beginning.
        """
        self._asked, self.tone = _voice_of(tone), tone

    def read(self, n: int) -> Float32Array:
        """Return the next samples, fewer than `n` only at the end.

        Returns
        -------
        float32, shape (n, 1), ±1.
        """
        n = max(0, min(n, self.n_samples - self.position))
        block = np.empty((n, 1), np.float32)
        done = 0
        while done < n:
            done += self._fill(block[done:, 0])
        return block

    def mono(self, block: Float32Array) -> Float32Array:
        """Return the one channel of a block, shape (n,)."""
        return block[:, 0]

    def seek(self, sample: int) -> None:
        """Go to a sample, beyond the ends meaning the ends; a change under way is over."""
        self.position = min(max(sample, 0), self.n_samples)
        self._change = None

    def close(self) -> None:
        """Do nothing: a tone holds no file."""

    def _fill(self, room: Float32Array) -> int:
        """Fill room up to its end or to where a change is over; returns how much was filled."""
        if self._change is not None and self.position >= self._change.end:
            self._change = None
        asked = self._asked  # read once: `set_tone` may set it at any moment
        if self._change is None and asked is not self._taken:
            self._change = _Change(self._voice, asked, self.position)
            self._taken, self._voice = asked, self._change.new
        source = self._change or self._voice
        n = min(len(room), self._change.end - self.position) if self._change else len(room)
        room[:n] = source.at(np.arange(self.position, self.position + n))
        self.position += n
        return n


def _voice_of(tone: Tone) -> _Oscillator:
    return _Oscillator(tone.kind, waveform_of(tone), 10 ** (tone.level / 20))
