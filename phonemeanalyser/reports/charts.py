"""Values of the page's pictures: the cells of heat maps, and what is drawn of a recording."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from phonemeanalyser.reports.report import CLASSES, confusion_shares, signed
from phonemeengine.arrays import BoolArray, Int64Array, UInt8Array
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.evaluation import Predictions
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment, segments_of
from phonemeengine.settings import FRAME_PERIOD

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


def time_rows(heard: Sequence[Predictions]) -> Iterator[TimeRow]:
    """Cut one recording, as each preset heard it, into rows as far as it is drawn."""
    n_frames, per_row = len(heard[0].phonemes), round(ROW_SECONDS / FRAME_PERIOD)
    for first in range(0, min(n_frames, MOST_ROWS * per_row), per_row):
        last = min(n_frames, first + per_row)
        yield _time_row(heard, slice(first, last))


def _time_row(heard: Sequence[Predictions], frames: slice) -> TimeRow:
    labels, intensities = heard[0].labels.phonemes[frames], heard[0].intensities[frames].tolist()
    known = labels != Phoneme.UNIDENTIFIED
    return TimeRow(
        start=frames.start * FRAME_PERIOD,
        end=frames.stop * FRAME_PERIOD,
        labels=_segments(labels),
        answers=[_segments(answers.phonemes[frames]) for answers in heard],
        mistakes=[_spans(known & ~answers.right[frames]) for answers in heard],
        intensities=[((k + 0.5) * FRAME_PERIOD, value) for k, value in enumerate(intensities)],
    )


def _segments(codes: UInt8Array) -> list[Segment]:
    blocks = [(codes, np.zeros(len(codes), np.float32))]
    return list(segments_of(blocks, len(codes) * FRAME_PERIOD))


def _spans(mask: BoolArray) -> list[list[float]]:
    borders = np.flatnonzero(np.diff(mask, prepend=False, append=False)) * FRAME_PERIOD
    spans: list[list[float]] = borders.reshape(-1, 2).tolist()
    return spans
