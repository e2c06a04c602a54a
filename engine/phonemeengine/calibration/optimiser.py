"""Muon and AdamW with one cycle of the learning rate."""

import math
from collections.abc import Collection

import numpy as np

from phonemeengine.arrays import Float32Array

FIRST, SECOND = 0.9, 0.999
DECAY = 0.01
CLIP = 1.0
WARM_UP = 0.15
"""Share of the steps in which the rate rises."""
MOMENTUM = 0.95
"""Of Muon."""
FASTER = 7.5
"""How much higher the rate of Muon is than that of AdamW, for steps of the same mean square."""
NEWTON_SCHULZ = (3.4445, -4.7750, 2.0315)
"""Coefficients of the polynomial that draws singular values towards 1."""
N_ITERATIONS = 5


class Optimiser:
    """Improves arrays in place.

    Matrices between hidden layers go along their momentum made orthogonal (K. Jordan et al., "Muon: An optimizer for
    hidden layers in neural networks", 2024; the length of its steps as in J. Liu et al., arXiv:2502.16982), all else
    as AdamW has it (I. Loshchilov and F. Hutter, arXiv:1711.05101).

    Parameters
    ----------
    values : the arrays.
    n_steps : how many steps there will be.
    rate : the highest learning rate of AdamW.
    hidden : positions of the matrices between hidden layers.
    """

    def __init__(
        self, values: list[Float32Array], n_steps: int, rate: float, hidden: Collection[int] = ()
    ) -> None:  # fmt: skip
        self._values = values
        self._first = [np.zeros_like(v) for v in values]
        self._second = {k: np.zeros_like(v) for k, v in enumerate(values) if k not in hidden}
        self._n_steps = n_steps
        self._rate = rate
        self.n_done = 0

    @property
    def moments(self) -> list[Float32Array]:
        """What it remembers of the gradients, besides `n_done`, the number of its steps."""
        return [*self._first, *self._second.values()]

    def step(self, gradients: list[Float32Array]) -> None:
        """Go one step down the gradients, which are clipped to a length of 1 together."""
        length = math.sqrt(sum(float(np.vdot(g, g)) for g in gradients))
        clip = np.float32(min(1.0, CLIP / max(length, 1e-12)))
        self.n_done += 1
        rate = self._rate * _cycle(self.n_done / self._n_steps)
        for k, (value, gradient) in enumerate(zip(self._values, gradients, strict=True)):
            if k in self._second:
                step, decay = rate * self._adam(k, gradient * clip), rate * DECAY * (value.ndim > 1)
            else:
                step, decay = FASTER * rate * self._muon(k, gradient), FASTER * rate * DECAY
            np.multiply(value, np.float32(1 - decay), out=value)
            np.subtract(value, step, out=value, casting="same_kind")

    def _adam(self, k: int, gradient: Float32Array) -> Float32Array:
        first, second = self._first[k], self._second[k]
        np.add(first, np.float32(1 - FIRST) * (gradient - first), out=first)
        np.add(second, np.float32(1 - SECOND) * (gradient * gradient - second), out=second)
        debias = np.float32(math.sqrt(1 - SECOND**self.n_done) / (1 - FIRST**self.n_done))
        return np.asarray(debias * first / (np.sqrt(second) + np.float32(1e-8)), np.float32)

    def _muon(self, k: int, gradient: Float32Array) -> Float32Array:
        momentum = self._first[k]
        np.add(np.float32(MOMENTUM) * momentum, gradient, out=momentum)
        direction = orthogonalised(gradient + np.float32(MOMENTUM) * momentum)
        return direction * np.float32(0.2 * math.sqrt(max(direction.shape)))


def orthogonalised(matrix: Float32Array) -> Float32Array:
    """Return a matrix with the singular vectors of another one, and singular values of about 1 (0.7 to 1.2).

    By an iteration of Newton and Schulz with the coefficients of K. Jordan (2024).
    """
    wide = matrix if matrix.shape[0] <= matrix.shape[1] else matrix.T
    found = wide / (np.linalg.norm(wide) + np.float32(1e-7))
    a, b, c = (np.float32(x) for x in NEWTON_SCHULZ)
    for _ in range(N_ITERATIONS):
        square = found @ found.T
        found = a * found + (b * square + c * (square @ square)) @ found
    return np.asarray(found if wide is matrix else found.T, np.float32)


def _cycle(progress: float) -> float:
    """Return the share of the highest rate: it rises, and falls to almost nothing, both like a cosine."""
    if progress < WARM_UP:
        return 0.04 + 0.96 * (0.5 - 0.5 * math.cos(math.pi * progress / WARM_UP))
    return 1e-4 + 0.5 + 0.5 * math.cos(math.pi * min(1.0, (progress - WARM_UP) / (1 - WARM_UP)))
