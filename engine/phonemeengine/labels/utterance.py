"""What was said when: labels, and utterances of words, syllables and phones with times.

A script that was aligned with its recording, a text that a voice spoke, a label file, and letters of pinyin all end
as an `Utterance`; mouths, exports and timelines begin from it.
"""

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import accumulate, pairwise

from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme

CORE = "core"
"""The certainty of a label that is not in doubt."""

ROUNDING = 0.001
"""Seconds by which times may be off because a file rounds them: two labels may overlap, or the last one outlast its
sound, by as much."""

LONGEST_OVERHANG = 0.05
"""A label that ends this much after its sound is cut, seconds; one that ends later belongs to another sound."""

LAST_END = 86_400.0
"""Labels end within a day, seconds."""


@dataclass(frozen=True)
class Label:
    """What was said in one interval of a recording.

    Attributes
    ----------
    start, end : seconds.
    phone : the sound in the alphabet of its language.
    phoneme : the class that it counts as.
    certainty : ``core``, or why the class is not certain, such as ``ambiguous`` or ``diphthong``.
    """

    start: float
    end: float
    phone: str
    phoneme: Phoneme
    certainty: str = CORE


@dataclass(frozen=True)
class RawLabel:
    """An interval of a label file, before its name has a meaning.

    Attributes
    ----------
    start, end : seconds.
    name : what stands for the phoneme.
    place : where it stands in the file, for people, such as ``line 3``.
    phone : the sound in the alphabet of its language; the name, where it is None.
    certainty : as in `Label`; None where the file does not say it.
    """

    start: float
    end: float
    name: str
    place: str
    phone: str | None = None
    certainty: str | None = None


def in_order(raw_labels: Iterable[RawLabel], file: str, duration: float | None = None) -> tuple[RawLabel, ...]:
    """Return marks in order of time, mended where a file's rounding made them overlap or outlast the sound.

    Parameters
    ----------
    raw_labels : in any order.
    file : what the file is called in a refusal.
    duration : length of the sound, seconds, where it is known. A mark that ends up to 50 ms after it is cut there;
        up to 1 ms is rounding and stays.

    Raises
    ------
    CorpusError : times that are impossible, overlap by more than 1 ms, or lie beyond the sound.
    """
    ordered = sorted(_checked(raw_labels, file), key=lambda raw: (raw.start, raw.end))
    if duration is not None:
        ordered = [_within(raw, file, duration) for raw in ordered]
    for k, (raw, following) in enumerate(itertools.pairwise(ordered)):
        if raw.end - following.start > ROUNDING:
            raise CorpusError(
                f"{file}, {following.place}: labels must not overlap, found {_span(following)} after {_span(raw)} "
                f"of {raw.place}; move one of their borders"
            )
        ordered[k] = replace(raw, end=max(raw.start, min(raw.end, following.start)))
    return tuple(ordered)


def _checked(raw_labels: Iterable[RawLabel], file: str) -> Iterator[RawLabel]:
    for raw in raw_labels:
        if not (math.isfinite(raw.start) and math.isfinite(raw.end) and raw.start >= 0):
            fault = "times must be seconds from 0"
        elif raw.end < raw.start:
            fault = "a label must not end before it starts"
        elif raw.end > LAST_END:
            fault = f"labels must end within a day ({LAST_END:g} s)"
        else:
            yield raw
            continue
        raise CorpusError(f"{file}, {raw.place}: {fault}, found {_span(raw)}; correct the label")


def _within(raw: RawLabel, file: str, duration: float) -> RawLabel:
    if raw.end <= duration + ROUNDING:
        return raw
    if raw.start >= duration or raw.end > duration + LONGEST_OVERHANG:
        raise CorpusError(
            f"{file}, {raw.place}: the label at {_span(raw)} lies beyond the end of the sound, which lasts "
            f"{duration:.3f} s; check whether the labels belong to this sound"
        )
    return replace(raw, end=duration)


def _span(raw: RawLabel) -> str:
    return f"{raw.start:g}..{raw.end:g} s"


UNKNOWN_WORD = "<unk>"
"""The text of a word that was said, but stands in no script; forced aligners call it so."""


