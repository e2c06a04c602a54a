"""A causal convolutional network over time, evaluated with NumPy alone, as the sound comes.

The architecture is that of S. Bai, J. Kolter and V. Koltun, "An Empirical Evaluation of Generic Convolutional and
Recurrent Networks for Sequence Modeling" (arXiv:1803.01271), reduced: each layer looks at three frames, the newest
one and those one and two dilations back, and adds what it finds to what came in.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Block = NDArray[np.float32]

TAPS = 3
"""Frames that a layer looks at."""
ROOM = 64
"""Frames for which a layer keeps room, so that what it remembers is moved seldom."""


@dataclass(frozen=True, eq=False)
class Layer:
    """One layer: a rectified weighted sum of three frames.

    Attributes
    ----------
    weights : float32, shape (3 x n_in, n_out): of the oldest frame first.
    bias : float32, shape (n_out,).
    dilation : frames from one tap to the next.
    """

    weights: Block
    bias: Block
    dilation: int

    @property
    def reach(self) -> int:
        """Frames before the newest one that it looks back to."""
        return (TAPS - 1) * self.dilation


class Delayed:
    """One layer at work: remembers the frames that it looks back to.

    Parameters
    ----------
    layer : the layer.
    before : what lay before the sound, shape (n_in,).
    """

    def __init__(self, layer: Layer, before: Block) -> None:
        self._layer = layer
        self._reach, self._step = layer.reach, layer.dilation
        self._seen = np.empty((self._reach + ROOM, len(before)), np.float32)
        self._seen[: self._reach] = before
        self._end = self._reach

    def push(self, block: Block) -> Block:
        """Take the next frames, shape (n, n_in), and give what it finds in them, shape (n, n_out)."""
        first = self._end - self._reach
        last = self._end + len(block)
        if last > len(self._seen):
            self._seen = np.concatenate((self._seen[first : self._end], block, self._seen[:ROOM]))
            first, last = 0, self._reach + len(block)
        else:
            self._seen[self._end : last] = block
        self._end = last
        found: Block = self._taps(first, last).dot(self._layer.weights)
        found += self._layer.bias
        return np.maximum(found, 0, out=found)

    def _taps(self, first: int, last: int) -> Block:
        """Put the frames that each answer looks at beside each other, shape (n, 3 x n_in)."""
        seen, step = self._seen, self._step
        if last - first == self._reach + 1:
            return seen[first:last:step].reshape(1, -1)
        n = last - first - self._reach
        starts = range(first, last - n + 1, step)
        return np.concatenate([seen[k : k + n] for k in starts], axis=1)


class Network:
    """A stack of layers at work; every layer but the first adds what it finds to what came in.

    Parameters
    ----------
    layers : the layers, the first one on the input.
    before : the input before the sound began, shape (n_in,).
    """

    def __init__(self, layers: tuple[Layer, ...], before: Block) -> None:
        nothing = np.zeros(layers[0].bias.shape, np.float32)
        self._stack = [Delayed(layer, nothing if k else before) for k, layer in enumerate(layers)]

    def push(self, block: Block) -> Block:
        """Take the next frames, shape (n, n_in), and give what the last layer makes of them, shape (n, n_out)."""
        hidden = self._stack[0].push(block)
        for layer in self._stack[1:]:
            found = layer.push(hidden)
            found += hidden
            hidden = found
        return hidden
