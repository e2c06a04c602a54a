"""Fifteen visemes: what the lips and the tongue show of a sound, finer than the eleven phonemes tell.

They are those of Oculus Lipsync, which avatars carry as blend shapes. Every phoneme allows some of them; which one it
is, a recogniser may recognise, or a phone says. A recogniser may also tell other visemes apart: a `VisemeSet` says
what they are.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import BoolArray, UInt8Array
from phonemeengine.errors import ModelError
from phonemeengine.labels.phone_sets import letters_of
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
"""The code of frames whose viseme is unknown or disputed."""
MOST_VISEMES = 32
"""The most that a set may have: the shipped runtime computes them together."""


@dataclass(frozen=True)
class VisemeSet:
    """The visemes that a recogniser tells apart: their names, and how they go with phonemes and sounds.

    Parameters
    ----------
    names : of the visemes, 1..32 in the order of their codes.
    phonemes : by each phoneme, the names of the visemes that it may be shown by, at least one.
    usual : by a phoneme, the viseme that it has where no more is known; one that may be any of several has none.
    phones : by a viseme that is finer than its phoneme, the letter of the IPA of a sound that it shows: mouth tables
        know that.

    Raises
    ------
    ModelError : they do not fit together.
    """

    names: tuple[str, ...]
    phonemes: Mapping[Phoneme, tuple[str, ...]]
    usual: Mapping[Phoneme, str]
    phones: Mapping[str, str]

    def __post_init__(self) -> None:
        known = {*self.names}
        if not 1 <= len(self.names) == len(known) <= MOST_VISEMES or not all(self.names):
            raise ModelError(f"a viseme set has 1..{MOST_VISEMES} different names, got {len(self.names)}; correct it")
        named = {*self.usual.values(), *self.phones, *(name for names in self.phonemes.values() for name in names)}
        if strange := sorted(named - known):
            raise ModelError(f"the viseme set names {strange[0]!r:.40}, which is none of its visemes; add it to them")
        if lacking := [phoneme.label for phoneme in Phoneme if not self.phonemes.get(phoneme)]:
            raise ModelError(f"the viseme set has no viseme for the phoneme {lacking[0]}; name one")
        for phoneme, name in self.usual.items():
            if name not in self.phonemes[phoneme]:
                raise ModelError(f"{name!r:.40} is no viseme of the phoneme {phoneme.label}; correct the viseme set")
        for name, phone in self.phones.items():
            if len(letters_of(phone)) != 1:
                raise ModelError(f"{phone!r:.40} of the viseme {name!r:.40} is no letter of the IPA; correct it")

    @cached_property
    def allowed(self) -> BoolArray:
        """Which visemes each phoneme may be shown by, shape (11, n_visemes)."""
        return np.array([[name in self.phonemes[phoneme] for name in self.names] for phoneme in Phoneme])

    def usual_visemes(self, phonemes: UInt8Array) -> UInt8Array:
        """Return the visemes of phonemes of which no more is known, uint8, shape (n_frames,).

        An unidentified sound mostly has `NO_VISEME`: it may be any of several.
        """
        return self._usual[phonemes]

    def phones_of(self, visemes: UInt8Array) -> list[str]:
        """Return for each frame the letter of a sound that looks as it does; empty where its phoneme says as much."""
        found: list[str] = self._phones[visemes].tolist()
        return found

    def labels_of(self, visemes: UInt8Array) -> list[str | None]:
        """Return the name of each frame's viseme; None where it is not known."""
        found: list[str | None] = self._labels[visemes].tolist()
        return found

    def codes_of(self, visemes: UInt8Array, other: "VisemeSet") -> UInt8Array:
        """Return the codes that another set's visemes have here, by their names; `NO_VISEME` for what it lacks."""
        codes = [self.names.index(name) if name in self.names else NO_VISEME for name in other.names]
        return np.array(codes + [NO_VISEME] * (NO_VISEME + 1 - len(codes)), np.uint8)[visemes]

    def to_json(self) -> str:
        """Return the set as JSON, which `from_json` reads."""
        by_phoneme = {phoneme.label: names for phoneme, names in self.phonemes.items()}
        usual = {phoneme.label: name for phoneme, name in self.usual.items()}
        told = {"names": self.names, "phonemes": by_phoneme, "usual": usual, "phones": dict(self.phones)}
        return json.dumps(told, ensure_ascii=False, sort_keys=True)

    @classmethod
    def from_json(cls, text: str) -> "VisemeSet":
        """Read a set.

        Raises
        ------
        ModelError : its parts do not fit together.
        ValueError, KeyError, TypeError, AttributeError : it is damaged.
        """
        told, phoneme_of = json.loads(text), {phoneme.label: phoneme for phoneme in Phoneme}
        return cls(
            names=tuple(str(name) for name in told["names"]),
            phonemes={phoneme_of[name]: tuple(map(str, names)) for name, names in told["phonemes"].items()},
            usual={phoneme_of[name]: str(viseme) for name, viseme in told["usual"].items()},
            phones={str(name): str(phone) for name, phone in told["phones"].items()},
        )

    @cached_property
    def _usual(self) -> UInt8Array:
        codes = {phoneme: self.names.index(name) for phoneme, name in self.usual.items()}
        return np.array([codes.get(phoneme, NO_VISEME) for phoneme in Phoneme], np.uint8)

    @cached_property
    def _phones(self) -> NDArray[np.object_]:
        return np.array([self.phones.get(name, "") for name in self._labels], object)

    @cached_property
    def _labels(self) -> NDArray[np.object_]:
        return np.array([*self.names, *[None] * (NO_VISEME + 1 - len(self.names))], object)


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
    Viseme.FF: "f",
    Viseme.TH: "θ",
    Viseme.DD: "t",
    Viseme.KK: "k",
    Viseme.NN: "n",
    Viseme.RR: "ɹ",
}
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
"""The sounds with one unambiguous viseme, by their letters in the IPA. Others share the looks of several:
h takes the mouth of the next vowel, j and w are between a vowel and a consonant, ə is anything."""
_BY_LETTER = {letter: viseme for viseme, letters in _LETTERS.items() for letter in letters.split()}
STANDARD_VISEMES = VisemeSet(
    names=tuple(viseme.label for viseme in Viseme),
    phonemes={phoneme: tuple(v.label for v in visemes) for phoneme, visemes in PHONEME_VISEMES.items()},
    usual={phoneme: visemes[0].label for phoneme, visemes in PHONEME_VISEMES.items() if len(visemes) == 1},
    phones={viseme.label: phone for viseme, phone in VISEME_PHONES.items()},
)
"""The fifteen, which every recogniser has that says nothing else; their codes are those of `Viseme`."""


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
