"""A passage of a text, laid out to be aligned, and its words where a way through it found them."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby, pairwise
from types import MappingProxyType

import numpy as np

from phonemeengine.alignment.evidence import KINDS, Manner, kind_of, least_frames_of, manner_of
from phonemeengine.alignment.viterbi import SILENT, SKIPPED, SOUND, STRANGE, Lattice, WayStep, lattice_of
from phonemeengine.arrays import Float64Array, IndexArray
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.text.pronunciation import ScriptWord

LONGEST_CLOSURE = 10
"""Frames of quiet before a stop that are taken for its closure."""
LEAST_STRANGE = 3
"""Frames that a sound lasts at least which the text does not hold."""


@dataclass(frozen=True)
class _SpeltSound:
    """A sound of a pronunciation, which of its syllables it is in, and that one's stress and spelling."""

    ipa: str
    syllable: int
    stress: int
    written: str


@dataclass(frozen=True, eq=False)
class Passage:
    """Consecutive words of a text.

    Attributes
    ----------
    words : at least one; each with at least one pronunciation.
    """

    words: tuple[ScriptWord, ...]

    @cached_property
    def _spellings(self) -> list[list[list[_SpeltSound]]]:
        return [
            [
                [
                    _SpeltSound(ipa, k, part.stress, part.text)
                    for k, part in enumerate(p.syllables)
                    for ipa in part.phones
                ]
                for p in word.pronunciations
            ]
            for word in self.words
        ]

    @cached_property
    def _sounds(self) -> list[_SpeltSound]:
        """The sounds of the lattice."""
        return [sound for word in self._spellings for spelling in word for sound in spelling]

    @cached_property
    def lattice(self) -> Lattice:
        """All ways to say it; its columns are the numbers of `KINDS`."""
        return lattice_of([[[kind_of(s.ipa) for s in spelling] for spelling in word] for word in self._spellings])

    def least_frames(self, hurry: int) -> IndexArray:
        """Return what each sound of the lattice lasts at least, where all are `hurry` frames shorter than usual."""
        return np.array([max(1, least_frames_of(sound.ipa) - hurry) for sound in self._sounds], np.intp)

    def n_words_in(self, steps: Sequence[WayStep]) -> int:
        """Return how many words a way from the beginning has said or skipped."""
        numbers = [self._word_at(step) for step in steps if step.kind in {SOUND, SKIPPED}]
        return max(numbers, default=-1) + 1

    def skipped_in(self, steps: Sequence[WayStep]) -> list[str]:
        """Return the words that a way leaves out."""
        return [self.words[step.sound].text for step in steps if step.kind == SKIPPED]

    def ends_word(self, step: WayStep) -> bool:
        """Return whether a word ends with a step, or it lies between words."""
        return step.kind != SOUND or int(self.lattice.after[step.sound]) <= self.lattice.n_words

    def column_of(self, step: WayStep) -> int | None:
        """Return where the scores of what a step says stand; None where the text does not hold it."""
        if step.kind == SILENT:
            return 0
        return int(self.lattice.columns[step.sound]) if step.kind == SOUND else None

    def closes(self, quiet: WayStep, steps: Sequence[WayStep]) -> bool:
        """Return whether a pause in a way is the closure of the stop that follows it."""
        following = next((step for step in steps if step.first == quiet.last and step.kind == SOUND), None)
        return following is not None and self._is_closure(quiet, following)

    def words_in(
        self,
        steps: Sequence[WayStep],
        shortfalls: Float64Array,
        first: int,
        edges: Mapping[int, float] = MappingProxyType({}),
    ) -> Iterator[Word]:
        """Return the words that a way says, and what it says besides.

        Parameters
        ----------
        steps : of the way.
        shortfalls : by which it was found.
        first : number of its first frame in the sound.
        edges : where the edges between steps are, in frames, by the number of the frame after them, if not there.
        """
        spoken = (step for step in self._with_closures(steps) if step.kind in {SOUND, STRANGE})
        for number, said in groupby(spoken, lambda step: -1 if step.kind == STRANGE else self._word_at(step)):
            if number < 0:
                for step in said:
                    yield from _strange_words(step, shortfalls, first)
            else:
                yield self._word(number, list(said), shortfalls, first, edges)

    def _word_at(self, step: WayStep) -> int:
        return step.sound if step.kind == SKIPPED else int(self.lattice.words[step.sound])

    def _with_closures(self, steps: Sequence[WayStep]) -> Iterator[WayStep]:
        """Return steps where the quiet before a stop, within speech, is part of it."""
        # A stop is a closure and a burst; the recogniser names the closure silence, so the best path has a pause
        # there. A short one between two sounds of speech belongs to the stop.
        earlier: tuple[WayStep | None, ...] = (None, None, *steps)
        for before, quiet, step in zip(earlier, earlier[1:], steps, strict=False):
            spoken = before is not None and before.kind == step.kind == SOUND
            closes = spoken and quiet is not None and quiet.kind == SILENT and self._is_closure(quiet, step)
            yield step._replace(first=quiet.first) if closes and quiet is not None else step

    def _is_closure(self, quiet: WayStep, step: WayStep) -> bool:
        is_stop = manner_of(self._sounds[step.sound].ipa) is Manner.STOP
        return is_stop and quiet.last - quiet.first <= LONGEST_CLOSURE

    def _word(
        self, number: int, said: Iterable[WayStep], shortfalls: Float64Array, first: int, edges: Mapping[int, float]
    ) -> Word:
        syllables = []
        for _, steps in groupby(said, lambda step: self._sounds[step.sound].syllable):
            part = list(steps)
            phones = tuple(self._phone(step, shortfalls, first, edges) for step in part)
            sound = self._sounds[part[0].sound]
            syllables.append(Syllable(phones, sound.stress, sound.written))
        return Word(self.words[number].text, tuple(syllables))

    def _phone(self, step: WayStep, shortfalls: Float64Array, first: int, edges: Mapping[int, float]) -> Phone:
        ipa = self._sounds[step.sound].ipa
        kind = int(self.lattice.columns[step.sound])
        phone = _phone_at(step.first, step.last, ipa, ipa_phoneme(ipa), shortfalls[:, kind], first)
        start, end = (first + edges.get(edge, float(edge)) for edge in (step.first, step.last))
        return replace(phone, start=start * FRAME_PERIOD, end=end * FRAME_PERIOD)


