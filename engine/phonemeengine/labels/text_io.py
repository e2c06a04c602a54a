"""Text files of labels: read whatever encoding Praat writes, and written so that a half one never shows."""

import codecs
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.files import printable_name, read_file, write_file

LARGEST = 64 << 20
"""Bytes of a label file at most: a day of labels has fewer."""

_BYTE_ORDER_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
WITHIN = 4
"""Bytes in which text in UTF-16 that begins without a byte order mark shows its zeros."""


def read_text(path: Path) -> str:
    """Return the text of a file in UTF-8 or UTF-16, with or without a byte order mark; line ends become ``\\n``.

    Raises
    ------
    CorpusError : it cannot be read, is no text, or is too large.
    """
    content = read_file(path, LARGEST, "a file of labels", CorpusError)
    try:
        text = content.decode(_encoding_of(content))
    except UnicodeDecodeError as error:
        raise CorpusError(
            f"{printable_name(path)}: this is no text in UTF-8 or UTF-16; save it as a text file in one of them"
        ) from error
    return text.replace("\r\n", "\n").replace("\r", "\n")


def write_text(text: str, path: Path, encoding: str = "utf-8") -> None:
    """Write a text file; the old one stays until the new one is complete and on the disk.

    Raises
    ------
    CorpusError : it cannot be written.
    """
    write_file(path, text.encode(encoding, errors="replace"), CorpusError, durable=True)


def _encoding_of(content: bytes) -> str:
    for mark, encoding in _BYTE_ORDER_MARKS:
        if content.startswith(mark):
            return encoding
    first = content[:WITHIN]
    if len(first) == WITHIN and first[1::2] == b"\0\0" and first[::2].strip(b"\0"):
        return "utf-16-le"
    if len(first) == WITHIN and first[::2] == b"\0\0" and first[1::2].strip(b"\0"):
        return "utf-16-be"
    return "utf-8"
