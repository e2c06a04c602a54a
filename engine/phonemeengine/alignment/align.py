"""A sound and what is said in it, in one call: its words, syllables and phones with times."""

import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from phonemeengine.alignment.aligner import Aligner
from phonemeengine.alignment.evidence import evidence_of
from phonemeengine.alignment.timed import align_timed
from phonemeengine.analyser import Analysis, analyse_file
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.labels.utterance import UNKNOWN_WORD, Phone, Syllable, Utterance, Word
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import segments_of
from phonemeengine.settings import FRAME_PERIOD, Channel
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import ScriptWord, words_of


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

    Words that nobody says are `Utterance.skipped`; what is said besides is `UNKNOWN_WORD`. Where another text was
    said, see `is_other_text`, the sound is recognised without it.

    Parameters
    ----------
    sound : the file, of any length.
    text : what is said in it, or its words with their pronunciations.
    preset : what to recognise with.
    language : the voice of espeak-ng that reads the text, such as ``de`` or ``en-us``.
    lexicon : how words are pronounced that the voice reads otherwise.
    channel : what is heard of a file of several channels.
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
    skipped : the words that nobody says.
    n_unknown : stretches in which something else is said.
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
        unheard = self.score is None or self.is_other
        return unheard, len(self.skipped) + self.n_unknown, self.score if self.score is not None else 0.0


def scored_take(path: Path, text: str, utterance: Utterance) -> ScoredTake:
    """Return how well a recording says a line, by the line's alignment with it."""
    said = [word for word in utterance.words if word.text != UNKNOWN_WORD]
    score = replace(utterance, words=tuple(said)).score
    n_unknown = len(utterance.words) - len(said)
    return ScoredTake(path, text, score, utterance.skipped, n_unknown, is_other_text(utterance))


def best_marked(takes: Iterable[ScoredTake]) -> tuple[ScoredTake, ...]:
    """Return takes in their order, the best one of each line marked; a line that nobody says has none."""
    takes = tuple(takes)
    best: dict[str, ScoredTake] = {}
    for take in takes:
        key = " ".join(take.text.split())
        if not take.rank[0] and (key not in best or take.rank < best[key].rank):
            best[key] = take
    chosen = {id(take) for take in best.values()}
    return tuple(replace(take, is_best=id(take) in chosen) for take in takes)
