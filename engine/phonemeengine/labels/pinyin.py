"""Pinyin, taken apart: tone, initial and full final of a syllable, and the phones that these are.

Pinyin writes some finals shorter than they are: iu for iou, ui for uei, un for uen, u for ü where no u can stand
(after j, q, x and y), and y and w for an i and a u that begin a syllable. The phones follow Lee and Zee, "Standard
Chinese (Beijing)", Journal of the International Phonetic Association 33 (2003).
"""

import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise

from phonemeengine.errors import TextError
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.labels.utterance import Phone, Syllable

INITIALS = (
    "b",
    "p",
    "m",
    "f",
    "d",
    "t",
    "n",
    "l",
    "g",
    "k",
    "h",
    "j",
    "q",
    "x",
    "zh",
    "ch",
    "sh",
    "r",
    "z",
    "c",
    "s",
    "y",
    "w",
)
"""What a syllable may begin with, as it is written."""
FINALS = (
    "a",
    "ia",
    "ua",
    "ai",
    "uai",
    "ao",
    "iao",
    "an",
    "ian",
    "uan",
    "üan",
    "ang",
    "iang",
    "uang",
    "o",
    "io",
    "uo",
    "ou",
    "iou",
    "ong",
    "iong",
    "u",
    "ü",
    "ün",
    "e",
    "ê",
    "ie",
    "üe",
    "ei",
    "uei",
    "en",
    "uen",
    "eng",
    "ueng",
    "er",
    "i",
    "in",
    "ing",
)
"""What follows it, in full."""
NASALS = {"m": "m̩", "n": "n̩", "ng": "ŋ̩", "hm": "x m̩", "hng": "x ŋ̩"}
"""Syllables without a vowel, and their phones."""
NEUTRAL = "5"
"""The digit of the neutral tone."""

_PHONES = {
    "b": "p",
    "p": "p",
    "m": "m",
    "f": "f",
    "d": "t",
    "t": "t",
    "n": "n",
    "l": "l",
    "g": "k",
    "k": "k",
    "h": "x",
    "j": "t ɕ",
    "q": "t ɕ",
    "x": "ɕ",
    "zh": "ʈ ʂ",
    "ch": "ʈ ʂ",
    "sh": "ʂ",
    "r": "ʐ",
    "z": "t s",
    "c": "t s",
    "s": "s",
}
"""Of initials; y and w are part of the full final."""
_RIMES = {
    "a": "a",
    "ia": "j a",
    "ua": "w a",
    "ai": "aɪ",
    "uai": "w aɪ",
    "ao": "aʊ",
    "iao": "j aʊ",
    "an": "a n",
    "ian": "j ɛ n",
    "uan": "w a n",
    "üan": "ɥ ɛ n",
    "ang": "a ŋ",
    "iang": "j a ŋ",
    "uang": "w a ŋ",
    "o": "o",
    "io": "j o",
    "uo": "w o",
    "ou": "oʊ",
    "iou": "j oʊ",
    "ong": "ʊ ŋ",
    "iong": "j ʊ ŋ",
    "u": "u",
    "ü": "y",
    "ün": "y n",
    "e": "ɤ",
    "ê": "ɛ",
    "ie": "j ɛ",
    "üe": "ɥ ɛ",
    "ei": "eɪ",
    "uei": "w eɪ",
    "en": "ə n",
    "uen": "w ə n",
    "eng": "ə ŋ",
    "ueng": "w ə ŋ",
    "er": "ɚ",
    "i": "i",
    "in": "i n",
    "ing": "i ŋ",
}
_APICALS = frozenset({"zh", "ch", "sh", "r", "z", "c", "s"})
"""Initials behind which i is the vowel of *zi* and *shi*."""
_BEFORE_VOWELS = frozenset("pmftnlkxɕʂʐsʈjwɥ")

_SHORT = {"iu": "iou", "ui": "uei", "un": "uen", "ue": "üe"}
_TONE_MARKS = {"\u0304": "1", "\u0301": "2", "\u030c": "3", "\u0300": "4"}
"""Macron, acute, caron and grave, as combining characters."""


