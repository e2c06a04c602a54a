"""Plans: what a mouth says from when to when, as a table that people read and programs take in."""

import csv
import io
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum

PLAN_COLUMNS = ("start_s", "turn_s", "end_s", "kind", "text", "sound", "letters")


class PlanKind(StrEnum):
    """What a row of a plan is."""

    SYLLABLE = "syllable"
    PAUSE = "pause"
    PHONE = "phone"


@dataclass(frozen=True)
class PlanRow:
    """A stretch of a plan.

    Attributes
    ----------
    start, end : seconds.
    turn : when the onset of a syllable ends; where there is none, the row's start.
    kind : what it is.
    text : as it is written: the character of a syllable, the mark of a pause.
    sound : a syllable's pinyin with its tone as a digit, such as ``lü4``; a phone's symbol; empty for a pause.
    letters : the two of a syllable, & of a pause; of a phone the name of its shape.
    shapes : the names of the mouth shapes: two of a syllable, else one.
    """

    start: float
    turn: float
    end: float
    kind: PlanKind
    text: str
    sound: str
    letters: str
    shapes: tuple[str, ...]


@dataclass(frozen=True)
class Plan:
    """What a mouth says.

    Attributes
    ----------
    rows : in order of time, without gaps from 0 on; at least one.
    longest_closing : the mouth comes to rest in a pause as if that lasted no longer, seconds.
    """

    rows: tuple[PlanRow, ...]
    longest_closing: float

    @property
    def duration(self) -> float:
        """When the last row ends, seconds."""
        return self.rows[-1].end


def format_plan(plan: Plan) -> str:
    """Write a plan as CSV: `PLAN_COLUMNS`, times in seconds to the millisecond."""
    return "".join(plan_lines(plan.rows))


def plan_lines(rows: Iterable[PlanRow], *, header: bool = True) -> Iterator[str]:
    """Return the lines of a plan as CSV, one by one, with the names of its columns before them; see `format_plan`."""
    if header:
        yield _line(PLAN_COLUMNS)
    for row in rows:
        times = (f"{time:.3f}" for time in (row.start, row.turn, row.end))
        yield _line((*times, row.kind, row.text, row.sound, row.letters))


def _line(values: Iterable[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(values)
    return text.getvalue()
