"""Time lines as SVG: what was said and what was answered, in lanes of the phonemes' colours."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from phonemeanalyser.colours import PHONEME_COLOURS
from phonemeanalyser.reports.charts import short
from phonemeanalyser.reports.markup import element, text
from phonemeanalyser.reports.report import clock
from phonemeengine.arrays import BoolArray, Float32Array, UInt8Array
from phonemeengine.calibration.scores.evaluation import Predictions
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import FRAME_PERIOD

ROW_SECONDS, MOST_ROWS = 6.0, 5
"""How much is drawn in a row, and how many rows of a recording are drawn."""
SCALE, NAMES = 160.0, 56.0
"""Pixels in a second, and room for names."""
LANE, STRIP, LOUD = 22.0, 4.0, 20.0
"""Height of a lane, of the strip that marks what is wrong in it, and of the intensity, pixels."""
PER_LETTER = 7.0
"""Width of a letter, pixels."""
BRIGHT = 0.42
"""Luminance from which a colour is written on in black."""
PALE = {Phoneme.SILENCE: 0.14, Phoneme.UNIDENTIFIED: 0.85}
"""Opacities of what is not one of the nine sounds."""


def time_lines(heard: Sequence[Predictions], names: Sequence[str]) -> str:
    """Draw one recording as each preset heard it, in rows of six seconds; what is wrong is marked in red."""
    n_frames = len(heard[0].phonemes)
    per_row = round(ROW_SECONDS / FRAME_PERIOD)
    starts = range(0, min(n_frames, MOST_ROWS * per_row), per_row)
    return "".join(_row(heard, names, first, min(n_frames, first + per_row)) for first in starts)


def drawn_seconds() -> float:
    """Return how much of a long recording is drawn."""
    return MOST_ROWS * ROW_SECONDS


def _row(heard: Sequence[Predictions], names: Sequence[str], first: int, last: int) -> str:
    frames = slice(first, last)
    labels = heard[0].labels.phonemes[frames]
    parts, y = [_name("labels", 0, LANE, "soft"), *_lane(labels, first, 0)], LANE + 4
    for k, (answers, name) in enumerate(zip(heard, names, strict=True)):
        parts += [_name(name, y, LANE, f"f{'ab'[k]}"), *_lane(answers.phonemes[frames], first, y)]
        parts += _wrong(~answers.right[frames] & (labels != Phoneme.UNIDENTIFIED), y + LANE + 1)
        y += LANE + STRIP + 4
    parts += [_name("intensity", y, LOUD, "soft"), _loudness(heard[0].intensities[frames], y)]
    y += LOUD
    parts += _ticks(first, last, y)
    return element(
        "svg", *parts, viewBox=f"0 0 {NAMES + ROW_SECONDS * SCALE + 4:g} {y + 20:g}", role="img",
        aria_label=f"{clock(first * FRAME_PERIOD)} to {clock(last * FRAME_PERIOD)}",
    )  # fmt: skip


def _name(name: str, y: float, height: float, colour: str) -> str:
    return element("text", text(name), x=NAMES - 8, y=y + height / 2 + 4, class_=f"end {colour}")


def _lane(codes: UInt8Array, first: int, y: float) -> list[str]:
    parts = []
    for start, end, code in _runs(codes):
        phoneme, x, width = Phoneme(code), _x(start), (end - start) * FRAME_PERIOD * SCALE
        span = f"{clock((first + start) * FRAME_PERIOD)} to {clock((first + end) * FRAME_PERIOD)}"
        tip = element("title", text(f"{phoneme.label}, {span}"))
        colour, pale = PHONEME_COLOURS[phoneme], PALE.get(phoneme)
        parts.append(element("rect", tip, x=x, y=y, width=width, height=LANE, fill=colour, fill_opacity=pale))
        if pale is None and width > PER_LETTER * len(phoneme.label) + 3:
            ink = "#000000" if _luminance(colour) > BRIGHT else "#ffffff"
            style = f"fill:{ink}"
            parts.append(element("text", short(phoneme), x=x + width / 2, y=y + 15, class_="mid", style=style))
    return parts


def _wrong(wrong: BoolArray, y: float) -> list[str]:
    return [
        element(
            "rect", x=_x(start), y=y, width=(end - start) * FRAME_PERIOD * SCALE, height=STRIP - 1, class_="wrong"
        )
        for start, end, is_wrong in _runs(wrong.astype(np.uint8))
        if is_wrong
    ]


def _loudness(intensities: Float32Array, y: float) -> str:
    points = [f"{_x(k + 0.5):.1f} {y + LOUD * (1 - float(value)):.1f}" for k, value in enumerate(intensities)]
    ends = f"{_x(len(points)):.1f} {y + LOUD:.1f}"
    return element("path", d=f"M{_x(0):.1f} {y + LOUD:.1f}L{'L'.join(points)}L{ends}Z", class_="loud")


def _ticks(first: int, last: int, y: float) -> list[str]:
    ticks = []
    start, end = first * FRAME_PERIOD, last * FRAME_PERIOD
    for half in range(math.ceil(2 * start - 1e-6), math.floor(2 * end + 1e-6) + 1):
        x = NAMES + (half / 2 - start) * SCALE
        ticks.append(element("line", x1=x, x2=x, y1=y, y2=y + 4, class_="grid"))
        if half % 2 == 0:
            ticks.append(element("text", f"{half // 2} s", x=x, y=y + 16, class_="mid soft"))
    return ticks


def _runs(codes: UInt8Array) -> list[tuple[int, int, int]]:
    """Return start, end and value of each run of equal values."""
    borders = [0, *(np.flatnonzero(np.diff(codes)) + 1).tolist(), len(codes)]
    return [(a, b, int(codes[a])) for a, b in pairwise(borders)]


def _x(frame: float) -> float:
    return NAMES + frame * FRAME_PERIOD * SCALE


def _luminance(colour: str) -> float:
    red, green, blue = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
