"""Words whose times are known: their phones are found within these times."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

import numpy as np

from phonemeengine.alignment.aligner import MOST_HURRY, ONLY_THE_TEXT, STRETCH, within
from phonemeengine.alignment.evidence import Evidence, joined, shortfalls_of
from phonemeengine.alignment.manners import KINDS
from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.viterbi import LeastFrames, cheapest_way
from phonemeengine.arrays import Float64Array
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word, shifted
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import Interval, ScriptWord

KEPT = 0.05
"""Seconds; shorter quiet at the edge of a word's time belongs to the word; longer quiet is padding, as of Whisper."""


def align_timed(
    evidence: Iterable[Evidence], words: Sequence[ScriptWord], duration: float, language: str = ""
) -> Utterance:
    """Return words at their given times, with phones, in a sound of `duration` seconds.

    Within the time of a word its phones lie where they fit the sound best. What lies between words is silence.

    Parameters
    ----------
    evidence : of consecutive blocks of the sound, which are read to the end.
    words : in order of time, each with its interval; words of one interval are said in it one after the other.
    """
    frames = _Frames(evidence)
    found: list[Word] = []
    groups = [(interval, list(said)) for interval, said in groupby(words, key=lambda word: word.interval)]
    for stretch in _stretches([(interval, said) for interval, said in groups if interval is not None]):
        first, last = _frame(stretch[0][0][0]), _frame(stretch[-1][0][1])
        heard = frames.take(first, last)
        shortfalls = shortfalls_of(heard) if len(heard) else np.zeros((0, len(KINDS)))
        for (start, end), said in stretch:
            part = shortfalls[_frame(start) - first : max(_frame(end), _frame(start) + 1) - first]
            found += _placed(said, part, start, end)
    frames.exhaust()
    return Utterance(tuple(found), duration, language)


_NO_FRAMES = Evidence(np.zeros((0, len(Phoneme)), np.float32), np.zeros((0, 2), np.float32))

Timed = tuple[Interval, list[ScriptWord]]


def _stretches(groups: Sequence[Timed]) -> Iterator[list[Timed]]:
    """Return words in stretches that are measured at once, so that what is loud is known."""
    stretch: list[Timed] = []
    for group in groups:
        if stretch and _frame(group[0][1]) - _frame(stretch[0][0][0]) > STRETCH:
            yield stretch
            stretch = []
        stretch.append(group)
    if stretch:
        yield stretch


def _frame(time: float) -> int:
    return round(time / FRAME_PERIOD)


class _Frames:
    """What is heard, of which only that stays which may still be asked for."""

    def __init__(self, evidence: Iterable[Evidence]) -> None:
        self._coming = iter(evidence)
        self._waiting: list[Evidence] = []
        self._first = self._n = 0

    def take(self, first: int, last: int) -> Evidence:
        """Return the frames first..last-1, and forget what lies before; the sound may end earlier."""
        last = max(last, first + 1)  # a word that is shorter than a frame has one
        while self._n < last and (block := next(self._coming, None)) is not None:
            self._waiting.append(block)
            self._n += len(block)
        if not self._waiting:
            return _NO_FRAMES
        heard = joined(self._waiting)
        kept = heard.part(slice(max(first - self._first, 0), None))
        self._first += len(heard) - len(kept)
        self._waiting = [kept]
        return kept.part(slice(max(last - self._first, 0)))

    def exhaust(self) -> None:
        """Read the rest: whoever gives it measures more of the sound than this."""
        for _ in self._coming:
            pass


def _placed(said: Sequence[ScriptWord], shortfalls: Float64Array, start: float, end: float) -> Iterator[Word]:
    """Return words that are said from `start` to `end`, seconds."""
    passage = Passage(tuple(said))
    for hurry in range(MOST_HURRY + 1):
        least = LeastFrames(passage.least_frames(hurry))
        way = cheapest_way(shortfalls, passage.lattice, ONLY_THE_TEXT, least) if len(shortfalls) else None
        if way is not None:
            words = list(passage.words_in(way.steps, shortfalls, 0))
            yield from (within(shifted(word, start), end) for word in _filled(words, end - start))
            return
    yield from _spread(said, start, end)


def _filled(words: list[Word], length: float) -> list[Word]:
    """Return words of which the first begins at 0 and the last ends at `length`, but for longer quiet."""
    if words and words[0].start <= KEPT:
        words[0] = _with_edge(words[0], start=0.0)
    if words and words[-1].end >= length - KEPT:
        words[-1] = _with_edge(words[-1], end=length)
    return words


def _with_edge(word: Word, *, start: float | None = None, end: float | None = None) -> Word:
    """Return a word whose first phone begins, or whose last one ends, elsewhere."""
    k = 0 if start is not None else -1
    syllables = list(word.syllables)
    phones = list(syllables[k].phones)
    phones[k] = replace(phones[k], start=start) if start is not None else replace(phones[k], end=end or 0.0)
    syllables[k] = replace(syllables[k], phones=tuple(phones))
    return replace(word, syllables=tuple(syllables))


def _spread(said: Sequence[ScriptWord], start: float, end: float) -> Iterator[Word]:
    """Return words whose sounds share a time that is too short for them to be found in it."""
    spelt = [word.pronunciations[0].syllables for word in said]
    n = sum(len(syllable.phones) for syllables in spelt for syllable in syllables)
    edges = pairwise(np.linspace(start, end, n + 1).tolist())
    for word, syllables in zip(said, spelt, strict=True):
        parts = [
            Syllable(
                tuple(Phone(*next(edges), ipa, ipa_phoneme(ipa)) for ipa in syllable.phones),
                syllable.stress,
                syllable.text,
            )
            for syllable in syllables
        ]
        yield Word(word.text, tuple(parts))
