"""One layer of the network while it is trained: forward with memory, and back with gradients.

Between the weighted sum and the rectifier the sums are normalised over the batch (S. Ioffe and C. Szegedy, "Batch
Normalization", arXiv:1502.03167); afterwards that is a factor of the weights, so
`phonemeengine.recognition.network` needs none of it. Inputs are dropped at random (N. Srivastava
et al., JMLR 15, 2014).
"""

import math

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.recognition.network import TAPS, Layer

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
        self, n_in: int, n_out: int, dilation: int, *, residual: bool, centred: bool = False, dropout: float,
        generator: np.random.Generator,
    ) -> None:  # fmt: skip
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
