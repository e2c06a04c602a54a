"""IPA in a voice's own names of phonemes, so that the voice says a word as a lexicon has it.

Each language of espeak-ng has names of its own, and what they sound like depends on their neighbours: a d at the end
of a German word is a t. So the voice itself is asked which names it has, and of each word, whether a spelling has the
very sounds of the lexicon. Where none has, names serve that have them alone: an American voice says the t of *water*
in its own way.
"""

import unicodedata
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product

from phonemeengine.labels.phone_sets import normal_ipa
from phonemeengine.text.espeak import SEPARATOR, Language, names_sounded, symbols_of
from phonemeengine.text.syllables import is_vowel

PHONEMES = "[["
"""Begins names of phonemes in a text."""
TRIES = 24
"""Spellings of a word that are tried."""
_LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123@&?*"
_MARKS = ':;.^#~-"/!`\\'
_AFFRICATES = ("tS", "dZ", "ts", "dz")
_NAMES = (
    *_LETTERS,
    *(first + second for first, second in product(_LETTERS, _LETTERS + _MARKS)),
    *(affricate + mark for affricate, mark in product(_AFFRICATES, _MARKS)),
)
"""Which a phoneme may have; most languages have two hundred of them."""
_PLACES = ("{}", "'{}", "@|{}|@")
"""Where the sound of a name is asked for: alone, stressed, and between vowels."""
_APART = "|"
_STRESSES = {"ˈ": "'", "ˌ": ","}
_LONG = "ː"
_NO_SOUND = str.maketrans("", "", "ˈˌʰ ")
_LONGEST = 5
"""Characters of a sound with its marks."""
_MODIFIERS = frozenset({"Mn", "Lm", "Sk"})
_WRITTEN_OTHERWISE = {"de": {"ɐ": "ɜ"}, "en": {"æ": "a"}}
"""What voices call otherwise than dictionaries: the end of German *Vater*, the vowel of British *cat*."""


@dataclass(frozen=True)
class _NamedSound:
    """A sound of a word: its IPA, the mark of its stress, and the names that sound so, the simplest first."""

    ipa: str
    stress: str
    names: tuple[str, ...]


def respelt(ipa: str, language: Language) -> str:
    """Return a word of IPA as espeak-ng takes it, in ``[[ ]]``; empty where the language's voice has no such sound.

    Parameters
    ----------
    ipa : of one word. Marks of stress stand before a syllable or its vowel; a single syllable needs none.
    language : whose voice is to say it.

    Raises
    ------
    VoiceError : the library of voices is missing or broken.
    """
    names = names_by_sound(language)
    others = _WRITTEN_OTHERWISE.get(language.tag.partition("-")[0], {})
    own = str.maketrans({ipa: other for ipa, other in others.items() if ipa not in names})
    sounds = _stressed(_sounds_of(normal_ipa(ipa).translate(own), names))
    spelling = _exact_spelling(sounds, language) or _usual_spelling(sounds, language)
    return f"{PHONEMES}{spelling}]]" if spelling else ""


@lru_cache(maxsize=32)
def names_by_sound(language: Language) -> Mapping[str, tuple[str, ...]]:
    """Return the names of phonemes of a language by what they sound like: IPA with its marks of length.

    Raises
    ------
    VoiceError : the library of voices is missing or broken.
    """
    found: dict[str, Counter[str]] = defaultdict(Counter)
    for place, name in product(_PLACES, _NAMES):
        k, parts = place.count("@|"), _sounded(place.format(name), language)
        if len(parts) == place.count(_APART) + 1 and symbols_of(parts[k]):
            found[parts[k].translate(_NO_SOUND)][name] += 1
    return {sound: tuple(sorted(names, key=lambda name: (len(name), -names[name]))) for sound, names in found.items()}


def _sounds_of(ipa: str, names: Mapping[str, tuple[str, ...]]) -> list[_NamedSound]:
    """Return the sounds of a word; nothing where one has no name."""
    sounds: list[_NamedSound] = []
    stress = ""
    while ipa:
        found = next((n for n in range(min(_LONGEST, len(ipa)), 0, -1) if _names_of(ipa[:n], names)), 0)
        if found:
            vowel = is_vowel(ipa[0])
            sounds.append(_NamedSound(ipa[:found], stress if vowel else "", _names_of(ipa[:found], names)))
            stress = "" if vowel else stress
        elif ipa[0] in _STRESSES:
            stress = _STRESSES[ipa[0]]
        elif unicodedata.category(ipa[0]) not in _MODIFIERS and ipa[0] != ".":
            return []
        ipa = ipa[found or 1 :]
    return sounds


def _names_of(sound: str, names: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    """Return the names of a sound, or those of the long one where a language has no short one."""
    return names.get(sound) or names.get(sound + _LONG, ())


def _stressed(sounds: Sequence[_NamedSound]) -> list[_NamedSound]:
    """Return the sounds of a word, with stress on its vowel where there is only one."""
    single = sum(is_vowel(sound.ipa) for sound in sounds) == 1
    return [replace(s, stress=_STRESSES["ˈ"]) if single and is_vowel(s.ipa) else s for s in sounds]


def _exact_spelling(sounds: Sequence[_NamedSound], language: Language) -> str:
    """Return a spelling that has these sounds; empty where none is found.

    Where a name sounds otherwise beside its neighbours, the next one of the same sound takes its place.
    """
    wanted, chosen = "".join(map(_phones_of, (s.ipa for s in sounds))), [0] * len(sounds)
    for _ in range(TRIES if sounds else 0):
        spelling = _spelt(sounds, chosen)
        parts = [phones for part in _sounded(spelling, language) if (phones := _phones_of(part))]
        if "".join(parts) == wanted:
            return spelling
        wrong = min(_first_other(parts, wanted), len(sounds) - 1)
        chosen[wrong] += 1
        if chosen[wrong] == len(sounds[wrong].names):
            break
    return ""


def _usual_spelling(sounds: Sequence[_NamedSound], language: Language) -> str:
    """Return the simplest names where each has its sound when it stands alone; empty otherwise."""
    alone = all(_phones_of("".join(_sounded(s.names[0], language))) == _phones_of(s.ipa) for s in sounds)
    spelling = _spelt(sounds, [0] * len(sounds))
    return spelling if alone and len(_sounded(spelling, language)) == len(sounds) else ""


def _spelt(sounds: Sequence[_NamedSound], chosen: Sequence[int]) -> str:
    return _APART.join(sound.stress + sound.names[k] for sound, k in zip(sounds, chosen, strict=True))


def _sounded(names: str, language: Language) -> list[str]:
    """Return how names sound, each apart."""
    return [part for part in names_sounded(names, language).split(SEPARATOR) if part.strip()]


def _phones_of(ipa: str) -> str:
    return "".join(symbols_of(ipa))


def _first_other(parts: Sequence[str], wanted: str) -> int:
    """Return the first part that is not what is wanted."""
    for k, part in enumerate(parts):
        if not wanted.startswith(part):
            return k
        wanted = wanted.removeprefix(part)
    return len(parts)
