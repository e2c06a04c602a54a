"""Reports as pages, of presets and of batches: one file that holds all it needs, for the screen and for paper.

The templates beside this module hold their words and markup, and ask for the values that are made here.
"""

import csv
import io
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from phonemeanalyser.colours import DARK, LIGHT, PHONEME_COLOURS
from phonemeanalyser.reports import report
from phonemeengine.arrays import BoolArray, Int64Array, UInt8Array
from phonemeengine.batch.remote import is_remote, write_place
from phonemeengine.batch.work import JobState, Outcome
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores, Predictions, group_scores_of
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.errors import BatchError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.recognition.segments import Segment, segments_of
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import printable, write_file


def rendered(template: str, values: Mapping[str, Any], filters: Mapping[str, Callable[..., Any]], **more: Any) -> str:
    """Write a page as HTML in ASCII that is well-formed XML too, and asks the network for nothing.

    Parameters
    ----------
    template : the name of its file.
    values, more : what it asks for by name, `values` within its macros too.
    filters : its functions.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined  # noqa: PLC0415 - takes 45 ms, for pages alone

    environment = Environment(
        loader=PackageLoader("phonemeanalyser.reports", ""),
        autoescape=True,
        finalize=_shown,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.globals |= values
    environment.filters |= filters
    page = environment.get_template(template).render(**more)
    return page.encode("ascii", errors="xmlcharrefreplace").decode("ascii")


def _shown(value: Any) -> Any:
    """Return what the page shows of a value: lengths to a tenth, and names without what cannot be printed."""
    if isinstance(value, float):
        return f"{value:.1f}".removesuffix(".0")
    return printable(value) if type(value) is str else value


# Values of the page's pictures: the cells of heat maps, and what is drawn of a recording.

FAINTEST = 0.005
"""A share that is not worth a number."""
MOST_DIFFERENT = 0.4
"""Difference of shares that is drawn in full colour."""
ROW_SECONDS, MOST_ROWS = 6, 5
"""How much is drawn in a row, and how many rows of a recording are drawn."""


@dataclass(frozen=True)
class MapCell:
    """A cell of a heat map: its number, a note, the letter of the preset in whose colour it is, how strong, 0..1."""

    number: str
    note: str
    colour: str
    strength: float


def confusion_cells(confusion: Int64Array, colour: str) -> list[list[MapCell]]:
    """Return what became of each label, in percent of its frames, in the colour of a preset's letter."""
    counts, shares = (
        confusion[np.ix_(report.CLASSES, report.CLASSES)].tolist(),
        report.confusion_shares(confusion).tolist(),
    )
    return [
        [
            MapCell(_unless_faint(share, f"{100 * share:.0f}"), f"{n} frames", colour, math.sqrt(share))
            for n, share in row
        ]
        for row in (zip(*rows, strict=True) for rows in zip(counts, shares, strict=True))
    ]


def difference_cells(comparison: PresetComparison) -> list[list[MapCell]]:
    """Return by how many percent of each label's frames the first preset gives an answer more often."""
    shares = (
        report.confusion_shares(scores.overall.confusion).tolist() for scores in (comparison.one, comparison.other)
    )
    return [[_difference_cell(*pair) for pair in zip(*rows, strict=True)] for rows in zip(*shares, strict=True)]


def _difference_cell(one: float, other: float) -> MapCell:
    number = _unless_faint(one - other, report.signed(100 * (one - other)))
    note = f"{100 * one:.1f} % against {100 * other:.1f} %"
    return MapCell(number, note, "a" if one > other else "b", min(1, math.sqrt(abs(one - other) / MOST_DIFFERENT)))


def _unless_faint(share: float, number: str) -> str:
    return number if abs(share) >= FAINTEST else ""


@dataclass(frozen=True)
class TimeRow:
    """A few seconds of a recording; all but its own start and end are seconds from its start.

    Attributes
    ----------
    start, end : seconds of the recording.
    labels : what was said.
    answers : what each preset answered.
    mistakes : for each preset, where it begins and ceases to be wrong.
    intensities : times and intensities of the frames.
    """

    start: float
    end: float
    labels: list[Segment]
    answers: list[list[Segment]]
    mistakes: list[list[list[float]]]
    intensities: list[tuple[float, float]]


