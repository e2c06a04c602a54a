"""Tones that can take the place of a sound: their settings, as values that check themselves."""

from dataclasses import dataclass
from enum import StrEnum

from phonemeengine.errors import SettingsError, check_range


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
