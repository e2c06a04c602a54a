"""Fifteen visemes: what the lips and the tongue show of a sound, finer than the eleven phonemes tell.

They are those of Oculus Lipsync, which avatars carry as blend shapes. Every phoneme allows some of them; which one it
is, a recogniser may hear, or a phone says.
"""

from enum import IntEnum

import numpy as np

from phonemeengine.arrays import UInt8Array
from phonemeengine.labels.articulation import letters_of
from phonemeengine.phonemes import Phoneme


class Viseme(IntEnum):
    """What a mouth shows; the number is the code used in arrays (uint8)."""

    SIL = 0
    PP = 1
    FF = 2
    TH = 3
    DD = 4
    KK = 5
    CH = 6
    SS = 7
    NN = 8
    RR = 9
    AA = 10
    E = 11
    IH = 12
    OH = 13
    OU = 14

    @property
    def label(self) -> str:
        """The name that avatars have for it, such as ``FF`` or ``kk``."""
        return _LABELS[self]


_LABELS = {
    viseme: viseme.name.lower() if viseme.name in {"SIL", "KK", "NN", "AA", "IH", "OH", "OU"} else viseme.name
    for viseme in Viseme
}
NO_VISEME = 255
"""The code of frames whose viseme nobody knows, or of which people disagree."""

PHONEME_VISEMES: dict[Phoneme, tuple[Viseme, ...]] = {
    Phoneme.SILENCE: (Viseme.SIL,),
    Phoneme.UNIDENTIFIED: (Viseme.DD, Viseme.FF, Viseme.TH, Viseme.KK, Viseme.NN, Viseme.RR),
    Phoneme.SZ: (Viseme.SS,),
    Phoneme.SCH: (Viseme.CH,),
    Phoneme.M: (Viseme.PP,),
    Phoneme.P: (Viseme.PP,),
    Phoneme.I: (Viseme.IH,),
    Phoneme.A: (Viseme.AA,),
    Phoneme.E: (Viseme.E,),
    Phoneme.U: (Viseme.OU,),
    Phoneme.O: (Viseme.OH,),
}
"""The visemes that a phoneme may be shown by."""
VISEME_PHONES: dict[Viseme, str] = {
    Viseme.FF: "f", Viseme.TH: "θ", Viseme.DD: "t", Viseme.KK: "k", Viseme.NN: "n", Viseme.RR: "ɹ",
}  # fmt: skip
"""For each viseme that is finer than its phoneme, the symbol of a sound that it shows: mouth tables know that."""

_LETTERS: dict[Viseme, str] = {
    Viseme.PP: "p b m ɓ",
    Viseme.FF: "f v",
    Viseme.TH: "θ ð",
    Viseme.DD: "t d ɗ ʈ ɖ ɾ",
    Viseme.KK: "k ɡ ɠ ŋ x ɣ q ɢ",
    Viseme.CH: "ʃ ʒ ʂ ʐ ɕ ʑ",
    Viseme.SS: "s z",
    Viseme.NN: "n ɳ l ɫ ɭ",
    Viseme.RR: "r ɹ ɻ",
    Viseme.AA: "a ɑ",
    Viseme.E: "e ɛ",
    Viseme.IH: "i ɪ",
    Viseme.OH: "o ɔ",
    Viseme.OU: "u ʊ",
}
"""The sounds of which nobody doubts what they show, by their letters in the IPA. Others share the looks of several:
h takes the mouth of the next vowel, j and w are between a vowel and a consonant, ə is anything."""
_BY_LETTER = {letter: viseme for viseme, letters in _LETTERS.items() for letter in letters.split()}
ALLOWED = np.array([[viseme in PHONEME_VISEMES[phoneme] for viseme in Viseme] for phoneme in Phoneme])
"""Which visemes each phoneme may be shown by, shape (11, 15)."""
_PHONES = np.array(
    [VISEME_PHONES.get(Viseme(k), "") if k < len(Viseme) else "" for k in range(NO_VISEME + 1)], object
)
_USUAL = np.array(
    [PHONEME_VISEMES[p][0] if len(PHONEME_VISEMES[p]) == 1 else NO_VISEME for p in Phoneme], np.uint8
)  # fmt: skip


def viseme_of(phone: str, phoneme: Phoneme) -> Viseme | None:
    """Return what is seen of a phone; None where that is disputed, as of ``h`` or ``ə``, and of sounds of two parts.

    Parameters
    ----------
    phone : its symbol in the International Phonetic Alphabet, with any marks.
    phoneme : the class that it counts as.
    """
    if phoneme is Phoneme.SILENCE:
        return Viseme.SIL
    letters = letters_of(phone)
    return _BY_LETTER.get(letters[0]) if len(letters) == 1 else None


def viseme_phones(visemes: UInt8Array) -> list[str]:
    """Return for each frame the symbol of a sound that looks as it does; empty where its phoneme says as much."""
    found: list[str] = _PHONES[visemes].tolist()
    return found


def usual_visemes(phonemes: UInt8Array) -> UInt8Array:
    """Return the visemes of phonemes of which no more is known, uint8, shape (n_frames,).

    An unidentified sound has `NO_VISEME`: it may be any of several.
    """
    usual: UInt8Array = _USUAL[phonemes]
    return usual
