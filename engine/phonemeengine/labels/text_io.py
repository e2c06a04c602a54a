"""Text files of labels: read whatever encoding Praat writes, and written so that a half one never shows."""

from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.files import read_text_file, write_file

LARGEST = 64 << 20
"""Bytes of a label file at most: a day of labels has fewer."""


def read_text(path: Path) -> str:
    """Return the text of a file of labels; see `read_text_file`.

    Raises
    ------
    CorpusError : it cannot be read, is no text, or is too large.
    """
    return read_text_file(path, LARGEST, "a file of labels", CorpusError)


def write_text(text: str, path: Path, encoding: str = "utf-8") -> None:
    """Write a text file; the old one stays until the new one is complete and on the disk.

    Raises
    ------
    CorpusError : it cannot be written.
    """
    write_file(path, text.encode(encoding, errors="replace"), CorpusError, durable=True)
