"""The file of a recording: made anew, held, watched, and saved elsewhere when its place vanishes."""

import errno
import io
import os
import shutil
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.libsndfile import DecodingError, FlacEncoder
from phonemeengine.errors import RecordingError
from phonemeengine.storage.files import atomic_write, free_path, printable, printable_name, reason_of

COPIED_AT_ONCE = 1 << 20
"""Bytes."""

TROUBLES: dict[int, tuple[str, str]] = {
    errno.ENOSPC: ("the disk is full", "free some space or record to another disk"),
    errno.EDQUOT: ("your share of the disk is used up", "free some space or record to another disk"),
    errno.EFBIG: ("the disk takes no larger file", "go on in a new file, or on a disk formatted as exFAT or NTFS"),
    errno.EROFS: ("the disk has become read-only", "record to another disk"),
    errno.EACCES: ("writing is no longer permitted", "change the permissions or record to another folder"),
    errno.EPERM: ("writing is no longer permitted", "change the permissions or record to another folder"),
}
"""What each refusal of the disk means while a recording runs, and what to do."""


class RecordingFile:
    """A new file that no other process has.

    Attributes
    ----------
    path : where it was made.
    raw : the file itself, unbuffered, open for writing and reading.

    Raises
    ------
    RecordingError : there is such a file already, or none can be made there.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.raw: BinaryIO = _made(path)

    def is_there(self) -> bool:
        """Return whether the path still leads to this file."""
        try:
            return os.path.samestat(os.fstat(self.raw.fileno()), self.path.stat())
        except PermissionError:
            return True  # it cannot be found out
        except OSError:
            return False

    def copy_to(self, folder: Path) -> Path:
        """Copy what was written into another folder, under a free name, from the open file itself.

        Raises
        ------
        OSError : it cannot be read or written; nothing is left there.
        """
        folder.mkdir(parents=True, exist_ok=True)
        path = free_path(folder / self.path.name)
        with path.open("xb") as copy:
            try:
                self.raw.seek(0)
                shutil.copyfileobj(self.raw, copy, COPIED_AT_ONCE)
            except OSError:
                path.unlink()
                raise
        return path

    def close(self) -> None:
        """Let go of the file; it stays."""
        with suppress(OSError):
            self.raw.close()

    def discard(self) -> None:
        """Let go of the file and remove it, if it is still where it was made."""
        was_there = self.is_there()
        self.close()
        if was_there:
            with suppress(OSError):
                self.path.unlink()


def describe_os_error(error: OSError) -> tuple[str, str]:
    """Return what a refusal of the disk means, and what to do."""
    unknown = (f"the disk refuses to take more ({reason_of(error)})", "check it or record to another disk")
    return TROUBLES.get(error.errno or 0, unknown)


def shown_folder(path: Path) -> str:
    """Return the folder of a file, without characters that would break the sentence it stands in."""
    return printable(str(path.absolute().parent))


def _made(path: Path) -> io.FileIO:
    name, folder = printable_name(path), shown_folder(path)
    try:
        if path.is_dir():
            raise RecordingError(f"{name}: this is a folder; choose a name for a new file")
        return path.open("x+b", buffering=0)
    except FileExistsError as error:
        raise RecordingError(
            f"{name}: there is a file of that name, which a recording does not overwrite; choose another name"
        ) from error
    except (FileNotFoundError, NotADirectoryError) as error:
        raise RecordingError(f"{name}: there is no folder {folder}; make it or choose another") from error
    except PermissionError as error:
        raise RecordingError(
            f"{name}: writing to {folder} is not permitted; change its permissions or choose another folder"
        ) from error
    except (OSError, ValueError) as error:
        raise RecordingError(
            f"{name}: it cannot be made in {folder} ({reason_of(error)}); choose another folder or name"
        ) from error


# A whole sound as a FLAC file, written so that a half one never shows.


def write_flac(path: Path, samples: Float32Array, rate: int) -> None:
    """Write a sound of 24 bits to a file, which appears once it is complete and on the disk.

    Parameters
    ----------
    path : ends in ``.flac``; a file of that name is replaced.
    samples : shape (n,) or (n, n_channels), ±1, n > 0.
    rate : 4000..655350 Hz.

    Raises
    ------
    RecordingError : the file cannot be written; nothing is left there.
    """
    try:
        with atomic_write(path, durable=True) as file:
            encoder = FlacEncoder(file, rate, 1 if samples.ndim == 1 else samples.shape[1], marks=False)
            encoder.write(samples)
            encoder.close()
    except OSError as error:
        what, advice = describe_os_error(error)
        raise RecordingError(f"{path.name}: {what}, so the sound is not kept; {advice}") from error
    except DecodingError as error:
        raise RecordingError(
            f"{path.name}: this sound cannot be written as FLAC ({error}); record it again"
        ) from error
