"""What the rows of a table of performances hold, looked at before it is believed."""

import json
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.performance.recording import PerformedPhone


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
