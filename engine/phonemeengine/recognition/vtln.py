"""Which vocal tract fits a speaker: that with which the network is the surest of what it names.

The same sound is named several times, with mel bands that are warped as if the speaker's vocal tract were longer or
shorter (L. Lee and R. Rose, "A frequency warping approach to speaker normalization", IEEE Trans. Speech and Audio
Processing 6(1), 1998). What they say is mixed; those that were sure count more.
"""

from math import exp, log

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

MEMORY = 10.0
"""Seconds over which confidence is remembered, so that another speaker may come."""
TRUST = 0.1
"""How much a frame's confidence, a logarithm of a probability, tells about the tract: neighbouring frames say nearly
the same."""

_KEPT = exp(-FRAME_PERIOD / MEMORY)


def mixed(shares: Float32Array, weights: Float32Array) -> Float32Array:
    """Mix the probabilities of tracts, shape (n, n_tracts, n_classes), by weights (n, n_tracts): (n, n_classes)."""
    if shares.shape[1] == 1:
        return shares[:, 0]
    found: Float32Array = np.matmul(weights[:, np.newaxis], shares)
    return found[:, 0]


class VtlnMixer:
    """Weighs what was heard with several vocal tracts, and remembers which of them were sure.

    Parameters
    ----------
    n_tracts : how many they are.
    """

    def __init__(self, n_tracts: int) -> None:
        self._evidence = [0.0] * n_tracts

    def weigh(self, shares: Float32Array) -> Float32Array:
        """Return how much each tract counts in the next frames, float32, shape (n, n_tracts); the sum is 1.

        Parameters
        ----------
        shares : the probabilities of the phonemes, shape (n, n_tracts, n_phonemes).
        """
        if shares.shape[1] == 1:
            return np.ones(shares.shape[:2], np.float32)
        sure = np.maximum.reduce(shares, axis=2).tolist()
        silent = shares[:, :, Phoneme.SILENCE].tolist()
        evidence, weights = self._evidence, []
        for certainties, silences in zip(sure, silent, strict=True):  # one loop: a call for each frame costs as much
            if sum(silences) < shares.shape[1] / 2:
                evidence = [_KEPT * before + log(now) for before, now in zip(evidence, certainties, strict=True)]
            else:  # silence tells nothing about them
                evidence = [_KEPT * before for before in evidence]
            most = max(evidence)
            odds = [exp(TRUST * (known - most)) for known in evidence]
            total = sum(odds)
            weights.append([chance / total for chance in odds])
        self._evidence = evidence
        return np.array(weights, np.float32).reshape(shares.shape[:2])
