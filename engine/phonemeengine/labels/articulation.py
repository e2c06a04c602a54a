"""How the sounds of speech are made: the letters of the IPA, and the classes that phoneticians put them into.

See the chart of the International Phonetic Association (revised to 2020). A letter stands for a sound with whatever
marks it wears: length, stress, aspiration, nasality or palatalisation change little of what a mouth shows.
"""

import unicodedata
from collections.abc import Mapping
from functools import lru_cache
from typing import TypeVar

T = TypeVar("T")

CONSONANT_CLASSES: dict[str, str] = {
    # What is seen the most comes first: lips, then the tongue.
    "labiovelar": "w ʍ",
    "dental": "θ ð",
    "labiodental": "f v ʋ ɱ",
    "bilabial": "p b m ɓ ɸ β ʙ",
    "uvular": "ʁ ʀ χ q ɢ ɴ",
    "pharyngeal": "ħ ʕ",
    "glottal": "h ɦ ʔ",
    "alveolo-palatal": "ɕ ʑ",
    "postalveolar": "ʃ ʒ",
    "lateral": "l ɫ ɭ ʎ ɬ ɮ ɺ",
    "tap": "ɾ ɽ ɺ",
    "trill": "r ʀ ʙ",
    "rhotic": "r ɹ ɾ ɻ ɽ ʁ ʀ",
    "nasal": "m ɱ n ɳ ɲ ŋ ɴ",
    "retroflex": "ʈ ɖ ɳ ʂ ʐ ɻ ɽ ɭ",
    "palatal": "j ɥ ç ʝ c ɟ ɲ ʎ",
    "velar": "k ɡ ɠ ŋ x ɣ ɰ",
    "alveolar": "t d ɗ n s z r ɹ ɾ l ɫ ɬ ɮ ɺ",
    "approximant": "w ʍ j ɥ ɰ ʋ ɹ ɻ l ɫ ɭ ʎ",
    "plosive": "p b ɓ t d ɗ ʈ ɖ c ɟ k ɡ ɠ q ɢ ʔ",
    "sibilant": "s z ʃ ʒ ɕ ʑ ʂ ʐ",
    "fricative": "ɸ β f v θ ð s z ɬ ɮ ʃ ʒ ɕ ʑ ʂ ʐ ç ʝ x ɣ χ ʁ ħ ʕ h ɦ",
}
VOWEL_CLASSES: dict[str, str] = {
    # Rounding shows the most, then how far the jaw is open; near-close counts as close, and near-open as open.
    "apical vowel": "ɿ ʅ",
    "rhotic vowel": "ɚ ɝ",
    "front rounded vowel": "y ʏ ø œ ɶ",
    "rounded vowel": "y ʏ ø œ ɶ ʉ ɵ ɞ u ʊ o ɔ ɒ",
    "open vowel": "a ɶ æ ɐ ɑ ɒ",
    "close vowel": "i y ɪ ʏ ɨ ᵻ ʉ ɯ u ʊ ɿ ʅ",
    "mid vowel": "e ø ɛ œ ə ɘ ɵ ɜ ɞ ɚ ɝ ɤ o ʌ ɔ",
    "back vowel": "ɯ u ʊ ɤ o ʌ ɔ ɑ ɒ",
    "central vowel": "ɨ ᵻ ʉ ə ɘ ɵ ɜ ɞ ɐ ɚ ɝ",
    "front vowel": "i y ɪ ʏ e ø ɛ œ æ a ɶ ɿ ʅ",
}


OPENNESS: dict[str, int] = {
    letter: height
    for height, letters in enumerate(
        ("i y ɨ ʉ ɯ u ɿ ʅ", "ɪ ʏ ʊ ᵻ", "e ø ɘ ɵ ɤ o", "ə ɚ", "ɛ œ ɜ ɞ ʌ ɔ ɝ", "æ ɐ", "a ɶ ɑ ɒ")
    )
    for letter in letters.split()
}
"""How open each vowel is, in rows of the chart: 0 close, 6 open."""


def _with_all(rows: dict[str, str], name: str) -> dict[str, frozenset[str]]:
    classes = {key: frozenset(letters.split()) for key, letters in rows.items()}
    return classes | {name: frozenset().union(*classes.values())}


ARTICULATIONS = _with_all(CONSONANT_CLASSES, "consonant") | _with_all(VOWEL_CLASSES, "vowel")
"""The letters of each class. None stands before one that it holds: of a sound's classes the first says the most."""
IPA_LETTERS = ARTICULATIONS["consonant"] | ARTICULATIONS["vowel"]
"""Every sound that can be told from others."""

_SPELLINGS = str.maketrans({"g": "ɡ", "ʧ": "tʃ", "ʤ": "dʒ", "ʦ": "ts", "ʣ": "dz", "ʨ": "tɕ", "ʥ": "dʑ"})
"""How some people write what the IPA writes otherwise."""


@lru_cache(maxsize=1024)
def letters_of(phone: str) -> tuple[str, ...]:
    """Return the letters of the sounds that a phone is made of, without marks: ``tʃʰ`` is t and ʃ."""
    spelt = unicodedata.normalize("NFC", phone).translate(_SPELLINGS)
    bare = (mark if mark in IPA_LETTERS else unicodedata.normalize("NFD", mark)[0] for mark in spelt)
    return tuple(letter for letter in bare if letter in IPA_LETTERS)


@lru_cache(maxsize=1024)
def articulations_of(letter: str) -> tuple[str, ...]:
    """Return the classes of a sound, that which says the most about it first."""
    return tuple(name for name, letters in ARTICULATIONS.items() if letter in letters)


def narrowest(known: Mapping[str, T], phone: str, usual: T) -> T:
    """Return what is known of the first sound of a phone, or else of the narrowest class that it is of."""
    names = (name for letter in letters_of(phone)[:1] if known for name in (letter, *articulations_of(letter)))
    return next((known[name] for name in names if name in known), usual)
