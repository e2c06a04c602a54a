"""A sound and what is said in it, in one call: its words, syllables and phones with times."""

import math
import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np

from phonemeengine.alignment.aligner import MOST_HURRY, ONLY_THE_TEXT, STRETCH, Aligner, within
from phonemeengine.alignment.evidence import KINDS, Evidence, evidence_of, joined, shortfalls_of
from phonemeengine.alignment.passage import Passage
from phonemeengine.alignment.viterbi import LeastFrames, cheapest_way
from phonemeengine.analyser import Analysis, analyse_file, analyse_range
from phonemeengine.arrays import Float32Array, Float64Array, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word, shifted
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import segments_of
from phonemeengine.settings import FRAME_PERIOD, Channel
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import Interval, ScriptWord, words_of

# Words whose times are known: their phones are found within these times.

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
        taken = frames.take(first, last)
        shortfalls = shortfalls_of(taken) if len(taken) else np.zeros((0, len(KINDS)))
        for (start, end), said in stretch:
            part = shortfalls[_frame(start) - first : max(_frame(end), _frame(start) + 1) - first]
            found += _placed(said, part, start, end)
    frames.exhaust()
    return Utterance(tuple(found), duration, language)


FINE = 1e-6
"""Frames by which a time that is the beginning of one may be rounded."""
_NO_FRAMES = Evidence(np.zeros((0, len(Phoneme)), np.float32), np.zeros((0, 2), np.float32))

Timed = tuple[Interval, list[ScriptWord]]


def _stretches(groups: Sequence[Timed]) -> Iterator[list[Timed]]:
    """Return words in sections that are measured at once, so that the level of loud speech is known."""
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
    """The evidence of each frame; only what may still be asked for is kept."""

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
        evidence = joined(self._waiting)
        kept = evidence.part(slice(max(first - self._first, 0), None))
        self._first += len(evidence) - len(kept)
        self._waiting = [kept]
        return kept.part(slice(max(last - self._first, 0)))

    def exhaust(self) -> None:
        """Read the rest of the iterable, which measures more of the sound than this class reads."""
        for _ in self._coming:
            pass


def _placed(said: Sequence[ScriptWord], shortfalls: Float64Array, start: float, end: float) -> Iterator[Word]:
    """Return words that are said from `start` to `end`, seconds."""
    passage = Passage(tuple(said))
    # Given times may be too short for the usual least durations: sounds are allowed to be ever shorter until they
    # fit, and in the end share the time evenly.
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


def align_word(
    sound: str | os.PathLike[str], word: ScriptWord, span: Interval, preset: Preset, *, channel: Channel = Channel.MIX
) -> Word:
    """Return a word where it fits a sound file best within a span of time; only that part is analysed.

    Parameters
    ----------
    sound : the file.
    word : with its pronunciations.
    span : start and end, seconds.
    preset : what to recognise with.
    channel : which channel of the file is analysed.

    Raises
    ------
    AudioError : the file cannot be read.
    """
    first, last = math.ceil(span[0] / FRAME_PERIOD - FINE), math.floor(span[1] / FRAME_PERIOD + FINE)
    length = (last - first) * FRAME_PERIOD
    if last <= first:
        return next(_spread([word], *span))
    with SoundReader(sound, channel) as reader:
        evidence = map(evidence_of, analyse_range(reader, first, last, preset))
        found = align_timed(evidence, [replace(word, interval=(0.0, length))], length)
    return within(shifted(found.words[0], first * FRAME_PERIOD), span[1])


def align(
    sound: str | os.PathLike[str],
    text: str | Sequence[ScriptWord],
    preset: Preset,
    *,
    language: str,
    lexicon: Lexicon | None = None,
    channel: Channel = Channel.MIX,
    literal: bool = False,
    accept_text: bool = False,
) -> Utterance:
    """Return where the words of a text are in a sound file.

    Words that are not spoken are `Utterance.skipped`; speech besides the text is `UNKNOWN_WORD`. Where another text
    was said, see `is_other_text`, the sound is recognised without it.

    Parameters
    ----------
    sound : the file, of any length.
    text : what is said in it, or its words with their pronunciations.
    preset : what to recognise with.
    language : the voice of espeak-ng that reads the text, such as ``de`` or ``en-us``.
    lexicon : how words are pronounced that the voice reads otherwise.
    channel : which channel of the file is analysed.
    literal : take the notation of scripts in a text as words, too; see `words_of`.
    accept_text : align the words even where another text seems to be said.

    Raises
    ------
    AudioError : the file cannot be read.
    TextError : there is nothing to say in the text, or no such language.
    """
    words = words_of(text, language, lexicon, literal=literal) if isinstance(text, str) else text
    with SoundReader(sound, channel) as reader:
        analyses = analyse_file(reader, preset)
        return align_analyses(analyses, words, reader.duration, language, accept_text=accept_text)


