"""A voice: text becomes sound, and what is said when, both from one and the same call of the synthesizer.

Two calls with the same text differ by some milliseconds, so times are never taken from another one. A text is spoken
sentence by sentence, a Chinese one clause by clause, so that a long one needs no more memory than a short one.
"""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import takewhile

import numpy as np

from phonemeengine.arrays import Float32Array, Int16Array
from phonemeengine.audio.resampling import Resampler
from phonemeengine.errors import TextError, VoiceError
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.pinyin import onset_and_rime, timed_syllable
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word, shifted
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.closures import STOPS, closure_before
from phonemeengine.speech.pinyin.table import PinyinTable, load_pinyin_table
from phonemeengine.text import mandarin
from phonemeengine.text.clauses import clauses_of, sentences_of, tokens_of
from phonemeengine.text.cleaning import speakable
from phonemeengine.text.espeak import (
    VOICE_RATE,
    Event,
    EventKind,
    Language,
    check_voice,
    language_of,
    stress_of,
    symbols_of,
    synthesise,
)
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.pronunciation import MARKS, check_script, separator_of
from phonemeengine.text.respelling import PHONEMES, respelt
from phonemeengine.text.syllables import is_vowel, syllables_of

USUAL_RATE = 4.0
"""Syllables a second, unless told otherwise."""
RATES = ((1.6, 80), (2.4, 120), (3.35, 160), (3.7, 175), (4.9, 220), (7.3, 300), (9.5, 450))
"""Syllables a second, measured, and the words a minute that are asked of the synthesizer for them."""
SENTENCE_PAUSE = 1.2
"""Silence after a sentence, in syllables: 0.3 s at the usual rate."""
LEAST_CLOSURE = 0.2
"""Share of an affricate that its closure has at least where it was found in the sound; else it has half."""
_ASCII_MARKS = str.maketrans("。？！；：，、", ".?!;:,,")


