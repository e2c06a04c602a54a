"""The names of sounds in label files, and which of our phonemes they stand for.

A name is looked up in the user's mapping, then among our own names, then in IPA, SAMPA and ARPAbet. ``S`` is the
sound of *see* in ARPAbet and that of *she* in SAMPA: what else stands in the files tells which alphabet they are
written in, and a name that is then still doubtful counts as unknown.
"""

import os
import tomllib
from collections import abc
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from phonemeengine.errors import CorpusError, UnknownPhonemeError
from phonemeengine.labels.label import Label, RawLabel
from phonemeengine.labels.phone_sets import AFFRICATE, PhoneClass, own_phone_class, phone_classes_in
from phonemeengine.labels.table import read_text, rows_of
from phonemeengine.phonemes import PHONEMES_BY_LABEL, Phoneme
from phonemeengine.storage.files import printable_name

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
