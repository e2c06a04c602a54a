"""One call of the synthesizer: words go in, and their sound and their times come out, from one and the same call."""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np

from phonemeengine.arrays import Int16Array
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.pinyin import onset_and_rime, timed_syllable
from phonemeengine.labels.utterance import Phone, Syllable, Word
from phonemeengine.text import espeak, mandarin
from phonemeengine.text.pronunciation import separator_of
from phonemeengine.text.respelling import PHONEMES
from phonemeengine.text.syllables import is_vowel, syllables_of

# Closures of stops: a synthesizer reports a stop when it bursts, but lips and tongue close before that.

STOPS = frozenset("pbtdkɡ")
LONGEST = 0.06
"""Seconds of a closure at most."""
QUIET = 0.25
"""Share of the loudest moment of the phone before, below which it is closed."""
_STEP = espeak.VOICE_RATE // 500
"""Samples that are looked at together (2 ms)."""


def closure_before(samples: Int16Array, phone: int, burst: int, symbol: str) -> int:
    """Return how many samples before its burst a stop closes: the quiet part there, at most half a phone.

    Parameters
    ----------
    samples : of the voice, at `VOICE_RATE`.
    phone : where the phone before begins, or the silence.
    burst : where the stop is reported.
    symbol : of IPA; what is no stop has no closure.
    """
    n_most = min((burst - phone) // 2, round(LONGEST * espeak.VOICE_RATE)) // _STEP
    if symbol not in STOPS or n_most < 1:
        return 0
    before = np.abs(samples[phone:burst].astype(np.int32))
    levels = before[len(before) - n_most * _STEP :].reshape(n_most, _STEP).max(axis=1)
    loud = np.flatnonzero(levels > QUIET * before.max())
    return (n_most - (int(loud[-1]) + 1 if len(loud) else 0)) * _STEP


LEAST_CLOSURE = 0.2
"""Share of an affricate that its closure has at least where it was found in the sound; else it has half."""

LONGEST_GAP = 0.06
"""Seconds that a voice of usual speed is silent between two words without a pause, at most: 39 ms before stops."""


@dataclass(frozen=True)
class Token:
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
class SpokenTokens:
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


def speak_tokens(tokens: Sequence[Token], language: espeak.Language, voice: str, words_a_minute: int) -> SpokenTokens:
    """Have the synthesizer speak words in one call.

    Parameters
    ----------
    tokens : the words.
    language : of all of them.
    voice : one of `voices`; the language's own where it is empty.
    words_a_minute : 80..450.

    Raises
    ------
    VoiceError : the library fails.
    """
    text, starts = _text_of(tokens, language)
    blocks = [np.zeros(0, np.int16)]
    events: list[espeak.Event] = []

    def take_sound(samples: Int16Array, begun: tuple[espeak.Event, ...]) -> bool:
        blocks.append(samples)
        events.extend(begun)
        return True

    espeak.synthesise(text, language, take_sound, voice=voice, rate=words_a_minute, phonemes=PHONEMES in text)
    samples = np.concatenate(blocks)
    longest_gap = round(
        LONGEST_GAP * espeak.NORMAL_RATE / min(words_a_minute, espeak.NORMAL_RATE) * espeak.VOICE_RATE
    )
    phones = list(_without_gaps([event for event in events if event.kind is espeak.EventKind.PHONE], longest_gap))
    begin = 0 if phones and phones[0].sample <= longest_gap else len(samples)
    words = tuple(_words_of(tokens, _timed(phones, samples, starts, len(tokens), begin)))
    return SpokenTokens(samples, words, tuple(token.text for token in tokens if token.unheeded))


def _text_of(tokens: Sequence[Token], language: espeak.Language) -> tuple[str, list[int]]:
    """Return what the synthesizer is given, and where in it each token begins."""
    text, starts = "", []
    for token in tokens:
        starts.append(len(text))
        separator = "" if token.spelt.startswith(PHONEMES) else separator_of(language)
        text += f"{separator}{token.spelt} "
    return text.rstrip(), starts


def _timed(
    phones: Sequence[espeak.Event], samples: Int16Array, starts: Sequence[int], n_tokens: int, first: int
) -> list[list[_Timed]]:
    """Return the phones of each token, with times; those of stops begin with their closure, and one by `first`."""
    found: list[list[_Timed]] = [[] for _ in range(n_tokens)]
    bursts = [min(event.sample, len(samples)) for event in phones]
    begins = [_begin(bursts[max(k - 1, 0)], bursts[k], event, samples) for k, event in enumerate(phones)]
    begins[:1] = [min(begin, first) for begin in begins[:1]]
    for event, begin, burst, end in zip(phones, begins, bursts, [*begins[1:], len(samples)], strict=False):
        token = max(0, bisect_right(starts, event.position) - 1)
        symbols = espeak.symbols_of(event.name)
        if symbols and end > begin:
            found[token] += _shared(symbols, begin, burst, end, espeak.stress_of(event.name))
    return found


def _without_gaps(phones: Sequence[espeak.Event], longest: int) -> Iterator[espeak.Event]:
    """Return phones and pauses, without gaps of at most this many samples before phones, which are no pauses."""
    runs = [(spoken, list(run)) for spoken, run in groupby(phones, lambda event: bool(espeak.symbols_of(event.name)))]
    for k, (spoken, run) in enumerate(runs):
        if spoken or k == len(runs) - 1 or runs[k + 1][1][0].sample - run[0].sample > longest:
            yield from run


def _begin(before: int, burst: int, event: espeak.Event, samples: Int16Array) -> int:
    """Return the sample at which a phone begins: that of its event, or for a stop, of its closure."""
    symbols = espeak.symbols_of(event.name)
    return burst - (closure_before(samples, before, burst, symbols[0]) if symbols else 0)


def _shared(symbols: Sequence[str], begin: int, burst: int, end: int, stress: int) -> Iterator[_Timed]:
    """Share the samples of one sound among its symbols: equally; an affricate's closure ends where it bursts."""
    borders = [begin + (end - begin) * k // len(symbols) for k in range(len(symbols) + 1)]
    if symbols[0] in STOPS and len(symbols) == 2 and LEAST_CLOSURE * (end - begin) < burst - begin < end - begin:
        borders[1] = burst
    for symbol, first, last in zip(symbols, borders, borders[1:], strict=False):
        yield _Timed(symbol, first / espeak.VOICE_RATE, last / espeak.VOICE_RATE, stress if is_vowel(symbol) else 0)


def _words_of(tokens: Sequence[Token], timed: Sequence[list[_Timed]]) -> Iterator[Word]:
    """Return the words that tokens make, without those that made no sound."""
    words: list[Word] = []
    for token, phones in zip(tokens, timed, strict=True):
        syllables = tuple(_syllables(token, phones)) if phones else ()
        if token.continues and words:
            words[-1] = replace(words[-1], syllables=words[-1].syllables + syllables)
        else:
            words.append(Word(token.text, syllables))
    return (word for word in words if word.syllables)


def _syllables(token: Token, phones: Sequence[_Timed]) -> Iterator[Syllable]:
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
