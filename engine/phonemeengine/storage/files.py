"""Files on the disk: written whole or not at all, how they are spoken of, free names, and which are our own.

A file that is there already is replaced only by one of the same kind that this program wrote. Each format says what
its own files look like; where those of other programs look alike, none counts as ours.
"""

import codecs
import io
import os
import re
import stat
import tokenize
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from phonemeengine.errors import EngineError

# The text of Word documents (.docx): of their paragraphs and tables, without notes, headers and what was deleted.

BODY = "word/document.xml"
_MARKS = {"tab": "\t", "br": "\n", "cr": "\n", "noBreakHyphen": "-"}
"""Characters that a document has as elements."""
_WITHOUT_TEXT = {"pPr", "rPr", "Fallback"}
"""Elements in a paragraph of which nothing is read: properties, and what stands for a text box in old programs."""


def text_of(content: bytes, largest: int) -> str:
    """Return the text of a document: a line for each paragraph, and for each row of a table, with tabs between.

    Parameters
    ----------
    content : of the file.
    largest : bytes that its body may have.

    Raises
    ------
    ValueError : it is no such document, is damaged or too large.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            body = archive.getinfo(BODY)
            if body.file_size > largest:
                raise ValueError(f"a body of {body.file_size} bytes")
            root = ElementTree.fromstring(archive.read(body))  # noqa: S314 - expat limits what grows by itself
    except (
        zipfile.BadZipFile,
        zlib.error,
        KeyError,
        EOFError,
        NotImplementedError,
        RuntimeError,
        SyntaxError,
    ) as error:
        raise ValueError("no Word document") from error
    return "".join(f"{line}\n" for line in _lines_of(root))


def _lines_of(element: ElementTree.Element) -> Iterator[str]:
    kind = _kind_of(element)
    if kind == "p":
        yield "".join(_MARKS.get(_kind_of(part), part.text or "") for part in _parts_of(element))
    elif kind == "tr":
        yield "\t".join(" ".join(_lines_of(cell)).strip() for cell in element if _kind_of(cell) == "tc")
    else:
        for child in element:
            yield from _lines_of(child)


def _parts_of(element: ElementTree.Element) -> Iterator[ElementTree.Element]:
    """Return what holds the characters of a paragraph."""
    for child in element:
        kind = _kind_of(child)
        if kind == "t" or kind in _MARKS:
            yield child
        elif kind not in _WITHOUT_TEXT:
            yield from _parts_of(child)


def _kind_of(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]


Owns = Callable[[bytes], bool]
"""Says of the content of a file whether a format of this program wrote it; when in doubt, it did not."""

MEGABYTE = 1 << 20
LARGEST = 1 << 30
"""Bytes of a file that are looked at."""

LONGEST_NAME = 255
"""Bytes of a name."""
_UNPORTABLE = re.compile(r'[<>:"/\\|?*]')
_DEVICES = {"CON", "PRN", "AUX", "NUL", *(f"{port}{k}" for port in ("COM", "LPT") for k in range(1, 10))}

_BYTE_ORDER_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),  # begins as that of UTF-16 does
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_FIRST = 4
"""Bytes in which text in UTF-16 that begins without a byte order mark shows its zeros."""
_BINARY = re.compile(rb"[\x00-\x08\x0b\x0e-\x1f\x7f]")
"""Bytes that no text in a code page has."""
_ZIP = b"PK\x03\x04"

JSON_TEXT = rb'"(?:[^"\\]|\\.)*"'
"""A text in JSON, as a regular expression."""


@contextmanager
def atomic_write(path: Path, *, durable: bool = False) -> Iterator[BinaryIO]:
    """Open a file, buffered and for writing bytes, that takes the place of `path` once the block has ended well.

    Until then, and if anything fails, what was at `path` stays as it is. A link is replaced, not followed. A device
    or a pipe (``/dev/stdout``) is written straight into.

    Parameters
    ----------
    durable : wait until the disk has the content before the old file goes, so that a power cut costs neither.

    Raises
    ------
    OSError, ValueError : it cannot be written; nothing is left behind.
    """
    if is_device(path):
        with path.open("wb") as file:
            yield file
        return
    part = path.with_name(f"{path.name}.{os.urandom(4).hex()}.part")
    try:
        with part.open("x+b") as file:
            yield file
            file.flush()
            if durable:
                os.fsync(file.fileno())
        part.replace(path)
    except BaseException:
        with suppress(OSError, ValueError):
            part.unlink(missing_ok=True)
        raise


def is_device(path: Path) -> bool:
    """Return whether a device, a pipe or a socket is at `path`, which no file may replace."""
    try:
        mode = path.stat().st_mode
    except (OSError, ValueError):
        return False
    if stat.S_ISREG(mode):  # as ``/dev/stdout`` is, where it goes into a file
        return path.is_symlink() and path.absolute().parts[:2] in {("/", "dev"), ("/", "proc")}
    return not stat.S_ISDIR(mode)


def is_folder(path: Path) -> bool:
    """Return whether a path is a folder; an inaccessible path is none, and opening it gives the reason."""
    try:
        return path.is_dir()
    except OSError:  # a name too long, or a folder that may not be entered
        return False


def write_file(path: Path, content: bytes, error: type[EngineError], *, durable: bool = False) -> None:
    """Write a file whole or not at all, see `atomic_write`.

    Raises
    ------
    EngineError : `error`, because it cannot be written.
    """
    try:
        with atomic_write(path, durable=durable) as file:
            file.write(content)
    except (OSError, ValueError) as cause:
        name = printable_name(path)
        raise error(f"{name}: cannot be written ({reason_of(cause)}); choose another folder") from cause


def read_file(path: Path, largest: int, what: str, error: type[EngineError]) -> bytes:
    """Return the content of a file.

    Parameters
    ----------
    largest : bytes that it may have.
    what : what such a file is called in a sentence, such as ``a preset``.

    Raises
    ------
    EngineError : `error`, because it cannot be read, or is too large.
    """
    name = printable_name(path)
    try:
        size = path.stat().st_size
        content = path.read_bytes() if size <= largest else b""
    except (OSError, ValueError) as cause:
        raise error(f"{name}: {why_unreadable(path, cause)}") from cause
    if size > largest:
        tenths = -(-10 * size // MEGABYTE)  # upwards: no file has just the limit
        raise error(f"{name}: {what} has at most {largest >> 20} MB, this has {tenths / 10} MB; choose another")
    return content


def why_unreadable(path: Path, cause: OSError | ValueError) -> str:
    """Return the end of a sentence that says why a file cannot be read, and what to do; it begins with its name."""
    if is_folder(path):
        return "this is a folder; choose a file in it"
    if isinstance(cause, FileNotFoundError):
        return "there is no such file; check its name and folder"
    if isinstance(cause, PermissionError):
        return "reading it is not permitted; change its permissions or copy it"
    return f"it cannot be read ({reason_of(cause)}); check the file"


def read_text_file(path: Path, largest: int, what: str, error: type[EngineError]) -> str:
    """Return the text of a file; line ends become ``\\n``. See `read_file`.

    It is in UTF-8, in UTF-16 or UTF-32 (with a byte order mark, or where its first bytes show it), else in the code
    page of Western Windows (cp1252). Of a Word document (.docx) it is the text, a row of a table as a line with tabs.
    """
    content = read_file(path, largest, what, error)
    try:
        text = text_of(content, largest) if content.startswith(_ZIP) else _decoded(content)
    except ValueError as cause:
        raise error(f"{printable_name(path)}: this is no text file; choose {what}") from cause
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _decoded(content: bytes) -> str:
    """Return text in the encoding that its first bytes show; UnicodeError where it is none."""
    for mark, encoding in _BYTE_ORDER_MARKS:
        if content.startswith(mark):
            return content.decode(encoding)
    first = content[:_FIRST]
    if len(first) == _FIRST and first[1::2] == b"\0\0" and first[::2].strip(b"\0"):
        return content.decode("utf-16-le")
    if len(first) == _FIRST and first[::2] == b"\0\0" and first[1::2].strip(b"\0"):
        return content.decode("utf-16-be")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        if _BINARY.search(content):  # nearly any bytes are characters of cp1252
            raise
        return content.decode("cp1252")


def begins_like(pattern: bytes) -> Owns:
    """Return what takes files for ours that begin as a regular expression says."""
    form = re.compile(pattern)
    return lambda content: form.match(content) is not None


def is_own(path: Path, owns: Owns) -> bool:
    """Return whether there is a file at `path` that a format wrote; one that cannot be read is not."""
    try:
        with path.open("rb") as file:
            return owns(file.read(LARGEST))
    except OSError:
        return False


def printable(words: str) -> str:
    """Return words without characters that would break the line they stand in."""
    return "".join(c if c.isprintable() else "?" for c in words)


def printable_name(path: Path) -> str:
    """Return the file's name, without characters that would break the sentence it stands in."""
    return printable(path.name or str(path))


