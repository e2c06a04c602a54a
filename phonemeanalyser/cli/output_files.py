"""What commands write: complete, or not at all."""

import io
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, TextIO

from phonemeengine import EngineError
from phonemeengine.files import Owns, atomic_write, is_own, reason_of


@dataclass(frozen=True)
class Guard:
    """Leaves files alone that somebody else made.

    Attributes
    ----------
    owns : says which files the format wrote itself; None where those of other programs look alike, so that only one
        with the same content is replaced.
    overwrite : whether the user gives up whatever is in the way.
    """

    owns: Owns | None
    overwrite: bool

    def check(self, target: Path | None) -> None:
        """Refuse a place where somebody else's file is, as far as that is known before anything is written.

        Raises
        ------
        EngineError : there is one.
        """
        if self.owns is not None:
            self._check(target, self.owns)

    def check_written(self, target: Path, part: Path) -> None:
        """Refuse to put what was written into `part` in the place of somebody else's file.

        Raises
        ------
        EngineError : there is one.
        """
        self._check(target, self.owns or (lambda content: content == part.read_bytes()))

    def _check(self, target: Path | None, owns: Owns) -> None:
        if target is not None and not self.overwrite and target.is_file() and not is_own(target, owns):
            raise EngineError(
                f"{target}: the file that is there may not be this program's, so it is left alone; choose another "
                "place with -o, or replace it with --overwrite"
            )


def print_whole(write: Callable[[TextIO], None]) -> None:
    """Print a table once it is complete, so that nothing is printed of a file that breaks in the middle.

    Characters that the terminal does not have become question marks.
    """
    text = io.StringIO()
    write(text)
    encoding = sys.stdout.encoding or "utf-8"
    sys.stdout.write(text.getvalue().encode(encoding, errors="replace").decode(encoding))
    sys.stdout.flush()


def write_whole(target: Path, write: Callable[[TextIO], None], guard: Guard | None = None) -> None:
    """Write a file so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written, or the guard leaves alone what is there.
    """

    def encode(file: BinaryIO) -> None:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        write(text)
        text.detach()

    write_whole_file(target, encode, guard)


def write_whole_bytes(target: Path, parts: Iterable[bytes], guard: Guard) -> None:
    """Write the parts of a file so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written, or the guard leaves alone what is there.
    """
    write_whole_file(target, lambda file: file.writelines(parts), guard)


def write_whole_file(target: Path, write: Callable[[BinaryIO], None], guard: Guard | None = None) -> None:
    """Write a file of bytes so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written, or the guard leaves alone what is there.
    """
    with whole_file(target, guard) as file:
        write(file)


@contextmanager
def whole_file(target: Path, guard: Guard | None = None) -> Iterator[BinaryIO]:
    """Open a file for bytes that is there complete once the block has ended well; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written, or the guard leaves alone what is there.
    """
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(target) as file:
            yield file
            if guard is not None:
                file.flush()
                guard.check_written(target, Path(file.name))
    except OSError as error:
        raise EngineError(
            f"{target}: cannot be written ({reason_of(error)}); choose another place with -o"
        ) from error
