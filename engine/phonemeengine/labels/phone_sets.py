"""What the names of sounds in label files mean: in IPA, SAMPA and ARPAbet, and which of our phonemes they stand for.

The classes are those of the corpus format: vowels between two classes are ambiguous, diphthongs count as what they
begin with, and an affricate is a closure that ends in friction.

A name is looked up in the user's mapping, then among our own names, then in IPA, SAMPA and ARPAbet. ``S`` is the
sound of *see* in ARPAbet and that of *she* in SAMPA: what else stands in the files tells which alphabet they are
written in, and a name that is then still doubtful counts as unknown.
"""

import os
import re
import tomllib
import unicodedata
from collections import abc
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import TypeVar

from phonemeengine.errors import CorpusError, UnknownPhonemeError
from phonemeengine.labels.table import read_text, rows_of
from phonemeengine.labels.utterance import CORE, Label, RawLabel
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.storage.files import printable_name

AMBIGUOUS, DIPHTHONG, AFFRICATE = "ambiguous", "diphthong", "affricate"
X = Phoneme.UNIDENTIFIED


@dataclass(frozen=True)
class PhoneClass:
    """What a name stands for: a class, and how certain that is."""

    phoneme: Phoneme
    certainty: str = CORE


Row = tuple[Phoneme, str, str]
"""A class, a certainty, and the names that have them."""

SILENCES: tuple[Row, ...] = (
    (Phoneme.SILENCE, CORE, "sil sp pau # ## h# <p:> <sil> [sil] <s> </s> brth"),
    (X, CORE, "spn"),
)

ARPABET: tuple[Row, ...] = (
    (Phoneme.SZ, CORE, "S Z"),
    (Phoneme.SCH, CORE, "SH ZH"),
    (Phoneme.SCH, AFFRICATE, "CH JH"),
    (Phoneme.M, CORE, "M EM"),
    (Phoneme.P, CORE, "P B"),
    (Phoneme.A, CORE, "AA"),
    (Phoneme.A, AMBIGUOUS, "AH"),
    (Phoneme.A, DIPHTHONG, "AW AY"),
    (Phoneme.E, CORE, "EH"),
    (Phoneme.E, AMBIGUOUS, "AE AX ER AXR IX"),
    (Phoneme.E, DIPHTHONG, "EY"),
    (Phoneme.I, CORE, "IY"),
    (Phoneme.I, AMBIGUOUS, "IH"),
    (Phoneme.O, AMBIGUOUS, "AO"),
    (Phoneme.O, DIPHTHONG, "OW OY"),
    (Phoneme.U, CORE, "UW"),
    (Phoneme.U, AMBIGUOUS, "UH UX"),
    (X, CORE, "N EN NX NG L EL R Y W WH HH HV T D DX K G F V TH DH Q"),
)

ARPABET_SYMBOLS = {
    "AA": "ɑ",
    "AE": "æ",
    "AH": "ʌ",
    "AH0": "ə",
    "AO": "ɔ",
    "AW": "aʊ",
    "AX": "ə",
    "AXR": "ɚ",
    "AY": "aɪ",
    "B": "b",
    "CH": "tʃ",
    "D": "d",
    "DH": "ð",
    "DX": "ɾ",
    "EH": "ɛ",
    "EL": "l̩",
    "EM": "m̩",
    "EN": "n̩",
    "ER": "ɚ",
    "EY": "eɪ",
    "F": "f",
    "G": "ɡ",
    "HH": "h",
    "HV": "ɦ",
    "IH": "ɪ",
    "IX": "ɨ",
    "IY": "i",
    "JH": "dʒ",
    "K": "k",
    "L": "l",
    "M": "m",
    "N": "n",
    "NG": "ŋ",
    "NX": "ɾ",
    "OW": "oʊ",
    "OY": "ɔɪ",
    "P": "p",
    "Q": "ʔ",
    "R": "ɹ",
    "S": "s",
    "SH": "ʃ",
    "T": "t",
    "TH": "θ",
    "UH": "ʊ",
    "UW": "u",
    "UX": "ʉ",
    "V": "v",
    "W": "w",
    "WH": "ʍ",
    "Y": "j",
    "Z": "z",
    "ZH": "ʒ",
}
"""What ARPAbet's names are in the IPA."""

