"""AdamW with one cycle of the learning rate, and a slow average of all that was learned."""

import math

import numpy as np

from phonemeengine.arrays import Float32Array

FIRST, SECOND = 0.9, 0.999
DECAY = 0.01
CLIP = 1.0
WARM_UP = 0.15
"""Share of the steps in which the rate rises."""
AVERAGED = 300
"""Steps over which the average reaches back, about."""


class Optimiser:
    """Improves arrays in place (I. Loshchilov and F. Hutter, arXiv:1711.05101).

    Parameters
    ----------
    values : the arrays.
    n_steps : how many steps there will be.
    rate : the highest learning rate.
    """

    def __init__(self, values: list[Float32Array], n_steps: int, rate: float) -> None:
        self._values = values
        self._first = [np.zeros_like(v) for v in values]
        self._second = [np.zeros_like(v) for v in values]
        self._n_steps = n_steps
        self._rate = rate
        self.n_done = 0

    @property
    def moments(self) -> list[Float32Array]:
        """What it remembers of the gradients, besides `n_done`, the number of its steps."""
        return [*self._first, *self._second]

    def step(self, gradients: list[Float32Array]) -> None:
        """Go one step down the gradients, which are clipped to a length of 1 together."""
        length = math.sqrt(sum(float(np.vdot(g, g)) for g in gradients))
        clip = min(1.0, CLIP / max(length, 1e-12))
        self.n_done += 1
        rate = self._rate * _cycle(self.n_done / self._n_steps)
        debias = math.sqrt(1 - SECOND**self.n_done) / (1 - FIRST**self.n_done)
        for value, first, second, gradient in zip(self._values, self._first, self._second, gradients, strict=True):
            clipped = gradient * np.float32(clip)
            np.add(first, np.float32(1 - FIRST) * (clipped - first), out=first)
            np.add(second, np.float32(1 - SECOND) * (clipped * clipped - second), out=second)
            if value.ndim > 1:
                np.multiply(value, np.float32(1 - rate * DECAY), out=value)
            step = np.float32(rate * debias) * first / (np.sqrt(second) + np.float32(1e-8))
            np.subtract(value, step, out=value)


class ExponentialAverage:
    """A slow average of arrays (B. Polyak and A. Juditsky, SIAM J. Control Optim. 30(4), 1992)."""

    def __init__(self, values: list[Float32Array]) -> None:
        self._values = values
        self.means = [v.copy() for v in values]
        self.n_done = 0

    def update(self) -> None:
        """Take in what the arrays are now."""
        self.n_done += 1
        share = np.float32(max(1 / AVERAGED, 10 / (self.n_done + 10)))
        for mean, value in zip(self.means, self._values, strict=True):
            np.add(mean, share * (value - mean), out=mean)

    def apply(self) -> None:
        """Write the averages into the arrays."""
        for mean, value in zip(self.means, self._values, strict=True):
            value[...] = mean


def _cycle(progress: float) -> float:
    """Return the share of the highest rate: it rises, and falls to almost nothing, both like a cosine."""
    if progress < WARM_UP:
        return 0.04 + 0.96 * (0.5 - 0.5 * math.cos(math.pi * progress / WARM_UP))
    return 1e-4 + 0.5 + 0.5 * math.cos(math.pi * min(1.0, (progress - WARM_UP) / (1 - WARM_UP)))
