"""Key words: those over which head and brows make a gesture, and those before which a long phrase is split.

They are data of each language, in ``keywords.toml`` and in files of the user's own.
"""

import os
import unicodedata
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float64Array
from phonemeengine.errors import PerformanceError, remedy
from phonemeengine.mouth.blendshape_names import BROWS, SHOULDERS, both_sides
from phonemeengine.performance.recording import HEAD
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml
from phonemeengine.text import mandarin

FORMAT = "phonemeanalyser keywords 1"
USUAL_KEYWORDS = Path(__file__).resolve().with_name("keywords.toml")
CHANNELS = (*HEAD, *BROWS, *SHOULDERS)
"""What moves by phrases: turns in degrees, and weights."""
CONJUNCTIONS = "conjunctions"
MOST_WORDS = 5
"""Of an entry at most; in Chinese each character is a word."""
LONGEST, MOST_VALUES = 5.0, 50
"""Seconds of a gesture, and values of a channel, at most."""
WIDEST = 60.0
"""Degrees that a gesture turns the head at most."""


@dataclass(frozen=True)
class Gesture:
    """What head and brows do over a word.

    Attributes
    ----------
    shortest : seconds that it takes at least.
    channels : the values that each channel goes through at equal distances of time, beside where it comes from and
        goes to: degrees, or weights. One without values is still.
    """

    shortest: float
    channels: Mapping[str, tuple[float, ...]]

    def curve(self, channel: str, places: Float64Array) -> Float64Array:
        """Return what a channel does at places 0..1 of the gesture, 0 at both ends; half cosines join the values."""
        values = np.array([0.0, *self.channels[channel], 0.0])
        curve: Float64Array = np.interp(_eased(places * (len(values) - 1)), np.arange(len(values)), values)
        return curve


@dataclass(frozen=True)
class Keywords:
    """Words that matter to head and brows.

    Attributes
    ----------
    gestures : by name.
    words : for each language, as espeak-ng names it, the gesture of each word, or few words, as `plain` writes them.
    conjunctions : for each language those before which a phrase is split, as `plain` writes them.
    """

    gestures: Mapping[str, Gesture]
    words: Mapping[str, Mapping[str, str]]
    conjunctions: Mapping[str, frozenset[str]]

    def gestures_in(self, words: Sequence[str], language: str) -> Iterator[tuple[int, int, Gesture]]:
        """Return the gestures of a sentence, each with its first and its last word; of entries the longest counts.

        Parameters
        ----------
        language : its tag, such as ``en-us``; an unknown language has none.
        """
        known = self.words.get(base_of(language), {})
        for first, last in phrases_in(words, known):
            yield first, last, self.gestures[known[joined_words(words, first, last)]]

    def conjunctions_in(self, words: Sequence[str], language: str) -> frozenset[int]:
        """Return the words of a sentence before which it may be split, by their numbers."""
        known = self.conjunctions.get(base_of(language), frozenset())
        return frozenset(first for first, _ in phrases_in(words, known))

    def with_others(self, others: "Keywords") -> "Keywords":
        """Return these with others added; where both know a gesture or a word, it is as the others have it."""
        languages = self.words.keys() | others.words.keys()
        return Keywords(
            {**self.gestures, **others.gestures},
            {name: {**self.words.get(name, {}), **others.words.get(name, {})} for name in languages},
            {
                name: self.conjunctions.get(name, frozenset()) | others.conjunctions.get(name, frozenset())
                for name in languages
            },
        )


def load_keywords(*paths: str | os.PathLike[str]) -> Keywords:
    """Load the key words that ship with the program, and add those of files of the user's own.

    A file may use the gestures of those before it.

    Raises
    ------
    PerformanceError : a file cannot be read, or says something impossible; the message names it and the entry.
    """
    keywords = Keywords({}, {}, {})
    for path in (USUAL_KEYWORDS, *paths):
        parse = partial(keywords_of, known=keywords.gestures)
        keywords = keywords.with_others(load_text(path, "a file of key words (.toml)", PerformanceError, parse))
    return keywords


