"""Chinese characters as pinyin, and how pinyin sounds: the only door to pypinyin.

pypinyin knows phrases, so that characters with several readings come right. What pinyin sounds like follows
Lee and Zee, "Standard Chinese (Beijing)", Journal of the International Phonetic Association 33 (2003).
"""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from types import ModuleType

from phonemeengine.errors import VoiceError
from phonemeengine.text.chinese_numbers import NUMBER, read_number, to_ascii_digits
from phonemeengine.text.syllables import SpokenSyllable

TAGS = frozenset({"cmn", "zh", "zh-cmn"})
"""Tags of the language in its own characters."""
PINYIN_TAG = "cmn-latn-pinyin"
"""Tag of the language in pinyin."""

_CHARACTERS = "\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff"
HANZI = f"[{_CHARACTERS}]"
"""A Chinese character, as a regular expression."""
_MARKS = "。！？；：，、"
_PART = re.compile(
    rf"(?P<chinese>[{_CHARACTERS}]+)|(?P<number>{NUMBER.pattern})|[^\W\d{_CHARACTERS}][^\s{_CHARACTERS}{_MARKS}]*|\S"
)

_INITIALS = {
    "zh": "ʈ ʂ", "ch": "ʈ ʂ", "sh": "ʂ", "b": "p", "p": "p", "m": "m", "f": "f", "d": "t", "t": "t", "n": "n",
    "l": "l", "g": "k", "k": "k", "h": "x", "j": "t ɕ", "q": "t ɕ", "x": "ɕ", "r": "ʐ", "z": "t s", "c": "t s",
    "s": "s", "": "",
}  # fmt: skip
"""The longest come first."""
_FINALS = {
    "a": "a", "o": "o", "e": "ɤ", "ê": "ɛ", "ai": "aɪ", "ei": "eɪ", "ao": "aʊ", "ou": "oʊ", "an": "a n", "en": "ə n",
    "ang": "a ŋ", "eng": "ə ŋ", "er": "ɚ", "i": "i", "ia": "j a", "iai": "j aɪ", "io": "j o", "ie": "j ɛ",
    "iao": "j aʊ", "iu": "j oʊ", "ian": "j ɛ n", "in": "i n", "iang": "j a ŋ", "ing": "i ŋ", "iong": "j ʊ ŋ",
    "u": "u", "ua": "w a", "uo": "w o", "uai": "w aɪ", "ui": "w eɪ", "uan": "w a n", "un": "w ə n", "uang": "w a ŋ",
    "ueng": "w ə ŋ", "ong": "ʊ ŋ", "ü": "y", "üe": "ɥ ɛ", "üan": "ɥ ɛ n", "ün": "y n",
}  # fmt: skip
_WHOLE = {"m": "m̩", "n": "n̩", "ng": "ŋ̩", "hm": "x m̩", "hng": "x ŋ̩"}
_SPELT_OTHERWISE = {"you": "iu", "wei": "ui", "wen": "un"}
_MAKING_U_ROUND = frozenset("jqx")
_APICAL = re.compile("(?:zh|ch|sh|r|z|c|s)i")

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
    syllables : pinyin with the tone behind it, ``ü`` written, 5 for the neutral one, such as ``lü4``.
    """

    text: str
    syllables: tuple[str, ...]


def read(text: str) -> Iterator[PinyinWord | str]:
    """Return what a Chinese text is made of, in order: characters, numbers, and as text other words and marks.

    Raises
    ------
    VoiceError : pypinyin is not installed.
    """
    for part in _PART.finditer(to_ascii_digits(text)):
        words = part.group()
        if part.lastgroup == "chinese":
            yield from map(PinyinWord, words, ((syllable,) for syllable in _pinyin_of(words)))
        elif part.lastgroup == "number":
            yield PinyinWord(words, tuple(_pinyin_of(read_number(words))))
        else:
            yield words


def read_pinyin(text: str) -> Iterator[PinyinWord | str]:
    """Return what a text in pinyin is made of, syllables apart and their tones as digits or as marks.

    Raises
    ------
    VoiceError : pypinyin is not installed.
    """
    for word in re.findall(r"[^\W\d_]+[1-5]?|\S", unicodedata.normalize("NFC", text)):
        syllable = _with_digit(word)
        yield PinyinWord(word, (syllable,)) if _is_syllable(syllable) else word


def syllable_of(pinyin: str) -> SpokenSyllable:
    """Return how a syllable of pinyin sounds, such as ``hao3``; one that does not exist is a murmured vowel."""
    plain = pinyin.rstrip("12345")
    return SpokenSyllable(tuple(_phones_of(plain) or ("ə",)), 0, pinyin)


def spelt_for_voice(pinyin: str) -> str:
    """Return what espeak-ng's voice for pinyin speaks a syllable from; it may hold names of phonemes in ``[[]]``."""
    plain, tone = pinyin.rstrip("12345"), pinyin[-1]
    if plain in _RESPELT:
        return f"[[{_RESPELT[plain].format(_TONES.get(tone, _TONES['5']))}]]"
    return pinyin.replace("ü", "v")


def _phones_of(plain: str) -> list[str]:
    if plain in _WHOLE:
        return _WHOLE[plain].split()
    if _APICAL.fullmatch(plain):
        return [*_INITIALS[plain[:-1]].split(), "ɨ"]
    initial = next(initial for initial in _INITIALS if plain.startswith(initial))
    final = _FINALS.get(_full_final(initial, plain.removeprefix(initial)))
    return [] if final is None else f"{_INITIALS[initial]} {final}".split()


def _full_final(initial: str, final: str) -> str:
    """Return what a final is called behind other initials: y and w stand for i, ü and u; u for ü after j, q, x."""
    if final.startswith("yu") or (initial in _MAKING_U_ROUND and final.startswith("u")):
        return "ü" + final.removeprefix("y")[1:]
    if final.startswith(("y", "w")) and final not in _SPELT_OTHERWISE:
        vowel = {"y": "i", "w": "u"}[final[0]]
        return final[1:] if final[1:].startswith(vowel) else vowel + final[1:]
    return _SPELT_OTHERWISE.get(final, final)


def _is_syllable(pinyin: str) -> bool:
    return bool(_phones_of(pinyin.rstrip("12345")))


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
        hanzi, style=pypinyin.Style.TONE3, errors=list, neutral_tone_with_five=True, tone_sandhi=True, v_to_u=True
    )
    return syllables


def _pinyin_of(hanzi: str) -> list[str]:
    """Return a syllable for each character; one that nobody can read is a murmur."""
    return [syllable if syllable[-1] in "12345" else "e5" for syllable in pinyin_of(hanzi)]


def _with_digit(word: str) -> str:
    if word[-1] in "12345":
        return word.lower().replace("v", "ü")
    _pypinyin()
    from pypinyin.contrib.tone_convert import to_tone3  # noqa: PLC0415 - as below

    return str(to_tone3(word.lower(), neutral_tone_with_five=True, v_to_u=True))


def _pypinyin() -> ModuleType:
    try:
        import pypinyin  # noqa: PLC0415 - half a second that only Chinese needs
    except ImportError as error:
        raise VoiceError(
            "Chinese text needs the package pypinyin, which is missing; pip install 'pypinyin'"
        ) from error
    return pypinyin
