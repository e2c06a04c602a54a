"""The units of a sentence: strings of words, words, syllables, triphones, diphones and halves of phones; and phrases.

Every phone has a left half, from its start to its middle, and a right half. Half 2k is the left one of phone k, half
2k + 1 its right one. A unit spans consecutive halves, and is looked up by the names of the phones that it touches.

A phrase is looked for among the recorded ones by its number of syllables, then by the likeness of its stresses, then
by its duration. One without a match is split beside a conjunction; without that it is matched by its number of
stresses alone; and where that fails too, it is split at the word boundary nearest its middle, and so on.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
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


SHORTEST_PAUSE = 0.1
"""Seconds of silence that part two phrases."""
STRENGTHS = {1: 1.0, 2: 0.5}
"""Of stresses, by their kind."""
MOST_STRETCH = 2.0
"""By which factor a phrase that was found by its stresses alone may be longer or shorter."""


@dataclass(frozen=True)
class Phrase:
    """A phrase, or a part of one, in a sentence.

    Attributes
    ----------
    times : when each syllable begins, and when the last one ends, seconds; increasing.
    stresses : of each syllable, as phones have them.
    words : the number of each syllable's word in the sentence.
    """

    times: tuple[float, ...]
    stresses: tuple[int, ...]
    words: tuple[int, ...]

    def __len__(self) -> int:
        """Count the syllables."""
        return len(self.stresses)

    @property
    def start(self) -> float:
        """When it begins, seconds."""
        return self.times[0]

    @property
    def end(self) -> float:
        """When it ends, seconds."""
        return self.times[-1]

    @property
    def duration(self) -> float:
        """How long it lasts, seconds."""
        return self.end - self.start

    @property
    def beats(self) -> tuple[float, ...]:
        """The middles of the syllables with the main stress of their word, seconds."""
        return tuple((self.times[k] + self.times[k + 1]) / 2 for k, stress in enumerate(self.stresses) if stress == 1)

    @property
    def word_starts(self) -> tuple[int, ...]:
        """The syllables with which words begin, but for the first one."""
        return tuple(k for k in range(1, len(self)) if self.words[k] != self.words[k - 1])

    def part(self, first: int, last: int) -> "Phrase":
        """Return some of its syllables; `last` is not of them."""
        return Phrase(self.times[first : last + 1], self.stresses[first:last], self.words[first:last])

    def nearest_to_middle(self, syllables: Iterable[int]) -> int:
        """Return the syllable that begins the nearest to the middle."""
        middle = (self.start + self.end) / 2
        return min(syllables, key=lambda k: abs(self.times[k] - middle))


class PhraseMatchKind(StrEnum):
    """How a phrase was found."""

    SYLLABLES = "syllables"
    STRESSES = "stresses"
    PIECE = "piece"


@dataclass(frozen=True)
class PhraseMatch:
    """A phrase that is to be said, and one that was recorded.

    Attributes
    ----------
    phrase : the one to be said, or a part of it.
    recording : the number of the recording.
    example : the phrase in it, or a part of it.
    kind : how it was found.
    """

    phrase: Phrase
    recording: int
    example: Phrase
    kind: PhraseMatchKind


@dataclass(frozen=True)
class _Recorded:
    recording: int
    phrase: Phrase


def phrases_of(phones: Sequence[PerformedPhone]) -> Iterator[Phrase]:
    """Return the phrases of a sentence, in order of time: what lies between pauses.

    A shorter silence belongs to the syllable before it.
    """
    spoken: list[PerformedPhone] = []
    for phone in phones:
        if phone.syllable >= 0:
            spoken.append(phone)
        elif spoken and phone.duration >= SHORTEST_PAUSE:
            yield _phrase_of(spoken)
            spoken = []
    if spoken:
        yield _phrase_of(spoken)


class PhraseIndex:
    """Recorded phrases, to be found by their syllables and stresses.

    Parameters
    ----------
    recordings : the phones of recordings, each with its number.
    """

    def __init__(self, recordings: Iterable[tuple[int, Sequence[PerformedPhone]]]) -> None:
        self._by_syllables: defaultdict[int, list[_Recorded]] = defaultdict(list)
        self._by_stresses: defaultdict[int, list[_Recorded]] = defaultdict(list)
        for number, phones in recordings:
            for phrase in phrases_of(phones):
                recorded = _Recorded(number, phrase)
                self._by_syllables[len(phrase)].append(recorded)
                self._by_stresses[len(phrase.beats)].append(recorded)

    def matches(self, phrase: Phrase, conjunctions: Collection[int] = ()) -> Iterator[PhraseMatch]:
        """Return what is found for a phrase and, where it must be split, for its parts, in order of time.

        Parameters
        ----------
        conjunctions : the words of the sentence before which it may be split, by their numbers.
        """
        if not self._by_syllables:
            return
        joints = phrase.word_starts
        beside = [k for k in joints if phrase.words[k] in conjunctions]
        if alike := self._of_like_syllables(phrase):
            yield PhraseMatch(phrase, alike.recording, alike.phrase, PhraseMatchKind.SYLLABLES)
        elif beside:
            yield from self._of_parts(phrase, phrase.nearest_to_middle(beside), conjunctions)
        elif alike := self._of_like_stresses(phrase):
            yield PhraseMatch(phrase, alike.recording, alike.phrase, PhraseMatchKind.STRESSES)
        elif joints:
            yield from self._of_parts(phrase, phrase.nearest_to_middle(joints), conjunctions)
        else:
            yield self._piece_for(phrase)

    def _of_parts(self, phrase: Phrase, at: int, conjunctions: Collection[int]) -> Iterator[PhraseMatch]:
        yield from self.matches(phrase.part(0, at), conjunctions)
        yield from self.matches(phrase.part(at, len(phrase)), conjunctions)

    def _of_like_syllables(self, phrase: Phrase) -> _Recorded | None:
        found = self._by_syllables.get(len(phrase))
        return _most_alike(found, phrase) if found else None

    def _of_like_stresses(self, phrase: Phrase) -> _Recorded | None:
        beats = len(phrase.beats)
        found = self._by_stresses.get(beats, ()) if beats else ()  # no stress at all tells nothing
        usable = (r for r in found if 1 / MOST_STRETCH <= r.phrase.duration / phrase.duration <= MOST_STRETCH)
        return min(usable, key=lambda r: abs(r.phrase.duration - phrase.duration), default=None)

    def _piece_for(self, phrase: Phrase) -> PhraseMatch:
        """Return the beginning of a longer phrase for a word that none matches, or the longest one there is.

        A table of long sentences has none of a single word.
        """
        n = min((count for count in self._by_syllables if count > len(phrase)), default=max(self._by_syllables))
        parts = [_Recorded(r.recording, r.phrase.part(0, min(n, len(phrase)))) for r in self._by_syllables[n]]
        chosen = _most_alike(parts, phrase)
        return PhraseMatch(phrase, chosen.recording, chosen.phrase, PhraseMatchKind.PIECE)


def _phrase_of(spoken: Sequence[PerformedPhone]) -> Phrase:
    firsts = [spoken[0], *(b for a, b in pairwise(spoken) if a.syllable != b.syllable)]
    times = (*(phone.start for phone in firsts), spoken[-1].end)
    return Phrase(times, tuple(phone.stress for phone in firsts), tuple(phone.word for phone in firsts))


def _most_alike(recorded: Iterable[_Recorded], phrase: Phrase) -> _Recorded:
    """Return the phrase whose stresses are the most alike; of equal ones that whose duration is."""
    return min(recorded, key=lambda r: (_unlikeness(r.phrase, phrase), abs(r.phrase.duration - phrase.duration)))


def _unlikeness(one: Phrase, other: Phrase) -> float:
    """Return by how much the stresses differ, syllable by syllable."""
    pairs = zip(one.stresses, other.stresses, strict=False)
    return sum(abs(STRENGTHS.get(a, 0.0) - STRENGTHS.get(b, 0.0)) for a, b in pairs)
