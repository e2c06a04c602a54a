"""The network while it is trained: what it is to answer, its layers and heads, and the gradients of its errors.

Between the weighted sum and the rectifier of a layer the sums are normalised over the batch (S. Ioffe and C. Szegedy,
"Batch Normalization", arXiv:1502.03167); afterwards that is a factor of the weights, so
`phonemeengine.recognition.network` needs none of it. Inputs are dropped at random (N. Srivastava et al., JMLR 15,
2014).
"""

import math
from functools import partial
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.calibration.fine_tuning import HEAD_SHARES, VISEME_SHARE
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import TAPS, Layer

SMOOTHING = 0.05
"""Share of the certainty that is spread over all classes: labels lie a little beside the truth."""
TEACHER_SHARE = 0.5
"""How much the teacher counts beside a label (G. Hinton, O. Vinyals and J. Dean, "Distilling the Knowledge in a
Neural Network", arXiv:1503.02531, at the temperature 1); where there is no label, it alone counts."""


class Targets(NamedTuple):
    """What is to be answered in the frames of a batch.

    Attributes
    ----------
    wanted : probabilities, float32, shape (n_batch, n_frames, n_classes).
    weights : how much each frame counts, float32, shape (n_batch, n_frames).
    """

    wanted: Float32Array
    weights: Float32Array


def targets_of(
    codes: UInt8Array, heard: Float32Array, importance: Float32Array, certainties: Float32Array
) -> Targets:
    """Return what is to be answered of one kind of classes.

    Parameters
    ----------
    codes : of the labels, shape (n_batch, n_frames); n_classes or above where the label says nothing of this kind.
    heard : the teacher's probabilities, shape (n_batch, n_frames, n_classes); zeros where it says nothing.
    importance : how much a frame of each class counts, shape (n_classes,).
    certainties : how much each label counts, 0..1, shape (n_batch, n_frames).
    """
    n = len(importance)
    told = certainties * (codes < n)
    spoken = heard.sum(axis=2)
    taught = spoken * np.where(told > 0, TEACHER_SHARE, 1)
    labelled = told * (1 - TEACHER_SHARE * spoken)
    smoothed = np.full((n, n), SMOOTHING / n, np.float32) + (1 - SMOOTHING) * np.eye(n, dtype=np.float32)
    wanted = labelled[..., np.newaxis] * smoothed[np.minimum(codes, n - 1)] + taught[..., np.newaxis] * heard
    weights = wanted.sum(axis=2)
    wanted /= np.maximum(weights, np.float32(1e-9))[..., np.newaxis]
    meant = np.where(told > 0, np.minimum(codes, n - 1), heard.argmax(axis=2))
    return Targets(wanted.astype(np.float32), (weights * importance[meant]).astype(np.float32))


MEMORY = 0.99
"""How much of the running means stays with each batch."""
LEAST_VARIANCE = 1e-5


