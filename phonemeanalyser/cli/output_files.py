"""What commands write: complete, or not at all."""

import io
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TextIO

from phonemeengine.replacing import Guard, guarded_write

STANDARD_OUTPUT = Path("-")
"""What stands for standard output wherever a file to write is named."""


def print_whole(write: Callable[[TextIO], None]) -> None:
    """Print a table once it is complete, so that nothing is printed of a file that breaks in the middle.

    Characters that the terminal does not have become question marks.
    """
    text = io.StringIO()
    write(text)
    encoding = sys.stdout.encoding or "utf-8"
    sys.stdout.write(text.getvalue().encode(encoding, errors="replace").decode(encoding))
    sys.stdout.flush()


def print_bytes(parts: Iterable[bytes]) -> None:
    """Write the parts of a file to standard output."""
    sys.stdout.flush()
    sys.stdout.buffer.writelines(parts)
    sys.stdout.buffer.flush()


def write_whole(target: Path | None, write: Callable[[TextIO], None], guard: Guard | None = None) -> None:
    """Write a text so that it is there complete, or not at all: into a file, or print it where there is none.

    Raises
    ------
    EngineError : it cannot be written, or the guard keeps what is there.
    """
    if target is None or target == STANDARD_OUTPUT:
        print_whole(write)
        return
    with guarded_write(target, guard or Guard(overwrite=True)) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        write(text)
        text.detach()


@contextmanager
def output_path(out: Path, ending: str = "") -> Iterator[Path]:
    """Give where a file is written: `out`, or for standard output a file that is printed once the block has ended.

    Parameters
    ----------
    ending : of the file, where its name says what is written.
    """
    if out != STANDARD_OUTPUT:
        yield out
        return
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"out{ending}"
        yield path
        with path.open("rb") as file:
            print_bytes(iter(lambda: file.read(1 << 20), b""))
