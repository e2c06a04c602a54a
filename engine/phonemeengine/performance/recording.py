"""A recorded performance: a face's weights over time, and what was said meanwhile."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import PerformanceError
from phonemeengine.labels.label import ROUNDING
from phonemeengine.labels.phone_sets import ipa_of
from phonemeengine.labels.utterance import Phone, Utterance
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
