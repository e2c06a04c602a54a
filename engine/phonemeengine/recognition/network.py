"""A convolutional network over time, evaluated with NumPy alone, as the sound comes.

The architecture is that of S. Bai, J. Kolter and V. Koltun, "An Empirical Evaluation of Generic Convolutional and
Recurrent Networks for Sequence Modeling" (arXiv:1803.01271), reduced: each layer looks at three frames and adds what
it finds to what came in. In a causal network they are the newest frame and those one and two dilations back; in a
centred one, which is for sounds that are wholly known, the frame itself and those one dilation before and after it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from timeit import repeat

import numpy as np
from numpy.lib.stride_tricks import as_strided

from phonemeengine.arrays import Float32Array, ShortRepr

TAPS = 3
"""Frames that a layer looks at."""
ROOM = 64
"""Frames for which a layer keeps room, so that what it remembers is moved seldom."""
FEW = 4
"""Up to this many frames are worked on one by one: a matrix of all of them costs more."""
CLEARLY = 0.85
"""Part of the time that is clearly less."""
ZERO = np.zeros((), np.float32)


@dataclass(frozen=True, eq=False, repr=False)
class Layer(ShortRepr):
    """One layer: a rectified weighted sum of three frames.

    Attributes
    ----------
    weights : float32, shape (3 x n_in, n_out): of the oldest frame first.
    bias : float32, shape (n_out,).
    dilation : frames from one tap to the next.
    """

    weights: Float32Array
    bias: Float32Array
    dilation: int

    @property
    def reach(self) -> int:
        """Frames before the newest one that it uses."""
        return (TAPS - 1) * self.dilation


@lru_cache(maxsize=1)
def vectors_pay() -> bool:
    """Return whether a matrix of a frame's vocal tracts costs more than as many vectors, as measured once.

    It costs twice as much with OpenBLAS on processors with AVX2, and two thirds of it on those with AVX-512. Where
    both are about equal, the answer is yes, so that it is the same in all processes.
    """
    rows, weights = np.ones((3, 1, 384), np.float32), np.ones((384, 128), np.float32)
    as_vectors, as_matrix = partial(np.matmul, rows, weights), partial(np.dot, rows[:, 0], weights)
    return min(repeat(as_matrix, number=4)) > CLEARLY * min(repeat(as_vectors, number=4))


class StreamingLayer:
    """One layer at work: remembers the frames that it uses again.

    Parameters
    ----------
    layer : the layer.
    before : what lay before the sound, shape (n_in,); or (n_lanes, n_in), where several sounds of equal length are
        worked on side by side.
    pay : see `vectors_pay`.
    """

    def __init__(self, layer: Layer, before: Float32Array, pay: Callable[[], bool] = vectors_pay) -> None:
        self._vectors_pay = pay
        self._weights, self._bias = layer.weights, layer.bias
        self._reach, self._step = layer.reach, layer.dilation
        # A layer with the dilation d uses 2 d frames of the past and no more, so these are all it has to keep: a
        # new frame costs one product, however long the sound is. There is room for more, so that the kept frames are
        # moved to the front once in `ROOM` frames only.
        self._seen = np.empty((self._reach + ROOM, *before.shape), np.float32)
        self._seen[: self._reach] = before
        # made once, since building a view takes some microseconds each time
        self._taps = _taps_of(self._seen, self._step)
        self._end = self._reach

    def forward(self, block: Float32Array) -> Float32Array:
        """Take the next frames, shape (n, ..., n_in), and give what it finds in them, shape (n, ..., n_out)."""
        found = self._few(block) if len(block) <= FEW else self._many(block)
        found += self._bias
        return np.maximum(found, ZERO, out=found)

    def remember(self, block: Float32Array) -> Float32Array:
        """Take the next frames, `ROOM` at the most, without an answer.

        Returns
        -------
        float32, shape (n, ..., 3, n_in): for each of them the frames that an answer looks at, as a view that holds
        until the next frames are taken.
        """
        # the view below is over this buffer, so what is remembered is never copied to be worked on
        n, seen, end = len(block), self._seen, self._end
        if end + n > len(seen):
            seen[: self._reach] = seen[end - self._reach : end]
            end = self._reach
        first, self._end = end - self._reach, end + n
        seen[end : end + n] = block
        return self._taps[first : first + n]

    def answers(self, taps: Float32Array) -> Float32Array:
        """Return what the layer finds in frames as `remember` gives them, shape (n, ..., n_out)."""
        found: Float32Array = taps.reshape(-1, len(self._weights)).dot(self._weights)
        found += self._bias
        np.maximum(found, ZERO, out=found)
        return found.reshape(*taps.shape[:-2], -1)

    def _few(self, block: Float32Array) -> Float32Array:
        """Work on each frame alone, so that its answer is the same to the last bit however many come."""
        # A product of matrices adds in another order for another number of rows, and then the last bits depend on how
        # the sound was cut. One product for each frame, stacked, always adds in the same order.
        n = block[..., 0].size if self._vectors_pay() else len(block)
        found: Float32Array = np.matmul(self.remember(block).reshape(n, -1, len(self._weights)), self._weights)
        return found.reshape(*block.shape[:-1], -1)

    def _many(self, block: Float32Array) -> Float32Array:
        n = len(block)
        seen = np.concatenate((self._seen[self._end - self._reach : self._end], block))
        self._seen[: self._reach], self._end = seen[n:], self._reach
        found: Float32Array = _taps_of(seen, self._step).reshape(-1, len(self._weights)).dot(self._weights)
        return found.reshape(*block.shape[:-1], -1)


def _taps_of(seen: Float32Array, step: int) -> Float32Array:
    """Return a view of frames with those side by side that an answer looks at, shape (n, ..., 3, n_in)."""
    # The taps of an answer are `step` frames apart: frames are rows of one block of memory, so strides say it without
    # a copy. Read-only, since all answers share the frames.
    n_answers, (frame, *lanes, value) = len(seen) - (TAPS - 1) * step, seen.strides
    shape = (n_answers, *seen.shape[1:-1], TAPS, seen.shape[-1])
    return as_strided(seen, shape, (frame, *lanes, step * frame, value), writeable=False)


class CentredLayer:
    """One layer of a centred network at work: it waits for the frames after each, and so gives fewer at first.

    Parameters
    ----------
    layer : the layer.
    before : as of `StreamingLayer`.
    adds : whether it adds what it finds to what came in.
    """

    def __init__(self, layer: Layer, before: Float32Array, *, adds: bool) -> None:
        self._layer, self._adds = layer, adds
        self._seen = np.repeat(before[np.newaxis], layer.dilation, axis=0)

    def forward(self, block: Float32Array) -> Float32Array:
        """Take the next n frames, and give the answers for the frames that lie `dilation` before them."""
        # An answer for frame t needs t - d, t and t + d; it can be given when t + d has come, and what came in is
        # added to it from d frames back.
        layer, seen = self._layer, np.concatenate((self._seen, block))
        n = max(0, len(seen) - layer.reach)
        self._seen = seen[n:]
        found = np.empty((n, *block.shape[1:-1], len(layer.bias)), np.float32)
        if n:
            taps = _taps_of(seen, layer.dilation).reshape(-1, len(layer.weights))
            np.dot(taps, layer.weights, out=found.reshape(len(taps), -1))
            found += layer.bias
            np.maximum(found, ZERO, out=found)
        if self._adds:
            found += seen[layer.dilation : layer.dilation + n]
        return found


class Network:
    """A stack of layers at work; every layer but the first adds what it finds to what came in.

    Parameters
    ----------
    layers : the layers, the first one on the input.
    before : the input before the sound began, shape (n_in,); or (n_lanes, n_in), see `StreamingLayer`.
    pay : see `vectors_pay`.

    Attributes
    ----------
    stack : the layers at work.
    """

    def __init__(
        self, layers: tuple[Layer, ...], before: Float32Array, pay: Callable[[], bool] = vectors_pay
    ) -> None:
        # Before the sound the first layer sees silence and all others see zeros, as where the training pads.
        nothing = np.zeros((*before.shape[:-1], len(layers[0].bias)), np.float32)
        self.stack = [StreamingLayer(layer, nothing if k else before, pay) for k, layer in enumerate(layers)]

    def forward(self, block: Float32Array) -> Float32Array:
        """Take the next frames, shape (n, ..., n_in), and give what the last layer makes of them, (n, ..., n_out)."""
        # The first layer changes the width from bands to channels, so there is nothing of equal shape to add to it.
        # All others learn what to add (residual connections, K. He et al., arXiv:1512.03385).
        hidden = self.stack[0].forward(block)
        for layer in self.stack[1:]:
            found = layer.forward(hidden)
            found += hidden
            hidden = found
        return hidden


def forward_together(networks: Sequence[Network], blocks: Sequence[Float32Array]) -> Float32Array:
    """Return what networks of the same layers find in the next frames of a sound each, one after the other.

    One matrix of many rows costs a fraction of as many of a few.

    Parameters
    ----------
    networks : at work, each on its own sound.
    blocks : the next frames of each, at least one and `ROOM` at the most, shape (n_k, ..., n_in).

    Returns
    -------
    float32, shape (sum of n_k, ..., n_out).
    """
    ends = np.cumsum([len(block) for block in blocks]).tolist()
    places = [slice(end - len(block), end) for end, block in zip(ends, blocks, strict=True)]
    hidden: Float32Array = np.concatenate(blocks)
    for number, layers in enumerate(zip(*(network.stack for network in networks), strict=True)):
        found = layers[0].answers(
            np.concatenate([layer.remember(hidden[at]) for layer, at in zip(layers, places, strict=True)])
        )
        if number:
            found += hidden
        hidden = found
    return hidden


class CentredNetwork:
    """The same of centred layers: it gives no answers for the sum of the dilations, then one for each frame.

    Before the sound no layer has found anything, which is what the training pads with. After its end silence follows.

    Parameters
    ----------
    layers, before : as of `Network`.
    """

    def __init__(self, layers: tuple[Layer, ...], before: Float32Array) -> None:
        nothing = np.zeros((*before.shape[:-1], len(layers[0].bias)), np.float32)
        self._stack = [CentredLayer(layer, nothing if k else before, adds=k > 0) for k, layer in enumerate(layers)]

    def forward(self, block: Float32Array) -> Float32Array:
        """Take the next frames, shape (n, ..., n_in), and give what the last layer makes of earlier ones."""
        for layer in self._stack:
            block = layer.forward(block)
        return block
