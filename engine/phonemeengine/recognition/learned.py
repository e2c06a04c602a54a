"""The learned recognisers: networks trained on many speakers, alone, with a speech encoder, or a real-time model."""

from collections.abc import Callable, Mapping, Sequence
from math import exp, log

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.dsp.framing import LEAD
from phonemeengine.dsp.mel import N_BANDS, log_mels, silent_log_mels
from phonemeengine.encoder.graph import N_HALVES
from phonemeengine.encoder.head import N_OUTPUTS, softmax
from phonemeengine.encoder.live import LOOK_AHEADS, EncoderStream, OpenEncoder
from phonemeengine.encoder.whisper import whisper_log_mels
from phonemeengine.features.variables import Features
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import ROOM, CentredNetwork, Network, forward_together
from phonemeengine.recognition.scores import (
    NO_SENSITIVITIES,
    SCORES,
    Recognition,
    ScoredRecogniser,
    Sensitivity,
    agreed,
)
from phonemeengine.settings import FRAME_PERIOD, HOP, WINDOW

# Which vocal tract fits a speaker: that with which the network is the surest of what it names.
#
# The same sound is named several times, with mel bands that are warped as if the speaker's vocal tract were longer or
# shorter (L. Lee and R. Rose, "A frequency warping approach to speaker normalization", IEEE Trans. Speech and Audio
# Processing 6(1), 1998). What they say is mixed; those that were sure count more.

MEMORY = 10.0
"""Seconds over which confidence is remembered, so that another speaker may come."""
TRUST = 0.1
"""How much a frame's confidence, a logarithm of a probability, tells about the tract: neighbouring frames say nearly
the same."""

# the evidence of n frames ago counts _KEPT to the power of n: after 10 s it is 1/e of what it was
_KEPT = exp(-FRAME_PERIOD / MEMORY)


def mixed(shares: Float32Array, weights: Float32Array) -> Float32Array:
    """Mix the probabilities of tracts, shape (n, n_tracts, n_classes), by weights (n, n_tracts): (n, n_classes)."""
    if shares.shape[1] == 1:
        return shares[:, 0]
    found: Float32Array = np.matmul(weights[:, np.newaxis], shares)
    return found[:, 0]