class TrainableLayer:
    """A layer under training.

    Parameters
    ----------
    n_in, n_out : channels.
    dilation : frames from one tap to the next.
    residual : whether it adds what it finds to what came in.
    centred : whether it looks as far ahead as back; if not, only back.
    dropout : share of the inputs that is dropped.
    generator : of the first weights, and of what is dropped.

    Attributes
    ----------
    values : the arrays that are learned, by name.
    gradients : their gradients after `back`, by the same names.
    mean, variance : running statistics of the sums, shape (n_out,).
    """

    def __init__(
        self,
        n_in: int,
        n_out: int,
        dilation: int,
        *,
        residual: bool,
        centred: bool = False,
        dropout: float,
        generator: np.random.Generator,
    ) -> None:
        spread = np.sqrt(2 / (TAPS * n_in))  # K. He et al., arXiv:1502.01852
        self.values = {
            "weights": generator.normal(0, spread, (TAPS * n_in, n_out)).astype(np.float32),
            "scale": np.full(n_out, 0.5 if residual else 1.0, np.float32),
            "shift": np.zeros(n_out, np.float32),
        }
        self.gradients: dict[str, Float32Array] = {}
        self.mean, self.variance = np.zeros(n_out, np.float32), np.ones(n_out, np.float32)
        self.dilation = dilation
        self._first = dilation if centred else (TAPS - 1) * dilation
        self._residual = residual
        self._dropout = dropout
        self._generator = generator

    def forward(self, block: Float32Array) -> Float32Array:
        """Take a batch, shape (n_batch, n_frames, n_in), and remember what `back` needs."""
        n_batch, n_frames, n_in = block.shape
        self._kept = self._keep(block.shape)
        inputs = block if self._kept is None else block * self._kept
        padded = np.zeros((n_batch, n_frames + (TAPS - 1) * self.dilation, n_in), np.float32)
        padded[:, self._first : self._first + n_frames] = inputs
        starts = [k * self.dilation for k in range(TAPS)]
        self._taps = np.concatenate([padded[:, s : s + n_frames] for s in starts], axis=2).reshape(-1, TAPS * n_in)
        sums = self._taps @ self.values["weights"]
        mean = np.full(len(sums), 1 / len(sums), np.float32) @ sums
        sums -= mean
        variance = np.einsum("ij,ij->j", sums, sums) / np.float32(len(sums))
        self.mean += (1 - MEMORY) * (mean - self.mean)
        self.variance += (1 - MEMORY) * (variance - self.variance)
        self._spread = np.sqrt(variance + LEAST_VARIANCE)
        self._normal = np.divide(sums, self._spread, out=sums)
        found = self._normal * self.values["scale"]
        found += self.values["shift"]
        np.maximum(found, 0, out=found)
        self._fires = found > 0
        out: Float32Array = found.reshape(n_batch, n_frames, -1)
        if self._residual:
            out += block
        return out

    def back(self, gradient: Float32Array) -> Float32Array:
        """Take the gradient of what `forward` gave, set `gradients`, and give the gradient of what it took."""
        n_batch, n_frames, n_out = gradient.shape
        sums = gradient.reshape(-1, n_out) * self._fires
        self.gradients["scale"] = np.einsum("ij,ij->j", sums, self._normal)
        self.gradients["shift"] = sums.sum(axis=0)
        sums -= self.gradients["shift"] / np.float32(len(sums))
        sums -= self._normal * (self.gradients["scale"] / np.float32(len(sums)))
        sums *= self.values["scale"] / self._spread
        self.gradients["weights"] = self._taps.T @ sums
        taps = (sums @ self.values["weights"].T).reshape(n_batch, n_frames, TAPS, -1)
        padded = np.zeros((n_batch, n_frames + (TAPS - 1) * self.dilation, taps.shape[3]), np.float32)
        for k in range(TAPS):
            padded[:, k * self.dilation : k * self.dilation + n_frames] += taps[:, :, k]
        block = padded[:, self._first : self._first + n_frames]
        if self._kept is not None:
            block *= self._kept
        if self._residual:
            block += gradient
        return block

    def finished(self) -> Layer:
        """Return the layer as it is used: the normalisation is part of its weights."""
        factor = self.values["scale"] / np.sqrt(self.variance + LEAST_VARIANCE)
        bias = self.values["shift"] - self.mean * factor
        return Layer(self.values["weights"] * factor, bias, self.dilation)

    def _keep(self, shape: tuple[int, ...]) -> Float32Array | None:
        """Choose what is not dropped, scaled so that the mean stays."""
        if not self._dropout:
            return None
        drawn = np.frombuffer(self._generator.bytes(math.prod(shape)), np.uint8).reshape(shape)
        n_dropped = round(256 * self._dropout)
        return (drawn >= n_dropped) * np.float32(256 / (256 - n_dropped))


MEAN, SPREAD = -6.0, 2.0
"""What the logarithms of the bands are like, so that the network sees numbers about 1."""
N_CLASSES = len(Phoneme) + len(Viseme)


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
        self,
        width: int,
        dilations: tuple[int, ...],
        dropout: float,
        generator: np.random.Generator,
        *,
        centred: bool = False,
    ) -> None:
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
