"""Label files as people edit them: all their tiers, and labels that are moved, renamed, inserted and deleted."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.labels import audacity, table
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.labels.label import CORE, ROUNDING, RawLabel, in_order
from phonemeengine.labels.table import read_text, write_text
from phonemeengine.labels.textgrid import Tier, format_grid, tiers_of
from phonemeengine.storage.files import printable_name

SHORTEST = 0.005
"""Seconds that a label lasts at least when it is edited."""
TRANSCRIPTION, CERTAINTY = "transcription", "certainty"
"""The tiers of a TextGrid that keep the columns phone and certainty of the corpus format."""
BY_HAND = "by hand"
"""Where labels stand that are in no file yet."""


def read_tiers(path: Path, *, duration: float | None = None) -> tuple[Tier, ...]:
    """Read all tiers of a label file; Audacity's labels and the corpus format have one, named after the file.

    Parameters
    ----------
    path : .TextGrid, .txt (Audacity) or .csv.
    duration : length of the sound, seconds, where it is known.

    Raises
    ------
    CorpusError : the file cannot be read, labels overlap, or one lies beyond the sound.
    """
    name, suffix = printable_name(path), path.suffix.lower()
    if suffix not in LABEL_SUFFIXES:
        raise CorpusError(
            f"{name}: labels are read from .TextGrid, .txt (Audacity) and .csv files; choose one of them"
        )
    tiers = _tiers_as_they_stand(path)
    return tuple(replace(tier, raw_labels=in_order(tier.raw_labels, name, duration)) for tier in tiers)


def _tiers_as_they_stand(path: Path) -> tuple[Tier, ...]:
    """Read all tiers, whatever their times are."""
    name, suffix, text = printable_name(path), path.suffix.lower(), read_text(path)
    if suffix == ".textgrid":
        return tuple(tiers_of(text, name, points=True))
    return (Tier(path.stem, (table if suffix == ".csv" else audacity).raw_labels_of(text, name)),)


def write_tiers(tiers: Sequence[Tier], path: Path, *, duration: float = 0.0) -> None:
    """Write tiers to a label file; the old file stays until the new one is complete.

    In a TextGrid, what the corpus format says besides of labels becomes tiers of its own, ``transcription`` and
    ``certainty``; in Audacity's labels it is lost, see `columns_lost`.

    Parameters
    ----------
    tiers : all of a TextGrid, or the one of another file.
    path : .TextGrid, .txt (Audacity) or .csv.
    duration : length of the sound, where a TextGrid ends, seconds.

    Raises
    ------
    CorpusError : the format holds one tier of stretches only, or the file cannot be written.
    """
    name, suffix = printable_name(path), path.suffix.lower()
    if suffix == ".textgrid":
        ends = [raw.end for tier in tiers for raw in tier.raw_labels]
        write_text(format_grid([*tiers, *_tiers_of_columns(tiers)], max([duration, *ends])), path)
        return
    if suffix not in LABEL_SUFFIXES:
        raise CorpusError(f"{name}: labels are written to .TextGrid, .txt and .csv files; choose such a name")
    if len(tiers) != 1 or tiers[0].points:
        raise CorpusError(f"{name}: only a TextGrid holds {len(tiers)} tiers; save the labels as .TextGrid")
    labels = tiers[0].raw_labels
    if suffix == ".csv":
        rows = ((f"{x.start:.6f}", f"{x.end:.6f}", x.phone or x.name, x.name, x.certainty or CORE) for x in labels)
        write_text(table.table_of(table.COLUMNS, rows), path)
    else:
        write_text("".join(f"{x.start:.6f}\t{x.end:.6f}\t{x.name}\n" for x in labels), path)


def columns_lost(tiers: Sequence[Tier], path: Path) -> tuple[str, ...]:
    """Return the columns of the corpus format that labels have and a label file of such a name does not hold."""
    if path.suffix.lower() != ".txt":
        return ()
    labels = [raw for tier in tiers for raw in tier.raw_labels]
    lost = {
        "phone": any(raw.phone not in {None, raw.name} for raw in labels),
        "certainty": any(raw.certainty not in {None, CORE} for raw in labels),
    }
    return tuple(name for name, is_lost in lost.items() if is_lost)


def _tiers_of_columns(tiers: Sequence[Tier]) -> list[Tier]:
    """Return what the corpus format says of labels besides their names, a tier for each column."""
    labels = [raw for tier in tiers for raw in tier.raw_labels]
    columns = {
        TRANSCRIPTION: [replace(raw, name=raw.phone) for raw in labels if raw.phone],
        CERTAINTY: [replace(raw, name=raw.certainty) for raw in labels if raw.certainty],
    }
    return [Tier(name, tuple(found)) for name, found in columns.items() if found]


def labels_beside(sound: Path) -> Path | None:
    """Return the label file of a sound, ``x.TextGrid``, ``x.csv`` or ``x.txt`` beside ``x.wav``; None without one.

    A text file counts only if it holds labels, be they impossible ones: it may as well be what is said.
    """
    try:
        names = {path.suffix.lower(): path for path in sound.parent.iterdir() if path.stem == sound.stem}
    except OSError:
        return None
    for suffix in LABEL_SUFFIXES:
        path = names.get(suffix)
        if path is not None and (suffix == ".textgrid" or _holds_labels(path)):
            return path
    return None


def moved(tier: Tier, k: int, *, end: bool, seconds: float) -> Tier:
    """Return a tier with one boundary elsewhere; the label that touches it there moves along.

    Parameters
    ----------
    tier : as it was.
    k : which label's boundary it is.
    end : whether it is its end, or its start.
    seconds : where it is to be; at most so far that each label keeps 5 ms, and no other is reached.
    """
    labels = list(tier.raw_labels)
    other = k + 1 if end else k - 1
    has_other = 0 <= other < len(labels)
    here = labels[k].end if end else labels[k].start
    touches = has_other and abs((labels[other].start if end else labels[other].end) - here) <= ROUNDING
    if end:
        most = (labels[other].end - SHORTEST if touches else labels[other].start) if has_other else float("inf")
        place = min(max(seconds, labels[k].start + SHORTEST), most)
        labels[k] = replace(labels[k], end=place)
        if touches:
            labels[other] = replace(labels[other], start=place)
    else:
        least = (labels[other].start + SHORTEST if touches else labels[other].end) if has_other else 0.0
        place = max(min(seconds, labels[k].end - SHORTEST), least)
        labels[k] = replace(labels[k], start=place)
        if touches:
            labels[other] = replace(labels[other], end=place)
    return replace(tier, raw_labels=tuple(labels))


def renamed(tier: Tier, k: int, name: str) -> Tier:
    """Return a tier in which a label says something else, which is sure now.

    Raises
    ------
    CorpusError : the name is empty.
    """
    label = replace(tier.raw_labels[k], name=_checked_name(name), phone=None, certainty=None)
    return replace(tier, raw_labels=(*tier.raw_labels[:k], label, *tier.raw_labels[k + 1 :]))


def inserted(tier: Tier, start: float, end: float, name: str) -> Tier:
    """Return a tier with one more label.

    Raises
    ------
    CorpusError : the name is empty, the label is too short, or there is one already.
    """
    label = RawLabel(start, end, _checked_name(name), BY_HAND)
    if end - start < SHORTEST:
        raise CorpusError(f"a label lasts {1000 * SHORTEST:g} ms at least; select a longer stretch")
    for other in tier.raw_labels:
        if other.start < end - ROUNDING and start < other.end - ROUNDING:
            raise CorpusError(
                f"{other.name!r} is labelled from {other.start:.3f} to {other.end:.3f} s; delete it first, or select "
                "a stretch beside it"
            )
    return replace(tier, raw_labels=in_order((*tier.raw_labels, label), tier.name))


def deleted(tier: Tier, k: int) -> Tier:
    """Return a tier without one of its labels."""
    return replace(tier, raw_labels=tier.raw_labels[:k] + tier.raw_labels[k + 1 :])


def _checked_name(name: str) -> str:
    if not name.strip():
        raise CorpusError("a label needs a name; write the sound, or delete the label")
    return " ".join(name.split())


def _holds_labels(path: Path) -> bool:
    try:
        return any(tier.raw_labels for tier in _tiers_as_they_stand(path))
    except CorpusError:
        return False