@lru_cache(maxsize=4096)
def sound_of(written: str) -> str:
    """Return a syllable of pinyin with its tone as a digit, such as ``lü4``.

    Parameters
    ----------
    written : with a digit (``lü4``), a tone mark (``lǜ``) or no tone, which is the neutral one; ü may be v or u:.

    Raises
    ------
    TextError : it is no syllable of pinyin.
    """
    toneless, tone = _without_tone(written)
    if toneless not in NASALS and initial_and_final(toneless)[1] not in FINALS:
        raise TextError(f"{written!r:.40} is no syllable of pinyin; write one such as hao3 or lü4")
    return f"{toneless}{tone}"


def is_sound(written: str) -> bool:
    """Return whether this is a syllable of pinyin with its tone as a digit, such as ``lü4``."""
    try:
        return written == sound_of(written)
    except TextError:
        return False


@lru_cache(maxsize=4096)
def initial_and_final(syllable: str) -> tuple[str, str]:
    """Return the initial of a syllable without tone, empty where it has none, and its full final.

    What is no syllable of pinyin has a final that is none of `FINALS`.
    """
    initial = next((name for name in (syllable[:2], syllable[:1]) if name in INITIALS), "")
    return initial, _full(initial, syllable.removeprefix(initial))


@lru_cache(maxsize=4096)
def onset_and_rime(syllable: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the phones of a syllable without tone: those before its vowel, and the others; IPA.

    What is no syllable of pinyin is a murmured vowel.
    """
    initial, final = initial_and_final(syllable)
    if syllable in NASALS:
        phones = NASALS[syllable].split()
    elif initial in _APICALS and final == "i":
        phones = [*_PHONES[initial].split(), "ɨ"]
    else:
        phones = [*_PHONES.get(initial, "").split(), *_RIMES.get(final, "ə").split()]
    n = next(k for k, phone in enumerate(phones) if phone not in _BEFORE_VOWELS)
    return tuple(phones[:n]), tuple(phones[n:])


def timed_syllable(sound: str, start: float, turn: float, end: float) -> Syllable:
    """Return a syllable with its phones.

    Parameters
    ----------
    sound : pinyin with its tone as a digit.
    start, end : seconds.
    turn : when the onset ends, where there is one.
    """
    onset, rime = onset_and_rime(sound[:-1])
    turn = turn if onset else start
    return Syllable((*_shared(onset, start, turn), *_shared(rime, turn, end)), text=sound)


def _shared(phones: Sequence[str], start: float, end: float) -> Iterator[Phone]:
    """Return phones that share a time equally."""
    borders = [start + (end - start) * k / max(len(phones), 1) for k in range(len(phones) + 1)]
    for ipa, (first, last) in zip(phones, pairwise(borders), strict=True):
        yield Phone(first, last, ipa, ipa_phoneme(ipa))


def _full(initial: str, final: str) -> str:
    if initial in {"j", "q", "x", "y"} and final.startswith("u"):
        return f"ü{final[1:]}"
    if initial == "y" and not final.startswith("i"):
        return _SHORT.get(final, f"i{final}")
    if initial == "w" and not final.startswith("u"):
        return f"u{final}"
    return _SHORT.get(final, final)


def _without_tone(written: str) -> tuple[str, str]:
    """Return the letters of a syllable, and its tone as a digit."""
    text = written.strip().lower().replace("u:", "ü").replace("v", "ü")
    digit = text[-1:] if text[-1:] in {"1", "2", "3", "4", NEUTRAL} else ""
    bare = unicodedata.normalize("NFD", text.removesuffix(digit))
    marks = [_TONE_MARKS[c] for c in bare if c in _TONE_MARKS]
    letters = "".join(c for c in bare if c not in _TONE_MARKS)
    tone = "".join((*marks, digit)) or NEUTRAL
    if len(tone) > 1:
        raise TextError(f"{written!r:.40} has more than one tone; write a syllable of pinyin such as hao3")
    return unicodedata.normalize("NFC", letters), tone
