"""Label files as people edit them: all their tiers, and labels that are moved, renamed, inserted and deleted."""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.labels import audacity, table
from phonemeengine.labels.files import LABEL_SUFFIXES
from phonemeengine.labels.table import read_text, write_text
from phonemeengine.labels.textgrid import Tier, format_grid, tiers_of
from phonemeengine.labels.utterance import CORE, ROUNDING, RawLabel, in_order
from phonemeengine.storage.files import printable_name

SHORTEST = 0.005
"""Seconds that a label lasts at least when it is edited."""
PHONES, CLASSES, CERTAINTY = "phones", "classes", "certainty"
"""The tiers that the columns of the corpus format become; that of certainty only in a TextGrid."""
BY_HAND = "by hand"
"""Where labels stand that are in no file yet."""


def read_tiers(path: Path, *, duration: float | None = None) -> tuple[Tier, ...]:
    """Read all tiers of a label file; Audacity's labels have one, named after the file.

    The corpus format has two, ``phones`` and ``classes``; one, if both say the same. A tier ``certainty`` of a
    TextGrid says how certain the ``classes`` beside it are, as it was written here.

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
        return _with_certainty(tiers_of(text, name, points=True))
    labels = (table if suffix == ".csv" else audacity).raw_labels_of(text, name)
    if all(raw.phone in {None, "", raw.name} for raw in labels):
        return (Tier(path.stem, labels),)
    phones = tuple(replace(raw, name=raw.phone or raw.name, phone=None, certainty=None) for raw in labels)
    return Tier(PHONES, phones), Tier(CLASSES, tuple(replace(raw, phone=None) for raw in labels))


def _with_certainty(tiers: tuple[Tier, ...]) -> tuple[Tier, ...]:
    """Return the tiers of a TextGrid, of which that of certainty is said of the classes."""
    named = {tier.name: tier for tier in tiers}
    if not {CLASSES, CERTAINTY} <= named.keys():
        return tiers
    said = {(raw.start, raw.end): raw.name for raw in named[CERTAINTY].raw_labels}
    classes = tuple(replace(raw, certainty=said.pop((raw.start, raw.end), CORE)) for raw in named[CLASSES].raw_labels)
    if said:
        return tiers  # they are not about the classes
    kept = (tier for tier in tiers if tier.name != CERTAINTY)
    return tuple(replace(tier, raw_labels=classes) if tier.name == CLASSES else tier for tier in kept)


def write_tiers(tiers: Sequence[Tier], path: Path, *, duration: float = 0.0) -> None:
    """Write tiers to a label file; the old file stays until the new one is complete.

    In a TextGrid the certainty of classes becomes a tier of its own; other formats lose more, see `lost_in`.

    Parameters
    ----------
    tiers : all of a TextGrid, ``phones`` and ``classes`` of the corpus format, or the one of another file.
    path : .TextGrid, .txt (Audacity) or .csv.
    duration : length of the sound, where a TextGrid ends, seconds.

    Raises
    ------
    CorpusError : the format holds one interval tier only, or the file cannot be written.
    """
    name, suffix = printable_name(path), path.suffix.lower()
    if suffix == ".textgrid":
        ends = [raw.end for tier in tiers for raw in tier.raw_labels]
        write_text(format_grid([*tiers, *_certainty_of(tiers)], max([duration, *ends])), path)
        return
    if suffix not in LABEL_SUFFIXES:
        raise CorpusError(f"{name}: labels are written to .TextGrid, .txt and .csv files; choose such a name")
    if suffix == ".csv" and {tier.name for tier in tiers} == {PHONES, CLASSES}:
        tiers = [_joined(*sorted(tiers, key=lambda tier: tier.name))]
    if len(tiers) != 1 or tiers[0].points:
        raise CorpusError(f"{name}: only a TextGrid holds {len(tiers)} tiers; save the labels as .TextGrid")
    labels = tiers[0].raw_labels
    if suffix == ".csv":
        rows = ((f"{x.start:.6f}", f"{x.end:.6f}", x.phone or x.name, x.name, x.certainty or CORE) for x in labels)
        write_text(table.table_of(table.COLUMNS, rows), path)
    else:
        write_text("".join(f"{x.start:.6f}\t{x.end:.6f}\t{x.name}\n" for x in labels), path)


def kept_in(tiers: Sequence[Tier], number: int, path: Path) -> tuple[Tier, ...]:
    """Return which tiers a label file of such a name holds: all, or that of a number, with its phones in a table."""
    suffix = path.suffix.lower()
    if suffix == ".textgrid":
        return tuple(tiers)
    if suffix == ".csv" and tiers[number].name in {PHONES, CLASSES}:
        pair = tuple({tier.name: tier for tier in tiers if tier.name in {PHONES, CLASSES}}.values())
        return pair if len(pair) == 2 else (tiers[number],)
    return (tiers[number],)


def lost_in(tiers: Sequence[Tier], number: int, path: Path) -> tuple[str, ...]:
    """Return the tiers that a label file of such a name would not keep, and ``certainty``, if that is lost."""
    kept = kept_in(tiers, number, path)
    labels = [raw for tier in tiers for raw in tier.raw_labels]
    is_lost = path.suffix.lower() == ".txt" and any(raw.certainty not in {None, CORE} for raw in labels)
    lost = tuple(tier.name for tier in tiers if not any(tier is one for one in kept))
    return (*lost, CERTAINTY) if is_lost else lost


def _joined(classes: Tier, phones: Tier) -> Tier:
    """Return classes with the phones that they have most in common with."""
    starts = [raw.start for raw in phones.raw_labels]

    def phone_of(label: RawLabel) -> str | None:
        beside = phones.raw_labels[max(0, bisect_right(starts, label.start) - 1) : bisect_right(starts, label.end)]
        shared = [(min(label.end, raw.end) - max(label.start, raw.start), raw.name) for raw in beside]
        longest, name = max(shared, key=lambda pair: pair[0], default=(0.0, ""))
        return name if longest > 0 else None

    return replace(classes, raw_labels=tuple(replace(raw, phone=phone_of(raw)) for raw in classes.raw_labels))


def _certainty_of(tiers: Sequence[Tier]) -> list[Tier]:
    """Return a tier of what is said of the certainty of labels, if any is in doubt."""
    labels = [raw for tier in tiers for raw in tier.raw_labels if raw.certainty]
    if all(raw.certainty == CORE for raw in labels):
        return []
    return [Tier(CERTAINTY, tuple(replace(raw, name=raw.certainty or CORE) for raw in labels))]


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
    check_room(tier, start, end)
    label = RawLabel(start, end, _checked_name(name), BY_HAND)
    return replace(tier, raw_labels=in_order((*tier.raw_labels, label), tier.name))


def check_room(tier: Tier, start: float, end: float) -> None:
    """Check that a label can be inserted between two times, seconds.

    Raises
    ------
    CorpusError : it would be too short, or there is one already.
    """
    if end - start < SHORTEST:
        raise CorpusError(f"a label lasts {1000 * SHORTEST:g} ms at least; select a longer segment")
    for other in tier.raw_labels:
        if other.start < end - ROUNDING and start < other.end - ROUNDING:
            raise CorpusError(
                f"{other.name!r} is labelled from {other.start:.3f} to {other.end:.3f} s; delete it first, or select "
                "a segment beside it"
            )


def split(tier: Tier, k: int, seconds: float) -> Tier:
    """Return a tier in which a label is two of the same name, the second of which begins at a time.

    Raises
    ------
    CorpusError : one of them would be too short, or the tier is one of points.
    """
    label = tier.raw_labels[k]
    if tier.points or not label.start + SHORTEST <= seconds <= label.end - SHORTEST:
        raise CorpusError(
            f"{label.name!r} can't be split at {seconds:.3f} s: each part lasts {1000 * SHORTEST:g} ms at least; "
            "move the cursor into the label"
        )
    parts = replace(label, end=seconds), replace(label, start=seconds)
    return replace(tier, raw_labels=(*tier.raw_labels[:k], *parts, *tier.raw_labels[k + 1 :]))


def merged(tier: Tier, k: int, other: int) -> Tier:
    """Return a tier in which a label reaches over its neighbour, too, and keeps its name.

    Parameters
    ----------
    tier : as it was.
    k : which label keeps its name.
    other : that after it, or before it; a gap between the two belongs to the label then.

    Raises
    ------
    CorpusError : there is no such neighbour, or the tier is one of points.
    """
    if tier.points or not 0 <= other < len(tier.raw_labels):
        raise CorpusError(
            f"{tier.raw_labels[k].name!r} has no label there to merge with; choose one that has a neighbour"
        )
    first, last = sorted((k, other))
    labels = tier.raw_labels
    whole = replace(labels[k], start=labels[first].start, end=labels[last].end)
    return replace(tier, raw_labels=(*labels[:first], whole, *labels[last + 1 :]))


def gap_at(tier: Tier | None, seconds: float, duration: float) -> tuple[float, float]:
    """Return from when to when nothing is labelled around a time, seconds; an empty gap where something is."""
    labels = () if tier is None else tier.raw_labels
    if any(raw.start <= seconds < raw.end for raw in labels):
        return seconds, seconds
    before = max((raw.end for raw in labels if raw.end <= seconds), default=0.0)
    return before, min((raw.start for raw in labels if raw.start > seconds), default=duration)


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
