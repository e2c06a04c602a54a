"""Sounds and outputs that are not on a disk here, but at addresses such as ``s3://bucket/folder``.

They are fetched into a folder of this process's own, worked on there, and sent back whole. The only module that
imports UPath, which makes paths of whatever fsspec knows.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import cast

from phonemeengine.batch.work import FileState, Job, digest_of, size_and_time
from phonemeengine.errors import BatchError
from phonemeengine.storage.files import printable, printable_name, reason_of


def place_of(text: str) -> Path:
    """Return a path; what is at an address behaves as one, too.

    Raises
    ------
    BatchError : a package is missing that knows such addresses.
    """
    if "://" not in text:
        return Path(text)
    try:
        from upath import UPath  # noqa: PLC0415 - an extra

        place = UPath(text)
        place.exists()
    except (ImportError, ValueError) as error:
        raise BatchError(
            f"{printable(text)}: addresses need packages that cannot be loaded ({error}); install them with: pip "
            "install 'phonemeanalyser[cluster]' and, for s3://, s3fs"
        ) from error
    except Exception as error:  # whatever a storage's library raises
        reason = str(error).partition("\n")[0] or type(error).__name__
        raise BatchError(f"{printable(text)}: nothing answers there ({reason}); check the address") from error
    return cast("Path", place)


def is_remote(path: Path | None) -> bool:
    """Return whether a path is an address."""
    return path is not None and not isinstance(path, Path)


def write_place(path: Path, content: bytes) -> None:
    """Write something to an address, which keeps what was there until it has all of the new.

    Raises
    ------
    BatchError : it cannot be written.
    """
    try:
        path.write_bytes(content)
    except Exception as error:
        reason = reason_of(error) if isinstance(error, OSError) else str(error)
        raise BatchError(f"{printable_name(path)}: cannot be written ({reason}); choose another place") from error


class Fetched:
    """A job whose files are here.

    Attributes
    ----------
    job : with the files that are here; its `Job.sound` is still the one that was asked for.
    """

    def __init__(self, asked: Job, job: Job) -> None:
        self.job, self._asked = job, asked

    def send(self) -> None:
        """Send the output to where it belongs.

        Raises
        ------
        BatchError : it cannot be written there.
        """
        if self._asked.target is not None and self.job.target is not None and is_remote(self._asked.target):
            self._asked.target.parent.mkdir(parents=True, exist_ok=True)
            write_place(self._asked.target, self.job.target.read_bytes())

    def states(self) -> tuple[FileState, FileState | None]:
        """Return what both files are, there where they belong; OSError where they cannot be asked."""
        target = None
        if self._asked.target is not None and self.job.target is not None:
            target = FileState(*size_and_time(self._asked.target), digest_of(self.job.target))
        return FileState(*size_and_time(self._asked.source), digest_of(self.job.source)), target


@contextmanager
def fetched(job: Job) -> Iterator[Fetched]:
    """Fetch the files of a job that are elsewhere, an output of before too, so that no other file is replaced.

    Raises
    ------
    BatchError : one cannot be fetched.
    """
    if not is_remote(job.source) and not is_remote(job.target):
        yield Fetched(job, job)
        return
    with TemporaryDirectory() as name:
        source, target = job.source, job.target
        if is_remote(source):
            source = _fetched(source, Path(name) / "in")
        if target is not None and is_remote(target):
            target = _fetched(target, Path(name) / "out")
        yield Fetched(job, replace(job, source=source, target=target, origin=job.source))


def _fetched(path: Path, folder: Path) -> Path:
    folder.mkdir()
    here = folder / path.name
    try:
        if path.is_file():
            here.write_bytes(path.read_bytes())
    except Exception as error:
        reason = str(error).partition("\n")[0] or type(error).__name__
        raise BatchError(f"{printable_name(path)}: cannot be fetched ({reason}); check the address") from error
    return here
