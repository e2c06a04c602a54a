"""Boundaries of words, syllables and phones that are moved by hand."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import accumulate

from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import Phone, Utterance

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
    or after where that touches. Nobody has listened to phones that were moved, so they have no score.

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
        replace(
            word,
            syllables=tuple(replace(s, phones=tuple(next(left) for _ in s.phones)) for s in word.syllables),
        )
        for word in utterance.words
    )
    return replace(utterance, words=words)