def is_portable(name: str) -> bool:
    """Return whether all systems can write a file of this name: Windows knows fewer names than others."""
    if _UNPORTABLE.search(name) or name.partition(".")[0].upper() in _DEVICES or name[-1:] in {" ", "."}:
        return False
    return name.isprintable() and len(name.encode(errors="replace")) <= LONGEST_NAME


def portable_name(name: str) -> str:
    """Return a name with which all systems can write a file: as it is, or with hyphens for what they refuse."""
    made = "".join(c if c.isprintable() else "-" for c in _UNPORTABLE.sub("-", name)).strip(" .-")[:80]
    return made if made and is_portable(made) else f"curve {made}".strip()


def reason_of(error: OSError | ValueError) -> str:
    """Return the system's own words for an error."""
    return (error.strerror if isinstance(error, OSError) else None) or str(error)


def free_path(path: Path) -> Path:
    """Return the path itself, or if there is such a file, one with a number behind its name."""
    number, free = 1, path
    while os.path.lexists(free):
        number += 1
        free = path.with_name(f"{path.stem} ({number}){path.suffix}")
    return free


MOST_ARRAYS = 1024
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""The ways in which NumPy compresses, which unpack no more than an archive says there is."""
_DAMAGE = (zipfile.BadZipFile, zlib.error, tokenize.TokenError, EOFError, MemoryError, OSError, RuntimeError)


def read_npz(path: Path, largest: int) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive as `arrays_in_npz` does; OSError where the file cannot be read."""
    return arrays_in_npz(path.read_bytes(), largest)


def arrays_in_npz(archived: bytes, largest: int) -> dict[str, NDArray[Any]]:
    """Read all arrays of an archive that `numpy.savez` wrote, never anything that is executed.

    Parameters
    ----------
    largest : bytes that all arrays may have together.

    Raises
    ------
    ValueError : the archive is damaged or too large, or holds what is no array.
    """
    content = io.BytesIO(archived)
    try:
        with zipfile.ZipFile(content) as archive:
            entries = archive.infolist()
        if sum(entry.file_size for entry in entries) > largest or len(entries) > MOST_ARRAYS:
            raise ValueError(f"the arrays have more than {largest} bytes")
        if any(entry.compress_type not in PACKED for entry in entries):
            raise ValueError("the archive is compressed in a way that NumPy does not use")
        with np.load(content, allow_pickle=False) as file:
            arrays = dict(file)
    except _DAMAGE as error:
        raise ValueError("the archive is damaged") from error
    if not all(isinstance(array, np.ndarray) for array in arrays.values()):
        raise ValueError("there is a file in the archive that is no array")
    return arrays
