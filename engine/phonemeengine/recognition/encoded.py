"""The recogniser of whole files by a speech encoder and the network together."""

from collections.abc import Callable

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.framing import LEAD
from phonemeengine.features.measure import Features
from phonemeengine.labels.visemes import Viseme
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.recognition import Recognition
from phonemeengine.recognition.scores import SCORES, ScoredRecogniser, Sensitivity, agreed
from phonemeengine.settings import HOP, WINDOW

STRETCH, OVERLAP = 2800, 100
"""Frames that are encoded at once, and how many more of the sound on both sides; both even."""
ENCODER_SHARE = 0.6
"""Of the encoder in the mean of the logarithms of both probabilities; the rest is the network's."""
WEAKENED = 0.35
"""How much less the likeliness of a class beforehand counts: frequent ones are named too often by both together."""
N_VISEMES = len(Viseme)

Evidence = Callable[[Float32Array], Float32Array]
"""Takes samples, gives how likely each phoneme and viseme is, shape (n_frames or some more, 26)."""


class EncodedRecogniser(ScoredRecogniser):
    """Names what encoder and network together find likeliest: the weighted mean of their log-probabilities.

    It delays frames until it has an excerpt of the sound, so it is for files.

    Parameters
    ----------
    network : names phonemes and visemes, with no sensitivities.
    evidence : the probabilities by the encoder and its head; called with excerpts of a few seconds to half a minute.
    priors : shares of the phonemes and visemes in what both were trained on, shape (26,).
    sensitivity : log-odds that are added in the end.
    """

    def __init__(
        self, network: LearnedRecogniser, evidence: Evidence, priors: Float32Array, sensitivity: Sensitivity
    ) -> None:
        self.look_ahead = STRETCH + OVERLAP
        self._network, self._evidence, self._sensitivity = network, evidence, sensitivity
        self._penalties = np.float32(WEAKENED) * np.log(priors)
        self._samples = np.zeros(0, np.float32)
        self._n_before = 0  # frames of the samples that are answered already
        self._shares: list[tuple[Float32Array, Float32Array]] = []

    def recognise(self, windows: Float32Array, _features: Features) -> Recognition:
        """Take the next frames; what is returned is about excerpts of the oldest, once there are any."""
        # The middle 10 ms of each window, put together, are the sound again: the encoder takes samples, not frames.
        self._samples = np.concatenate((self._samples, windows[:, LEAD : LEAD + HOP].ravel()))
        self._follow(windows)
        return self._answers((self._n_waiting - OVERLAP) // STRETCH * STRETCH)

    def finish(self) -> Recognition:
        """Return the answers for all frames that are left."""
        self._follow(np.zeros((self._network.look_ahead, WINDOW), np.float32))
        return self._answers(self._n_waiting)

    @property
    def _n_waiting(self) -> int:
        return len(self._samples) // HOP - self._n_before

    def _follow(self, windows: Float32Array) -> None:
        shares, visemes = self._network.probabilities(windows)
        if len(shares):
            unknown = np.ones((len(shares), N_VISEMES), np.float32)
            self._shares.append((shares, unknown if visemes is None else visemes))

    def _answers(self, n: int) -> Recognition:
        """Name the oldest n frames; none, if n is not above 0."""
        # The encoder attends to all of an excerpt, so excerpts are as long as it can take, and only whole ones are
        # answered before the end.
        lengths = [min(STRETCH, n - first) for first in range(0, n, STRETCH)]
        parts = [(np.zeros((0, len(SCORES)), np.float32), np.zeros((0, N_VISEMES), np.float32))]
        parts += [self._stretch(length) for length in lengths]
        scores, visemes = (np.concatenate(part) for part in zip(*parts, strict=True))
        return Recognition(scores.argmax(axis=1).astype(np.uint8), scores, visemes)

    def _stretch(self, n: int) -> tuple[Float32Array, Float32Array]:
        """Return how likely phonemes and visemes are in the oldest n frames, and forget them."""
        # The overlap before and after gives the frames at both edges their context; its answers are thrown away here,
        # since the neighbouring excerpt knows better.
        end = (self._n_before + n + OVERLAP) * HOP
        encoded = self._evidence(self._samples[:end])[self._n_before :]
        encoded = encoded[np.minimum(np.arange(n), len(encoded) - 1)]  # the last of an odd number has none of its own
        shares, fine = (np.concatenate(part) for part in zip(*self._shares, strict=True))
        self._shares = [(shares[n:], fine[n:])]
        kept = max(0, self._n_before + n - OVERLAP)
        self._samples, self._n_before = self._samples[kept * HOP :], self._n_before + n - kept
        n_phonemes = len(SCORES)
        found = agreed(encoded[:, :n_phonemes], shares[:n], ENCODER_SHARE, self._penalties[:n_phonemes])
        return self._sensitivity.apply(found), agreed(
            encoded[:, n_phonemes:], fine[:n], ENCODER_SHARE, self._penalties[n_phonemes:]
        )
