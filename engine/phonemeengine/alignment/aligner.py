"""Where the words of a text are in a sound, as it is heard: any length of both, in memory that grows with neither.

A stretch of the sound is aligned with the words that can be in it at most. All but its end, whose best way may still
change, is settled up to the end of a word, and the next stretch begins there.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.alignment.edges import edges_of
from phonemeengine.alignment.evidence import Evidence, joined, shortfalls_of, spoken_in
from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.sounds import least_frames_of
from phonemeengine.alignment.text_fit import TextFit, fit_of
from phonemeengine.alignment.viterbi import (
    SILENT,
    STRANGE,
    LeastFrames,
    Prices,
    WayStep,
    cheapest_way,
)
from phonemeengine.arrays import BoolArray
from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word
from phonemeengine.text.pronunciation import ScriptWord

STRETCH, UNSETTLED = 1000, 220
"""Frames that are aligned at once, and how many at their end stay unsettled."""
MOST_SOUNDS = 200
"""Sounds of the text that may be in a stretch: 20 a second, more than fast speakers say."""
ONLY_THE_TEXT = Prices(silence=3.0)
PRICES = Prices(silence=3.0, skip=42.0, skip_sound=3.0, strange=35.0, strange_frame=1.0)
"""What does not fit costs so much: of 113 words that are left out 90 are found (of those of up to three sounds 6 in
10), and in 3 of 158 lines that are said as they are written a word is taken to be left out."""
PRICES_OF_ACCEPTED = Prices(silence=3.0, skip=126.0, skip_sound=9.0, strange=105.0, strange_frame=3.0)
"""The same thrice, for a text of which somebody knows that it is said."""
UNHURRIED = 0.6
"""Sounds last their usual least duration where all of them fill no more than this share of the whole sound."""
AROUND = 8
"""Frames before and after the speech that count as part of the sound; more silence says nothing of its hurry."""
MOST_HURRY = 5
"""Frames by which sounds may be shorter than usual."""


class Aligner:
    """Finds the words of a text, one stretch of sound after the other.

    Parameters
    ----------
    words : the text.
    n_frames : how long the whole sound is: by that it is known how hurried the speech is.
    accepted : whether somebody knows that the text is said: then less of it is left out.

    Raises
    ------
    CorpusError : there is no word.
    """

    def __init__(self, words: Sequence[ScriptWord], n_frames: int, *, accepted: bool = False) -> None:
        if not words:
            raise CorpusError("there is no word in the text; write down what is said in the sound")
        self._words = tuple(words)
        self._prices = PRICES_OF_ACCEPTED if accepted else PRICES
        self._n_sounds = np.cumsum([0, *(_shortest(word) for word in words)])
        self._hurry = _hurry_of(words, n_frames)
        self._waiting: list[Evidence] = []
        self._n_frames = self._n_words = 0
        self._found: list[Word] = []
        self._skipped: list[str] = []
        self._fit = TextFit()

    @property
    def fit(self) -> TextFit:
        """How badly the text fits what was heard so far."""
        return self._fit

    def push(self, evidence: Evidence) -> None:
        """Take what is heard next."""
        self._waiting.append(evidence)
        while sum(len(part) for part in self._waiting) > STRETCH:
            heard = joined(self._waiting)
            n = self._align(heard.part(slice(STRETCH)), last=False)
            self._waiting = [heard.part(slice(n, None))]

    def finish(self, duration: float, language: str = "") -> Utterance:
        """Return where the words are in a sound of `duration` seconds; `language` is that of the text."""
        if any(len(part) for part in self._waiting):
            self._align(joined(self._waiting), last=True)
        skipped = (*self._skipped, *(word.text for word in self._words[self._n_words :]))
        words = (within(word, duration) for word in united(self._found) if word.start < duration)
        return Utterance(tuple(words), duration, language, skipped)

    def _align(self, heard: Evidence, *, last: bool) -> int:
        """Align a stretch, and settle its beginning, or all of it; returns how many frames of it."""
        end = int(np.searchsorted(self._n_sounds, self._n_sounds[self._n_words] + MOST_SOUNDS))
        passage = Passage(self._words[self._n_words : end])
        whole = last and end > len(self._words)
        spoken, first = spoken_in(heard), not self._n_words
        hurry = max(self._hurry, _hurry_of(passage.words, _n_about(spoken))) if whole else self._hurry
        shortfalls, least = shortfalls_of(heard), LeastFrames(passage.least_frames(hurry))
        way = cheapest_way(shortfalls, passage.lattice, self._prices, least, whole=whole)
        assert way is not None  # all of it may be strange
        steps = way.steps if last else settled_steps(way.steps, len(heard) - UNSETTLED, passage)
        n = steps[-1].last if steps else 0
        fit = fit_of(steps, passage, shortfalls, spoken)
        if fit.is_wrong and whole and first:
            strict = cheapest_way(shortfalls, passage.lattice, ONLY_THE_TEXT, least)
            fit = fit if strict is None else min(fit, fit_of(strict.steps, passage, shortfalls, spoken))
        self._fit += fit
        edges = edges_of(steps, passage, shortfalls, heard)
        self._found += passage.words_in(steps, shortfalls, self._n_frames, edges)
        self._skipped += passage.skipped_in(steps)
        self._n_words += passage.n_words_in(steps)
        self._n_frames += n
        return n


def settled_steps(steps: Sequence[WayStep], limit: int, passage: Passage) -> Sequence[WayStep]:
    """Return the steps up to the last end of a word before a frame; quiet and strange stretches are cut there."""
    ends = [k for k, step in enumerate(steps) if step.last <= limit and passage.ends_word(step)]
    n = ends[-1] + 1 if ends else 0
    if n < len(steps) and steps[n].kind in {SILENT, STRANGE} and steps[n].first < limit < steps[n].last:
        return [*steps[:n], steps[n]._replace(last=limit)]
    return steps[:n] or steps


def _hurry_of(words: Sequence[ScriptWord], n_frames: int) -> int:
    """Return by how many frames sounds are shorter than usual, so that all of them have room."""
    usual = np.array([least_frames_of(ipa) for word in words for ipa in word.pronunciations[0].phones])
    lengths = (int(np.maximum(usual - hurry, 1).sum()) for hurry in range(MOST_HURRY))
    return next((hurry for hurry, n in enumerate(lengths) if n <= UNHURRIED * n_frames), MOST_HURRY)


def _n_about(spoken: BoolArray) -> int:
    """Return how many frames there are from a little before the first one with speech to a little after the last."""
    frames = np.flatnonzero(spoken)
    return min(len(spoken), int(frames[-1] - frames[0]) + 1 + 2 * AROUND) if len(frames) else 0


def _shortest(word: ScriptWord) -> int:
    return min(len(pronunciation.phones) for pronunciation in word.pronunciations)


def united(words: Sequence[Word]) -> Iterator[Word]:
    """Return words, where unknown ones that touch each other are one."""
    before: Word | None = None
    for word in words:
        if before is not None and before.text == word.text == UNKNOWN_WORD and word.start - before.end < 1e-6:
            before = Word(UNKNOWN_WORD, (Syllable(before.phones + word.phones),))
            continue
        if before is not None:
            yield before
        before = word
    if before is not None:
        yield before


def within(word: Word, duration: float) -> Word:
    """Return a word that ends within the sound."""
    if word.end <= duration:
        return word
    syllables = (replace(s, phones=tuple(_cut(phone, duration) for phone in s.phones)) for s in word.syllables)
    return replace(word, syllables=tuple(syllables))


def _cut(phone: Phone, duration: float) -> Phone:
    return replace(phone, start=min(phone.start, duration), end=min(phone.end, duration))
