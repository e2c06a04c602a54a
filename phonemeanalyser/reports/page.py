"""A report as a page: one file that holds all it needs, for the screen and for paper.

The templates beside this module hold its words and markup, and ask for the values that are made here.
"""

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from phonemeanalyser.colours import DARK, LIGHT, PHONEME_COLOURS
from phonemeanalyser.reports.report import (
    CLASSES,
    FIGURES,
    Report,
    clock,
    confusion_shares,
    flicker_of,
    look_ahead_of,
    short,
    signed,
    written,
)
from phonemeanalyser.reports.templates import rendered
from phonemeengine.arrays import BoolArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores, Predictions, group_scores_of
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.recognition.segments import Segment, segments_of
from phonemeengine.settings import FRAME_PERIOD

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
    counts, shares = confusion[np.ix_(CLASSES, CLASSES)].tolist(), confusion_shares(confusion).tolist()
    return [
        [
            MapCell(_unless_faint(share, f"{100 * share:.0f}"), f"{n} frames", colour, math.sqrt(share))
            for n, share in row
        ]
        for row in (zip(*rows, strict=True) for rows in zip(counts, shares, strict=True))
    ]


def difference_cells(comparison: PresetComparison) -> list[list[MapCell]]:
    """Return by how many percent of each label's frames the first preset gives an answer more often."""
    shares = (confusion_shares(scores.overall.confusion).tolist() for scores in (comparison.one, comparison.other))
    return [[_difference_cell(*pair) for pair in zip(*rows, strict=True)] for rows in zip(*shares, strict=True)]


def _difference_cell(one: float, other: float) -> MapCell:
    number = _unless_faint(one - other, signed(100 * (one - other)))
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


def page_of(report: Report) -> str:
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


def _parts(report: Report) -> Iterator[list[tuple[str, Groups]]]:
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


def _mistakes(report: Report) -> list[tuple[Phoneme, Phoneme]]:
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


def _examples(report: Report) -> Iterator[DrawnExample]:
    for k, why in _chosen(report).items():
        answers = [preset.scores.predictions[k] for preset in report.presets]
        yield DrawnExample(why, answers, [group_scores_of([predictions]) for predictions in answers])


def _chosen(report: Report) -> dict[int, str]:
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
    return f"{written(100 * share, 0)} %"


def _ink(phoneme: Phoneme) -> str:
    """Return black or white, in which one writes on a phoneme's colour."""
    red, green, blue = bytes.fromhex(PHONEME_COLOURS[phoneme][1:])
    return "#000000" if (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255 > BRIGHT else "#ffffff"


VALUES = {
    "light": LIGHT,
    "dark": DARK,
    "colours": PHONEME_COLOURS,
    "classes": CLASSES,
    "scored_phonemes": SCORED_PHONEMES,
    "figures": FIGURES,
    "headlines": [next(f for f in FIGURES if f.field == field) for field in HEADLINES],
    "row_seconds": ROW_SECONDS,
    "drawn_seconds": MOST_ROWS * ROW_SECONDS,
}
FILTERS: dict[str, Callable[..., Any]] = {
    "class_of": _class_of,
    "clock": clock,
    "confusion_cells": confusion_cells,
    "difference_cells": difference_cells,
    "model": model_in_words,
    "flicker": flicker_of,
    "ink": _ink,
    "look_ahead": look_ahead_of,
    "nan_to_num": np.nan_to_num,
    "percent": _percent,
    "short": short,
    "signed": signed,
    "split_path": re.compile(r"(?<=[/_ -])(?=.)").split,
    "time_rows": time_rows,
    "written": written,
}
"""What the templates ask for by name."""