IPA: tuple[Row, ...] = (
    (Phoneme.SZ, CORE, "s z sʲ zʲ s̪ z̪"),
    (Phoneme.SZ, AFFRICATE, "ts dz tsʲ"),
    (Phoneme.SCH, CORE, "ʃ ʒ ʂ ʐ ʃʲ"),
    (Phoneme.SCH, AMBIGUOUS, "ɕ ʑ"),
    (Phoneme.SCH, AFFRICATE, "tʃ dʒ tɕ dʑ tʂ dʐ ʧ ʤ"),
    (Phoneme.M, CORE, "m mʲ m̩"),
    (Phoneme.M, AMBIGUOUS, "ɱ"),
    (Phoneme.P, CORE, "p b pʲ bʲ ɓ"),
    (Phoneme.P, AFFRICATE, "pf"),
    (Phoneme.A, CORE, "a ɑ ä ɑ̃ ã"),
    (Phoneme.A, AMBIGUOUS, "ʌ ɐ ɜ ɐ̃"),
    (Phoneme.A, DIPHTHONG, "aɪ aʊ ai au aj aw ɑɪ ɑʊ aɪə aʊə"),
    (Phoneme.E, CORE, "e ɛ"),
    (Phoneme.E, AMBIGUOUS, "æ ə ɘ ɚ ɝ ɤ ɛ̃ œ̃ ẽ"),
    (Phoneme.E, DIPHTHONG, "eɪ ei ej eə ɛɪ ɛə"),
    (Phoneme.I, CORE, "i ɪ"),
    (Phoneme.I, AMBIGUOUS, "ɨ ᵻ ɿ ʅ ĩ"),
    (Phoneme.I, DIPHTHONG, "iə ɪə"),
    (Phoneme.O, CORE, "o ɔ"),
    (Phoneme.O, AMBIGUOUS, "ɒ ɔ̃ õ ɵ ɞ ø œ ɶ"),
    (Phoneme.O, DIPHTHONG, "oʊ ou ow əʊ ɔɪ ɔʏ ɔj ɔø"),
    (Phoneme.U, CORE, "u ʊ"),
    (Phoneme.U, AMBIGUOUS, "y ʏ ʉ ɯ ũ"),
    (Phoneme.U, DIPHTHONG, "ʊə uə"),
    (X, CORE, "n n̩ nʲ ɲ ŋ l l̩ lʲ ɫ ʎ ɭ r ɹ ɾ ʁ ʀ rʲ ɻ j w ɥ ʍ h ɦ x χ ç ɣ ʝ t tʲ d dʲ c ɟ k ɡ g q f v ʋ θ ð ʔ"),
    (X, CORE, "ɸ β ʙ ɬ ɮ ɽ ʈ ɖ ɗ ɳ ɰ ɢ ɠ ɴ ħ ʕ ŋ̩ r̩ ɻ̩ z̩ r̝ r̝̊ ɺ"),
)

SAMPA: tuple[Row, ...] = (
    (Phoneme.SZ, CORE, "s z"),
    (Phoneme.SZ, AFFRICATE, "ts dz"),
    (Phoneme.SCH, CORE, "S Z"),
    (Phoneme.SCH, AFFRICATE, "tS dZ"),
    (Phoneme.M, CORE, "m m="),
    (Phoneme.P, CORE, "p b"),
    (Phoneme.P, AFFRICATE, "pf"),
    (Phoneme.A, CORE, "a A A~ a~"),
    (Phoneme.A, AMBIGUOUS, "V 6 3"),
    (Phoneme.A, DIPHTHONG, "aI aU"),
    (Phoneme.E, CORE, "e E"),
    (Phoneme.E, AMBIGUOUS, "{ @ @` 3` E~ e~ 9~"),
    (Phoneme.E, DIPHTHONG, "eI e@"),
    (Phoneme.I, CORE, "i I"),
    (Phoneme.I, AMBIGUOUS, "1"),
    (Phoneme.I, DIPHTHONG, "I@"),
    (Phoneme.O, CORE, "o O"),
    (Phoneme.O, AMBIGUOUS, "Q O~ o~ 2 9"),
    (Phoneme.O, DIPHTHONG, "@U oU OI OY"),
    (Phoneme.U, CORE, "u U"),
    (Phoneme.U, AMBIGUOUS, "y Y }"),
    (Phoneme.U, DIPHTHONG, "U@"),
    (X, CORE, "n n= N J l l= L r R R\\ r\\ 4 j w h x X C G t d k g f v T D ?"),
)

_TIES = str.maketrans("", "", "‿‍|-\u0361\u035c\u032f ")
_IPA_MARKS = str.maketrans("", "", "ˈˌː:ˑʰʼ‿‍|-\u0361\u035c\u032f ")
_STRESS = re.compile(r"(?<=[A-Z])[012]$")
_SAMPA_MARKS = re.compile(r"^[\"%']+|:|_h|_>")


def _table(rows: tuple[Row, ...]) -> dict[str, PhoneClass]:
    return {name: PhoneClass(phoneme, certainty) for phoneme, certainty, names in rows for name in names.split()}


