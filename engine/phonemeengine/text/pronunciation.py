"""How the words of a text are pronounced: by a lexicon first, then by pinyin, then by the voice of their language."""

import re
import unicodedata
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from phonemeengine.errors import TextError, VoiceError
from phonemeengine.labels.timed_words import TimedWord
from phonemeengine.text import espeak, mandarin
from phonemeengine.text.cleaning import clauses_of, speakable, tokens_of
from phonemeengine.text.espeak import Language, language_of, phone_names, symbols_of
from phonemeengine.text.lexicon import Lexicon
from phonemeengine.text.syllables import SpokenSyllable, syllables_of

BREAK = "\u200b"
"""Before each word of English, it keeps the voice from melting words together, such as *of the*; it is inaudible.

Other languages do without: it would part a preposition from the word that voices it.
"""

MARKS = ".,;:!?…\"“”„‚‘’'«»‹›()[]{}<>¿¡—–-。！？；：，、「」『』（）《》·*_~|/\\"
"""What stands around words and is not part of them."""


_LETTERS = re.compile(r"[^\W\d_]{1,40}")
_PAUSE = 2 * espeak.SEPARATOR
"""Between the names of two letters that are spelt."""
_SAMPLED = 40
"""Words of a text that are looked at to know its script."""
_SHOWN = 5


Interval = tuple[float, float]
"""Start and end, seconds."""


@dataclass(frozen=True)
class Pronunciation:
    """A way to pronounce a word: its syllables, at least one."""

    syllables: tuple[SpokenSyllable, ...]

    @property
    def phones(self) -> tuple[str, ...]:
        """Its phones, symbols of IPA; the halves of an affricate are two."""
        return tuple(phone for syllable in self.syllables for phone in syllable.phones)


@dataclass(frozen=True)
class ScriptWord:
    """A word of a script.

    Attributes
    ----------
    text : as it is written, without the marks around it.
    pronunciations : the likeliest first: as it is said in its clause, then alone; or as a lexicon has it. At least
        one.
    interval : when it is said, start and end in seconds, where that is known; several words may share one.
    """

    text: str
    pronunciations: tuple[Pronunciation, ...]
    interval: Interval | None = None


def words_of(
    text: str, language: str | None, lexicon: Lexicon | None = None, *, literal: bool = False
) -> tuple[ScriptWord, ...]:
    """Return the words of a text, in order, and how they are pronounced.

    Numbers, dates and abbreviations are read as the voice of the language reads them. The notation of scripts, such
    as ``MARY (sighs): *Never*``, is not spoken.

    Parameters
    ----------
    text : of any length; what cannot be spoken is left out, see `speakable`.
    language : such as ``en-us`` or ``de``; see `espeak.languages`.
    lexicon : goes before the voice.
    literal : take the notation of scripts as words, too.

    Raises
    ------
    TextError : there is nothing to speak, or no such language.
    VoiceError : the library of voices is missing or broken.
    """
    known = language_of(language)
    cleaned = speakable(text, language, literal=literal).text
    if known.tag not in mandarin.TAGS:
        check_script(cleaned, known)
    read = clause_reader(language, lexicon)
    words = tuple(word for clause in clauses_of(cleaned) for word in read(clause))
    if not words:
        raise TextError(f"the voice of {known.tag} has no sounds for this text; check its language")
    return words


def clause_reader(language: str | None, lexicon: Lexicon | None = None) -> Callable[[str], Iterator[ScriptWord]]:
    """Return what gives the words of a clause of a language, and how they are pronounced.

    Raises
    ------
    TextError : there is no such language.
    VoiceError : the library of voices is missing or broken.
    """
    known, lexicon = language_of(language), lexicon or Lexicon()
    if known.tag in mandarin.TAGS:
        return _MandarinReader(known, lexicon).words_of
    return _WordReader(known, lexicon).words_of


def timed_words_of(
    words: Sequence[TimedWord], language: str | None, lexicon: Lexicon | None = None
) -> tuple[ScriptWord, ...]:
    """Return words with given times, and how they are pronounced; those without a sound are left out.

    Parameters
    ----------
    words : in order of time; see `read_timed_words`.
    language, lexicon : as in `words_of`.

    Raises
    ------
    TextError, VoiceError : as in `words_of`.
    """
    read = words_of(" ".join(word.text for word in words), language, lexicon)
    if [word.text for word in read] == [word.text.strip(MARKS) for word in words]:
        return tuple(replace(one, interval=(w.start, w.end)) for one, w in zip(read, words, strict=True))
    # What one side takes for a word is none, or several, to the other, so each is read on its own.
    return tuple(
        replace(one, interval=(w.start, w.end)) for w in words for one in _words_alone(w.text, language, lexicon)
    )


def _words_alone(text: str, language: str | None, lexicon: Lexicon | None) -> tuple[ScriptWord, ...]:
    try:
        return words_of(text, language, lexicon)
    except VoiceError:
        raise
    except TextError:  # a mark, or a word of another script
        return ()


def check_script(text: str, language: Language) -> None:
    """Refuse a text whose first words are mostly of a script that the voice of a language spells letter by letter.

    Raises
    ------
    TextError : they are.
    """
    words = [found.group() for found, _ in zip(_LETTERS.finditer(text), range(_SAMPLED), strict=False)]
    spelt = [word for word in words if _is_spelt(word, phone_names(word, language))]
    if 2 * len(spelt) > len(words):
        raise TextError(
            f"the voice of {language.tag} cannot read {spelt[0]!r:.40}, which is of another script; name the "
            "language of the text"
        )


