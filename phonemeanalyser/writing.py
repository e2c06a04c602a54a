"""What commands write: complete, or not at all."""

import io
import os
import sys
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import BinaryIO, TextIO

from engine.errors import EngineError


def print_whole(write: Callable[[TextIO], None]) -> None:
    """Print a table once it is complete, so that nothing is printed of a file that breaks in the middle.

    Characters that the terminal does not have become question marks.
    """
    text = io.StringIO()
    write(text)
    encoding = sys.stdout.encoding or "utf-8"
    sys.stdout.write(text.getvalue().encode(encoding, errors="replace").decode(encoding))
    sys.stdout.flush()


def write_whole(target: Path, write: Callable[[TextIO], None]) -> None:
    """Write a file so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written.
    """

    def encode(file: BinaryIO) -> None:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        write(text)
        text.detach()

    write_whole_file(target, encode)


def write_whole_bytes(target: Path, parts: Iterable[bytes]) -> None:
    """Write the parts of a file so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written.
    """
    write_whole_file(target, lambda file: file.writelines(parts))


def write_whole_file(target: Path, write: Callable[[BinaryIO], None]) -> None:
    """Write a file of bytes so that it is there complete, or not at all; its folder is made if need be.

    Raises
    ------
    EngineError : it cannot be written.
    """
    name = ""
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=target.name, suffix=".part")
        with os.fdopen(handle, "wb") as file:
            write(file)
        Path(name).chmod(0o644)
        Path(name).replace(target)
    except OSError as error:
        raise EngineError(f"{target}: cannot be written ({error.strerror}); choose another place with -o") from error
    finally:
        if name:
            Path(name).unlink(missing_ok=True)
