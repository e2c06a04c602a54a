"""Chinese characters as pinyin, and how a voice is asked for it: the only door to pypinyin.

pypinyin knows phrases, so that characters with several readings come right.
"""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from types import ModuleType

from phonemeengine.errors import TextError, VoiceError
from phonemeengine.labels.pinyin import is_sound, onset_and_rime, sound_of
from phonemeengine.text.chinese_numbers import NUMBER, read_number, to_ascii_digits
from phonemeengine.text.simplified import simplified
from phonemeengine.text.syllables import SpokenSyllable

PINYIN_TAG = "cmn-latn-pinyin"
"""Tag of the language in pinyin."""
TAGS = frozenset({"cmn", "zh", "zh-cmn", PINYIN_TAG})
"""Tags of the language, in its own characters or in pinyin."""

_CHARACTERS = "\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff"
HANZI = f"[{_CHARACTERS}]"
"""A Chinese character, as a regular expression."""
_MARKS = "。！？；：，、"
_PART = re.compile(
    rf"(?P<chinese>[{_CHARACTERS}]+)|(?P<number>{NUMBER.pattern})|[^\W\d{_CHARACTERS}][^\s{_CHARACTERS}{_MARKS}]*|\S"
)

_TONES = {"1": "55", "2": "35", "3": "214", "4": "51", "5": "11"}
_RESPELT = {
    "jiong": "tS;'y{}N", "qiong": "tS;h'u{}N", "xiong": "S;'y{}N", "ê": "E{}", "m": "m", "n": "n", "ng": "N",
    "hm": "Xm", "hng": "XN",
}  # fmt: skip
"""What espeak-ng would otherwise spell in English, in its own names of phonemes, with a place for the tone."""


@dataclass(frozen=True)
class PinyinWord:
    """A Chinese character, or a number, and how it is read.

    Attributes
    ----------
    text : as it is written.
    syllables : pinyin with the tone behind it, ``ü`` written, 5 for the neutral one, such as ``lü4``; none of a
        character that nobody can read.
    """

    text: str
    syllables: tuple[str, ...]


def read(text: str, tag: str) -> Iterator[PinyinWord | str]:
    """Return what a text of the language of a tag is made of, in its own characters or in pinyin, in order.

    Raises
    ------
    VoiceError : pypinyin is not installed.
    """
    return read_pinyin(text) if tag == PINYIN_TAG else read_characters(text)


def read_characters(text: str) -> Iterator[PinyinWord | str]:
    """Return what a Chinese text is made of, in order: characters, numbers, and as text other words and marks.

    Raises
    ------
    VoiceError : pypinyin is not installed.
    """
    for part in _PART.finditer(to_ascii_digits(text)):
        words = part.group()
        if part.lastgroup == "chinese":
            for character, syllable in zip(words, pinyin_of(words), strict=True):
                yield PinyinWord(character, (syllable,) if is_sound(syllable) else ())
        elif part.lastgroup == "number":
            yield PinyinWord(words, tuple(pinyin_of(read_number(words))))
        else:
            yield words


def read_pinyin(text: str) -> Iterator[PinyinWord | str]:
    """Return what a text in pinyin is made of, syllables apart and their tones as digits or as marks."""
    for word in re.findall(r"[^\W\d_]+[1-5]?|\S", unicodedata.normalize("NFC", text)):
        try:
            yield PinyinWord(word, (sound_of(word),))
        except TextError:
            yield word


def syllable_of(pinyin: str) -> SpokenSyllable:
    """Return how a syllable of pinyin sounds, such as ``hao3``; one that does not exist is a murmured vowel."""
    onset, rime = onset_and_rime(pinyin.rstrip("12345"))
    return SpokenSyllable((*onset, *rime), 0, pinyin)


def spelt_for_voice(pinyin: str) -> str:
    """Return what espeak-ng's voice for pinyin speaks a syllable from; it may hold names of phonemes in ``[[]]``."""
    plain, tone = pinyin.rstrip("12345"), pinyin[-1]
    if plain in _RESPELT:
        return f"[[{_RESPELT[plain].format(_TONES.get(tone, _TONES['5']))}]]"
    return pinyin.replace("ü", "v")


def pinyin_of(hanzi: str) -> list[str]:
    """Return the pinyin of each character, with its tone as a digit (5 is neutral) and ü, such as ``lü4``.

    What stands for a character that nobody knows is that character.

    Parameters
    ----------
    hanzi : Chinese characters without anything else, a clause at a time, as phrases tell how they are read.

    Raises
    ------
    VoiceError : pypinyin is not installed.
    """
    pypinyin = _pypinyin()
    syllables: list[str] = pypinyin.lazy_pinyin(
        list(_phrases_of(hanzi)), style=pypinyin.Style.TONE3, errors=list, neutral_tone_with_five=True,
        tone_sandhi=True, v_to_u=True,
    )  # fmt: skip
    return syllables


def _phrases_of(hanzi: str) -> Iterator[str]:
    """Return phrases that pypinyin knows, and single characters; phrases in their simplified form.

    What is no phrase stays as it is written, since a simplified character may stand for others, too.
    """
    from pypinyin.seg.mmseg import seg  # noqa: PLC0415 - as below

    at = 0
    for is_phrase, group in groupby(seg.cut(simplified(hanzi)), lambda word: len(word) > 1):
        words = list(group)
        end = at + sum(map(len, words))
        yield from words if is_phrase else seg.cut(hanzi[at:end])
        at = end


def _pypinyin() -> ModuleType:
    try:
        import pypinyin  # noqa: PLC0415 - half a second that only Chinese needs
    except ImportError as error:
        raise VoiceError(
            "Chinese text needs the package pypinyin, which is missing; pip install 'pypinyin'"
        ) from error
    return pypinyin
