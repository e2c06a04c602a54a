"""What the rows of a table of performances hold, looked at before it is believed."""

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PerformanceError
from phonemeengine.performance.recording import Performance, PerformedPhone

LARGEST_WEIGHTS = 32 << 20
"""Bytes of a recording's weights at most: more than an hour of 61 channels at 60 frames a second."""
_MOST = float(np.finfo(np.float16).max)


class DamageError(ValueError):
    """A database says something impossible."""


def weights_of(content: Any, n_frames: int, n_channels: int) -> Float32Array:
    """Return the weights of a recording, float32, shape (n_frames, n_channels)."""
    if not isinstance(content, bytes) or len(content) != 2 * n_frames * n_channels:
        raise DamageError("the weights of a recording do not fit its frames")
    return np.frombuffer(content, "<f2").reshape(n_frames, n_channels).astype(np.float32)


def clips_of(content: Any) -> dict[str, str]:
    """Return the recordings that answer words, of JSON."""
    clips = json.loads(text_of(content))
    if not isinstance(clips, dict):
        raise DamageError("the words of its clips are missing")
    return {words: text_of(name) for words, name in clips.items()}


def phone_of(row: tuple[Any, ...]) -> PerformedPhone:
    """Return the phone of a row, whose first cell is the number of its recording."""
    _recording, start, middle, end, name, word, syllable, stress, energy, pitch = row
    return PerformedPhone(
        real_of(start), real_of(middle), real_of(end), text_of(name), whole_of(word), whole_of(syllable),
        whole_of(stress), real_of(energy), real_of(pitch),
    )  # fmt: skip


def whole_of(value: Any) -> int:
    """Return a cell that is a whole number."""
    if not isinstance(value, int):
        raise DamageError(f"a whole number is missing, found {value!r:.20}")
    return value


def real_of(value: Any) -> float:
    """Return a cell that is a finite number."""
    if not isinstance(value, float) or not np.isfinite(value):
        raise DamageError(f"a number is missing, found {value!r:.20}")
    return value


def text_of(value: Any) -> str:
    """Return a cell that is a text."""
    if not isinstance(value, str):
        raise DamageError(f"a text is missing, found {value!r:.20}")
    return value


@dataclass(frozen=True, eq=False)
class Basis:
    """Principal components that a table stores in place of shapes.

    Attributes
    ----------
    shapes : the names of these.
    mean : float32, shape (n_shapes,).
    components : float32, shape (n_components, n_shapes), at right angles and of length 1.
    """

    shapes: tuple[str, ...]
    mean: Float32Array
    components: Float32Array

    def stored(self, channels: Sequence[str]) -> tuple[str, ...]:
        """Return the columns that are stored for channels: components, then what is no shape of theirs."""
        own = (f"pc{k + 1}" for k in range(len(self.components)))
        return (*own, *(name for name in channels if name not in self.shapes))

    def read(self, stored: Sequence[str]) -> tuple[str, ...]:
        """Return the channels of performances that come back from those that are stored."""
        return (*self.shapes, *stored[len(self.components) :])

    def reduced(self, channels: Sequence[str], weights: Float32Array) -> Float32Array:
        """Return weights as they are stored, shape (n_frames, n_stored)."""
        shapes = weights[:, [*map(channels.index, self.shapes)]]
        rest = weights[:, [k for k, name in enumerate(channels) if name not in self.shapes]]
        return np.hstack([(shapes - self.mean) @ self.components.T, rest])

    def expanded(self, stored: Float32Array) -> Float32Array:
        """Return the weights of what is stored, shape (n_frames, n_channels)."""
        n = len(self.components)
        return np.hstack([self.mean + stored[:, :n] @ self.components, stored[:, n:]])

    def text(self) -> str:
        """Return it as JSON; see `basis_of`."""
        parts = {"shapes": self.shapes, "mean": self.mean.tolist(), "components": self.components.tolist()}
        return json.dumps(parts)


def basis_of(text: str) -> Basis | None:
    """Return the basis that a table says it has, as JSON; None for an empty text.

    Raises
    ------
    ValueError, TypeError, KeyError, IndexError : it is none.
    """
    if not text:
        return None
    try:
        parts = json.loads(text)
    except RecursionError as error:
        raise DamageError("its components are no list of numbers") from error
    shapes = tuple(map(text_of, parts["shapes"]))
    mean, components = (np.array(parts[key], np.float32) for key in ("mean", "components"))
    fits = mean.shape == components.shape[1:] == (len(shapes),) and len(components) and len({*shapes}) == len(shapes)
    if not fits or not (np.isfinite(mean).all() and np.isfinite(components).all()):
        raise DamageError("its components do not fit its shapes")
    return Basis(shapes, mean, components)


def stored_weights(performance: Performance, basis: Basis | None) -> bytes:
    """Return the weights of a performance as a table stores them: float16 by frame and column.

    Raises
    ------
    PerformanceError : they take more than a recording may.
    """
    stored = performance.weights if basis is None else basis.reduced(performance.channels, performance.weights)
    weights = np.clip(stored, -_MOST, _MOST).astype("<f2")
    if weights.nbytes > LARGEST_WEIGHTS:
        raise PerformanceError(
            f"{performance.name}: the weights of a recording may have {LARGEST_WEIGHTS >> 20} MB, these have "
            f"{weights.nbytes / (1 << 20):.1f} MB; cut it into sentences"
        )
    return weights.tobytes()


def place_beside(path: Path, folder: str | os.PathLike[str]) -> str:
    """Return where a folder lies, from the folder of a file if there is such a way: both may move together."""
    try:
        return Path(os.path.relpath(folder, path.absolute().parent)).as_posix()
    except ValueError:  # on another drive
        return Path(folder).absolute().as_posix()
