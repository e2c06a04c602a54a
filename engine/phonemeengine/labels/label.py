"""What was said when: an interval as a file has it, and as one of our phonemes."""

import itertools
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

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
