"""A voice: text becomes sound, and what is said when, both from one and the same call of the synthesizer.

The same text always sounds alike, whatever was spoken before, but for two of espeak-ng's voices, Reed and caleb, that
draw noise. It is spoken sentence by sentence, a Chinese one clause by clause, so that a long one needs no more memory
than a short one.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.resampling import Resampler
from phonemeengine.errors import TextError, VoiceError, check_range
from phonemeengine.labels.utterance import Utterance, Word, shifted
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.pinyin.script import mark_after
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.speech.pinyin.timing import USUAL_RATE
from phonemeengine.speech.synthesis import SpokenTokens, Token, speak_tokens
from phonemeengine.text import mandarin
from phonemeengine.text.cleaning import clauses_of, sentences_of, speakable, tokens_of
from phonemeengine.text.espeak import VOICE_RATE, Language, check_voice, language_of
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import MARKS, check_script
from phonemeengine.text.respelling import respelt

RATES = ((1.6, 80), (2.4, 120), (3.35, 160), (3.7, 175), (4.9, 220), (7.3, 300), (9.5, 450))
"""Syllables a second, measured, and the words a minute that are asked of the synthesizer for them."""
SENTENCE_PAUSE = 1.2
"""Silence after a sentence, in syllables: 0.3 s at the usual rate."""
_ASCII_MARKS = str.maketrans("。？！；：，、", ".?!;:,,")


@dataclass(frozen=True, eq=False)
class SpokenSentence:
    """A sentence, or a clause, as a voice said it, with the silence after it.

    Attributes
    ----------
    samples : float32, shape (n,), mono at 44.1 kHz, ±1.
    words : what is said, in seconds from the sentence's beginning; may be none.
    text : as it is written.
    skipped : words of the text that were not said: by a program, or Chinese characters without a known reading.
    unheeded : words that the voice cannot say as the lexicon has them, and said as it reads them.
    """

    samples: Float32Array
    words: tuple[Word, ...]
    text: str
    skipped: tuple[str, ...] = ()
    unheeded: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """Its length, seconds."""
        return len(self.samples) / SAMPLE_RATE


@dataclass(frozen=True)
class Voice:
    """A voice of espeak-ng that speaks texts of one language.

    Attributes
    ----------
    language : such as ``en-us``, ``de``, ``cmn``; see `languages`.
    name : another voice than the language's own, such as ``f3`` or ``klatt``; see `voices`.
    rate : syllables a second, 1.6..9.5.
    lexicon : how words are pronounced that the voice reads otherwise. It says those whose sounds it has; Chinese
        characters it cannot, as IPA tells no tones.
    pinyin_table : how long the pauses after Chinese clauses are; the one that ships, where it is None.

    Raises
    ------
    VoiceError : the rate lies outside its range.
    """

    language: str
    name: str = ""
    rate: float = USUAL_RATE
    lexicon: Lexicon = field(default_factory=Lexicon)
    pinyin_table: PinyinTable | None = None

    def __post_init__(self) -> None:
        check_range("the rate", self.rate, (RATES[0][0], RATES[-1][0], "syllables per second"), VoiceError)

    def speak(self, text: str, *, literal: bool = False) -> Iterator[SpokenSentence]:
        """Return what is spoken, sentence by sentence, each as soon as it is there.

        What cannot be spoken is left out, and so is the notation of scripts, unless it is to be taken literally;
        `notes_on` says what that is.

        Raises
        ------
        TextError : there is nothing to speak, or no such language, before anything is spoken; or after all of it, the
            voice had no sounds for any of it.
        VoiceError : there is no such voice, or no library of voices.
        """
        language = language_of(self.language)
        check_voice(self.name)
        cleaned = speakable(text, language.tag, literal=literal).text
        if language.tag in mandarin.TAGS:
            table = self.pinyin_table or load_pinyin_table()
            return _with_words(self._said_in_chinese(clause, language, table) for clause in clauses_of(cleaned))
        check_script(cleaned, language)
        return _with_words(self._said(sentence, language) for sentence in sentences_of(cleaned))

    def _said(self, sentence: str, language: Language) -> SpokenSentence:
        tokens = [Token(word.strip(MARKS) or word, word) for word in tokens_of(sentence)]
        return _ended([self._call(tokens, language)], sentence, SENTENCE_PAUSE / self.rate)

    def _said_in_chinese(self, clause: str, language: Language, table: PinyinTable) -> SpokenSentence:
        parts = list(mandarin.read(clause, language.tag))
        calls = [self._call(tokens, of) for tokens, of in _runs_of(parts)]
        sentence = _ended(calls, clause, _weight_after(clause, table) * table.pause / self.rate)
        unread = (part.text for part in parts if isinstance(part, mandarin.PinyinWord) and not part.syllables)
        return replace(sentence, skipped=tuple(unread))

    def _call(self, tokens: Sequence[Token], language: Language) -> SpokenTokens:
        tokens = [self._as_lexicon_has(token, language) for token in tokens]
        return speak_tokens(tokens, language, self.name, self._words_a_minute)

    def _as_lexicon_has(self, token: Token, language: Language) -> Token:
        """Return a word spelt as the lexicon has it, where it is there and the voice has such sounds."""
        spellings = self.lexicon.spellings.get(token.text.casefold(), ())
        respellings = () if token.pinyin else (respelt(ipa, language) for ipa in spellings)
        if found := next(filter(None, respellings), ""):
            return replace(token, spelt=found + token.spelt.partition(token.text)[2])
        return replace(token, unheeded=bool(spellings))

    @property
    def _words_a_minute(self) -> int:
        syllables, words = zip(*RATES, strict=True)
        return round(float(np.interp(self.rate, syllables, words)))


def speak(text: str, voice: Voice, *, literal: bool = False) -> tuple[Float32Array, Utterance]:
    """Return a text as sound and as what is said in it, whole; `Voice.speak` gives a long one sentence by sentence.

    Returns
    -------
    float32, shape (n,), mono at 44.1 kHz, ±1; and the utterance.

    Raises
    ------
    TextError : there is nothing to speak, or no such language.
    VoiceError : there is no such voice, or no library of voices.
    """
    parts: list[Float32Array] = []
    words: list[Word] = []
    n = 0
    for sentence in voice.speak(text, literal=literal):
        words += (shifted(word, n / SAMPLE_RATE) for word in sentence.words)
        parts.append(sentence.samples)
        n += len(sentence.samples)
    return np.concatenate(parts), Utterance(tuple(words), n / SAMPLE_RATE, voice.language)


def _with_words(sentences: Iterator[SpokenSentence]) -> Iterator[SpokenSentence]:
    """Return sentences as they come, and refuse them after the last one if no word was said."""
    n_words = 0
    for sentence in sentences:
        n_words += len(sentence.words)
        yield sentence
    if not n_words:
        raise TextError("the voice has no sounds for this text; check its language")


def _ended(calls: Sequence[SpokenTokens], text: str, pause: float) -> SpokenSentence:
    """Join what several calls gave, at 44.1 kHz, and add silence."""
    words: list[Word] = []
    n = 0
    for call in calls:
        words += (shifted(word, n / VOICE_RATE) for word in call.words)
        n += len(call.samples)
    whole = np.concatenate([np.zeros(0, np.int16), *(call.samples for call in calls)])
    block = (whole.astype(np.float32) / np.float32(32768))[:, np.newaxis]
    spoken = Resampler(VOICE_RATE, 1).resample(block, last=True)[:, 0]
    samples = np.concatenate([spoken, np.zeros(round(pause * SAMPLE_RATE), np.float32)])
    return SpokenSentence(
        samples, tuple(words), text, unheeded=tuple(word for call in calls for word in call.unheeded)
    )


def _weight_after(clause: str, table: PinyinTable) -> float:
    mark = mark_after(clause, table)
    return mark.weight if mark else 0.0


def _runs_of(parts: Sequence["mandarin.PinyinWord | str"]) -> Iterator[tuple[list[Token], Language]]:
    """Return Chinese words, and those of other scripts, in runs that one call can speak; marks end a run."""
    run: list[Token] = []
    chinese, english = language_of(mandarin.PINYIN_TAG), language_of("en-us")
    for part in parts:
        if isinstance(part, mandarin.PinyinWord):
            run += (
                Token(part.text, mandarin.spelt_for_voice(pinyin), pinyin, k > 0)
                for k, pinyin in enumerate(part.syllables)
            )
        elif part[0].isalnum():
            if run:
                yield run, chinese
            run = []
            yield [Token(part.strip(MARKS), part)], english
        elif run and (mark := part.translate(_ASCII_MARKS)) in {".", "?", "!", ";", ":", ","}:
            run[-1] = replace(run[-1], spelt=run[-1].spelt + mark)
    if run:
        yield run, chinese
