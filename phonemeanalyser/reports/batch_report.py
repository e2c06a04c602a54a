"""What was wrong in a batch: a table and a page in the folder of its outputs."""

import csv
import io
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.reports.report import clock, counted
from phonemeanalyser.reports.templates import rendered
from phonemeengine.batch.remote import is_remote, write_place
from phonemeengine.batch.work import JobState, Outcome
from phonemeengine.errors import BatchError
from phonemeengine.storage.files import printable, write_file

TABLE, PAGE = "phonemeanalyser-report.csv", "phonemeanalyser-report.html"
"""The names of the files."""
COLUMNS = ("file", "duration_s", "language", "score", "state", "what was wrong")


@dataclass(frozen=True)
class ReportedFile:
    """A file with which something was wrong.

    Attributes
    ----------
    path : of the sound.
    duration : seconds; 0 where it cannot be read.
    language : of what is said in it; empty where unknown.
    score : how well it says its script, 0 is best; None where unknown.
    is_failed : whether nothing was made of it.
    words : what was wrong.
    """

    path: str
    duration: float
    language: str
    score: float | None
    is_failed: bool
    words: str


def write_batch_report(outcomes: Sequence[Outcome], folder: Path) -> None:
    """Write what was wrong in a batch, those that failed first; nothing, and no older report, where nothing was.

    Raises
    ------
    BatchError : it cannot be written.
    """
    rows = sorted(_rows_of(outcomes), key=lambda row: not row.is_failed)
    if not rows:
        for name in (TABLE, PAGE):
            with suppress(OSError):
                (folder / name).unlink(missing_ok=True)
        return
    page = rendered(
        "batch.html.j2",
        {"light": LIGHT, "dark": DARK},
        {"clock": clock},
        rows=rows,
        folder=folder.name,
        words=_summary_of(outcomes),
    )
    for name, text in ((TABLE, _table_of(rows)), (PAGE, page)):
        if is_remote(folder):
            write_place(folder / name, text.encode())
        else:
            write_file(folder / name, text.encode(), BatchError)


def _rows_of(outcomes: Sequence[Outcome]) -> Iterator[ReportedFile]:
    for outcome in outcomes:
        words = "; ".join([*([outcome.words] if outcome.words else []), *(note for _, note in outcome.notes)])
        if words:
            made, path = outcome.made, printable(str(outcome.job.source))
            is_failed = outcome.state is JobState.FAILED
            yield ReportedFile(path, made.duration, made.language, made.score, is_failed, printable(words))


def _table_of(rows: Sequence[ReportedFile]) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(COLUMNS)
    for row in rows:
        duration = f"{row.duration:.3f}" if row.duration else ""
        score = "" if row.score is None else f"{row.score:.3f}"
        state = "failed" if row.is_failed else "note"
        table.writerow([row.path, duration, row.language, score, state, row.words])
    return text.getvalue()


def _summary_of(outcomes: Sequence[Outcome]) -> str:
    states = [outcome.state for outcome in outcomes]
    found = [f"{states.count(state)} {state.value}" for state in JobState if state in states]
    return f"{counted(len(outcomes), 'file')}: {', '.join(found)}"
