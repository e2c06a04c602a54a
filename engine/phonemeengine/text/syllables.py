"""Syllables: the phones of a word between its vowels, by maximal onset.

A syllable begins as early as its consonants can begin one (Kahn 1976, Syllable-based generalizations in English
phonology): where they grow more sonorous towards the vowel, or are s or ʃ before a stop.
"""

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

_VOWELS = frozenset("aɑɐɒæɛeəɘɚɜɝɞɤiɪɨᵻyʏʉuʊɯoɔøœɵʌɶ")
_SYLLABIC = "\u0329"
_SONORITIES = {
    consonant: sonority
    for sonority, consonants in enumerate(
        ("p b t d k ɡ q ʔ c ɟ ʈ ɖ ɢ ɓ ɗ ɠ", "", "m n ɲ ŋ ɳ ɱ ɴ", "l ɫ r ɹ ɾ ʁ ʀ ɻ ɭ ʎ ɽ ɺ", "j w ɥ ʍ ɰ")
    )
    for consonant in consonants.split()
}
_FRICATIVE = 1
_STOP = 0
_BEFORE_STOPS = frozenset("sʃ")
_FRICTION_OF = {"p": "f", "b": "v", "t": "sʃɕʂ", "d": "zʒʑʐ", "ʈ": "ʂ", "ɖ": "ʐ", "k": "x"}
"""What a closure opens into as an affricate."""
_NO_ONSET = frozenset("ŋɴ")


@dataclass(frozen=True)
class SpokenSyllable:
    """A syllable as it is pronounced.

    Attributes
    ----------
    phones : symbols of IPA, without stress; at least one.
    stress : 0 for none, 1 for the main one of its word, 2 for a secondary one.
    """

    phones: tuple[str, ...]
    stress: int = 0


def is_vowel(phone: str) -> bool:
    """Return whether a symbol of IPA makes a syllable: a vowel, or a consonant that is marked as syllabic."""
    return unicodedata.normalize("NFD", phone)[0] in _VOWELS or _SYLLABIC in phone


def syllables_of(phones: Sequence[str], stresses: Sequence[int]) -> tuple[SpokenSyllable, ...]:
    """Return the syllables of a word; one without a vowel is a single one.

    Parameters
    ----------
    phones : symbols of IPA, at least one.
    stresses : of each phone; that of its vowel is a syllable's.
    """
    vowels = [k for k, phone in enumerate(phones) if is_vowel(phone)]
    borders = [_onset(phones, before + 1, k) for before, k in pairwise(vowels)]
    starts, ends = [0, *borders], [*borders, len(phones)]
    return tuple(
        SpokenSyllable(tuple(phones[a:b]), next(filter(None, stresses[a:b]), 0))
        for a, b in zip(starts, ends, strict=True)
    )


def _onset(phones: Sequence[str], first: int, vowel: int) -> int:
    """Return where the syllable of a vowel begins, if it may begin at `first`."""
    start = vowel
    while start > first and _may_precede(phones[start - 1], phones[start] if start < vowel else ""):
        start -= 1
    return start


def _may_precede(phone: str, following: str) -> bool:
    if phone[0] in _NO_ONSET:
        return False
    if not following:
        return True
    if _sonority(phone) == _STOP and _sonority(following) == _FRICATIVE:
        return following[0] in _FRICTION_OF.get(phone[0], "")
    return _sonority(phone) < _sonority(following) or (phone[0] in _BEFORE_STOPS and _sonority(following) == _STOP)


def _sonority(phone: str) -> int:
    return _SONORITIES.get(phone[0], _FRICATIVE)
