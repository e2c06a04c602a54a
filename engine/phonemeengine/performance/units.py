"""The units of a sentence: strings of words, words, syllables, triphones, diphones and halves of phones.

Every phone has a left half, from its start to its middle, and a right half. Half 2k is the left one of phone k, half
2k + 1 its right one. A unit spans consecutive halves, and is looked up by the names of the phones that it touches.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import groupby, pairwise

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.labels.utterance import Utterance
from phonemeengine.mouth.transcript import Prosody, Transcript
from phonemeengine.performance.recording import SILENCE, PerformedPhone, phones_of
from phonemeengine.settings import FRAME_PERIOD, AnalysisSettings
from phonemeengine.text.syllables import is_vowel

# Sentences that are to be performed: what is said in a sound, with how loud and how high each phone is.

PAUSE = 0.25
"""Seconds of silence that part sentences; what is shorter is a pause within one."""

Sentence = tuple[PerformedPhone, ...]
"""Phones in order of time, without gaps; the first and the last are silence."""


def performed_phones(utterance: Utterance, speech: Prosody | Transcript) -> Sentence:
    """Return the phones of an utterance, with silence before and after them and in pauses.

    Parameters
    ----------
    utterance : what is said; p and b begin where the lips close, as voices and alignments have it.
    speech : how loud and high it is. Levels are as if its preset had the usual range of intensities.
    """
    first = speech.first if isinstance(speech, Prosody) else 0
    intensities, pitches = speech.intensities, speech.pitches
    return tuple(
        replace(
            phone,
            energy=_level(_frames_of(phone, intensities, first)),
            pitch=_middle(_frames_of(phone, pitches, first)),
        )
        for phone in phones_of(utterance)
    )


def sentences_in(phones: Sentence) -> tuple[Sentence, ...]:
    """Part phones at long pauses; neighbours share the pause, so that one may go over into the other there."""
    pauses = [k for k, phone in enumerate(phones) if phone.name == SILENCE and phone.duration >= PAUSE]
    bounds = sorted({0, len(phones) - 1, *pauses})
    return tuple(phones[first : last + 1] for first, last in pairwise(bounds)) or (phones,)


def joined(sentences: Sequence[Sentence]) -> Sentence:
    """Return sentences as one; neighbours share a pause."""
    return sentences[0] + tuple(phone for sentence in sentences[1:] for phone in sentence[1:])


def _frames_of(phone: PerformedPhone, values: Float32Array, first: int) -> Float32Array:
    """Return the frames of a phone, of values whose first frame has a number."""
    start = max(0, int(phone.start / FRAME_PERIOD) - first)
    return values[start : max(start + 1, round(phone.end / FRAME_PERIOD) - first)]


def _level(intensities: Float32Array) -> float:
    """Return the mean level of frames, dB; 0 where it was not measured."""
    low, high = AnalysisSettings.intensity_low, AnalysisSettings.intensity_high
    return low + (high - low) * float(intensities.mean()) if len(intensities) else 0.0


def _middle(pitches: Float32Array) -> float:
    """Return the median pitch of frames, Hz; 0 where fewer than half of them are voiced."""
    return float(np.median(pitches)) if len(pitches) else 0.0


class UnitKind(StrEnum):
    """The sets of units, the longest first; a table has no index of `STRINGS`, see `recorded_strings`."""

    CLIP = "clip"
    SENTENCE = "sentence"
    WORDS = "words"
    WORD = "word"
    SYLLABLE = "syllable"
    VOWEL_TRIPHONE = "vowel-triphone"
    CONSONANT_TRIPHONE = "consonant-triphone"
    BOUNDARY_TRIPHONE = "boundary-triphone"
    DIPHONE = "diphone"
    BOUNDARY_DIPHONE = "boundary-diphone"
    RIGHT_HALF = "right-half"
    LEFT_HALF = "left-half"


STRINGS = frozenset({UnitKind.CLIP, UnitKind.SENTENCE, UnitKind.WORDS})
"""Sets whose units are found by their words."""


@dataclass(frozen=True)
class Unit:
    """A unit of a sentence.

    Attributes
    ----------
    kind : its set.
    names : of the phones that it touches, in order.
    first, last : its halves; `last` is not of it.
    """

    kind: UnitKind
    names: tuple[str, ...]
    first: int
    last: int


def units_of(phones: Sequence[PerformedPhone]) -> Iterator[Unit]:
    """Return all units of a sentence but its `STRINGS`, the sets in their order, each in order of time.

    Words and syllables span the right half of their first phone to the left half of their last one: neighbours share
    those phones. A word of one syllable is one of the syllables.

    Parameters
    ----------
    phones : in order of time; the first and the last are silence.
    """
    names = tuple(phone.name for phone in phones)
    last = len(phones) - 1
    inner, outer = range(2, last - 1), sorted({*range(1, last)} & {1, last - 1})
    yield from _words_of(phones, names)
    yield from _syllables_of(phones, names)
    yield from (_between(UnitKind.VOWEL_TRIPHONE, names, k - 1, k + 1) for k in inner if is_vowel(names[k]))
    yield from (_between(UnitKind.CONSONANT_TRIPHONE, names, k - 1, k + 1) for k in inner if not is_vowel(names[k]))
    yield from (_between(UnitKind.BOUNDARY_TRIPHONE, names, k - 1, k + 1) for k in outer)
    yield from (_between(UnitKind.DIPHONE, names, k, k + 1) for k in range(1, last - 1))
    yield from (_between(UnitKind.BOUNDARY_DIPHONE, names, k, k + 1) for k in range(last) if k in {0, last - 1})
    yield from (Unit(UnitKind.RIGHT_HALF, (name,), 2 * k + 1, 2 * k + 2) for k, name in enumerate(names))
    yield from (Unit(UnitKind.LEFT_HALF, (name,), 2 * k, 2 * k + 1) for k, name in enumerate(names))


def duration_of(unit: Unit, phones: Sequence[PerformedPhone]) -> float:
    """Return how long a unit of a sentence lasts, seconds."""
    return boundary_at(unit.last, phones) - boundary_at(unit.first, phones)


def boundary_at(half: int, phones: Sequence[PerformedPhone]) -> float:
    """Return when a half begins, seconds; the one after the last begins where the sentence ends."""
    if half == 2 * len(phones):
        return phones[-1].end
    phone = phones[half // 2]
    return phone.middle if half % 2 else phone.start


def _words_of(phones: Sequence[PerformedPhone], names: tuple[str, ...]) -> Iterator[Unit]:
    for first, last in _runs_of([phone.word for phone in phones]):
        if len({phone.syllable for phone in phones[first : last + 1]}) > 1:
            yield _between(UnitKind.WORD, names, first, last)


def _syllables_of(phones: Sequence[PerformedPhone], names: tuple[str, ...]) -> Iterator[Unit]:
    for first, last in _runs_of([phone.syllable for phone in phones]):
        if first == last:
            yield Unit(UnitKind.SYLLABLE, (names[first],), 2 * first, 2 * first + 2)
        else:
            yield _between(UnitKind.SYLLABLE, names, first, last)


def _runs_of(numbers: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Return where each run of a number begins and ends, both counted; those of -1 are none."""
    for number, run in groupby(range(len(numbers)), key=numbers.__getitem__):
        places = list(run)
        if number != -1:
            yield places[0], places[-1]


def _between(kind: UnitKind, names: tuple[str, ...], first: int, last: int) -> Unit:
    """Return the unit from the right half of one phone to the left half of another."""
    return Unit(kind, names[first : last + 1], 2 * first + 1, 2 * last + 1)
