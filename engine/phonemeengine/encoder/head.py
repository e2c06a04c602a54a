"""The head on an encoder: phonemes and visemes, every 10 ms, from its states. NumPy alone."""

from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from typing_extensions import override

from phonemeengine.arrays import Float32Array, ShortRepr
from phonemeengine.encoder.weights import N_STATES, OUTPUT
from phonemeengine.encoder.whisper import LAYER
from phonemeengine.errors import ModelError
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import arrays_in_npz, atomic_write, reason_of

FORMAT = 2
LARGEST_FILE = 4 << 20
CONTEXT = (-2, -1, 0, 1, 2)
"""Neighbouring frames of 20 ms at which it looks."""
HALVES = 2
"""Frames of 10 ms in one of the encoder's."""
N_OUTPUTS = len(Phoneme) + len(Viseme)
SHAPES = {
    "mean": (N_STATES,),
    "projection": (N_STATES, None),
    "hidden_weights": (None, None),
    "hidden_bias": (None,),
    "weights": (None, HALVES * N_OUTPUTS),
    "bias": (HALVES * N_OUTPUTS,),
    "priors": (N_OUTPUTS,),
}


@dataclass(frozen=True, eq=False, repr=False)
class EncoderHead(ShortRepr):
    """One hidden layer on neighbouring, projected states.

    Attributes
    ----------
    mean : of the states, float32, shape (512,).
    projection : onto their principal components, scaled to a spread of 1, shape (512, n_components).
    hidden_weights, hidden_bias : shapes (5 x n_components, n_hidden) and (n_hidden,).
    weights, bias : shapes (n_hidden, 2 x 26) and (2 x 26,): the first 10 ms of a frame, then the second.
    priors : shares of the phonemes, and of the visemes, in what it was trained on, shape (26,), above 0.
    layer : after which of the encoder's layers the states are taken, 0..5; `OUTPUT` for the encoder's output.
    """

    mean: Float32Array
    projection: Float32Array
    hidden_weights: Float32Array
    hidden_bias: Float32Array
    weights: Float32Array
    bias: Float32Array
    priors: Float32Array
    layer: int = field(default=LAYER, kw_only=True)

    @cached_property
    def digest(self) -> str:
        """A fingerprint of the layer and the arrays."""
        return sha256(b"".join([bytes([self.layer]), *(getattr(self, n).tobytes() for n in SHAPES)])).hexdigest()

    def rounded(self) -> "EncoderHead":
        """Return the head with the precision of its file, so that saving it changes nothing."""
        return replace(self, **{name: getattr(self, name).astype(np.float16).astype(np.float32) for name in SHAPES})

    @override
    def __eq__(self, other: object) -> bool:
        return isinstance(other, EncoderHead) and self.digest == other.digest

    @override
    def __hash__(self) -> int:
        return hash(self.digest)

    def probabilities(self, states: NDArray[np.float16]) -> Float32Array:
        """Return how likely each phoneme and viseme is, float32, shape (2 x n_states, 26), one row each 10 ms."""
        # One frame of the encoder covers two of ours, so the last layer has the outputs of both halves side by side;
        # reshaping puts them one after the other in time.
        inputs = with_context(self.project(states))
        hidden = np.maximum(inputs @ self.hidden_weights + self.hidden_bias, 0)
        sums = (hidden @ self.weights + self.bias).reshape(-1, N_OUTPUTS)
        # two questions of one sound, so two distributions that each add up to 1
        phonemes, visemes = sums[:, : len(Phoneme)], sums[:, len(Phoneme) :]
        return np.concatenate((softmax(phonemes), softmax(visemes)), axis=1)

    def project(self, states: NDArray[np.float16]) -> Float32Array:
        """Return the principal components of states, float32, shape (n_states, n_components)."""
        # A principal component of spread 1 weighs as much as any other, whatever its variance in the encoder.
        return np.asarray((states.astype(np.float32) - self.mean) @ self.projection, np.float32)


def with_context(components: Float32Array) -> Float32Array:
    """Put the neighbours of each frame beside it, shape (n, 5 x n_components); at the ends that of the end."""
    n = len(components)
    places = np.clip(np.arange(n)[:, np.newaxis] + np.array(CONTEXT), 0, max(n - 1, 0))
    return np.asarray(components[places].reshape(n, len(CONTEXT) * components.shape[1]), np.float32)


def softmax(sums: Float32Array) -> Float32Array:
    """Return probabilities, along the last axis."""
    # e to the difference from the greatest: the quotient is the same, and nothing can overflow
    shares = np.exp(sums - sums.max(axis=-1, keepdims=True))
    return np.asarray(shares / shares.sum(axis=-1, keepdims=True), np.float32)


def save_head(head: EncoderHead, path: Path) -> None:
    """Write a head's file, as float16.

    Raises
    ------
    ModelError : it cannot be written.
    """
    arrays: dict[str, NDArray[Any]] = {name: getattr(head, name).astype(np.float16) for name in SHAPES}
    try:
        with atomic_write(path) as file:
            told = {"encoder_format": np.array(FORMAT), "layer": np.array(head.layer)}
            np.savez_compressed(file, allow_pickle=False, **told, **arrays)
    except OSError as error:
        raise ModelError(f"{path.name}: cannot be written ({reason_of(error)}); choose another folder") from error


def load_head(path: Path) -> EncoderHead:
    """Read a head's file.

    Raises
    ------
    ModelError : it cannot be read, is damaged, of a newer version, or holds what no head has.
    """
    try:
        return _head_in(path.read_bytes())
    except OSError as error:
        raise ModelError(
            f"{path.name}: the head of the encoder cannot be read ({reason_of(error)}); put it beside its preset"
        ) from error
    except (ValueError, KeyError, TypeError, OverflowError) as error:
        raise ModelError(f"{path.name}: the head of the encoder is damaged; get it anew") from error


@lru_cache(maxsize=2)  # as models are
def _head_in(content: bytes) -> EncoderHead:
    arrays = arrays_in_npz(content, LARGEST_FILE)
    if int(arrays["encoder_format"]) > FORMAT:
        raise ModelError("the head of the encoder is of a newer version; update the program")
    found = {name: arrays[name].astype(np.float32) for name in SHAPES}
    for name, shape in SHAPES.items():
        sizes = found[name].shape
        fits = len(sizes) == len(shape) and all(m in (None, n) for m, n in zip(shape, sizes, strict=True))
        if not (fits and np.all(np.isfinite(found[name]))):
            raise ValueError(name)
    n_components, n_hidden = found["projection"].shape[1], len(found["hidden_bias"])
    if found["hidden_weights"].shape != (len(CONTEXT) * n_components, n_hidden) or len(found["weights"]) != n_hidden:
        raise ValueError("hidden_weights")
    if not (found["priors"] > 0).all():
        raise ValueError("priors")
    layer = int(arrays.get("layer", OUTPUT))  # those of format 1 tell no layer, since there was only the output
    if not 0 <= layer <= OUTPUT:
        raise ValueError("layer")
    return EncoderHead(**found, layer=layer)
