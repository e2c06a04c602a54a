"""Pinyin, taken apart: tone, initial and full final of a syllable.

Pinyin writes some finals shorter than they are: iu for iou, ui for uei, un for uen, u for ü where no u can stand
(after j, q, x and y), and y and w for an i and a u that begin a syllable.
"""

import unicodedata

from phonemeengine.errors import TextError

INITIALS = (
    "b", "p", "m", "f", "d", "t", "n", "l", "g", "k", "h", "j", "q", "x", "zh", "ch", "sh", "r", "z", "c", "s", "y",
    "w",
)  # fmt: skip
"""What a syllable may begin with, as it is written."""
FINALS = (
    "a", "ia", "ua", "ai", "uai", "ao", "iao", "an", "ian", "uan", "üan", "ang", "iang", "uang", "o", "io", "uo",
    "ou", "iou", "ong", "iong", "u", "ü", "ün", "e", "ê", "ie", "üe", "ei", "uei", "en", "uen", "eng", "ueng", "er",
    "i", "in", "ing",
)  # fmt: skip
"""What follows it, in full."""
NASALS = ("m", "n", "ng", "hm", "hng")
"""Syllables without a vowel."""
NEUTRAL = "5"
"""The digit of the neutral tone."""

_SHORT = {"iu": "iou", "ui": "uei", "un": "uen", "ue": "üe"}
_TONE_MARKS = {"\u0304": "1", "\u0301": "2", "\u030c": "3", "\u0300": "4"}
"""Macron, acute, caron and grave, as combining characters."""


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


def initial_and_final(syllable: str) -> tuple[str, str]:
    """Return the initial of a syllable without tone, empty where it has none, and its full final.

    What is no syllable of pinyin has a final that is none of `FINALS`.
    """
    initial = next((name for name in (syllable[:2], syllable[:1]) if name in INITIALS), "")
    return initial, _full(initial, syllable.removeprefix(initial))


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
