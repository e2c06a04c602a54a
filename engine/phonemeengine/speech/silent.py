"""Text without sound: what is said when, in any language, at a rate of syllables per second."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np

from phonemeengine.errors import TextError, VoiceError
from phonemeengine.labels.utterance import Utterance, Word
from phonemeengine.mouth.transcript import Transcript, transcript_of_utterance
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.speech.pinyin import timing
from phonemeengine.speech.pinyin.script import Read, Written, chinese_parts, clause_parts
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.text import mandarin
from phonemeengine.text.cleaning import speakable, spoken_part
from phonemeengine.text.espeak import language_of
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import ScriptWord, check_script, clause_reader

ENGLISH = "en-us"
"""The language as which words of other scripts are read in a Chinese text."""


@dataclass(frozen=True, eq=False)
class SilentText:
    """A text without a voice.

    Parameters
    ----------
    text : of any length.
    language : such as ``en-us``, ``de``, ``cmn``. Chinese needs no library of voices, but for words of other scripts.
    table : the letters of pinyin, and how long pauses are; those that ship, where it is None.
    rate : syllables per second, 0.5..10.
    seed : of the variation of onsets; none varies where it is None.
    lexicon : how words are pronounced.
    literal : take the notation of scripts as words, too.

    Raises
    ------
    TextError : there is nothing to speak, no such language, or the rate lies outside its range.
    VoiceError : the library of voices is missing or broken, and the text needs it.
    """

    text: str
    language: str
    table: PinyinTable = field(default_factory=load_pinyin_table)
    rate: float = timing.USUAL_RATE
    seed: int | None = None
    lexicon: Lexicon | None = None
    literal: bool = False

    def __post_init__(self) -> None:
        timing.pause_unit(self.table, self.rate)
        if not self._is_chinese:
            check_script(self._cleaned, language_of(self.language))

    def parts(self) -> Iterator[timing.SaidPart | str]:
        """Return its words and pauses one by one, with their times; as text, what is not spoken.

        Raises
        ------
        TextError : after all of it, nothing was spoken.
        """
        skipped: list[str] = []
        n_words = 0
        for part in timing.said_at_rate(self._spoken(skipped), self.table, self.rate, self.seed):
            yield from skipped
            skipped.clear()
            n_words += part.word is not None
            yield part
        yield from skipped
        if not n_words:
            what = "Chinese syllable" if self._is_chinese else "word"
            raise TextError(f"there is no {what} in the text; write some, or name its language")

    def rows(self) -> Iterator[timing.PlanRow]:
        """Return the rows of its plan, one by one."""
        return (row for part in self.parts() if isinstance(part, timing.SaidPart) for row in part.rows)

    def whole(self) -> "SilentSpeech":
        """Return what is said in it, whole."""
        rows: list[timing.PlanRow] = []
        words: list[Word] = []
        skipped: list[str] = []
        for part in self.parts():
            if isinstance(part, str):
                skipped.append(part)
                continue
            rows += part.rows
            words += () if part.word is None else (part.word,)
        plan = timing.Plan(tuple(rows), timing.pause_unit(self.table, self.rate))
        return SilentSpeech(Utterance(tuple(words), plan.duration, self.language, tuple(skipped)), plan)

    @property
    def _is_chinese(self) -> bool:
        return self.language.lower() in mandarin.TAGS

    @property
    def _cleaned(self) -> str:
        return speakable(self.text, self.language, literal=self.literal).text

    def _spoken(self, skipped: list[str]) -> Iterator[Written]:
        """Return what is spoken; what is not goes to `skipped`."""
        if self._is_chinese:
            text = self.text if self.literal else spoken_part(self.text, self.language).text
            parts = chinese_parts(text, self.table, self._read_english(), self.language.lower())
        else:
            parts = clause_parts(self._cleaned, self.table, clause_reader(self.language, self.lexicon))
        for part in parts:
            if isinstance(part, str):
                skipped.append(part)
            else:
                yield part

    def _read_english(self) -> Read:
        """Return what reads words of other scripts; espeak-ng is loaded for the first one."""

        @cache
        def reader() -> Read:
            try:
                return clause_reader(ENGLISH, self.lexicon)
            except VoiceError:  # then Chinese alone is spoken, as it needs no library
                return lambda _word: ()

        def read(word: str) -> Iterable[ScriptWord]:
            return reader()(word)

        return read


@dataclass(frozen=True)
class SilentSpeech:
    """What is said in a text without a voice, and its plan."""

    utterance: Utterance
    plan: timing.Plan

    def transcript(self, name: str) -> Transcript:
        """Return what is said, as if a voice of even loudness said it, until the mouth is at rest.

        Parameters
        ----------
        name : what files that are made of it call the sound.
        """
        said = replace(self.utterance, duration=self.plan.duration + timing.AFTERWARDS)
        loud = np.zeros(round(said.duration / FRAME_PERIOD), np.float32)
        for phone in said.phones:
            loud[round(phone.start / FRAME_PERIOD) : round(phone.end / FRAME_PERIOD)] = 1
        return transcript_of_utterance(said, loud, np.zeros_like(loud), name)