@dataclass(frozen=True, eq=False)
class SpokenSentence:
    """A sentence, or a clause, as a voice said it, with the silence after it.

    Attributes
    ----------
    samples : float32, shape (n,), mono at 44.1 kHz, ±1.
    words : what is said, in seconds from the sentence's beginning; may be none.
    text : as it is written.
    skipped : words of the text that were not said: by a program, or of Chinese characters that nobody can read.
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
        if not RATES[0][0] <= self.rate <= RATES[-1][0]:
            raise VoiceError(
                f"the rate of a voice must lie in {RATES[0][0]}..{RATES[-1][0]} syllables a second, got "
                f"{self.rate:g}; choose another"
            )

    def speak(self, text: str) -> Iterator[SpokenSentence]:
        """Return what is spoken, sentence by sentence, each as soon as it is there.

        What nobody can speak is left out; `notes_on` says what that is.

        Raises
        ------
        TextError : there is nothing to speak, or no such language, before anything is spoken; or after all of it, the
            voice had no sounds for any of it.
        VoiceError : there is no such voice, or no library of voices.
        """
        language = language_of(self.language)
        check_voice(self.name)
        cleaned = speakable(text).text
        if language.tag in {*mandarin.TAGS, mandarin.PINYIN_TAG}:
            table = self.pinyin_table or load_pinyin_table()
            return _with_words(self._said_in_chinese(clause, language, table) for clause in clauses_of(cleaned))
        check_script(cleaned, language)
        return _with_words(self._said(sentence, language) for sentence in sentences_of(cleaned))

    def _said(self, sentence: str, language: Language) -> SpokenSentence:
        tokens = [_Token(word.strip(MARKS) or word, word) for word in tokens_of(sentence)]
        call = self._call(tokens, language)
        return _ended([call], sentence, SENTENCE_PAUSE / self.rate)

    def _said_in_chinese(self, clause: str, language: Language, table: PinyinTable) -> SpokenSentence:
        read = mandarin.read_pinyin if language.tag == mandarin.PINYIN_TAG else mandarin.read
        parts = list(read(clause))
        calls = [self._call(tokens, of) for tokens, of in _runs_of(parts)]
        sentence = _ended(calls, clause, _weight_of(clause, table) * table.pause / self.rate)
        unread = (part.text for part in parts if isinstance(part, mandarin.PinyinWord) and not part.syllables)
        return replace(sentence, skipped=tuple(unread))

    def _call(self, tokens: Sequence["_Token"], language: Language) -> "_Call":
        """Have the synthesizer speak words in one call."""
        tokens = [self._as_lexicon_has(token, language) for token in tokens]
        text, starts = "", []
        for token in tokens:
            starts.append(len(text))
            separator = "" if token.spelt.startswith(PHONEMES) else separator_of(language)
            text += f"{separator}{token.spelt} "
        blocks: list[Int16Array] = []
        events: list[Event] = []

        def hear(samples: Int16Array, begun: tuple[Event, ...]) -> bool:
            blocks.append(samples)
            events.extend(begun)
            return True

        phonemes = PHONEMES in text
        synthesise(text.rstrip(), language, hear, voice=self.name, rate=self._words_a_minute, phonemes=phonemes)
        samples = np.concatenate(blocks) if blocks else np.zeros(0, np.int16)
        words = tuple(_words_of(tokens, _timed(events, samples, starts, len(tokens))))
        return _Call(samples, words, tuple(token.text for token in tokens if token.unheeded))

    def _as_lexicon_has(self, token: "_Token", language: Language) -> "_Token":
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


def speak(text: str, voice: Voice) -> tuple[Float32Array, Utterance]:
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
    for sentence in voice.speak(text):
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


@dataclass(frozen=True)
class _Token:
    """What the synthesizer takes for a word.

    Attributes
    ----------
    text : of the word it belongs to.
    spelt : for the synthesizer, with the marks around it.
    pinyin : of a Chinese syllable.
    continues : whether it belongs to the word of the token before it.
    unheeded : whether the lexicon has it otherwise than it can be said.
    """

    text: str
    spelt: str
    pinyin: str = ""
    continues: bool = False
    unheeded: bool = False


@dataclass(frozen=True, eq=False)
class _Call:
    """What one call gave: samples at `VOICE_RATE`, words in seconds, and those that the lexicon has otherwise."""

    samples: Int16Array
    words: tuple[Word, ...]
    unheeded: tuple[str, ...]


@dataclass(frozen=True)
class _Timed:
    """A phone with its times, seconds, and stress."""

    ipa: str
    start: float
    end: float
    stress: int = 0


def _ended(calls: Sequence[_Call], text: str, pause: float) -> SpokenSentence:
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


def _weight_of(clause: str, table: PinyinTable) -> float:
    """Return the weight of the pause after a Chinese clause: that of the heaviest of its last marks."""
    last = takewhile(lambda character: not character.isalnum(), reversed(clause))
    return max(map(table.pause_at, last), default=0.0)


def _runs_of(parts: Sequence["mandarin.PinyinWord | str"]) -> Iterator[tuple[list[_Token], Language]]:
    """Return Chinese words, and those of other scripts, in runs that one call can speak; marks end a run."""
    run: list[_Token] = []
    chinese, english = language_of(mandarin.PINYIN_TAG), language_of("en-us")
    for part in parts:
        if isinstance(part, mandarin.PinyinWord):
            run += (
                _Token(part.text, mandarin.spelt_for_voice(pinyin), pinyin, k > 0)
                for k, pinyin in enumerate(part.syllables)
            )
        elif part[0].isalnum():
            if run:
                yield run, chinese
            run = []
            yield [_Token(part.strip(MARKS), part)], english
        elif run and (mark := part.translate(_ASCII_MARKS)) in {".", "?", "!", ";", ":", ","}:
            run[-1] = replace(run[-1], spelt=run[-1].spelt + mark)
    if run:
        yield run, chinese


def _timed(events: Sequence[Event], samples: Int16Array, starts: Sequence[int], n_tokens: int) -> list[list[_Timed]]:
    """Return the phones of each token, with times; those of stops begin with their closure."""
    found: list[list[_Timed]] = [[] for _ in range(n_tokens)]
    phones = [event for event in events if event.kind is EventKind.PHONE]
    bursts = [min(event.sample, len(samples)) for event in phones]
    begins = [_begin(bursts[max(k - 1, 0)], bursts[k], event, samples) for k, event in enumerate(phones)]
    for event, begin, burst, end in zip(phones, begins, bursts, [*begins[1:], len(samples)], strict=False):
        token = max(0, bisect_right(starts, event.position) - 1)
        symbols = symbols_of(event.name)
        if symbols and end > begin:
            found[token] += _shared(symbols, begin, burst, end, stress_of(event.name))
    return found


def _begin(before: int, burst: int, event: Event, samples: Int16Array) -> int:
    """Return the sample at which a phone begins: that of its event, or for a stop, of its closure."""
    symbols = symbols_of(event.name)
    return burst - (closure_before(samples, before, burst, symbols[0]) if symbols else 0)


def _shared(symbols: Sequence[str], begin: int, burst: int, end: int, stress: int) -> Iterator[_Timed]:
    """Share the samples of one sound among its symbols: equally; an affricate's closure ends where it bursts."""
    borders = [begin + (end - begin) * k // len(symbols) for k in range(len(symbols) + 1)]
    if symbols[0] in STOPS and len(symbols) == 2 and LEAST_CLOSURE * (end - begin) < burst - begin < end - begin:
        borders[1] = burst
    for symbol, first, last in zip(symbols, borders, borders[1:], strict=False):
        yield _Timed(symbol, first / VOICE_RATE, last / VOICE_RATE, stress if is_vowel(symbol) else 0)


def _words_of(tokens: Sequence[_Token], timed: Sequence[list[_Timed]]) -> Iterator[Word]:
    """Return the words that tokens make, without those that made no sound."""
    words: list[Word] = []
    for token, phones in zip(tokens, timed, strict=True):
        syllables = tuple(_syllables(token, phones)) if phones else ()
        if token.continues and words:
            words[-1] = replace(words[-1], syllables=words[-1].syllables + syllables)
        else:
            words.append(Word(token.text, syllables))
    return (word for word in words if word.syllables)


def _syllables(token: _Token, phones: Sequence[_Timed]) -> Iterator[Syllable]:
    if token.pinyin:
        yield _chinese_syllable(token.pinyin, phones)
        return
    rest = iter(phones)
    for syllable in syllables_of([phone.ipa for phone in phones], [phone.stress for phone in phones]):
        own = (next(rest) for _ in syllable.phones)
        yield Syllable(tuple(Phone(x.start, x.end, x.ipa, ipa_phoneme(x.ipa)) for x in own), syllable.stress)


def _chinese_syllable(sound: str, phones: Sequence[_Timed]) -> Syllable:
    """Return a syllable of pinyin with the times of what the voice made of it.

    The voice has names of its own, so only where consonants end and vowels begin is taken from it, unless it has as
    many phones.
    """
    names = mandarin.syllable_of(sound).phones
    if len(names) == len(phones):
        pairs = zip(names, phones, strict=True)
        return Syllable(tuple(Phone(x.start, x.end, ipa, ipa_phoneme(ipa)) for ipa, x in pairs), text=sound)
    start, end = phones[0].start, phones[-1].end
    turn = next((phone.start for phone in phones if is_vowel(phone.ipa)), start)
    if turn == start:
        turn += (end - start) * len(onset_and_rime(sound[:-1])[0]) / len(names)
    return timed_syllable(sound, start, turn, end)