class VtlnMixer:
    """Weighs the answers for several vocal tracts, and remembers which of them were confident.

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
        # Evidence of a tract: the sum of the logarithms of its greatest probability in each frame, older frames
        # fading, as if the frames were independent. `TRUST` takes back what neighbouring frames repeat; the weights
        # are the posterior of the tracts, all equally likely before the sound.
        sure = np.maximum.reduce(shares, axis=2).tolist()
        silent = shares[:, :, Phoneme.SILENCE].tolist()
        evidence, weights = self._evidence, []
        for certainties, silences in zip(sure, silent, strict=True):  # one loop: a call for each frame costs as much
            if sum(silences) < shares.shape[1] / 2:
                evidence = [_KEPT * before + log(now) for before, now in zip(evidence, certainties, strict=True)]
            else:  # silence tells nothing about them
                evidence = [_KEPT * before for before in evidence]
            # less the greatest, so that no power overflows and the best one has exactly 1
            most = max(evidence)
            odds = [exp(TRUST * (known - most)) for known in evidence]
            total = sum(odds)
            weights.append([chance / total for chance in odds])
        self._evidence = evidence
        return np.array(weights, np.float32).reshape(shares.shape[:2])


NOTHING = np.zeros((0, len(SCORES)), np.float32), None
"""What is known of no frames."""


class LearnedRecogniser(ScoredRecogniser):
    """Names the likeliest phoneme; its scores are probabilities.

    Parameters
    ----------
    model : what it knows.
    look_ahead : seconds that it may wait for what comes after a frame; rounded down to what the model has. A centred
        model waits for as much context as it uses.
    sensitivities : log-odds that are added to those of phonemes, nats.

    Attributes
    ----------
    kin : equal to that of others that may be asked with it, since they differ in their sounds alone; None where it is
        asked alone, since its model is centred.
    """

    most_together = ROOM

    def __init__(
        self, model: Model, look_ahead: float, sensitivities: Mapping[Phoneme, float] = NO_SENSITIVITIES
    ) -> None:
        self.look_ahead = model.frames_ahead(look_ahead)
        # A network that looks n frames ahead answers about frame t - n when it gets frame t; its first n answers are
        # about what lay before the sound. There is a head for each n.
        self._n_early = 0 if model.centred else self.look_ahead  # a centred network itself holds its answers back
        heads = (model.heads, model.viseme_heads) if model.viseme_heads else (model.heads,)
        self._heads = tuple(known[self._n_early] for known in heads)
        self._warps = model.warps
        likes = (id(model), self.look_ahead, tuple(sorted(sensitivities.items())))
        self.kin: object | None = None if model.centred else likes
        self._model = model  # as long as it lives, no other one has its identity
        self._network = (CentredNetwork if model.centred else Network)(
            model.layers, silent_log_mels(len(model.warps))
        )
        self._mixer = VtlnMixer(len(model.warps))
        self._sensitivity = Sensitivity(sensitivities)

    def recognise(self, windows: Float32Array, _features: Features) -> Recognition:
        """Recognise the next frames; the answers are about those `look_ahead` frames before."""
        shares, visemes = self.probabilities(windows)
        return self._recognition(shares, visemes)

    def probabilities(self, windows: Float32Array) -> tuple[Float32Array, Float32Array | None]:
        """Take the next frames; return how likely phonemes and visemes are in those `look_ahead` frames before.

        Before any sensitivity acts; float32, shapes (n, 11) and (n, n_visemes), the latter None where it knows none.
        """
        if not len(windows):
            return NOTHING
        found = self._without_early(self._network.forward(self._log_mels_of(windows)))
        if not len(found):
            return NOTHING
        shares, *others = (self._probabilities_of(found, head) for head in self._heads)
        weights = self._mixer.weigh(shares)
        return mixed(shares, weights), mixed(others[0], weights) if others else None

    def _log_mels_of(self, windows: Float32Array) -> Float32Array:
        return log_mels(windows, self._warps).reshape(-1, len(self._warps), N_BANDS)

    def _without_early(self, found: Float32Array) -> Float32Array:
        """Leave out what is found before the first frames of the sound, whose answers are not needed."""
        n_early = min(self._n_early, len(found))
        self._n_early -= n_early
        return found[n_early:]

    def _recognition(self, shares: Float32Array, visemes: Float32Array | None) -> Recognition:
        scores = self._sensitivity.apply(shares)
        return Recognition(scores.argmax(axis=1).astype(np.uint8), scores, visemes, self._model.viseme_set)

    def recognise_with(
        self, others: Sequence["LearnedRecogniser"], windows: Sequence[Float32Array]
    ) -> list[Recognition]:
        """Recognise the next frames of several sounds with one network, its own first, as if each were alone.

        Parameters
        ----------
        windows : the next frames of each, its own first, at least one and `most_together`, shape (n_k, 2048).
        """
        found = self.probabilities_with(others, windows)
        return [r._recognition(*known) for r, known in zip((self, *others), found, strict=True)]

    def probabilities_with(
        self, others: Sequence["LearnedRecogniser"], windows: Sequence[Float32Array]
    ) -> list[tuple[Float32Array, Float32Array | None]]:
        """Return the same as `probabilities` for its own sound and those of others, given as to `recognise_with`."""
        recognisers = (self, *others)
        networks = [recogniser._network for recogniser in recognisers if isinstance(recogniser._network, Network)]
        # All sounds are laid one after the other for what has no memory, log mels and heads; only layers and mixers
        # keep them apart.
        ends = np.cumsum([len(block) for block in windows])[:-1]
        inputs = np.split(self._log_mels_of(np.concatenate(windows)), ends)
        found = np.split(forward_together(networks, inputs), ends)
        wanted = [recogniser._without_early(block) for recogniser, block in zip(recognisers, found, strict=True)]
        ends = np.cumsum([len(block) for block in wanted])
        if not ends[-1]:
            return [NOTHING for _ in recognisers]
        ends = ends[:-1]
        shares, *of_visemes = (self._probabilities_of(np.concatenate(wanted), head) for head in self._heads)
        weights = np.concatenate(
            [r._mixer.weigh(block) for r, block in zip(recognisers, np.split(shares, ends), strict=True)]
        )
        phonemes = np.split(mixed(shares, weights), ends)
        visemes = np.split(mixed(of_visemes[0], weights), ends) if of_visemes else [None] * len(recognisers)
        return list(zip(phonemes, visemes, strict=True))

    def _probabilities_of(self, found: Float32Array, head: OutputHead) -> Float32Array:
        """Return how likely each class of a head is with each vocal tract, shape (n, n_warps, n_classes)."""
        scores: Float32Array = found.reshape(-1, found.shape[2]).dot(head.weights)
        scores += head.bias
        # softmax, without overflow and in place: it runs for every frame and tract
        scores -= np.maximum.reduce(scores, axis=1, keepdims=True)
        np.exp(scores, out=scores)
        scores /= np.add.reduce(scores, axis=1, keepdims=True)
        return scores.reshape(len(found), len(self._warps), -1)


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


N_PHONEMES = len(SCORES)
_UNASKED = np.zeros((0, N_OUTPUTS), np.float32)


def real_time_look_ahead(look_ahead: float) -> int:
    """Return how many frames the real-time model looks ahead within a limit in seconds; never less than 2."""
    return max((n for n in LOOK_AHEADS if n * FRAME_PERIOD <= look_ahead + 1e-6), default=LOOK_AHEADS[0])


def states_ahead(look_ahead: float) -> int:
    """Return how many states the first layer of the real-time model looks ahead then, 0 or 1."""
    return LOOK_AHEADS.index(real_time_look_ahead(look_ahead))


class RealTimeRecogniser(ScoredRecogniser):
    """Names what the real-time model and the small network together find likeliest.

    Parameters
    ----------
    encoder : the real-time model.
    model : of the small network; it may hold a head that was adapted to a voice.
    look_ahead : seconds that it may wait for what comes after a frame; it waits for 20 or 40 ms.
    sensitivity : log-odds that are added in the end.
    states : of the whole sound, as `OpenEncoder.states_of` gives them, where they are known; None for what comes.

    Attributes
    ----------
    kin : see `LearnedRecogniser`.
    """

    most_together = ROOM

    def __init__(
        self,
        encoder: OpenEncoder,
        model: Model,
        look_ahead: float,
        sensitivity: Sensitivity,
        states: Float32Array | None = None,
    ) -> None:
        n_ahead = real_time_look_ahead(look_ahead)
        self._network = LearnedRecogniser(model, n_ahead * FRAME_PERIOD)
        self.look_ahead = max(n_ahead, self._network.look_ahead)
        self._encoder, self._sensitivity, self._known = encoder, sensitivity, states
        self._head = encoder.fitting(model.live_head)
        self._penalties = np.float32(encoder.mix.weakened) * np.log(np.asarray(encoder.mix.priors, np.float32))
        self._stream = EncoderStream(encoder, states_ahead(look_ahead))
        own = self._network.kin
        self.kin: object | None = None if own is None or states is not None else (id(encoder), n_ahead, own)
        self._n_early = self.look_ahead  # frames that still come before the first answer
        self._by_encoder = self._by_network = _UNASKED  # what they said of frames that have no answer yet

    def recognise(self, windows: Float32Array, _features: Features) -> Recognition:
        """Recognise the next frames; the answers are about those `look_ahead` frames before."""
        return self._joined_with([], [windows], [self._network.probabilities(windows)])[0]

    def recognise_with(
        self, others: Sequence["RealTimeRecogniser"], windows: Sequence[Float32Array]
    ) -> list[Recognition]:
        """Recognise the next frames of several sounds with one network, its own first, as if each were alone.

        Parameters
        ----------
        windows : the next frames of each, its own first, at least one and `most_together`, shape (n_k, 2048).
        """
        known = self._network.probabilities_with([other._network for other in others], windows)
        return self._joined_with(others, windows, known)

    def _joined_with(
        self,
        others: Sequence["RealTimeRecogniser"],
        windows: Sequence[Float32Array],
        by_network: Sequence[tuple[Float32Array, Float32Array | None]],
    ) -> list[Recognition]:
        """Ask the encoder about the next frames of all sounds, and join what the network said of each."""
        recognisers = (self, *others)
        if self._known is None:
            ends = np.cumsum([len(block) for block in windows])[:-1]
            logarithms = np.split(whisper_log_mels(np.concatenate(windows), self._head.warp), ends)
            states = self._encoder.encode([each._stream for each in recognisers], logarithms)
        else:
            states, self._known = [self._known], self._known[:0]  # all of them wait for what the network says
        # what has no memory is asked once for all of them
        ends = N_HALVES * np.cumsum([len(of) for of in states])[:-1]
        logits = self._head.logits(np.concatenate(states))
        said = np.concatenate((softmax(logits[:, :N_PHONEMES]), softmax(logits[:, N_PHONEMES:])), axis=1)
        told = zip(recognisers, windows, np.split(said, ends), by_network, strict=True)
        due = [each._due(len(block), by_encoder, *known) for each, block, by_encoder, known in told]
        ends = np.cumsum([len(first) for first, _ in due])[:-1]
        first, second = (np.concatenate(part) for part in zip(*due, strict=True))
        mix, parts = self._encoder.mix, (slice(None, N_PHONEMES), slice(N_PHONEMES, None))
        found = (agreed(first[:, p], second[:, p], mix.encoder_share, self._penalties[p]) for p in parts)
        split = (np.split(scores, ends) for scores in found)
        return [each._recognition(*scores) for each, *scores in zip(recognisers, *split, strict=True)]

    def _due(
        self, n_came: int, by_encoder: Float32Array, shares: Float32Array, visemes: Float32Array | None
    ) -> tuple[Float32Array, Float32Array]:
        """Return what both said of the frames whose answers are due now that `n_came` more frames came."""
        # The encoder answers for two frames at once, and either may be quicker than the other; the delay is constant.
        n_early = min(self._n_early, n_came)
        self._n_early -= n_early
        n = n_came - n_early
        fine = np.ones((len(shares), N_OUTPUTS - N_PHONEMES), np.float32) if visemes is None else visemes
        self._by_encoder = np.concatenate((self._by_encoder, by_encoder))
        self._by_network = np.concatenate((self._by_network, np.concatenate((shares, fine), axis=1)))
        first, second = self._by_encoder[:n], self._by_network[:n]
        self._by_encoder, self._by_network = self._by_encoder[n:], self._by_network[n:]
        return first, second

    def _recognition(self, phonemes: Float32Array, visemes: Float32Array) -> Recognition:
        scores = self._sensitivity.apply(phonemes)
        return Recognition(scores.argmax(axis=1).astype(np.uint8), scores, visemes)