def _strange_words(step: WayStep, shortfalls: Float64Array, first: int) -> Iterator[Word]:
    """Return what is said in a section that the text does not hold: words end where it is silent."""
    kinds = shortfalls[step.first : step.last].argmax(axis=1)
    # without a text each frame says what suits it best; runs of equal ones become phones
    runs = [(kind, len(list(frames))) for kind, frames in groupby(_calmed(kinds).tolist())]
    ends = np.cumsum([n for _, n in runs]) + step.first
    phones = [
        (KINDS[kind].phoneme, _phone_at(int(end) - n, int(end), "", KINDS[kind].phoneme, shortfalls[:, kind], first))
        for (kind, n), end in zip(runs, ends, strict=True)
    ]
    for silent, spoken in groupby(phones, lambda pair: pair[0] is Phoneme.SILENCE):
        if not silent:
            yield Word(UNKNOWN_WORD, (Syllable(tuple(phone for _, phone in spoken)),))


def _calmed(kinds: IndexArray) -> IndexArray:
    """Return the kinds of frames, where what lasts less than `LEAST_STRANGE` frames belongs to what came before."""
    calmed = kinds.copy()
    starts = (np.flatnonzero(np.diff(kinds)) + 1).tolist()
    for start, end in pairwise([*starts, len(kinds)]):
        if end - start < LEAST_STRANGE:
            calmed[start:end] = calmed[start - 1]
    return calmed


def _phone_at(begin: int, end: int, ipa: str, phoneme: Phoneme, shortfalls: Float64Array, first: int) -> Phone:
    # the mean shortfall over its frames: 0 where nothing would fit better
    score = abs(float(shortfalls[begin:end].mean()))
    return Phone((first + begin) * FRAME_PERIOD, (first + end) * FRAME_PERIOD, ipa, phoneme, score)
