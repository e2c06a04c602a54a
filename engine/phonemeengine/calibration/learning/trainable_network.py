"""The whole network while it is trained: layers, heads, and what is wrong with its answers."""

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.calibration.learning.trainable_layer import TrainableLayer
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import MOST_FRAMES_AHEAD, Model, OutputHead
from phonemeengine.visemes import NO_VISEME, Viseme

N_HEADS = MOST_FRAMES_AHEAD + 1
MEAN, SPREAD = -6.0, 2.0
"""What the logarithms of the bands are like, so that the network sees numbers about 1."""
SMOOTHING = 0.05
"""Share of the certainty that is spread over all phonemes: labels lie a little beside the truth."""
VISEME_SHARE = 0.5
"""How much the visemes count, beside the phonemes."""
N_CLASSES = len(Phoneme) + len(Viseme)
HEAD_SHARES = np.array([0.11, 0.11, 0.15, 0.15, 0.15, 0.33], np.float32)
"""How much each look-ahead counts in the training."""


class TrainableNetwork:
    """A network under training.

    Parameters
    ----------
    width : channels.
    dilations : of the layers after the first.
    dropout : share of the inputs of each layer that is dropped.
    generator : of all chance.
    """

    def __init__(
        self, width: int, dilations: tuple[int, ...], dropout: float, generator: np.random.Generator
    ) -> None:
        first = TrainableLayer(N_BANDS, width, 1, residual=False, dropout=0.0, generator=generator)
        others = [
            TrainableLayer(width, width, d, residual=True, dropout=dropout, generator=generator) for d in dilations
        ]
        self._layers = [first, *others]
        spread = np.sqrt(1 / width)
        self._heads = {
            "weights": generator.normal(0, spread, (width, N_HEADS * N_CLASSES)).astype(np.float32),
            "bias": np.zeros(N_HEADS * N_CLASSES, np.float32),
        }
        self._head_gradients: dict[str, Float32Array] = {}

    @property
    def values(self) -> list[Float32Array]:
        """All arrays that are learned."""
        return [v for layer in self._layers for v in layer.values.values()] + [*self._heads.values()]

    @property
    def gradients(self) -> list[Float32Array]:
        """The gradients of `values` after `learn`."""
        ordered = [layer.gradients[name] for layer in self._layers for name in layer.values]
        return ordered + [self._head_gradients[name] for name in self._heads]

    @property
    def statistics(self) -> list[Float32Array]:
        """The running statistics, which are followed, not learned."""
        return [array for layer in self._layers for array in (layer.mean, layer.variance)]

    def learn(
        self, log_mels: Float32Array, truth: UInt8Array, visemes: UInt8Array, weights: Float32Array
    ) -> float:  # fmt: skip
        """Go forth and back through a batch, and leave the gradients; returns the loss.

        Parameters
        ----------
        log_mels : float32, shape (n_batch, n_frames, 40).
        truth : codes of `Phoneme`, shape (n_batch, n_frames).
        visemes : codes of `Viseme`, or `NO_VISEME`, shape (n_batch, n_frames).
        weights : how much each frame counts, shape (n_batch, n_frames).
        """
        hidden = (log_mels - np.float32(MEAN)) / np.float32(SPREAD)
        for layer in self._layers:
            hidden = layer.forward(hidden)
        flat = hidden.reshape(-1, hidden.shape[2])
        scores = (flat @ self._heads["weights"] + self._heads["bias"]).reshape(*truth.shape, N_HEADS, -1)
        n, seen = len(Phoneme), visemes != NO_VISEME
        loss, gradient = _loss_of(scores[..., :n], truth, weights)
        viseme_loss, viseme_gradient = _loss_of(scores[..., n:], np.where(seen, visemes, 0), weights * seen)
        loss += VISEME_SHARE * viseme_loss
        sums = np.concatenate((gradient, VISEME_SHARE * viseme_gradient), axis=3).reshape(len(flat), -1)
        self._head_gradients = {"weights": np.asarray(flat.T @ sums, np.float32), "bias": sums.sum(axis=0)}
        back = (sums @ self._heads["weights"].T).reshape(hidden.shape)
        for layer in reversed(self._layers):
            back = layer.back(back)
        return loss

    def finished(self) -> Model:
        """Return the model as it is used, rounded to what its file holds."""
        layers = [layer.finished() for layer in self._layers]
        weights, bias = layers[0].weights, layers[0].bias
        scaled = weights / np.float32(SPREAD)
        layers[0] = type(layers[0])(scaled, bias - np.float32(MEAN) * scaled.sum(axis=0), layers[0].dilation)
        heads, viseme_heads = (tuple(self._head(k, first, last) for k in range(N_HEADS)) for first, last in _CLASSES)
        return Model(tuple(layers), heads, viseme_heads=viseme_heads).rounded()

    def _head(self, k: int, first: int, last: int) -> OutputHead:
        """Return what the head of a look-ahead of k frames says of some classes."""
        columns = slice(k * N_CLASSES + first, k * N_CLASSES + last)
        return OutputHead(self._heads["weights"][:, columns], self._heads["bias"][columns])


_CLASSES = ((0, len(Phoneme)), (len(Phoneme), N_CLASSES))
"""First class and the end of the phonemes, and of the visemes."""


def _loss_of(scores: Float32Array, truth: UInt8Array, weights: Float32Array) -> tuple[float, Float32Array]:
    """Return the cross-entropy of all heads and its gradient; head k answers at frame t for frame t - k."""
    n_frames, n = truth.shape[1], scores.shape[3]
    gradient = np.zeros_like(scores)
    loss = 0.0
    for k in range(N_HEADS):
        logits, labels = scores[:, k:, k], truth[:, : n_frames - k]
        counted = weights[:, : n_frames - k, np.newaxis]
        logarithms = logits - logits.max(axis=2, keepdims=True)
        logarithms -= np.log(np.exp(logarithms).sum(axis=2, keepdims=True))
        wanted = np.full((n, n), SMOOTHING / n, np.float32) + (1 - SMOOTHING) * np.eye(n, dtype=np.float32)
        wanted = wanted[labels]
        share = HEAD_SHARES[k] / max(float(counted.sum()), 1e-9)
        loss -= share * float((counted * wanted * logarithms).sum())
        gradient[:, k:, k] = share * counted * (np.exp(logarithms) - wanted)
    return loss, gradient
