"""What is heard in each frame, and how badly it suits each kind of sound."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.alignment.manners import levels_of, log_likelihoods, measured_of
from phonemeengine.alignment.sounds import KINDS
from phonemeengine.analyser import Analysis
from phonemeengine.arrays import Float32Array, Float64Array
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
"""How likely every phoneme is at least: recognisers are surer than they are right."""
MANNER_WEIGHT = 0.5
"""The power of the likelihood of loudness and sharpness beside the recogniser's probability."""
SURENESS = 0.8
"""How likely the answer of a recogniser without scores is taken to be."""


@dataclass(frozen=True)
class Evidence:
    """What is heard in consecutive frames.

    Attributes
    ----------
    probabilities : of each phoneme, float32, shape (n_frames, n_phonemes).
    levels : of the sound and of its differences, dB, float32, shape (n_frames, 2).
    """

    probabilities: Float32Array
    levels: Float32Array

    def __len__(self) -> int:
        return len(self.levels)

    def part(self, frames: slice) -> "Evidence":
        """Return some of the frames."""
        return Evidence(self.probabilities[frames], self.levels[frames])


def evidence_of(analysis: Analysis) -> Evidence:
    """Return what was heard in a block."""
    scores = scores_in(analysis.features)
    if scores is None:
        scores = np.full((len(analysis), len(Phoneme)), (1 - SURENESS) / (len(Phoneme) - 1), np.float32)
        scores[np.arange(len(analysis)), analysis.recognised] = SURENESS
    return Evidence(np.array(scores, np.float32), levels_of(analysis.frames.windows))


def joined(parts: Sequence[Evidence]) -> Evidence:
    """Return consecutive evidence as one; there must be some."""
    return Evidence(np.concatenate([p.probabilities for p in parts]), np.concatenate([p.levels for p in parts]))


def shortfalls_of(evidence: Evidence) -> Float64Array:
    """Return by how much each kind of sound falls short of the best one, natural logarithms, shape (n, n_kinds)."""
    shares = np.array([SHARES[phoneme] for phoneme in Phoneme])
    likely = np.log(evidence.probabilities + LEAST_LIKELY, dtype=np.float64) - SHARE_WEIGHT * np.log(shares)
    speaks = 1 - evidence.probabilities[:, Phoneme.SILENCE]
    suits = MANNER_WEIGHT * log_likelihoods(measured_of(evidence.levels, speaks))
    scores = likely[:, [kind.phoneme for kind in KINDS]] + suits[:, [kind.manner for kind in KINDS]]
    found: Float64Array = scores - scores.max(axis=1, keepdims=True)
    return found
