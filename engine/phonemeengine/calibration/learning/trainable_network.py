"""The whole network while it is trained: layers, heads, and what is wrong with its answers."""

from functools import partial

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.learning.targets import Targets
from phonemeengine.calibration.learning.trainable_layer import TrainableLayer
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.visemes import Viseme

MEAN, SPREAD = -6.0, 2.0
"""What the logarithms of the bands are like, so that the network sees numbers about 1."""
VISEME_SHARE = 0.5
"""How much the visemes count, beside the phonemes."""
N_CLASSES = len(Phoneme) + len(Viseme)
HEAD_SHARES = np.array([0.11, 0.11, 0.15, 0.15, 0.15, 0.33], np.float32)
"""How much each look-ahead counts in the training; the network that hears both ways has one answer."""


class TrainableNetwork:
    """A network under training.

    Parameters
    ----------
    width : channels.
    dilations : of the layers after the first.
    centred : whether it looks as far ahead as back.
    dropout : share of the inputs of each layer that is dropped.
    generator : of all chance.
    """

    def __init__(
        self, width: int, dilations: tuple[int, ...], dropout: float, generator: np.random.Generator, *,
        centred: bool = False,
    ) -> None:  # fmt: skip
        layer = partial(TrainableLayer, centred=centred, generator=generator)
        first = layer(N_BANDS, width, 1, residual=False, dropout=0.0)
        others = [layer(width, width, d, residual=True, dropout=dropout) for d in dilations]
        self._layers = [first, *others]
        self._centred = centred
        self._shares = np.ones(1, np.float32) if centred else HEAD_SHARES
        spread = np.sqrt(1 / width)
        self._heads = {
            "weights": generator.normal(0, spread, (width, len(self._shares) * N_CLASSES)).astype(np.float32),
            "bias": np.zeros(len(self._shares) * N_CLASSES, np.float32),
        }
        self._head_gradients: dict[str, Float32Array] = {}

    @property
    def values(self) -> list[Float32Array]:
        """All arrays that are learned."""
        return [v for layer in self._layers for v in layer.values.values()] + [*self._heads.values()]

    @property
    def hidden(self) -> set[int]:
        """The positions in `values` of the matrices between hidden layers."""
        names = [name for layer in self._layers for name in layer.values]
        return {k for k, name in enumerate(names) if name == "weights"} - {0}

    @property
    def gradients(self) -> list[Float32Array]:
        """The gradients of `values` after `learn`."""
        ordered = [layer.gradients[name] for layer in self._layers for name in layer.values]
        return ordered + [self._head_gradients[name] for name in self._heads]

    @property
    def statistics(self) -> list[Float32Array]:
        """The running statistics, which are followed, not learned."""
        return [array for layer in self._layers for array in (layer.mean, layer.variance)]

    def learn(self, log_mels: Float32Array, phonemes: Targets, visemes: Targets) -> float:
        """Go forth and back through a batch, and leave the gradients; returns the loss.

        Parameters
        ----------
        log_mels : float32, shape (n_batch, n_frames, 40).
        phonemes, visemes : what is to be answered in those frames.
        """
        hidden = (log_mels - np.float32(MEAN)) / np.float32(SPREAD)
        for layer in self._layers:
            hidden = layer.forward(hidden)
        flat = hidden.reshape(-1, hidden.shape[2])
        sums = flat @ self._heads["weights"] + self._heads["bias"]
        scores = sums.reshape(*log_mels.shape[:2], len(self._shares), -1)
        n = len(Phoneme)
        loss, gradient = _loss_of(scores[..., :n], phonemes, self._shares)
        viseme_loss, viseme_gradient = _loss_of(scores[..., n:], visemes, VISEME_SHARE * self._shares)
        sums = np.concatenate((gradient, viseme_gradient), axis=3).reshape(len(flat), -1)
        self._head_gradients = {"weights": np.asarray(flat.T @ sums, np.float32), "bias": sums.sum(axis=0)}
        back = (sums @ self._heads["weights"].T).reshape(hidden.shape)
        for layer in reversed(self._layers):
            back = layer.back(back)
        return loss + viseme_loss

    def finished(self) -> Model:
        """Return the model as it is used, rounded to what its file holds."""
        layers = [layer.finished() for layer in self._layers]
        weights, bias = layers[0].weights, layers[0].bias
        scaled = weights / np.float32(SPREAD)
        layers[0] = type(layers[0])(scaled, bias - np.float32(MEAN) * scaled.sum(axis=0), layers[0].dilation)
        heads, viseme_heads = (
            tuple(self._head(k, first, last) for k in range(len(self._shares))) for first, last in _CLASSES
        )
        return Model(tuple(layers), heads, viseme_heads=viseme_heads, centred=self._centred).rounded()

    def _head(self, k: int, first: int, last: int) -> OutputHead:
        """Return what the head of a look-ahead of k frames says of some classes."""
        columns = slice(k * N_CLASSES + first, k * N_CLASSES + last)
        return OutputHead(self._heads["weights"][:, columns], self._heads["bias"][columns])


_CLASSES = ((0, len(Phoneme)), (len(Phoneme), N_CLASSES))
"""First class and the end of the phonemes, and of the visemes."""


def _loss_of(scores: Float32Array, targets: Targets, shares: Float32Array) -> tuple[float, Float32Array]:
    """Return the cross-entropy of all heads and its gradient; head k answers at frame t for frame t - k."""
    n_frames = scores.shape[1]
    gradient = np.zeros_like(scores)
    loss = 0.0
    for k, share in enumerate(shares):
        logits, wanted = scores[:, k:, k], targets.wanted[:, : n_frames - k]
        counted = targets.weights[:, : n_frames - k, np.newaxis]
        logarithms = logits - logits.max(axis=2, keepdims=True)
        logarithms -= np.log(np.exp(logarithms).sum(axis=2, keepdims=True))
        counted = counted * (share / max(float(counted.sum()), 1e-9))
        loss -= float((counted * wanted * logarithms).sum())
        gradient[:, k:, k] = counted * (np.exp(logarithms) - wanted)
    return loss, gradient
