"""How sounds of a manner of articulation sound: how loud, and how much of it at high frequencies.

The recogniser calls n, l, t, k, f alike unidentified, and its window is 23 ms. What it leaves open, such as where an
n becomes a t, the loudness of every 10 ms tells.
"""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.visemes import Viseme, viseme_of
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.settings import WINDOW

# one or two periods of a voice, shorter than the recogniser's window: the closure of a stop shows
HEARD = slice(WINDOW // 2 - 330, WINDOW // 2 + 331)
"""The middle of a window that is measured, 15 ms."""
QUIETEST = 1e-9
"""Power below which nothing is distinguished; full scale is 1."""
DEEPEST, HIGHEST = -60.0, 6.0
"""The loudness that is distinguished, dB relative to loud speech."""
DULLEST, SHARPEST = -40.0, 5.0
"""The sharpness that is distinguished, dB."""
LEAST_LIKELY = -12.0
"""A logarithm below which nothing is unlikelier."""
LOUD = 90
"""Percentile of the loudness of speech that is loud."""
ENOUGH_SPEECH = 10
"""Frames of speech by which its loudness is known."""
ABOVE_SILENCE = 25.0
"""Where there is less speech, it is taken to be so much louder than what else there is, dB."""


class Manner(IntEnum):
    """How a sound is made; the number is its row in `MANNERS`."""

    SILENCE = 0
    STOP = 1
    NASAL = 2
    APPROXIMANT = 3
    FRICATIVE = 4
    SIBILANT = 5
    VOWEL = 6


CONSONANTS: dict[Manner, str] = {
    Manner.STOP: "p b pʲ bʲ pf ɓ t d tʲ dʲ ʈ ɖ ɗ k ɡ g kʲ ɡʲ ɠ c ɟ q ɢ ʔ",
    Manner.NASAL: "m mʲ m̩ ɱ n n̩ nʲ ɲ ŋ ŋ̩ ɳ ɴ",
    Manner.FRICATIVE: "f θ h ɦ x χ ç ɣ ʝ ɸ β ħ ʕ ɬ ɮ r̝ r̝̊",
    Manner.SIBILANT: "s z sʲ zʲ s̪ z̪ z̩ ʃ ʒ ʂ ʐ ʃʲ ɕ ʑ",
}
"""The consonants of each manner; unidentified sounds that are not among them are approximants, all others vowels."""

_MANNERS = {ipa: manner for manner, names in CONSONANTS.items() for ipa in names.split()}


@dataclass(frozen=True)
class Blob:
    """A part of a mixture of normal distributions over loudness and sharpness, both dB.

    Attributes
    ----------
    weight : its share, 0..1.
    loudness, sharpness : where it lies, dB.
    loudness_variance, covariance, sharpness_variance : how wide it is, dB squared.
    """

    weight: float
    loudness: float
    sharpness: float
    loudness_variance: float
    covariance: float
    sharpness_variance: float

    def log_density(self, measured: Float64Array) -> Float64Array:
        """Return the logarithm of its density at some frames, shape (n_frames,); see `measured_of`."""
        x, y = measured[:, 0] - self.loudness, measured[:, 1] - self.sharpness
        # the bivariate normal distribution, its 2 x 2 covariance inverted by hand
        determinant = self.loudness_variance * self.sharpness_variance - self.covariance**2
        form = self.sharpness_variance * x**2 - 2 * self.covariance * x * y + self.loudness_variance * y**2
        found: Float64Array = np.log(self.weight / (2 * np.pi * np.sqrt(determinant))) - form / (2 * determinant)
        return found


MANNERS: dict[Manner, tuple[Blob, ...]] = {
    Manner.SILENCE: (Blob(0.29, -59.4, -3.0, 4, -3, 21), Blob(0.71, -35.1, -18.8, 184, -53, 64)),
    Manner.STOP: (Blob(0.26, -41.5, -17.8, 147, -127, 135), Blob(0.74, -16.2, -19.7, 61, -28, 98)),
    Manner.NASAL: (Blob(0.05, -10.5, -20.9, 67, 6, 32), Blob(0.95, -4.7, -27.4, 19, -5, 9)),
    Manner.APPROXIMANT: (Blob(0.13, -21.3, -14.5, 125, -40, 73), Blob(0.87, -6.5, -23.6, 24, -4, 18)),
    Manner.FRICATIVE: (Blob(0.62, -23.2, -5.9, 36, -7, 20), Blob(0.38, -14.9, -18.5, 87, -49, 57)),
    Manner.SIBILANT: (Blob(0.28, -13.0, -15.7, 80, -45, 55), Blob(0.72, -11.9, -4.1, 27, -4, 14)),
    Manner.VOWEL: (Blob(0.06, -10.3, -20.1, 40, -2, 27), Blob(0.94, -2.4, -21.3, 10, 1, 16)),
}
"""How loud and how sharp sounds of each manner are: fitted to 13 minutes of 16 voices, aligned with their texts."""


def manner_of(ipa: str) -> Manner:
    """Return how a sound is made, by its symbol in the phonetic alphabet."""
    return _MANNERS.get(ipa) or (Manner.APPROXIMANT if ipa_phoneme(ipa) is Phoneme.UNIDENTIFIED else Manner.VOWEL)


def levels_of(windows: Float32Array) -> Float32Array:
    """Return the level of the middle of each window, and that of its differences, dB, shape (n_frames, 2).

    Parameters
    ----------
    windows : shape (n_frames, 2048), ±1.
    """
    middle = windows[:, HEARD].astype(np.float64)
    # The difference of neighbouring samples raises by 6 dB an octave, so its level beside that of the sound says
    # where the energy lies: about -27 dB for a nasal, -4 dB for an s. Two sums instead of a spectrum.
    powers = (np.mean(middle**2, axis=1), np.mean(np.diff(middle, axis=1) ** 2, axis=1))
    return (10 * np.log10(np.maximum(powers, QUIETEST))).T.astype(np.float32)


def measured_of(levels: Float32Array, speaks: Float32Array) -> Float64Array:
    """Return loudness beside that of loud speech, and sharpness, dB, shape (n_frames, 2).

    Parameters
    ----------
    levels : as `levels_of` gives them.
    speaks : the probability that there is speech, 0..1, shape (n_frames,).
    """
    spoken = levels[speaks > 0.5, 0]
    # Levels count relative to the loud speech of the same section, so that neither gain nor distance matters.
    loud = np.percentile(spoken, LOUD) if len(spoken) else -np.inf
    if len(spoken) < ENOUGH_SPEECH:
        loud = max(loud, np.median(levels[:, 0]) + ABOVE_SILENCE)
    loudness = np.clip(levels[:, 0] - loud, DEEPEST, HIGHEST)
    sharpness = np.clip(levels[:, 1] - levels[:, 0], DULLEST, SHARPEST)
    return np.stack([loudness, sharpness], axis=1).astype(np.float64)


def log_likelihoods(measured: Float64Array) -> Float64Array:
    """Return how well frames suit each manner, natural logarithms, shape (n_frames, n_manners)."""
    # the sum of the parts of a mixture, from their logarithms; the floor keeps one odd frame from forbidding a sound
    found = [np.logaddexp.reduce([blob.log_density(measured) for blob in MANNERS[manner]]) for manner in Manner]
    likely: Float64Array = np.maximum(np.stack(found, axis=1), LEAST_LIKELY)
    return likely


# What can be told apart of the sounds of speech: a phoneme of the recogniser, made in one manner, and its viseme.

LEAST_FRAMES: dict[Manner, int] = {
    Manner.SILENCE: 4,
    Manner.STOP: 5,
    Manner.NASAL: 5,
    Manner.APPROXIMANT: 3,
    Manner.FRICATIVE: 5,
    Manner.SIBILANT: 6,
    Manner.VOWEL: 7,
}
"""What sounds of a manner last at least in speech that is not hurried, 10 ms each."""

SHORT = frozenset("əɐɪʊɨᵻɾ")
LEAST_SHORT = 4
"""Sounds that are shorter than others of their manner, and what they last at least."""


@dataclass(frozen=True)
class SoundKind:
    """What is listened for: a phoneme, how it is made, and what is seen of it, where that tells more."""

    phoneme: Phoneme
    manner: Manner
    viseme: Viseme | None = None


SEEN = {
    Manner.STOP: (Viseme.DD, Viseme.KK),
    Manner.NASAL: (Viseme.NN, Viseme.KK),
    Manner.APPROXIMANT: (Viseme.DD, Viseme.NN, Viseme.RR, Viseme.FF, Viseme.TH),
    Manner.FRICATIVE: (Viseme.FF, Viseme.TH, Viseme.KK),
}
"""By which visemes sounds that are none of the phonemes are distinguished, for each manner."""

KINDS: tuple[SoundKind, ...] = (
    SoundKind(Phoneme.SILENCE, Manner.SILENCE),
    *(SoundKind(vowel, Manner.VOWEL) for vowel in VOWELS),
    *(SoundKind(Phoneme.UNIDENTIFIED, manner) for manner in SEEN),
    *(SoundKind(Phoneme.UNIDENTIFIED, manner, viseme) for manner, visemes in SEEN.items() for viseme in visemes),
    SoundKind(Phoneme.P, Manner.STOP),
    SoundKind(Phoneme.M, Manner.NASAL),
    SoundKind(Phoneme.SZ, Manner.SIBILANT),
    SoundKind(Phoneme.SCH, Manner.SIBILANT),
)
"""All of them; silence is the first."""

_NUMBERS = {kind: k for k, kind in enumerate(KINDS)}
_BY_PHONEME = {kind.phoneme: k for k, kind in enumerate(KINDS) if kind.viseme is None}
"""For sounds that are made otherwise than those of their phoneme usually are."""


def kind_of(ipa: str) -> int:
    """Return the number of the kind of a sound, by its symbol in the phonetic alphabet."""
    phoneme, manner = ipa_phoneme(ipa), manner_of(ipa)
    # the finest kind that is listened for: with its viseme, by its manner, or at least by its phoneme
    kinds = (SoundKind(phoneme, manner, viseme_of(ipa, phoneme)), SoundKind(phoneme, manner))
    return next((_NUMBERS[kind] for kind in kinds if kind in _NUMBERS), _BY_PHONEME[phoneme])


def least_frames_of(ipa: str) -> int:
    """Return how many frames a sound lasts at least in speech that is not hurried."""
    return LEAST_SHORT if ipa in SHORT else LEAST_FRAMES[manner_of(ipa)]
