"""Label files as text, and those of the corpus format: CSV with start_s, end_s, phone, class and certainty.

Other tables in CSV, such as the manifest of a corpus, are read by this module too.
"""

import csv
import io
from collections.abc import Iterable, Sequence
from pathlib import Path

from phonemeengine.errors import CorpusError
from phonemeengine.labels.utterance import CORE, Label, RawLabel
from phonemeengine.storage.files import read_text_file, write_file

# Text files of labels: read whatever encoding Praat writes, and written so that a half one never shows.

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


COLUMNS = ("start_s", "end_s", "phone", "class", "certainty")


def rows_of(text: str, columns: tuple[str, ...], file: str) -> list[tuple[int, dict[str, str]]]:
    """Read a table in CSV with a header; give for each row the line where it ends, and its cells by column.

    Raises
    ------
    CorpusError : it lacks one of `columns`, or has no row, or is no CSV.
    """
    reader = csv.DictReader(io.StringIO(text, newline=""), restval="")
    try:
        header = reader.fieldnames or ()
        rows = [(reader.line_num, {str(key): str(value) for key, value in row.items()}) for row in reader]
    except csv.Error as error:
        raise CorpusError(f"{file}: it cannot be read as CSV ({error}); check the file") from error
    missing = [name for name in columns if name not in header]
    if missing:
        raise CorpusError(f"{file}: it lacks the column {missing[0]}; give it the columns {', '.join(columns)}")
    if not rows:
        raise CorpusError(f"{file}: there is no row under the header; add one")
    return rows


def table_of(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Write a table as CSV with a header."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(rows)
    return text.getvalue()


def raw_labels_of(text: str, file: str) -> tuple[RawLabel, ...]:
    """Read the text of a label file of the corpus format.

    Raises
    ------
    CorpusError : a column or a row is missing, or a row says something impossible.
    """
    return tuple(_raw_label_of(row, f"line {line}", file) for line, row in rows_of(text, COLUMNS, file))


def format_table(labels: Sequence[Label]) -> str:
    """Write labels, in order of time, in the corpus format."""
    return table_of(
        COLUMNS, ((f"{x.start:.6f}", f"{x.end:.6f}", x.phone, x.phoneme.label, x.certainty) for x in labels)
    )


def _raw_label_of(row: dict[str, str], place: str, file: str) -> RawLabel:
    try:
        start, end = float(row["start_s"]), float(row["end_s"])
    except ValueError:
        raise CorpusError(
            f"{file}, {place}: start_s and end_s must be seconds, found {row['start_s'][:20]!r} and "
            f"{row['end_s'][:20]!r}; correct the row"
        ) from None
    if not row["class"].strip():
        raise CorpusError(f"{file}, {place}: the class must be a phoneme, found nothing; fill the cell in")
    return RawLabel(start, end, row["class"].strip(), place, row["phone"], row["certainty"] or CORE)
