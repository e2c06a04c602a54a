"""What can be told apart of the sounds of speech: a phoneme of the recogniser, made in one manner, and its viseme."""

from dataclasses import dataclass

from phonemeengine.alignment.manners import Manner, manner_of
from phonemeengine.labels.phone_sets import ipa_phoneme
from phonemeengine.phonemes import VOWELS, Phoneme
from phonemeengine.visemes import Viseme, viseme_of

LEAST_FRAMES: dict[Manner, int] = {
    Manner.SILENCE: 4,
    Manner.STOP: 5,
    Manner.NASAL: 5,
    Manner.APPROXIMANT: 3,
    Manner.FRICATIVE: 5,
    Manner.SIBILANT: 6,
    Manner.VOWEL: 7,
}
"""What sounds of a manner last at least in speech that is not hurried, 10 ms each."""

SHORT = frozenset("əɐɪʊɨᵻɾ")
LEAST_SHORT = 4
"""Sounds that are shorter than others of their manner, and what they last at least."""


@dataclass(frozen=True)
class SoundKind:
    """What is listened for: a phoneme, how it is made, and what is seen of it, where that tells more."""

    phoneme: Phoneme
    manner: Manner
    viseme: Viseme | None = None


KINDS: tuple[SoundKind, ...] = (
    SoundKind(Phoneme.SILENCE, Manner.SILENCE),
    *(SoundKind(vowel, Manner.VOWEL) for vowel in VOWELS),
    *(
        SoundKind(Phoneme.UNIDENTIFIED, manner)
        for manner in (Manner.STOP, Manner.NASAL, Manner.APPROXIMANT, Manner.FRICATIVE)
    ),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.STOP, Viseme.DD),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.STOP, Viseme.KK),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.NASAL, Viseme.NN),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.NASAL, Viseme.KK),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.APPROXIMANT, Viseme.DD),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.APPROXIMANT, Viseme.NN),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.APPROXIMANT, Viseme.RR),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.APPROXIMANT, Viseme.FF),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.APPROXIMANT, Viseme.TH),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.FRICATIVE, Viseme.FF),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.FRICATIVE, Viseme.TH),
    SoundKind(Phoneme.UNIDENTIFIED, Manner.FRICATIVE, Viseme.KK),
    SoundKind(Phoneme.P, Manner.STOP),
    SoundKind(Phoneme.M, Manner.NASAL),
    SoundKind(Phoneme.SZ, Manner.SIBILANT),
    SoundKind(Phoneme.SCH, Manner.SIBILANT),
)
"""All of them; silence is the first."""

_NUMBERS = {kind: k for k, kind in enumerate(KINDS)}
_BY_PHONEME = {kind.phoneme: k for k, kind in enumerate(KINDS) if kind.viseme is None}
"""For sounds that are made otherwise than those of their phoneme usually are."""


def kind_of(ipa: str) -> int:
    """Return the number of the kind of a sound, by its symbol in the phonetic alphabet."""
    phoneme, manner = ipa_phoneme(ipa), manner_of(ipa)
    kinds = (SoundKind(phoneme, manner, viseme_of(ipa, phoneme)), SoundKind(phoneme, manner))
    return next((_NUMBERS[kind] for kind in kinds if kind in _NUMBERS), _BY_PHONEME[phoneme])


def least_frames_of(ipa: str) -> int:
    """Return how many frames a sound lasts at least in speech that is not hurried."""
    return LEAST_SHORT if ipa in SHORT else LEAST_FRAMES[manner_of(ipa)]
