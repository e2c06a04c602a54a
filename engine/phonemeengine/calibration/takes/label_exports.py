"""Label files for other programs beside the sounds of takes: copies of what the corpus format says there.

A copy follows its take. What somebody else put or changed there is left alone, but for a copy that is asked for: then
it is kept under another name.
"""

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from phonemeengine.calibration.takes.take import Take
from phonemeengine.errors import CorpusError, TakeError
from phonemeengine.files import free_path, printable_name, reason_of
from phonemeengine.labels.files import read_labels, write_labels
from phonemeengine.labels.label import Label
from phonemeengine.phonemes import Phoneme

COPY_SUFFIXES = (".TextGrid", ".txt")
"""Praat's and Audacity's."""


def write_copy(folder: Path, take: Take, suffix: str) -> Path | None:
    """Write the labels of a take beside its sound; give the new name of what was there and said something else.

    Raises
    ------
    CorpusError : the disk refuses; what was there is still there.
    """
    path = _copy_of(folder, take, suffix)
    if _is_ours(path, take):
        return None
    aside = free_path(path)
    try:
        if aside != path:
            path.rename(aside)
    except OSError as error:
        raise TakeError(
            f"{printable_name(path)}: this file cannot be renamed ({reason_of(error)}); "
            "close what uses it and try again"
        ) from error
    write_labels(take.to_labels(), path, duration=take.duration)
    return aside if aside != path else None


def remove_copies(folder: Path, take: Take) -> tuple[str, ...]:
    """Remove those copies that say what the take says; give their suffixes."""
    removed = []
    for suffix in COPY_SUFFIXES:
        path = _copy_of(folder, take, suffix)
        with suppress(OSError):
            if _is_ours(path, take):
                path.unlink()
                removed.append(suffix)
    return tuple(removed)


def write_copies(folder: Path, take: Take, suffixes: Iterable[str]) -> None:
    """Write copies again that were removed, as far as the disk allows: they can be had again at any time."""
    for suffix in suffixes:
        with suppress(CorpusError):
            write_copy(folder, take, suffix)


def _copy_of(folder: Path, take: Take, suffix: str) -> Path:
    return (folder / take.sound).with_suffix(suffix)


def _is_ours(path: Path, take: Take) -> bool:
    try:
        return _heard(read_labels(path)) == _heard(take.to_labels())
    except CorpusError:
        return False


def _heard(labels: Iterable[Label]) -> list[tuple[str, str, Phoneme]]:
    """Return what a copy can say of labels."""
    rows = [(f"{label.start:.6f}", f"{label.end:.6f}", label.phoneme) for label in labels]
    return [row for row in rows if row[0] != row[1]]