def time_rows(answers: Sequence[Predictions]) -> Iterator[TimeRow]:
    """Cut one recording, as each preset recognised it, into rows as far as it is drawn."""
    n_frames, per_row = len(answers[0].phonemes), round(ROW_SECONDS / FRAME_PERIOD)
    for first in range(0, min(n_frames, MOST_ROWS * per_row), per_row):
        last = min(n_frames, first + per_row)
        yield _time_row(answers, slice(first, last))


def _time_row(answers: Sequence[Predictions], frames: slice) -> TimeRow:
    labels, intensities = answers[0].labels.phonemes[frames], answers[0].intensities[frames].tolist()
    known = labels != Phoneme.UNIDENTIFIED
    return TimeRow(
        start=frames.start * FRAME_PERIOD,
        end=frames.stop * FRAME_PERIOD,
        labels=_segments(labels),
        answers=[_segments(own.phonemes[frames]) for own in answers],
        mistakes=[_spans(known & ~own.right[frames]) for own in answers],
        intensities=[((k + 0.5) * FRAME_PERIOD, value) for k, value in enumerate(intensities)],
    )


def _segments(codes: UInt8Array) -> list[Segment]:
    blocks = [(codes, np.zeros(len(codes), np.float32))]
    return list(segments_of(blocks, len(codes) * FRAME_PERIOD))


def _spans(mask: BoolArray) -> list[list[float]]:
    borders = np.flatnonzero(np.diff(mask, prepend=False, append=False)) * FRAME_PERIOD
    spans: list[list[float]] = borders.reshape(-1, 2).tolist()
    return spans


SPOKEN_FRAMES = 50
"""Frames of the nine sounds that a recording should have to be drawn as an example."""
HEADLINES = ("macro_f1", "viseme_accuracy", "vowel_accuracy", "silence_recall", "false_silence")
"""The figures that the page begins with; the changes follow."""
MOST_MISTAKES = 14
"""Rows of a list that could be long."""
BRIGHT = 0.42
"""Luminance from which a colour is written on in black."""

NINE = tuple(p for p in SCORED_PHONEMES if p is not Phoneme.SILENCE)

Groups = list[GroupScores]


def page_of(report: report.Report) -> str:
    """Write a report as HTML in ASCII that is well-formed XML too, and asks the network for nothing."""
    return rendered(
        "report.html.j2",
        VALUES,
        FILTERS,
        report=report,
        parts=_parts(report),
        mistakes=_mistakes(report),
        examples=_examples(report),
    )


def _parts(report: report.Report) -> Iterator[list[tuple[str, Groups]]]:
    """Return the names and scores of all recordings, of each kind and of each speaker."""
    presets = [preset.scores for preset in report.presets]
    yield [("all", [scores.overall for scores in presets])]
    for parts in ([scores.by_kind for scores in presets], [scores.by_speaker for scores in presets]):
        if len(parts[0]) > 1:
            yield [(name, [part[name] for part in parts]) for name in parts[0]]


@dataclass(frozen=True)
class ClassFigures:
    """What becomes of a class: its frames, figures 0..1, and what it is taken for most often."""

    n_frames: int
    f1: float
    precision: float
    recall: float
    taken_for: str


def _class_of(group: GroupScores, phoneme: Phoneme) -> ClassFigures:
    said, answered = group.confusion[phoneme], group.confusion[:, phoneme].sum()
    hits, n_frames = said[phoneme], int(said.sum())
    wrong = np.where(np.arange(len(said)) == phoneme, 0, said)
    worst = Phoneme(int(wrong.argmax()))
    return ClassFigures(
        n_frames=n_frames,
        f1=group.f1_of(phoneme),
        precision=hits / answered if answered else math.nan,
        recall=hits / n_frames if n_frames else math.nan,
        taken_for=f"{worst.label} {_percent(wrong[worst] / n_frames)}" if wrong[worst] else "–",
    )


