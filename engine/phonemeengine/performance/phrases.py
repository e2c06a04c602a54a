"""Phrases, by which head and brows are looked up: what is said between two pauses, counted in syllables.

A phrase is looked for among the recorded ones by its number of syllables, then by the likeness of its stresses, then
by its duration. One without a match is split beside a conjunction; without that it is matched by its number of
stresses alone; and where that fails too, it is split at the word boundary nearest its middle, and so on.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

from phonemeengine.performance.recording import PerformedPhone

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