def notes_on(text: str, language: str | None = None, *, literal: bool = False) -> tuple[str, ...]:
    """Return what a user should know of a text before it is spoken, or found in a sound: a sentence each.

    Names, directions, emoji and control characters are left out; words of scripts that the voice of the language does
    not read are spelt letter by letter. With `literal` names and directions are spoken.

    Raises
    ------
    TextError : there is nothing to speak, or no such language.
    VoiceError : the library of voices is missing or broken.
    """
    cleaned = speakable(text, language, literal=literal)
    spelt = _spelt_words(cleaned.text, language_of(language)) if language else ()
    if not spelt:
        return cleaned.notes
    more = f" and {len(spelt) - _SHOWN} more" if len(spelt) > _SHOWN else ""
    words = ", ".join(spelt[:_SHOWN]) + more
    return (*cleaned.notes, f"the voice of {language} spells words of another script letter by letter: {words}")


def separator_of(language: Language) -> str:
    """Return what stands before each word, so that it has phones and times of its own."""
    return BREAK if language.tag.startswith("en") else ""


class _MandarinReader:
    """Reads Chinese, by characters or pinyin; words of other scripts are read as English."""

    def __init__(self, language: Language, lexicon: Lexicon) -> None:
        self._tag = language.tag
        self._lexicon = lexicon
        self._english = _WordReader(language_of("en-us"), lexicon)

    def words_of(self, clause: str) -> Iterator[ScriptWord]:
        for word in mandarin.read(clause, self._tag):
            if isinstance(word, str):
                yield from self._english.words_of(word)
            elif word.syllables:
                syllables = tuple(map(mandarin.syllable_of, word.syllables))
                variants = self._lexicon.pronunciations.get(word.text) or (syllables,)
                yield ScriptWord(word.text, tuple(map(Pronunciation, variants)))


class _WordReader:
    """Reads clauses of one language, and remembers how words are pronounced that stand alone."""

    def __init__(self, language: Language, lexicon: Lexicon) -> None:
        self._language = language
        self._lexicon = lexicon
        self._alone: dict[str, tuple[str, ...]] = {}

    def words_of(self, clause: str) -> Iterator[ScriptWord]:
        tokens = tokens_of(clause)
        for token, names in zip(tokens, self._names_of(tokens), strict=True):
            text = token.strip(MARKS) or token
            variants = self._lexicon.pronunciations.get(text.casefold()) or _distinct(
                [syllables_from(names), syllables_from(self._names_alone(token))]
            )
            if variants:
                yield ScriptWord(text, tuple(map(Pronunciation, variants)))

    def _names_of(self, tokens: Sequence[str]) -> list[tuple[str, ...]]:
        """Return what each word is called in its clause, or alone, where it cannot be told which is which."""
        spoken = self._spoken(" ".join(separator_of(self._language) + token for token in tokens))
        alone = [self._names_alone(token) for token in tokens]
        if sum(map(len, alone)) != len(spoken):
            return alone
        rest = iter(spoken)
        return [tuple(next(rest) for _ in names) for names in alone]

    def _names_alone(self, token: str) -> tuple[str, ...]:
        if token not in self._alone:
            self._alone[token] = self._spoken(token)
        return self._alone[token]

    def _spoken(self, text: str) -> tuple[str, ...]:
        return tuple(name for name in phone_names(text, self._language).split() if symbols_of(name))


def syllables_from(names: Sequence[str]) -> tuple[SpokenSyllable, ...]:
    """Return the syllables of a word from what the voice calls its parts; none for a pause."""
    return tuple(syllable for name in names for syllable in _syllables_of(name))


def _syllables_of(name: str) -> tuple[SpokenSyllable, ...]:
    phones: list[str] = []
    stresses: list[int] = []
    for part in name.split(espeak.SEPARATOR):
        symbols = symbols_of(part)
        phones += symbols
        stresses += [espeak.stress_of(part)] * len(symbols)
    return syllables_of(phones, stresses) if phones else ()


def _distinct(variants: Sequence[tuple[SpokenSyllable, ...]]) -> list[tuple[SpokenSyllable, ...]]:
    """Return variants that differ in more than stress."""
    by_phones: dict[tuple[str, ...], tuple[SpokenSyllable, ...]] = {}
    for variant in filter(None, variants):
        by_phones.setdefault(tuple(phone for syllable in variant for phone in syllable.phones), variant)
    return list(by_phones.values())


def _spelt_words(text: str, language: Language) -> tuple[str, ...]:
    """Return the words of a text that a voice spells; of each script it is asked for one of them."""
    if language.tag in mandarin.TAGS:
        text, language = re.sub(mandarin.HANZI, " ", text), language_of("en-us")
    by_script: dict[str, list[str]] = defaultdict(list)
    for word in dict.fromkeys(_LETTERS.findall(text)):
        if not word.isascii():
            by_script[unicodedata.name(word[0], "").partition(" ")[0]].append(word)
    longest = {script: max(words[:_SAMPLED], key=len) for script, words in by_script.items()}
    spelt = (words for s, words in by_script.items() if _is_spelt(longest[s], phone_names(longest[s], language)))
    return tuple(word for words in spelt for word in words)


def _is_spelt(word: str, names: str) -> bool:
    """Return whether a voice said the names of a word's letters, as it does with letters that it cannot read.

    Every voice reads Latin ones, be it as English.
    """
    return not word.isascii() and 1 < len(word) <= len(names.replace(_PAUSE, " ").split())
