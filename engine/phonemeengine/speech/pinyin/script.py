"""Text as the syllables, words and pauses with which it is spoken."""

import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import takewhile

from phonemeengine.labels.pinyin import is_sound
from phonemeengine.speech.pinyin.table import FULL_FORMS, PinyinTable
from phonemeengine.text.cleaning import LONGEST, clauses_of, without_controls
from phonemeengine.text.mandarin import HANZI, PINYIN_TAG, PinyinWord, numbers_spelt, pinyin_of, read_pinyin
from phonemeengine.text.pronunciation import ScriptWord
from phonemeengine.text.syllables import SpokenSyllable

_FOREIGN = rf"(?:(?!{HANZI})[^\W_])+"
_PART = rf"(?s)(?P<hanzi>{HANZI}{{1,{LONGEST}}})|(?P<foreign>{_FOREIGN}(?:['’.?!;:,/@-]{_FOREIGN})*)|(?P<mark>.)"
"""Marks within a Latin word, such as an address, are part of it."""


@dataclass(frozen=True)
class WrittenSyllable:
    """A syllable of a text: its character, and its pinyin with the tone as a digit."""

    text: str
    sound: str


@dataclass(frozen=True)
class WrittenMark:
    """A mark of a text at which the voice pauses, and the weight of the pause."""

    text: str
    weight: float


@dataclass(frozen=True)
class WrittenWord:
    """A word of a text that is no Chinese, and how it is pronounced."""

    text: str
    syllables: tuple[SpokenSyllable, ...]


Written = WrittenSyllable | WrittenWord | WrittenMark
Read = Callable[[str], Iterable[ScriptWord]]
"""Gives the words of a clause, and how they are pronounced."""


@dataclass(frozen=True)
class PinyinScript:
    """A text as it is spoken.

    Attributes
    ----------
    written : its syllables, words and marks in order.
    skipped : what is not spoken, since it is no Chinese and nothing else reads it, such as emoji, in order.
    """

    written: tuple[Written, ...]
    skipped: tuple[str, ...] = ()


def script_of(text: str, table: PinyinTable) -> PinyinScript:
    """Return what is spoken of a Chinese text, and what is not; see `chinese_parts`."""
    parts = list(chinese_parts(text, table))
    skipped = tuple(part for part in parts if isinstance(part, str))
    return PinyinScript(tuple(part for part in parts if not isinstance(part, str)), skipped)


def chinese_parts(
    text: str, table: PinyinTable, read: Read | None = None, tag: str = "cmn"
) -> Iterator[Written | str]:
    """Return what a Chinese text is made of, in order, as it is read; what is not spoken as text.

    Numbers are spoken as Chinese words; of marks in a row the heaviest counts; what is neither Chinese nor a mark of
    the table, such as brackets and quotation marks, is no pause.

    Parameters
    ----------
    read : reads words of other languages; they are not spoken, where it is None.
    tag : of the language, in its own characters or in pinyin.
    """
    normal = unicodedata.normalize("NFC", without_controls(text).lstrip())
    return _with_joined_marks(_of_pinyin(normal, table, read) if tag == PINYIN_TAG else _parts(normal, table, read))


def clause_parts(text: str, table: PinyinTable, read: Read) -> Iterator[Written | str]:
    """Return what a text of any other language is made of, in order, as it is read: words, and marks after clauses.

    Parameters
    ----------
    text : cleaned.
    read : reads its clauses.
    """
    return _with_joined_marks(_of_clauses(text, table, read))


def mark_after(clause: str, table: PinyinTable) -> WrittenMark | None:
    """Return the heaviest mark at the end of a clause, as it is written; None where there is no pause."""
    last = takewhile(lambda character: not character.isalnum(), reversed(clause))
    marks = [WrittenMark(character, weight) for character in last if (weight := table.pause_at(character))]
    return max(marks, key=lambda mark: mark.weight, default=None)


def _parts(text: str, table: PinyinTable, read: Read | None) -> Iterator[Written | str]:
    for part in re.finditer(_PART, numbers_spelt(text)):
        if part.lastgroup == "hanzi":
            yield from _syllables_of(part[0])
        elif part.lastgroup == "foreign":
            yield from _foreign(part[0], read)
        elif mark := _mark_of(part[0], table):
            yield mark
        elif unicodedata.category(part[0]).startswith("S"):
            yield part[0]


def _of_pinyin(text: str, table: PinyinTable, read: Read | None) -> Iterator[Written | str]:
    for part in read_pinyin(text):
        if isinstance(part, PinyinWord):
            yield WrittenSyllable(part.text, part.syllables[0])
        elif mark := _mark_of(part, table):
            yield mark
        elif part[0].isalnum():
            yield from _foreign(part, read)


def _of_clauses(text: str, table: PinyinTable, read: Read) -> Iterator[Written]:
    for number, line in enumerate(text.split("\n")):
        if number and (weight := table.pause_at("\n")):
            yield WrittenMark("", weight)
        for clause in clauses_of(line):
            yield from map(_word_of, read(clause))
            if mark := mark_after(clause, table):
                yield mark


def _syllables_of(hanzi: str) -> Iterator[Written | str]:
    """Return the syllables of characters; of those whose pinyin is not known, the characters."""
    for character, sound in zip(hanzi, pinyin_of(hanzi), strict=True):
        yield WrittenSyllable(character, sound) if is_sound(sound) else character


def _foreign(word: str, read: Read | None) -> Iterator[Written | str]:
    """Return the words that a word of another language is spoken as; itself, where it is not spoken."""
    words = list(read(word)) if read else []
    yield from map(_word_of, words) if words else (word,)


def _word_of(word: ScriptWord) -> WrittenWord:
    return WrittenWord(word.text, word.pronunciations[0].syllables)


def _mark_of(character: str, table: PinyinTable) -> WrittenMark | None:
    weight = table.pause_at(character)
    return WrittenMark(FULL_FORMS.get(character, character), weight) if weight else None


def _with_joined_marks(parts: Iterable[Written | str]) -> Iterator[Written | str]:
    """Return parts in which the heaviest mark stands for those in a row."""
    last: WrittenMark | None = None
    for part in parts:
        if isinstance(part, WrittenMark):
            last = part if last is None or part.weight > last.weight else last
            continue
        if last is not None and not isinstance(part, str):
            yield last
            last = None
        yield part
    if last is not None:
        yield last
