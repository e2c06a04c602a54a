"""Chinese text as the syllables and pauses with which it is spoken."""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass

from phonemeengine.labels.pinyin import is_sound
from phonemeengine.speech.pinyin.table import FULL_FORMS, PinyinTable
from phonemeengine.text.chinese_numbers import numbers_spelt
from phonemeengine.text.cleaning import without_controls
from phonemeengine.text.mandarin import HANZI, pinyin_of

_FOREIGN = rf"(?:(?!{HANZI})[^\W_])+"
_PART = re.compile(rf"(?P<hanzi>{HANZI}+)|(?P<foreign>{_FOREIGN}(?:['’.?!;:,/@-]{_FOREIGN})*)|(?P<mark>.)", re.DOTALL)
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


Written = WrittenSyllable | WrittenMark


@dataclass(frozen=True)
class PinyinScript:
    """A text as it is spoken.

    Attributes
    ----------
    written : its syllables and marks in order.
    skipped : what is no Chinese and so has no pinyin, such as Latin words and emoji, in order.
    """

    written: tuple[Written, ...]
    skipped: tuple[str, ...] = ()


def script_of(text: str, table: PinyinTable) -> PinyinScript:
    """Return what is spoken of a Chinese text, and what is not.

    Numbers are spoken as Chinese words; of marks in a row the heaviest counts; what is neither Chinese nor a mark of
    the table, such as brackets and quotation marks, is no pause.
    """
    written: list[Written] = []
    skipped: list[str] = []
    for part in _PART.finditer(numbers_spelt(unicodedata.normalize("NFC", without_controls(text).lstrip()))):
        if part.lastgroup == "hanzi":
            written += _syllables_of(part[0], skipped)
        elif part.lastgroup == "mark" and (mark := _mark_of(part[0], table)):
            _add_mark(written, mark)
        elif part.lastgroup == "foreign" or unicodedata.category(part[0]).startswith("S"):
            skipped.append(part[0])
    return PinyinScript(tuple(written), tuple(skipped))


def _syllables_of(hanzi: str, skipped: list[str]) -> Iterator[WrittenSyllable]:
    """Return the syllables of characters; those whose pinyin nobody knows are skipped."""
    for character, sound in zip(hanzi, pinyin_of(hanzi), strict=True):
        if is_sound(sound):
            yield WrittenSyllable(character, sound)
        else:
            skipped.append(character)


def _mark_of(character: str, table: PinyinTable) -> WrittenMark | None:
    weight = table.pause_at(character)
    return WrittenMark(FULL_FORMS.get(character, character), weight) if weight else None


def _add_mark(written: list[Written], mark: WrittenMark) -> None:
    """Add a mark; it joins one that stands right before it."""
    last = written[-1] if written else None
    if not isinstance(last, WrittenMark):
        written.append(mark)
    elif mark.weight > last.weight:
        written[-1] = mark