def _mistakes(report: report.Report) -> list[tuple[Phoneme, Phoneme]]:
    """Return what was said and answered in the most frequent mistakes."""
    wrong = np.sum([preset.scores.overall.confusion for preset in report.presets], axis=0)
    wrong[np.diag_indices_from(wrong)] = wrong[Phoneme.UNIDENTIFIED] = 0
    most = np.argsort(-wrong, axis=None, kind="stable")[:MOST_MISTAKES].tolist()
    pairs = (divmod(place, len(Phoneme)) for place in most if wrong.flat[place])
    return [(Phoneme(said), Phoneme(answer)) for said, answer in pairs]


@dataclass(frozen=True)
class DrawnExample:
    """A recording that is drawn: why, what each preset answered in it, and how right that is."""

    why: str
    answers: Sequence[Predictions]
    groups: Groups

    @property
    def seconds(self) -> float:
        """How long the recording is."""
        return len(self.answers[0].phonemes) * FRAME_PERIOD


def _examples(report: report.Report) -> Iterator[DrawnExample]:
    for k, why in _chosen(report).items():
        answers = [preset.scores.predictions[k] for preset in report.presets]
        yield DrawnExample(why, answers, [group_scores_of([predictions]) for predictions in answers])


def _chosen(report: report.Report) -> dict[int, str]:
    """Choose the recordings that are drawn, each once: the first that is asked for names it."""
    answers = {k: a for k, a in enumerate(report.first.predictions) if len(a.phonemes)}
    rights = {k: group_scores_of([a]).scores.accuracy for k, a in answers.items()}
    spoken = {k: np.isin(a.labels.phonemes, NINE).sum() for k, a in answers.items()}
    enough = min(SPOKEN_FRAMES, max(spoken.values()))
    fit = [k for k, right in rights.items() if spoken[k] >= enough and not math.isnan(right)]
    ranked = sorted(fit, key=lambda k: -rights[k])
    found: dict[int, str] = {}
    if ranked:
        by = " by A" if report.comparison else ""
        for name, k in (("Best", 0), ("Median", len(ranked) // 2), ("Worst", -1)):
            found.setdefault(ranked[k], f"{name} recognised{by}")
    if report.comparison is not None:
        places = {a.utterance.path: k for k, a in answers.items()}
        differing = [d for d in report.comparison.differences if d.utterance.path in places]
        ahead = sorted(differing, key=lambda d: d.n_other - d.n_one)
        for letter, d in (("A", ahead[0]), ("B", ahead[-1])):
            found.setdefault(places[d.utterance.path], f"{letter} the furthest ahead")
    return found


def _percent(share: float) -> str:
    return f"{report.written(100 * share, 0)} %"


def _ink(phoneme: Phoneme) -> str:
    """Return black or white, in which one writes on a phoneme's colour."""
    red, green, blue = bytes.fromhex(PHONEME_COLOURS[phoneme][1:])
    return "#000000" if (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255 > BRIGHT else "#ffffff"


VALUES = {
    "light": LIGHT,
    "dark": DARK,
    "colours": PHONEME_COLOURS,
    "classes": report.CLASSES,
    "scored_phonemes": SCORED_PHONEMES,
    "figures": report.FIGURES,
    "headlines": [next(f for f in report.FIGURES if f.field == field) for field in HEADLINES],
    "row_seconds": ROW_SECONDS,
    "drawn_seconds": MOST_ROWS * ROW_SECONDS,
}
FILTERS: dict[str, Callable[..., Any]] = {
    "class_of": _class_of,
    "clock": report.clock,
    "confusion_cells": confusion_cells,
    "difference_cells": difference_cells,
    "model": model_in_words,
    "flicker": report.flicker_of,
    "ink": _ink,
    "look_ahead": report.look_ahead_of,
    "nan_to_num": np.nan_to_num,
    "percent": _percent,
    "short": report.short,
    "signed": report.signed,
    "split_path": re.compile(r"(?<=[/_ -])(?=.)").split,
    "time_rows": time_rows,
    "written": report.written,
}
"""What the templates ask for by name."""


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
        {"clock": report.clock},
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
    return f"{report.counted(len(outcomes), 'file')}: {', '.join(found)}"
