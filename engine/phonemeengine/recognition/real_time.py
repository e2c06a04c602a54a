"""The recogniser of live sound that asks the real-time model and the small network together."""

from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.encoder.graph import N_HALVES
from phonemeengine.encoder.head import N_OUTPUTS, softmax
from phonemeengine.encoder.live import LOOK_AHEADS, EncoderStream, OpenEncoder
from phonemeengine.encoder.whisper import whisper_log_mels
from phonemeengine.features.measure import Features
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.network import ROOM
from phonemeengine.recognition.scores import SCORES, Recognition, ScoredRecogniser, Sensitivity, agreed
from phonemeengine.settings import FRAME_PERIOD

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
