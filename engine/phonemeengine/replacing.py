"""Which files that are there may be replaced: for the window, the command line, the API and batches.

A file gives way to what the same work makes of it: where that is noted in its folder, as batches do, or where the new
file is the same byte for byte. Everything else stays, unless the user gives it up.
"""

import filecmp
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from phonemeengine.errors import EngineError
from phonemeengine.files import Owns, atomic_write, is_own, reason_of


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


@contextmanager
def guarded_write(target: Path, guard: Guard) -> Iterator[BinaryIO]:
    """Open a file for bytes that is there complete once the block has ended well; its folder is made if need be.

    Raises
    ------
    EngineError : the guard's, because it cannot be written, or the guard keeps what is there.
    """
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(target) as file:
            yield file
            file.flush()
            guard.check_written(target, Path(file.name))
    except OSError as error:
        raise guard.error(f"{target}: cannot be written ({reason_of(error)}); choose another place") from error


def write_guarded(target: Path, parts: Iterable[bytes], guard: Guard) -> None:
    """Write the parts of a file; see `guarded_write`."""
    with guarded_write(target, guard) as file:
        file.writelines(parts)
