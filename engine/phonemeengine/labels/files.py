"""Label files of every kind, by the ending of their names: all reading and writing of labels goes through here."""

from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.labels import audacity, table
from phonemeengine.labels.phone_sets import PhonemeMap, labels_named
from phonemeengine.labels.table import read_text, write_text
from phonemeengine.labels.textgrid import Tier, format_textgrid, tiers_of
from phonemeengine.labels.utterance import Label, RawLabel, in_order
from phonemeengine.storage.files import printable_name

LABEL_SUFFIXES = (".textgrid", ".csv", ".txt")
"""Endings, in small letters, of label files; where a sound has several, the first counts."""

TIER_NAMES = ("phon", "segment", "mau")
"""What the names of tiers begin with that hold sounds, not words, in small letters."""


def read_labels(
    path: Path, mapping: PhonemeMap | None = None, *, duration: float | None = None, tier: str | None = None
) -> tuple[Label, ...]:
    """Read a label file: TextGrid (.TextGrid), Audacity's labels (.txt), or the corpus format (.csv).

    Parameters
    ----------
    path : the file.
    mapping : what unknown names stand for.
    duration : length of the sound, seconds, where it is known.
    tier : of a TextGrid; the first one whose names are phonemes, where it is None.

    Raises
    ------
    UnknownPhonemeError : names in it stand for no phoneme.
    CorpusError : it cannot be read, or says something impossible.
    """
    mapping = mapping or PhonemeMap()
    name = printable_name(path)
    raw_labels = read_raw_labels(path, mapping, duration=duration, tier=tier)
    return labels_named(raw_labels, mapping.phone_classes_of(names_in(raw_labels), name))


def read_raw_labels(
    path: Path, mapping: PhonemeMap, *, duration: float | None = None, tier: str | None = None
) -> tuple[RawLabel, ...]:
    """Read a label file as `read_labels` does, and leave its names as they are.

    Raises
    ------
    CorpusError : it cannot be read, or says something impossible.
    """
    name, suffix = printable_name(path), path.suffix.lower()
    if suffix not in LABEL_SUFFIXES:
        raise CorpusError(
            f"{name}: labels are read from .TextGrid, .txt (Audacity) and .csv files; choose one of them"
        )
    text = read_text(path)
    if suffix == ".textgrid":
        raw_labels = _chosen(tiers_of(text, name), mapping, tier, name).raw_labels
    else:
        raw_labels = (table if suffix == ".csv" else audacity).raw_labels_of(text, name)
    if not raw_labels:
        raise CorpusError(f"{name}: there is no label in it; label the sounds and save it again")
    return in_order(raw_labels, name, duration)


def names_in(raw_labels: Iterable[RawLabel]) -> Counter[str]:
    """Count the names of marks."""
    return Counter(raw.name for raw in raw_labels)


def write_labels(
    labels: Sequence[Label], path: Path, *, duration: float = 0.0, encoding: str = "utf-8", short: bool = False
) -> None:
    """Write labels in the format that the file's name ends with; the old file stays until the new one is complete.

    The corpus format (.csv) keeps everything; a TextGrid and Audacity's labels hold names and times, to the
    microsecond.

    Parameters
    ----------
    labels : in order of time.
    path : .TextGrid, .txt (Audacity) or .csv.
    duration : length of the sound, where a TextGrid ends, seconds; the end of the last label where that is later.
    encoding : of a TextGrid: utf-8, utf-8-sig, or utf-16 (both with a byte order mark).
    short : write a TextGrid in the short format.

    Raises
    ------
    CorpusError : the name ends differently, there is no label, or the file cannot be written.
    """
    suffix = path.suffix.lower()
    if suffix not in LABEL_SUFFIXES:
        raise CorpusError(
            f"{printable_name(path)}: labels are written to .TextGrid, .txt (Audacity) "
            "and .csv files; choose such a name"
        )
    if not labels:
        raise CorpusError(f"{printable_name(path)}: there is no label to write; label something first")
    if suffix == ".textgrid":
        write_text(format_textgrid(labels, duration, short=short), path, encoding)
    else:
        write_text(table.format_table(labels) if suffix == ".csv" else audacity.format_audacity(labels), path)


def _chosen(tiers: tuple[Tier, ...], mapping: PhonemeMap, wanted: str | None, file: str) -> Tier:
    """Return the tier of a name, or the one of whose names the most are known."""
    names = ", ".join(repr(tier.name[:40]) for tier in tiers) or "none"
    if wanted is not None:
        found = [tier for tier in tiers if tier.name == wanted]
        if not found:
            raise CorpusError(
                f"{file}: there is no tier of intervals named {wanted!r:.40}, found {names}; choose one"
            )
        return found[0]
    filled = [tier for tier in tiers if tier.raw_labels]
    if not filled:
        raise CorpusError(
            f"{file}: there is no tier of intervals with a label, found {names}; label the sounds in one"
        )
    return phoneme_tier_of(filled, mapping)


def phoneme_tier_of(tiers: Sequence[Tier], mapping: PhonemeMap) -> Tier:
    """Return the one of some tiers with labels whose names are phonemes more often than those of the others."""
    return max(tiers, key=lambda tier: (_known_share(tier, mapping), tier.name.lower().startswith(TIER_NAMES)))


def known_labels(raw_labels: Iterable[RawLabel], mapping: PhonemeMap, file: str) -> tuple[Label, ...]:
    """Return those of some marks as labels whose names are known; the others, such as words, are left out.

    Raises
    ------
    UnknownPhonemeError : names are doubtful, since alphabets do not agree on them.
    """
    known = [raw for raw in raw_labels if mapping.knows(raw.name)]
    return labels_named(known, mapping.phone_classes_of(names_in(known), file))


def _known_share(tier: Tier, mapping: PhonemeMap) -> float:
    return sum(mapping.knows(raw.name) for raw in tier.raw_labels) / len(tier.raw_labels)
