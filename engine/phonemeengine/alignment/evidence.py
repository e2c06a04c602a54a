"""The evidence of each frame, how sounds of a manner of articulation sound, and how badly one fits the other.

The recogniser calls n, l, t, k, f alike unidentified, and its window is 23 ms. What it leaves open, such as where an
n becomes a t, the loudness of every 10 ms tells.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from phonemeengine.analyser import Analysis
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme, viseme_of
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.recognition.scores import scores_in
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
LEAST_LOG_LIKELIHOOD = -12.0
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
    likely: Float64Array = np.maximum(np.stack(found, axis=1), LEAST_LOG_LIKELIHOOD)
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


SHARES: dict[Phoneme, float] = {
    Phoneme.SILENCE: 0.14,
    Phoneme.UNIDENTIFIED: 0.36,
    Phoneme.SZ: 0.075,
    Phoneme.SCH: 0.022,
    Phoneme.M: 0.028,
    Phoneme.P: 0.037,
    Phoneme.I: 0.075,
    Phoneme.A: 0.1,
    Phoneme.E: 0.1,
    Phoneme.U: 0.03,
    Phoneme.O: 0.058,
}
"""How much of running speech is of each phoneme."""
SHARE_WEIGHT = 0.45
"""The power of its share by which a phoneme's probability is divided: the text says what is said, not its frequency;
more favours rare phonemes, less whole mouths."""
LEAST_LIKELY = 1e-4
"""The least probability of a phoneme: recognisers are more confident than they are right."""
MANNER_WEIGHT = 0.5
"""The power of the likelihood of loudness and sharpness beside the recogniser's probability."""
SPOKEN = 0.5
"""There is speech where silence is less likely than this."""
NOTHING, LONG = -85.0, 25
"""The level below which there is silence, dB, whatever the recogniser says, where it lasts for this many frames: the
closures of stops are shorter."""
SURENESS = 0.8
"""How likely the answer of a recogniser without scores is taken to be."""


VISEME_WEIGHT = 1.0
"""The power of the likelihood of what is seen of an unidentified sound, beside the best of them."""
LEAST_SEEN = 0.03
"""How likely every viseme of an unidentified sound is at least."""
VISEME_SHARES: dict[Viseme, float] = {
    Viseme.DD: 0.24,
    Viseme.FF: 0.11,
    Viseme.TH: 0.05,
    Viseme.KK: 0.18,
    Viseme.NN: 0.29,
    Viseme.RR: 0.13,
}
"""How many of the unidentified sounds show each viseme."""


@dataclass(frozen=True)
class Evidence:
    """The evidence of consecutive frames.

    Attributes
    ----------
    probabilities : of each phoneme, float32, shape (n_frames, n_phonemes).
    levels : of the sound and of its differences, dB, float32, shape (n_frames, 2).
    visemes : how likely each `Viseme` is, float32, shape (n_frames, 15); None where they are not recognised.
    """

    probabilities: Float32Array
    levels: Float32Array
    visemes: Float32Array | None = None

    def __len__(self) -> int:
        return len(self.levels)

    def part(self, frames: slice) -> "Evidence":
        """Return some of the frames."""
        visemes = None if self.visemes is None else self.visemes[frames]
        return Evidence(self.probabilities[frames], self.levels[frames], visemes)


def evidence_of(analysis: Analysis) -> Evidence:
    """Return the evidence of a block."""
    scores = scores_in(analysis.features)
    if scores is None:
        scores = np.full((len(analysis), len(Phoneme)), (1 - SURENESS) / (len(Phoneme) - 1), np.float32)
        scores[np.arange(len(analysis)), analysis.recognised] = SURENESS
    levels = levels_of(analysis.frames.windows)
    visemes = analysis.viseme_scores if analysis.viseme_set == STANDARD_VISEMES else None
    return Evidence(np.array(scores, np.float32), levels, visemes)


def spoken_in(evidence: Evidence) -> BoolArray:
    """Return in which frames there is speech, shape (n_frames,)."""
    found: BoolArray = _believed(evidence)[:, Phoneme.SILENCE] < SPOKEN
    return found


def _believed(evidence: Evidence) -> Float32Array:
    """Return the probabilities, where long digital silence is silence, shape (n_frames, n_phonemes)."""
    nothing = evidence.levels[:, 0] < NOTHING
    if not nothing.any():
        return evidence.probabilities
    # begins and ends of runs alternate, since a False stands at both ends
    edges = np.flatnonzero(np.diff(np.concatenate([[False], nothing, [False]]).astype(np.int8)))
    believed = evidence.probabilities.copy()
    for first, last in edges.reshape(-1, 2).tolist():
        if last - first >= LONG:
            believed[first:last] = np.eye(len(Phoneme), dtype=np.float32)[Phoneme.SILENCE]
    return believed


def joined(parts: Sequence[Evidence]) -> Evidence:
    """Return consecutive evidence as one; there must be some."""
    visemes = [part.visemes for part in parts if part.visemes is not None]
    return Evidence(
        np.concatenate([part.probabilities for part in parts]),
        np.concatenate([part.levels for part in parts]),
        np.concatenate(visemes) if len(visemes) == len(parts) else None,
    )


def shortfalls_of(evidence: Evidence) -> Float64Array:
    """Return by how much each kind of sound falls short of the best one, natural logarithms, shape (n, n_kinds)."""
    shares = np.array([SHARES[phoneme] for phoneme in Phoneme])
    probabilities = _believed(evidence)
    # Bayes: p(sound | phoneme) is proportional to p(phoneme | sound) / p(phoneme), the scaled likelihoods of hybrids
    # of networks and hidden Markov models (H. Bourlard and N. Morgan, Connectionist Speech Recognition, 1994). The
    # prior is taken back only in part, see `SHARE_WEIGHT`.
    likely = np.log(probabilities + LEAST_LIKELY, dtype=np.float64) - SHARE_WEIGHT * np.log(shares)
    speaks = 1 - probabilities[:, Phoneme.SILENCE]
    # Loudness is no independent witness, since the recogniser has it too, so its likelihood counts with a power below
    # 1.
    suits = MANNER_WEIGHT * log_likelihoods(measured_of(evidence.levels, speaks))
    scores = likely[:, [kind.phoneme for kind in KINDS]] + suits[:, [kind.manner for kind in KINDS]]
    if evidence.visemes is not None:
        scores += _seen(evidence.visemes)
    # Beside the best that could be said in the frame: the level of the scores drops out, so costs of frames compare
    # whatever the sound, and prices mean the same everywhere.
    found: Float64Array = scores - scores.max(axis=1, keepdims=True)
    return found


def _seen(visemes: Float32Array) -> Float64Array:
    """Return how well what is seen suits each kind of sound, 0 for the best and for those that it does not tell."""
    shares = np.array([*VISEME_SHARES.values()])
    likely = visemes[:, [*VISEME_SHARES]].astype(np.float64)
    # Given that it is an unidentified sound, which viseme? So they add up to 1 among themselves, and how likely an
    # unidentified sound is at all stays with the phonemes.
    likely = likely / np.maximum(likely.sum(axis=1, keepdims=True), LEAST_LIKELY) + LEAST_SEEN
    suits = VISEME_WEIGHT * (np.log(likely) - SHARE_WEIGHT * np.log(shares))
    suits -= suits.max(axis=1, keepdims=True)
    found = np.zeros((len(visemes), len(KINDS)))
    for number, viseme in enumerate(VISEME_SHARES):
        found[:, [k for k, kind in enumerate(KINDS) if kind.viseme is viseme]] = suits[:, [number]]
    return found
