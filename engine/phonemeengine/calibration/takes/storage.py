"""The folder of a project of takes, and how a change of it is made.

Every change is whole or has not happened, whatever happens to this process or to the disk, and no sound goes before
its copy is complete: sounds are copied and label files and manifest written first; then the new list replaces the
old one, and only after that the old sound goes. Copies of the labels for other programs are gone meanwhile.
"""

import filecmp
import re
import shutil
from collections.abc import Collection, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.recording import write_flac
from phonemeengine.calibration.takes.take import (
    DELETED,
    SOUND_SUFFIX,
    TAKES,
    Take,
    folder_for,
    read_take_list,
    write_manifest,
    write_take_labels,
    write_take_list,
)
from phonemeengine.errors import CorpusError, TakeError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.files import read_labels, write_labels
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.storage.files import atomic_write, free_path, printable_name, reason_of
from phonemeengine.storage.replacing import lock_at

# Label files for other programs beside the sounds of takes: copies of what the corpus format says there.
#
# A copy follows its take. Files that others put or changed there stay, but for a copy that is asked for:
# then it is kept under another name.

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
        return _rows_of(read_labels(path)) == _rows_of(take.to_labels())
    except CorpusError:
        return False


def _rows_of(labels: Iterable[Label]) -> list[tuple[str, str, Phoneme]]:
    """Return what a copy can say of labels."""
    rows = [(f"{label.start:.6f}", f"{label.end:.6f}", label.phoneme) for label in labels]
    return [row for row in rows if row[0] != row[1]]


LOCK = "takes.lock"
_NUMBER = re.compile(r"-(\d{1,9})\b")


class _HalfMade(NamedTuple):
    """A change whose first half is made: the take before and now, whether its sound was copied, removed copies."""

    old: Take | None
    new: Take
    copied: bool
    copies: tuple[str, ...]