_SILENCES, _ARPABET, _IPA, _SAMPA = (_table(rows) for rows in (SILENCES, ARPABET, IPA, SAMPA))
_MOST_LETTERS = max(map(len, _IPA))
_WHOLE = frozenset(name for name, phone_class in _IPA.items() if phone_class.certainty != AFFRICATE)
_MODIFIERS = frozenset({"Mn", "Lm", "Sk"})
_SPELT_OTHERWISE = str.maketrans({"ʧ": "tʃ", "ʤ": "dʒ", "ʦ": "ts", "ʣ": "dz", "ɝ": "ɚ", "g": "ɡ"})
_OWN = {phoneme.label: PhoneClass(phoneme) for phoneme in Phoneme}


def ipa_of(name: str) -> tuple[str, ...]:
    """Return the symbols of IPA of a phone that is written in IPA or in ARPAbet, the halves of an affricate apart.

    A half of an affricate, as labels name it (``tʃ_cl``, ``tʃ_fr``), is one symbol. See `split_ipa`.
    """
    whole, _, half = name.partition("_")
    symbols = split_ipa(ARPABET_SYMBOLS.get(whole) or ARPABET_SYMBOLS.get(_STRESS.sub("", whole)) or whole)
    return {"cl": symbols[:1], "fr": symbols[-1:]}.get(half, symbols)


def stress_of_arpabet(name: str) -> int:
    """Return the stress that a vowel of ARPAbet bears as a digit: 0 for none, 1 for main, 2 for secondary."""
    return int(name[-1]) if _STRESS.search(name) else 0


def own_phone_class(name: str) -> PhoneClass | None:
    """Return what one of our own names means, or one that stands for silence in every alphabet; None for another."""
    small = name.lower()
    return _OWN.get(small) or _SILENCES.get(small)


def marks_silence(name: str) -> bool:
    """Return whether a name stands for silence in every alphabet, unlike the word *silence*, which is one of ours."""
    known = _SILENCES.get(name.lower())
    return known is not None and known.phoneme is Phoneme.SILENCE


def phone_classes_in(name: str) -> tuple[PhoneClass | None, PhoneClass | None, PhoneClass | None]:
    """Return what a name means in ARPAbet, IPA and SAMPA, without marks of stress and length; None for others."""
    spelt = name.upper() if name.islower() and name.isascii() else name
    return (
        _ARPABET.get(_STRESS.sub("", spelt)),
        _IPA.get(name.translate(_IPA_MARKS)),
        _SAMPA.get(_SAMPA_MARKS.sub("", name)),
    )


def ipa_class(symbol: str) -> PhoneClass | None:
    """Return what a symbol of `split_ipa` means; None for an unknown one."""
    return _IPA.get(symbol)


def ipa_phoneme(symbol: str) -> Phoneme:
    """Return the class of a symbol of `split_ipa`; an unknown one is unidentified."""
    return _IPA[symbol].phoneme if symbol in _IPA else X


def normal_ipa(name: str) -> str:
    """Return IPA as `split_ipa` takes it apart, with its marks of stress and length: letters that mean one thing."""
    return unicodedata.normalize("NFC", name.translate(_TIES)).translate(_SPELT_OTHERWISE).replace(":", "ː")


def split_ipa(name: str) -> tuple[str, ...]:
    """Return the symbols of IPA that a name is made of, the halves of an affricate apart.

    A diphthong is one symbol, and an unknown letter is one, too. Marks of stress and length, and modifiers
    that no symbol here has, are left out.
    """
    rest = unicodedata.normalize("NFC", name.translate(_IPA_MARKS)).translate(_SPELT_OTHERWISE)
    symbols = []
    while rest:
        known = next((rest[:n] for n in range(_MOST_LETTERS, 0, -1) if rest[:n] in _WHOLE), "")
        if known or unicodedata.category(rest[0]) not in _MODIFIERS:
            symbols.append(known or rest[0])
        rest = rest[len(known) or 1 :]
    return tuple(symbols)


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


FORMAT = "phonemeanalyser mapping 1"
COLUMNS = ("name", "phoneme")
CLOSURE = 0.45
"""Share of an affricate that is closure, as in the corpus format."""