def align_analyses(
    analyses: Iterable[Analysis],
    words: Sequence[ScriptWord],
    duration: float,
    language: str = "",
    *,
    accept_text: bool = False,
) -> Utterance:
    """Return where words are in a sound of `duration` seconds, from its consecutive analyses; see `align`.

    Words that have an interval, see `timed_words_of`, stay in it.
    """
    if words and words[0].interval is not None:
        return align_timed(map(evidence_of, analyses), words, duration, language)
    n_frames = math.ceil(duration / FRAME_PERIOD - 0.5)  # frames whose middle lies in the sound
    aligner, recognised, n = Aligner(words, n_frames, accepted=accept_text), [np.zeros(0, np.uint8)], 0
    for analysis in analyses:
        part = analysis.part(slice(n_frames - n))
        n += len(part)
        if len(part):
            aligner.push(evidence_of(part))
            recognised.append(part.phonemes)
    utterance = aligner.finish(duration, language)
    # Words of another text, forced onto a sound, would move a mouth wrongly; what was recognised without it moves it
    # better.
    if accept_text or not aligner.fit.is_wrong:
        return utterance
    skipped = tuple(word.text for word in words)
    return Utterance(_unknown_words(np.concatenate(recognised), duration), duration, language, skipped)


def is_other_text(utterance: Utterance) -> bool:
    """Return whether none of the words that were looked for is there, and all of the speech is unknown."""
    return bool(utterance.skipped) and all(word.text == UNKNOWN_WORD for word in utterance.words)


def _unknown_words(phonemes: UInt8Array, duration: float) -> tuple[Word, ...]:
    """Return what was recognised without a text, as words between silences."""
    loud: Float32Array = np.zeros(len(phonemes), np.float32)
    words: list[Word] = []
    phones: list[Phone] = []
    for run in segments_of([(phonemes, loud)], duration):
        if run.phoneme is not Phoneme.SILENCE:
            phones.append(Phone(run.start, run.end, "", run.phoneme))
        elif phones:
            words.append(Word(UNKNOWN_WORD, (Syllable(tuple(phones)),)))
            phones = []
    return (*words, Word(UNKNOWN_WORD, (Syllable(tuple(phones)),))) if phones else tuple(words)


# One line of a script in several takes: which of them says it best.


@dataclass(frozen=True)
class ScoredTake:
    """A recording of a line, and how well it says the line.

    Attributes
    ----------
    path : the sound's file.
    text : the line.
    score : of its words, see `Utterance.score`: 0 fits best; None where none of them is said.
    skipped : the words that are not spoken.
    n_unknown : sections in which something else is said.
    is_other : whether another text is said.
    is_best : whether no other take of the line is better.
    """

    path: Path
    text: str
    score: float | None
    skipped: tuple[str, ...]
    n_unknown: int
    is_other: bool
    is_best: bool = False

    @property
    def rank(self) -> tuple[bool, int, float]:
        """What orders takes: the better, the less. Words that are missing or added count before the score."""
        unaligned = self.score is None or self.is_other
        return unaligned, len(self.skipped) + self.n_unknown, self.score if self.score is not None else 0.0


def scored_take(path: Path, text: str, utterance: Utterance) -> ScoredTake:
    """Return how well a recording says a line, by the line's alignment with it."""
    said = [word for word in utterance.words if word.text != UNKNOWN_WORD]
    score = replace(utterance, words=tuple(said)).score
    n_unknown = len(utterance.words) - len(said)
    return ScoredTake(path, text, score, utterance.skipped, n_unknown, is_other_text(utterance))


def best_marked(takes: Iterable[ScoredTake]) -> tuple[ScoredTake, ...]:
    """Return takes in their order, the best one of each line marked; a line that was not spoken has none."""
    takes = tuple(takes)
    best: dict[str, ScoredTake] = {}
    for take in takes:
        key = " ".join(take.text.split())
        if not take.rank[0] and (key not in best or take.rank < best[key].rank):
            best[key] = take
    chosen = {id(take) for take in best.values()}
    return tuple(replace(take, is_best=id(take) in chosen) for take in takes)
