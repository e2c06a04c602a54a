"""The evidence of each frame, and how badly it fits each kind of sound."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.alignment.manners import KINDS, levels_of, log_likelihoods, measured_of
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.labels.visemes import STANDARD_VISEMES, Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import scores_in

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
