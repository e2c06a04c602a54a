"""Lexicons: how words are pronounced that a voice reads otherwise. What they say goes before the voice.

TOML: ``format = "phonemeanalyser lexicon 1"`` and a table ``[words]`` with lines ``word = "IPA"`` or, for variants,
``word = ["IPA", "IPA"]``. CSV: the columns word and ipa; a word with variants has several rows. In IPA, marks of
stress stand before a syllable or its vowel, and a full stop may stand between syllables.
"""

import os
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from phonemeengine.errors import CorpusError, TextError
from phonemeengine.labels.phone_sets import ipa_class, split_ipa
from phonemeengine.labels.table import rows_of
from phonemeengine.storage.files import printable_name, read_text_file
from phonemeengine.storage.strict_table import parse_toml, shown
from phonemeengine.text.syllables import SpokenSyllable, syllables_of

FORMAT = "phonemeanalyser lexicon 1"
COLUMNS = ("word", "ipa")
LARGEST = 64 << 20
STRESSES = {"ˈ": 1, "ˌ": 2}

Syllables = tuple[SpokenSyllable, ...]
V = TypeVar("V")


@dataclass(frozen=True)
class Lexicon:
    """How words are pronounced.

    Attributes
    ----------
    pronunciations : by word, case-folded: each a variant, the likeliest first.
    spellings : the same as they are written: IPA with its marks of stress and length.
    """

    pronunciations: Mapping[str, tuple[Syllables, ...]] = field(default_factory=dict)
    spellings: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def load_lexicon(path: str | os.PathLike[str]) -> Lexicon:
    """Load a lexicon, TOML or CSV.

    Raises
    ------
    TextError : it cannot be read, or says something that is no pronunciation.
    """
    path = Path(path)
    text, file = read_text_file(path, LARGEST, "a lexicon", TextError), printable_name(path)
    entries = _rows_of_csv(text, file) if path.suffix.lower() == ".csv" else _lines_of_toml(text, file)
    variants: dict[str, list[Syllables]] = defaultdict(list)
    spellings: dict[str, list[str]] = defaultdict(list)
    for place, word, ipa in entries:
        if len(word.split()) != 1 or min(word.strip()) < " ":
            raise TextError(f"{file}, {place}: a lexicon has single words, found {word!r:.40}; correct it")
        key = word.strip().casefold()
        variants[key].append(spoken_syllables(ipa, word, f"{file}, {place}"))
        spellings[key].append(ipa)
    if not variants:
        raise TextError(f"{file}: there is no word in it; write some, or leave the lexicon out")
    return Lexicon(_distinct(variants), _distinct(spellings))


def _distinct(variants: Mapping[str, Sequence[V]]) -> dict[str, tuple[V, ...]]:
    return {word: tuple(dict.fromkeys(found)) for word, found in variants.items()}


def _rows_of_csv(text: str, file: str) -> Iterator[tuple[str, str, str]]:
    try:
        rows = rows_of(text, COLUMNS, file)
    except CorpusError as error:
        raise TextError(str(error)) from error
    return ((f"line {line}", row["word"], row["ipa"]) for line, row in rows)


def _lines_of_toml(text: str, file: str) -> Iterator[tuple[str, str, str]]:
    try:
        top = parse_toml(text, "a lexicon", FORMAT, TextError)
        top.check_keys(["words"])
        words = top.table("words").entries
    except TextError as error:
        raise TextError(f"{file}: {error}") from error
    for word, said in words.items():
        for ipa in said if isinstance(said, list) else [said]:
            if not isinstance(ipa, str):
                raise TextError(f"{file}: {word!r:.40} must be IPA or a list of it, found {shown(ipa)}; correct it")
            yield "[words]", word, ipa


def spoken_syllables(ipa: str, word: str, place: str) -> Syllables:
    """Return the syllables that IPA says; those without dots are found as in any word.

    Parameters
    ----------
    ipa : with marks of stress, and full stops between syllables, where these are given.
    word, place : what it is the pronunciation of, and where it stands, for the sentence of an error.

    Raises
    ------
    TextError : it is no IPA.
    """
    syllables: list[SpokenSyllable] = []
    for part in ipa.replace(" ", ".").split("."):
        phones: list[str] = []
        stresses: list[int] = []
        for piece in re.findall(r"[ˈˌ]?[^ˈˌ]*", part):
            symbols = split_ipa(piece)
            if unknown := [symbol for symbol in symbols if ipa_class(symbol) is None]:
                raise TextError(f"{place}: {word!r:.40} has no IPA, found {unknown[0]!r} in {ipa!r:.40}; correct it")
            phones += symbols
            stresses += [STRESSES.get(piece[:1], 0), *[0] * len(symbols)][: len(symbols)]
        if phones:
            syllables += syllables_of(phones, stresses)
    if not syllables:
        raise TextError(f"{place}: {word!r:.40} has no sounds, found {ipa!r:.40}; write its IPA")
    return tuple(syllables)