@dataclass(frozen=True)
class Phone:
    """One sound of speech.

    Attributes
    ----------
    start, end : seconds from the beginning of the sound.
    ipa : its symbol in the International Phonetic Alphabet, without stress; the halves of an affricate are two
        phones. Empty where only the phoneme is known.
    phoneme : the class of it that recognisers tell apart.
    score : how well the sound fits it: the mean, over its frames, of the best score of any phone less its own,
        natural logarithm; 0 fits best. None where it was not aligned with a sound.
    """

    start: float
    end: float
    ipa: str
    phoneme: Phoneme
    score: float | None = None


@dataclass(frozen=True)
class Syllable:
    """A syllable: its phones, and how it is stressed.

    Attributes
    ----------
    phones : in order of time, without gaps; at least one.
    stress : 0 for none, 1 for the main one of its word, 2 for a secondary one.
    text : how it is written, where that is known, such as ``hao3``.
    """

    phones: tuple[Phone, ...]
    stress: int = 0
    text: str = ""

    @property
    def start(self) -> float:
        """When it begins, seconds."""
        return self.phones[0].start

    @property
    def end(self) -> float:
        """When it ends, seconds."""
        return self.phones[-1].end


@dataclass(frozen=True)
class Word:
    """A word: its text, and its syllables.

    Attributes
    ----------
    text : as it is written; `UNKNOWN_WORD` for speech that the script does not hold.
    syllables : in order of time, without gaps; at least one.
    """

    text: str
    syllables: tuple[Syllable, ...]

    @property
    def start(self) -> float:
        """When it begins, seconds."""
        return self.syllables[0].start

    @property
    def end(self) -> float:
        """When it ends, seconds."""
        return self.syllables[-1].end

    @property
    def phones(self) -> tuple[Phone, ...]:
        """Its phones, in order of time."""
        return tuple(phone for syllable in self.syllables for phone in syllable.phones)

    @property
    def score(self) -> float | None:
        """How well the sound fits it: the mean of its phones' scores over time; None without an alignment."""
        return _mean_score(self.phones)


@dataclass(frozen=True)
class Utterance:
    """What is said in a sound.

    What lies between words, before the first and after the last one is silence.

    Attributes
    ----------
    words : in order of time, not overlapping.
    duration : of the sound, seconds.
    language : the voice of espeak-ng that read the text, such as ``de``; empty where it came from labels.
    skipped : words of the script that were not spoken, in order.

    Raises
    ------
    CorpusError : times overlap, or lie outside the sound.
    """

    words: tuple[Word, ...]
    duration: float
    language: str = ""
    skipped: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        phones = tuple(self.phones)
        for phone, following in pairwise(phones):
            if following.start < phone.end - ROUNDING or phone.end < phone.start:
                raise CorpusError(
                    f"the phones of an utterance must follow each other, found {following.ipa!r} at "
                    f"{following.start:g} s after {phone.ipa!r} until {phone.end:g} s; correct the times"
                )
        if phones and (phones[0].start < 0 or phones[-1].end > self.duration + ROUNDING):
            raise CorpusError(
                f"the phones of an utterance must lie within its sound of {self.duration:g} s, found "
                f"{phones[0].start:g}..{phones[-1].end:g} s; correct the times"
            )

    @property
    def phones(self) -> Iterator[Phone]:
        """All phones, in order of time; what lies between them is silence."""
        return (phone for word in self.words for syllable in word.syllables for phone in syllable.phones)

    @property
    def score(self) -> float | None:
        """How well the sound fits the words: the mean of the phones' scores over time; None without an alignment."""
        return _mean_score(self.phones)


def shifted(word: Word, seconds: float) -> Word:
    """Return a word that begins later by a number of seconds."""
    return retimed(word, lambda time: time + seconds)


def retimed(word: Word, time_of: Callable[[float], float]) -> Word:
    """Return a word whose phones are at other times; the function gives the new time of an old one, seconds."""
    return replace(
        word,
        syllables=tuple(
            replace(
                syllable,
                phones=tuple(
                    replace(phone, start=time_of(phone.start), end=time_of(phone.end)) for phone in syllable.phones
                ),
            )
            for syllable in word.syllables
        ),
    )


