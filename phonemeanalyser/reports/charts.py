"""Pictures of numbers, as SVG: bars of F1, and the confusion as heat maps."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from phonemeanalyser.colours import PHONEME_COLOURS
from phonemeanalyser.reports.markup import element, text
from phonemeanalyser.reports.report import CLASSES, signed, written
from phonemeengine.arrays import Float64Array, Int64Array
from phonemeengine.calibration.scores.comparison import PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme

BAR, GAP, NAMES, LENGTH = 13, 11, 74, 380
"""Height and distance of bars, room for names, and length of a bar of 1, pixels."""
CELL, HEAD = 38, 62
"""Side of a cell of a heat map, and room for names, pixels."""
FAINTEST = 0.005
"""A share that is not worth a number."""
STRONG = 0.77
"""Opacity from which numbers are written in the opposite colour."""
MOST_DIFFERENT = 0.4
"""Difference of shares that is drawn in full colour."""


def short(phoneme: Phoneme) -> str:
    """Return a name that fits over a narrow column."""
    return "other" if phoneme is Phoneme.UNIDENTIFIED else phoneme.label


def f1_bars(groups: Sequence[GroupScores]) -> str:
    """Draw the F1 of the ten classes, a bar for each preset."""
    step = BAR * len(groups) + GAP
    height, width = step * len(SCORED_PHONEMES) + 20, NAMES + LENGTH + 40
    grid = [
        element("line", x1=_at(share), x2=_at(share), y1=0, y2=height - 18, class_="grid")
        + element("text", f"{share:g}", x=_at(share), y=height - 4, class_="mid soft")
        for share in (0, 0.25, 0.5, 0.75, 1)
    ]
    rows = [_bars_of(phoneme, groups, step * k + GAP / 2) for k, phoneme in enumerate(SCORED_PHONEMES)]
    return element("svg", *grid, *rows, viewBox=f"0 0 {width} {height}", role="img", aria_label="F1 by phoneme")


def _bars_of(phoneme: Phoneme, groups: Sequence[GroupScores], y: float) -> str:
    middle = y + BAR * len(groups) / 2
    name = element("circle", cx=8, cy=middle, r=5, fill=PHONEME_COLOURS[phoneme])
    name += element("text", short(phoneme), x=20, y=middle + 4)
    bars = []
    for k, group in enumerate(groups):
        f1, top = group.f1_of(phoneme), y + BAR * k
        share = 0.0 if math.isnan(f1) else f1
        bars.append(
            element("rect", x=NAMES, y=top, width=share * LENGTH, height=BAR - 2.0, rx=2, class_=f"f{'ab'[k]}")
        )
        bars.append(element("text", written(f1, 2), x=_at(share) + 5, y=top + BAR - 3.0))
    return element("g", name, *bars)


def _at(share: float) -> float:
    return NAMES + share * LENGTH


def heat_map(confusion: Int64Array, title: str, colour: str) -> str:
    """Draw what became of each label, in percent of its frames; `colour` is the class of a fill."""
    shares = _shares_of(confusion)
    return _map(
        shares,
        lambda row, column: f"{100 * shares[row, column]:.0f}" if shares[row, column] >= FAINTEST else "",
        lambda row, column: (colour, math.sqrt(shares[row, column])),
        lambda row, column: f"{confusion[CLASSES[row], CLASSES[column]]} frames",
        title,
    )


def difference_map(comparison: PresetComparison) -> str:
    """Draw by how many percent of each label's frames the first preset gives an answer more often than the second."""
    one, other = (_shares_of(scores.overall.confusion) for scores in (comparison.one, comparison.other))
    difference = one - other
    return _map(
        difference,
        lambda row, column: signed(100 * difference[row, column]) if abs(difference[row, column]) >= FAINTEST else "",
        lambda row, column: (
            "fa" if difference[row, column] > 0 else "fb",
            min(1.0, math.sqrt(abs(difference[row, column]) / MOST_DIFFERENT)),
        ),
        lambda row, column: f"{100 * one[row, column]:.1f} % against {100 * other[row, column]:.1f} %",
        "Differences in the confusion",
    )


def _shares_of(confusion: Int64Array) -> Float64Array:
    ordered = confusion[np.ix_(CLASSES, CLASSES)].astype(float)
    return np.asarray(ordered / np.maximum(1, ordered.sum(axis=1, keepdims=True)))


def _map(
    values: Float64Array,
    number: Callable[[int, int], str],
    paint: Callable[[int, int], tuple[str, float]],
    note: Callable[[int, int], str],
    title: str,
) -> str:
    side = CELL * len(CLASSES)
    names = [
        element("text", short(p), x=HEAD + CELL * (k + 0.5), y=14, class_="mid")
        + element("text", short(p), x=HEAD - 8, y=22 + CELL * (k + 0.5) + 4, class_="end")
        for k, p in enumerate(CLASSES)
    ]
    cells = []
    for row, column in np.ndindex(*values.shape):
        x, y = HEAD + CELL * column, 22 + CELL * row
        fill, opacity = paint(row, column)
        tip = element("title", text(f"{CLASSES[row].label} called {CLASSES[column].label}: {note(row, column)}"))
        box = {"x": x + 1, "y": y + 1, "width": CELL - 2, "height": CELL - 2, "rx": 3}
        cells.append(element("rect", tip, **box, class_=fill, fill_opacity=f"{0.04 + 0.96 * opacity:.2f}"))
        shade = "mid on" if opacity > STRONG else "mid"
        if words := number(row, column):
            cells.append(element("text", words, x=x + CELL / 2, y=y + CELL / 2 + 4, class_=shade))
    return element(
        "svg", *names, *cells, viewBox=f"0 0 {HEAD + side + 2} {side + 26}", role="img", aria_label=title
    )  # fmt: skip
