"""Files that are written whole or not at all, which of those that are there they may replace, and locks on files.

A file gives way to what the same work makes of it: where that is noted in its folder, as batches do, or where the new
file is the same byte for byte. Everything else stays, unless the user gives it up.
"""

import filecmp
import io
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, BinaryIO, TextIO

from phonemeengine.errors import EngineError
from phonemeengine.storage.files import Owns, atomic_write, is_own, reason_of

STANDARD_OUTPUT = Path("-")
"""What stands for standard output wherever a file to write is named."""


def nothing_is_own(_content: bytes) -> bool:
    """Take no file for one's own: for work that gives something else each time, or takes long, see `Guard.owns`."""
    return False


@dataclass(frozen=True)
class Guard:
    """Keeps files that other work made.

    Attributes
    ----------
    owns : says which files the format wrote itself, so that others are refused before anything is computed; None
        where those of other programs look alike.
    overwrite : whether whatever is there is replaced.
    earlier : whether the same work made the file that is there, as a batch noted it; None where nothing is noted.
    error : what is raised.
    """

    owns: Owns | None = None
    overwrite: bool = False
    earlier: bool | None = None
    error: type[EngineError] = EngineError

    def check(self, target: Path | None) -> None:
        """Refuse a place whose file stays, as far as that is known before anything is written.

        Raises
        ------
        EngineError : `error`, because there is one.
        """
        if target is None or not self._keeps(target):
            return
        if self.earlier is False or (self.owns is not None and not is_own(target, self.owns)):
            raise self._refusal(target)

    def check_written(self, target: Path, part: Path) -> None:
        """Refuse to put what was written into `part` in the place of another file.

        Raises
        ------
        EngineError : `error`, because there is one.
        """
        if self._keeps(target) and not filecmp.cmp(target, part, shallow=False):
            raise self._refusal(target)

    def _keeps(self, target: Path) -> bool:
        return not self.overwrite and not self.earlier and target.is_file()

    def _refusal(self, target: Path) -> EngineError:
        return self.error(
            f"{target}: the file that is there was made in another way, so it is left alone; choose another place, "
            "or replace it with --overwrite"
        )


REPLACING = Guard(overwrite=True)
"""Keeps nothing."""


@contextmanager
def guarded_write(target: Path | None, guard: Guard, *, is_text: bool = True) -> Iterator[BinaryIO]:
    """Open a file for bytes that is there complete once the block has ended well; its folder is made if need be.

    Parameters
    ----------
    target : the file; None and `STANDARD_OUTPUT` print what is written, once the block has ended well.
    is_text : whether that is text in UTF-8: characters that the terminal does not have become question marks.

    Raises
    ------
    EngineError : the guard's, because it cannot be written, or the guard keeps what is there.
    """
    if target is None or target == STANDARD_OUTPUT:
        content = io.BytesIO()
        yield content
        _print(content.getvalue(), is_text=is_text)
        return
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(target) as file:
            yield file
            file.flush()
            guard.check_written(target, Path(file.name))
    except OSError as error:
        raise guard.error(f"{target}: cannot be written ({reason_of(error)}); choose another place") from error


@contextmanager
def guarded_text(target: Path | None, guard: Guard = REPLACING) -> Iterator[TextIO]:
    """Open a file for text in UTF-8; see `guarded_write`."""
    with guarded_write(target, guard) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", errors="surrogateescape", newline="")
        yield text
        text.detach()


def write_guarded(target: Path | None, parts: Iterable[bytes], guard: Guard, *, is_text: bool = True) -> None:
    """Write the parts of a file; see `guarded_write`."""
    with guarded_write(target, guard, is_text=is_text) as file:
        file.writelines(parts)


@contextmanager
def output_path(target: Path | None, ending: str = "") -> Iterator[Path]:
    """Give where bytes are written: the target, or a file that is printed once the block has ended well.

    Parameters
    ----------
    ending : of the file, where its name says what is written.
    """
    if target is not None and target != STANDARD_OUTPUT:
        yield target
        return
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"out{ending}"
        yield path
        _print(path.read_bytes(), is_text=False)


def _print(content: bytes, *, is_text: bool) -> None:
    if sys.stdout is None:  # it was closed before the program began
        raise EngineError("standard output is closed; name a file with -o")
    try:
        if is_text:
            encoding = sys.stdout.encoding or "utf-8"
            text = content.decode(errors="surrogateescape")
            sys.stdout.write(text.encode(encoding, errors="replace").decode(encoding))
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(content)
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        words = f"standard output cannot be written ({reason_of(error)}); free some space, or name a file with -o"
        raise EngineError(words) from error


def lock_at(path: Path) -> Any:
    """Return a lock on a file of its own, not yet acquired.

    ``acquire(blocking=False)`` raises TimeoutError while another holds it, another OSError where it cannot be made,
    and NotImplementedError where the disk knows no locks.
    """
    from filelock import FileLock  # noqa: PLC0415 - takes 40 ms, which only who needs a lock should wait for

    return FileLock(path, thread_local=False)