def keywords_of(text: str, known: Mapping[str, Gesture] | None = None) -> Keywords:
    """Read key words from the text of a TOML file.

    Parameters
    ----------
    known : gestures of other files that its words may have.

    Raises
    ------
    PerformanceError : not TOML, not of this format, or an entry that is unknown or out of range.
    """
    top = parse_toml(text, "a file of key words", FORMAT, PerformanceError)
    top.read({"gestures": dict, "languages": dict, "notes": str}, optional=("gestures", "languages", "notes"))
    tables = top.table("gestures")
    tables.check_keys((), [name for name in tables.entries if name != CONJUNCTIONS])
    gestures = {name: _gesture_of(table) for name, table in tables.tables_by_name()}
    languages = dict(top.table("languages").tables_by_name())
    names = {*(known or {}), *gestures}
    return Keywords(
        gestures,
        {name: _gestured(table, names) for name, table in languages.items()},
        {name: frozenset(plain_words(table, CONJUNCTIONS)) for name, table in languages.items()},
    )


def plain(words: str) -> str:
    """Return words as they are compared: letters and digits alone, without case."""
    return "".join(c for c in unicodedata.normalize("NFC", words).casefold() if c.isalnum())


def base_of(language: str) -> str:
    """Return a language by the tag of a variety of it: ``en`` for ``en-us``."""
    return "cmn" if language.lower() in mandarin.TAGS else language.lower().partition("-")[0]


def plain_words(table: StrictTable, key: str) -> Iterator[str]:
    """Return the words, or few words, of an entry as `plain` writes them.

    Raises
    ------
    EngineError : it is no list of words; the error is that of the table.
    """
    words = table.value(key, list, [])
    for word in words:
        if not isinstance(word, str) or not plain(word):
            raise table.refusal(key, "a list of words", words)
        yield plain(word)


def phrases_in(words: Sequence[str], entries: Collection[str]) -> Iterator[tuple[int, int]]:
    """Return where entries stand in a sentence, first word and last one; they do not overlap, and the longest counts.

    Parameters
    ----------
    entries : words, or up to five, as `plain` writes them.
    """
    k = 0
    while k < len(words):
        longest = range(min(k + MOST_WORDS, len(words)) - 1, k - 1, -1)
        last = next((last for last in longest if joined_words(words, k, last) in entries), None)
        if last is not None:
            yield k, last
        k = k + 1 if last is None else last + 1


def _eased(places: Float64Array) -> Float64Array:
    """Return places between whole numbers moved along half a cosine."""
    whole = np.floor(places)
    return whole + (1 - np.cos(np.pi * (places - whole))) / 2


def joined_words(words: Sequence[str], first: int, last: int) -> str:
    """Return the words from one to another, both counted, as `plain` writes them."""
    return "".join(map(plain, words[first : last + 1]))


def _gesture_of(table: StrictTable) -> Gesture:
    table.check_keys(("shortest", "channels"))
    channels = table.table("channels")
    values: dict[str, tuple[float, ...]] = {}
    for name in channels.entries:
        sides = (name,) if name in CHANNELS else both_sides(name)
        if not {*sides} <= {*CHANNELS}:
            words = remedy(name, CHANNELS)
            raise PerformanceError(f"{channels.name}: there is no channel {name!r:.40}; {words}")
        values |= dict.fromkeys(sides, _values_of(channels, name))
    return Gesture(table.limited("shortest", 0, LONGEST, f"seconds in 0..{LONGEST:g}"), values)


def _values_of(channels: StrictTable, name: str) -> tuple[float, ...]:
    most, numbers = WIDEST if name in HEAD else 1.0, channels.numbers(name)
    if len(numbers) > MOST_VALUES or any(abs(number) > most for number in numbers):
        raise channels.refusal(name, f"a list of up to {MOST_VALUES} numbers within ±{most:g}", list(numbers))
    return numbers


def _gestured(table: StrictTable, gestures: Collection[str]) -> dict[str, str]:
    """Return the gesture of each word of a language."""
    table.check_keys((), (CONJUNCTIONS, *sorted(gestures)))
    return {word: name for name in table.entries if name != CONJUNCTIONS for word in plain_words(table, name)}
