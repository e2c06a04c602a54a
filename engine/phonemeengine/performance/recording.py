"""A recorded performance: a face's weights over time, and what was said meanwhile; and the rows that hold it."""

import json
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PerformanceError
from phonemeengine.labels.phone_sets import ipa_of
from phonemeengine.labels.utterance import ROUNDING, Phone, Utterance
from phonemeengine.storage.files import printable

SILENCE = "sil"
"""The name of the phone before the first word, after the last one, and in pauses."""
HEAD = ("headYaw", "headPitch", "headRoll")
"""The channels of the head's turns, degrees."""
LEAST_SILENCE = 0.01
"""Seconds that are silence before the first and after the last phone, even where there is speech."""


@dataclass(frozen=True)
class PerformedPhone:
    """A phone of a performance, or of a sentence that is to be performed.

    Attributes
    ----------
    start, middle, end : seconds; its halves meet at `middle`.
    name : its symbol in the International Phonetic Alphabet, as `ipa_of` spells it; `SILENCE` outside of speech.
    word : number of its word in the sentence; -1 for silence.
    syllable : number of its syllable in the sentence; -1 for silence.
    stress : of its syllable: 0 for none, 1 for the main one of its word, 2 for a secondary one.
    energy : mean level of the sound, dB beside full scale.
    pitch : median fundamental frequency, Hz; 0 where the phone is voiceless.
    """

    start: float
    middle: float
    end: float
    name: str
    word: int = -1
    syllable: int = -1
    stress: int = 0
    energy: float = 0.0
    pitch: float = 0.0

    @property
    def duration(self) -> float:
        """How long it lasts, seconds."""
        return self.end - self.start


@dataclass(frozen=True, eq=False)
class Performance:
    """One recording.

    Attributes
    ----------
    name : of its files, without endings.
    rate : frames a second; frame k shows the time k / rate of the sound.
    channels : the names of the columns: blend shapes as ARKit has them, `HEAD`, and whatever else was recorded.
    weights : float32, shape (n_frames, n_channels): blend shapes 0..1, turns of the head in degrees.
    phones : in order of time, without gaps; the first and the last are silence.
    words : the texts of the words, by number.
    synthetic : whether no person, but a model of one moved.

    Raises
    ------
    PerformanceError : the weights do not fit the channels or are not finite, or the phones do not follow each other.
    """

    name: str
    rate: float
    channels: tuple[str, ...]
    weights: Float32Array
    phones: tuple[PerformedPhone, ...]
    words: tuple[str, ...] = ()
    synthetic: bool = False

    def __post_init__(self) -> None:
        if fault := self._fault():
            raise PerformanceError(f"{printable(self.name[:60])}: {fault}; record or label it anew")

    @property
    def duration(self) -> float:
        """How long it lasts, seconds."""
        return self.phones[-1].end

    def check_beside(self, first: "Performance") -> None:
        """Refuse to go into one table with another one.

        Raises
        ------
        PerformanceError : the channels or the rate differ, or the name of a phone is not one word.
        """
        if self.channels != first.channels or self.rate != first.rate:
            raise PerformanceError(
                f"{self.name}: the recordings of a table must have the same channels and rate as {first.name} "
                f"({len(first.channels)} at {first.rate:g} frames a second), found {len(self.channels)} at "
                f"{self.rate:g}; export it again, or leave it out"
            )
        if bad := next((phone.name for phone in self.phones if not phone.name or " " in phone.name), None):
            raise PerformanceError(f"{self.name}: the name of a phone is one word, found {bad[:20]!r}; correct it")

    def _fault(self) -> str:
        shape = self.weights.shape
        if len(shape) != 2 or not shape[0] or shape[1] != len(self.channels) or not np.isfinite(self.weights).all():
            return f"the weights must be a finite number for each frame and channel, found the shape {shape}"
        if not self.phones or {self.phones[0].name, self.phones[-1].name} != {SILENCE}:
            return "the first and the last phone of a performance must be silence"
        if not all(phone.start <= phone.middle <= phone.end for phone in self.phones):
            return "a phone must begin before its middle, and its middle lie before its end"
        if any(abs(a.end - b.start) > ROUNDING for a, b in pairwise(self.phones)):
            return "the phones of a performance must follow each other without gaps"
        return ""


def phones_of(utterance: Utterance) -> tuple[PerformedPhone, ...]:
    """Return what is said as performances have it: with silence before and after it and in pauses.

    Phones without length are left out; a gap within a word belongs to the phone before it. Energy and pitch are not
    known yet.
    """
    spoken = [phone for phone in _spoken_in(utterance) if phone.duration > ROUNDING]
    if not spoken:
        return (_silence(0.0, max(utterance.duration, LEAST_SILENCE)),)
    return (*_with_silence(spoken, utterance.duration),)


def _spoken_in(utterance: Utterance) -> Iterator[PerformedPhone]:
    number = 0
    for k, word in enumerate(utterance.words):
        for syllable in word.syllables:
            for phone in syllable.phones:
                middle = (phone.start + phone.end) / 2
                yield PerformedPhone(phone.start, middle, phone.end, _name_of(phone), k, number, syllable.stress)
            number += 1


def _with_silence(spoken: list[PerformedPhone], duration: float) -> Iterator[PerformedPhone]:
    first, last = spoken[0], spoken[-1]
    begin = max(first.start, min(LEAST_SILENCE, first.duration / 2))
    end = min(last.end, duration - min(LEAST_SILENCE, last.duration / 2))
    at = 0.0
    for phone, following in zip(spoken, [*spoken[1:], None], strict=True):
        start = max(phone.start, begin)
        if start > at + ROUNDING or not at:
            yield _silence(at, start)
            at = start
        stop = following.start if following and following.word == phone.word else min(phone.end, end)
        yield replace(phone, start=at, middle=(at + stop) / 2, end=stop)
        at = stop
    yield _silence(at, max(duration, end))


def _silence(start: float, end: float) -> PerformedPhone:
    return PerformedPhone(start, (start + end) / 2, end, SILENCE)


def _name_of(phone: Phone) -> str:
    return "".join(ipa_of(phone.ipa)) or phone.phoneme.label


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