def _mean_score(phones: Iterable[Phone]) -> float | None:
    scored = [(phone.score, phone.end - phone.start) for phone in phones if phone.score is not None]
    total = sum(duration for _, duration in scored)
    return sum(score * duration for score, duration in scored) / total if total else None


# Boundaries of words, syllables and phones that are moved by hand.

TOUCHING = 1e-6
"""Seconds between two units that have one boundary."""


class LabelUnit(StrEnum):
    """What an utterance is made of."""

    WORD = "word"
    SYLLABLE = "syllable"
    PHONE = "phone"


def spans_of(utterance: Utterance, unit: LabelUnit) -> list[tuple[float, float]]:
    """Return when the units of an utterance begin and end, seconds, in order."""
    phones = tuple(utterance.phones)
    return [(phones[first].start, phones[last - 1].end) for first, last in _phones_in(utterance, unit)]


def with_boundary(utterance: Utterance, unit: LabelUnit, boundary: int, seconds: float) -> Utterance:
    """Return an utterance with one boundary elsewhere.

    All phones of the unit that it bounds become longer or shorter by one factor, and so do those of the unit before
    or after where that touches. Phones that were moved were not compared with the sound, so they have no score.

    Parameters
    ----------
    utterance : as it was.
    unit : whose boundary it is.
    boundary : 2 k is the start of unit k, 2 k + 1 its end.
    seconds : where it is to be.

    Raises
    ------
    CorpusError : there is no such boundary, or it would leave nothing of a unit, or lie in another one.
    """
    ranges, spans = _phones_in(utterance, unit), spans_of(utterance, unit)
    k, is_end = divmod(boundary, 2)
    if not 0 <= k < len(spans):
        raise CorpusError(
            f"there are {len(spans)} {unit}s, found boundary {boundary}; choose 0..{2 * len(spans) - 1}"
        )
    phones = list(utterance.phones)
    other = k + 1 if is_end else k - 1
    moved = [(k, is_end)]
    if 0 <= other < len(spans) and abs(spans[other][1 - is_end] - spans[k][is_end]) < TOUCHING:
        moved.append((other, 1 - is_end))
    for number, edge in moved:
        start, end = (seconds, spans[number][1]) if edge == 0 else (spans[number][0], seconds)
        if end <= start:
            raise CorpusError(f"a boundary at {seconds:g} s would leave nothing of a {unit}; choose another place")
        part = slice(*ranges[number])
        phones[part] = _stretched(phones[part], start, end)
    return _with_phones(utterance, phones)


def _phones_in(utterance: Utterance, unit: LabelUnit) -> list[tuple[int, int]]:
    """Return the number of the first phone of each unit, and that after its last one."""
    counts = {
        LabelUnit.WORD: [len(word.phones) for word in utterance.words],
        LabelUnit.SYLLABLE: [len(syllable.phones) for word in utterance.words for syllable in word.syllables],
        LabelUnit.PHONE: [1 for _ in utterance.phones],
    }[unit]
    ends = list(accumulate(counts))
    return [(end - n, end) for n, end in zip(counts, ends, strict=True)]


def _stretched(phones: Sequence[Phone], start: float, end: float) -> list[Phone]:
    """Return phones that follow each other from a start to an end."""
    first, last = phones[0].start, phones[-1].end
    if last <= first:
        raise CorpusError(f"a phone of no length, at {first:g} s, cannot be made longer; correct the times")
    factor = (end - start) / (last - first)

    def moved(time: float) -> float:
        return end if time == last else start + (time - first) * factor

    return [replace(p, start=moved(p.start), end=moved(p.end), score=None) for p in phones]


def _with_phones(utterance: Utterance, phones: Sequence[Phone]) -> Utterance:
    left: Iterator[Phone] = iter(phones)
    words = tuple(
        replace(word, syllables=tuple(replace(s, phones=tuple(next(left) for _ in s.phones)) for s in word.syllables))
        for word in utterance.words
    )
    return replace(utterance, words=words)