@dataclass(frozen=True)
class PhonemeMap:
    """Which phoneme a foreign name stands for, as the user says; it goes before all other knowledge.

    Attributes
    ----------
    phonemes : by name, spelt as in the label files.
    """

    phonemes: abc.Mapping[str, Phoneme] = field(default_factory=dict)

    def knows(self, name: str) -> bool:
        """Return whether a name may stand for a phoneme."""
        return name in self.phonemes or own_phone_class(name) is not None or any(phone_classes_in(name))

    def phone_classes_of(self, names: abc.Mapping[str, int], file: str) -> dict[str, PhoneClass]:
        """Return what the names in some label files mean.

        Parameters
        ----------
        names : how often each occurs.
        file : what the files are called in a refusal.

        Raises
        ------
        UnknownPhonemeError : some are unknown, or doubtful; it holds them all.
        """
        known = {name: PhoneClass(phoneme) for name, phoneme in self.phonemes.items()}
        known |= {name: own for name in names if name not in known and (own := own_phone_class(name))}
        known |= _senses_in_the_same_alphabet([name for name in names if name not in known])
        unknown = {name: count for name, count in names.items() if name not in known}
        if unknown:
            raise UnknownPhonemeError(file, unknown)
        return known


def labels_named(raw_labels: Iterable[RawLabel], phone_classes: abc.Mapping[str, PhoneClass]) -> tuple[Label, ...]:
    """Return marks as labels; affricates become a closure, which is unidentified, and friction."""
    return tuple(label for raw in raw_labels for label in _labels_of(raw, phone_classes[raw.name]))


def load_phoneme_map(path: str | os.PathLike[str]) -> PhonemeMap:
    """Load a mapping: TOML with lines ``name = "phoneme"`` in a table ``[phonemes]``, or CSV with name and phoneme.

    Raises
    ------
    CorpusError : it cannot be read, or names no phoneme of ours.
    """
    path = Path(path)
    file = printable_name(path)
    text = read_text(path)
    entries = _entries_of_csv(text, file) if path.suffix.lower() == ".csv" else _entries_of_toml(text, file)
    return PhonemeMap({name: _phoneme_of(name, phoneme, file) for name, phoneme in entries.items()})


def _phoneme_of(name: str, phoneme: object, file: str) -> Phoneme:
    found = PHONEMES_BY_LABEL.get(phoneme.strip().lower()) if isinstance(phoneme, str) else None
    if found is None:
        raise CorpusError(
            f"{file}: {name!r:.40} must stand for one of {', '.join(PHONEMES_BY_LABEL)}, found {phoneme!r:.40}; "
            "correct it"
        )
    return found


def _senses_in_the_same_alphabet(names: list[str]) -> dict[str, PhoneClass]:
    """Return what names mean in the alphabets that know the most of them; what these do not agree on is left out."""
    found = {name: phone_classes_in(name) for name in names}
    n_known = [sum(phone_class is not None for phone_class in column) for column in zip(*found.values(), strict=True)]
    likely = [k for k, n in enumerate(n_known) if n == max(n_known)]
    meanings = {
        name: {phone_classes[k] for k in likely if phone_classes[k]}
        or {phone_class for phone_class in phone_classes if phone_class}
        for name, phone_classes in found.items()
    }
    return {
        name: phone_class for name, few in meanings.items() if len(few) == 1 for phone_class in few if phone_class
    }


def _labels_of(raw: RawLabel, phone_class: PhoneClass) -> tuple[Label, ...]:
    phone = raw.name if raw.phone is None else raw.phone
    certainty = raw.certainty or phone_class.certainty
    if raw.certainty is not None or phone_class.certainty != AFFRICATE or phone_class.phoneme is Phoneme.P:
        return (Label(raw.start, raw.end, phone, phone_class.phoneme, certainty),)
    friction = raw.start + CLOSURE * (raw.end - raw.start)
    return (
        Label(raw.start, friction, f"{phone}_cl", Phoneme.UNIDENTIFIED, AFFRICATE),
        Label(friction, raw.end, f"{phone}_fr", phone_class.phoneme, AFFRICATE),
    )


def _entries_of_toml(text: str, file: str) -> dict[str, object]:
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise CorpusError(f"{file}: this is no TOML file ({error}); correct it") from error
    if document.get("format", FORMAT) != FORMAT:
        raise CorpusError(
            f"{file}: a mapping begins with format = {FORMAT!r}, found {document['format']!r:.60}; if a newer "
            "version of the program wrote it, use that"
        )
    entries = document.get("phonemes")
    if not isinstance(entries, dict) or document.keys() - {"format", "phonemes"}:
        raise CorpusError(f'{file}: a mapping is a table [phonemes] with lines like "AA" = "a"; write it like that')
    return entries


def _entries_of_csv(text: str, file: str) -> dict[str, object]:
    entries: dict[str, object] = {}
    for line, row in rows_of(text, COLUMNS, file):
        if row["name"] in entries:
            raise CorpusError(f"{file}, line {line}: {row['name']!r:.40} stands there twice; remove one of the rows")
        entries[row["name"]] = row["phoneme"]
    return entries
