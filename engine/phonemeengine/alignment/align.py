"""A sound and what is said in it, in one call: its words, syllables and phones with times."""

import math
import os
from collections.abc import Iterable, Sequence

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