class TakeFolder:
    """Keeps the takes of a project on the disk, and the folder to itself.

    Parameters
    ----------
    folder : made where there is none.
    progress : called with the share that is read, 0..1.

    Attributes
    ----------
    takes : all takes by number, also deleted and missing ones.
    missing : numbers of the takes whose sounds are not there.
    notes : remarks for the user, a sentence each; mostly none.

    Raises
    ------
    TakeError : it cannot be made, is open elsewhere, is another kind of corpus, or a newer program wrote it.
    CorpusError : its files cannot be read or written.
    Cancelled : the answer of `progress` is not to go on; nothing was changed but label files that were wrong.
    """

    def __init__(self, folder: Path, progress: Progress = no_progress) -> None:
        self._folder = folder
        self._lock = _locked(folder)
        try:
            found = read_take_list(folder)
            self.takes = {take.number: take for take in found.takes}
            self.missing = found.missing
            self.notes = found.notes
            self._changes: list[_HalfMade] = []
            self._waits = False
            self._catch_up(progress)
        except BaseException:
            self.close()
            raise

    def current(self, take: Take) -> Take:
        """Return a take as it is now.

        Raises
        ------
        TakeError : it is not in the project, or its sound is missing.
        """
        if take.number not in self.takes or take.number in self.missing:
            raise TakeError(f"{take.name}: this take is not in the project any more; open the project again")
        return self.takes[take.number]

    def free_number(self) -> int:
        """Return a number that no take and no file of a take has."""
        files = (*self._folder.glob(f"{TAKES}/*/*"), *self._folder.glob(f"{DELETED}/*/*"))
        numbers = [int(found[1]) for path in files if (found := _NUMBER.search(path.name))]
        return max([0, *self.takes, *numbers]) + 1

    def place_for(self, number: int, speaker: str, phoneme: Phoneme, *, deleted: bool) -> str:
        """Return the path in the folder where the sound of a take belongs."""
        place = f"{DELETED if deleted else TAKES}/{folder_for(speaker)}/{phoneme.label}-{number}{SOUND_SUFFIX}"
        now = self.takes.get(number)
        if now is not None and now.sound == place:
            return place
        return free_path(self._folder / place).relative_to(self._folder).as_posix()

    def add(self, take: Take, samples: Float32Array, rate: int) -> None:
        """Keep a new take with its sound.

        Raises
        ------
        RecordingError, CorpusError : the disk refuses; nothing has changed.
        """
        path = self._folder / take.sound
        _make_folder(path.parent)
        write_flac(path, samples, rate)
        try:
            self.put(take)
        except BaseException:
            with suppress(OSError):
                self._remove(take)
            raise

    def put(self, take: Take) -> None:
        """Let a take be what it is now; its sound moves where it says.

        Raises
        ------
        CorpusError : the disk refuses; nothing has changed.
        """
        old = self.takes.get(take.number)
        copied = old is not None and old.sound != take.sound and self._copy(old, take)
        copies = remove_copies(self._folder, old) if old is not None else ()
        self._changes.append(_HalfMade(old, take, copied, copies))
        self.takes = {**self.takes, take.number: take}
        try:
            write_take_labels(self._folder, take)
            if not self._waits:
                self._write_list()
        except BaseException:
            if not self._waits:
                self._go_back()
            raise

    @contextmanager
    def together(self) -> Iterator[None]:
        """Make several changes one: the list, which is long where there are many takes, is written once.

        Raises
        ------
        CorpusError : the disk refuses; none of the changes has happened.
        """
        self._waits = True
        try:
            yield
            self._write_list()
        except BaseException:
            self._go_back()
            raise
        finally:
            self._waits = False

    def forget(self, takes: Collection[Take]) -> None:
        """Remove takes and their sounds for ever.

        Raises
        ------
        CorpusError : the disk refuses; what was not removed is still a take.
        """
        for take in takes:
            remove_copies(self._folder, take)
            try:
                self._remove(take)
            except OSError as error:
                raise TakeError(
                    f"{take.sound}: it cannot be removed ({reason_of(error)}); close what uses it and try again"
                ) from error
            rest = {number: kept for number, kept in self.takes.items() if number != take.number}
            write_take_list(self._folder, rest.values())
            self.takes = rest

    def close(self) -> None:
        """Let others have the folder; may be called twice."""
        if self._lock is not None:
            with suppress(OSError):
                self._lock.release()

    def _catch_up(self, progress: Progress) -> None:
        """Write what follows from the list, where a crash or another program left something else there."""
        present = self._present(self.takes)
        for k, take in enumerate(present):
            report_progress(progress, k / len(present))
            write_take_labels(self._folder, take)
        if self.takes:
            write_manifest(self._folder, present)
        if self.notes:
            write_take_list(self._folder, self.takes.values())

    def _present(self, takes: dict[int, Take]) -> list[Take]:
        return [take for number, take in sorted(takes.items()) if number not in self.missing]

    def _copy(self, old: Take, new: Take) -> bool:
        """Copy a sound to its new place; say whether it was not there yet."""
        source, target = self._folder / old.sound, self._folder / new.sound
        _make_folder(target.parent)
        try:
            if target.exists():
                if filecmp.cmp(source, target, shallow=False):
                    return False
                raise TakeError(f"{new.sound}: there is another file of that name; move it out of the project")
            with source.open("rb") as sound, atomic_write(target, durable=True) as file:
                shutil.copyfileobj(sound, file)
        except OSError as error:
            raise TakeError(
                f"{new.sound}: the take cannot be moved there ({reason_of(error)}); check the project's folder"
            ) from error
        return True

    def _write_list(self) -> None:
        """Write manifest and list, with which the changes so far have happened; what they replaced goes."""
        write_manifest(self._folder, self._present(self.takes))
        write_take_list(self._folder, self.takes.values())
        changes, self._changes = self._changes, []
        for change in changes:
            write_copies(self._folder, change.new, change.copies)
            if change.old is not None and change.old.sound != change.new.sound:
                with suppress(OSError):
                    self._remove(change.old)

    def _go_back(self) -> None:
        """Undo the first half of changes that the disk refused."""
        changes, self._changes = self._changes, []
        for change in reversed(changes):
            self.takes = {number: take for number, take in self.takes.items() if number != change.new.number}
            if change.old is not None:
                self.takes[change.old.number] = change.old
            with suppress(OSError, CorpusError):
                if change.copied:
                    self._remove(change.new)
                if change.old is not None:
                    write_take_labels(self._folder, change.old)
            write_copies(self._folder, change.old or change.new, change.copies)
        with suppress(OSError, CorpusError):
            write_manifest(self._folder, self._present(self.takes))

    def _remove(self, take: Take) -> None:
        (self._folder / take.sound).unlink(missing_ok=True)
        (self._folder / take.labels).unlink(missing_ok=True)


def _locked(folder: Path) -> Any:
    """Make the folder and lock it; None where its disk knows no locks."""
    _make_folder(folder)
    lock = lock_at(folder / LOCK)
    try:
        lock.acquire(blocking=False)
    except TimeoutError as error:
        raise TakeError(
            f"{printable_name(folder)}: this project is open in another window or program; close it there first"
        ) from error
    except NotImplementedError:
        return None
    except OSError as error:
        raise TakeError(
            f"{printable_name(folder)}: this project cannot be written ({reason_of(error)}); choose another folder"
        ) from error
    return lock


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        raise TakeError(
            f"{printable_name(folder)}: this folder cannot be made ({reason_of(error)}); choose another"
        ) from error
