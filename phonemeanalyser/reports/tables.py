"""Tables of the page: figures by speaker and by phoneme, and what only one preset gets right."""

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from phonemeanalyser.colours import PHONEME_COLOURS
from phonemeanalyser.reports.markup import element, text
from phonemeanalyser.reports.report import CLASSES, FIGURES, Report, clock, flicker_of, signed, written
from phonemeengine.calibration.scores.comparison import DifferingSegment, PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores
from phonemeengine.calibration.scores.scoring import SCORED_PHONEMES
from phonemeengine.phonemes import Phoneme

MOST_ROWS, MOST_MISTAKES = 12, 14
"""Rows of lists that could be long."""
EQUAL = 0.0005
"""Figures that differ by less read the same."""


@dataclass(frozen=True)
class Cell:
    """Figures of the presets in one cell, and whether more is better (1), or less (-1), or neither (0)."""

    values: Sequence[float]
    digits: int = 3
    better: int = 1

    def markup(self) -> str:
        """Return the cell; the worse one of two figures is paler."""
        if len(self.values) == 1:
            return element("td", text(written(self.values[0], self.digits)))
        best = max(value * self.better for value in self.values)
        spans = [
            element(
                "span",
                text(written(value, self.digits)),
                class_="ab"[k] + (" less" if best - value * self.better > EQUAL else ""),
            )
            for k, value in enumerate(self.values)
        ]
        return element("td", *spans)


def group_table(report: Report) -> str:
    """Return the figures of all recordings, each kind and each speaker; those of two presets one over the other."""
    presets = [preset.scores for preset in report.presets]
    bodies = [element("tbody", _group_row("all", [scores.overall for scores in presets], "sum"))]
    for parts in ([scores.by_kind for scores in presets], [scores.by_speaker for scores in presets]):
        if len(parts[0]) > 1:
            rows = [_group_row(name, [part[name] for part in parts]) for name in parts[0]]
            bodies += [element("tbody", *rows)]
    headings = ("", "Minutes", *(f.title for f in FIGURES), "Changes ÷ labels’", "Mean intensity")
    return _table(headings, *bodies)


def _group_row(name: str, groups: Sequence[GroupScores], kind: str | None = None) -> str:
    cells = [
        Cell([getattr(group.scores, f.field) for group in groups], better=-1 if f.field == "false_silence" else 1)
        for f in FIGURES
    ]
    cells.append(Cell([flicker_of(group) for group in groups], 2, -1))
    cells.append(Cell([group.intensity for group in groups], 2, 0))
    heads = element("td", text(name)), element("td", text(written(groups[0].scores.minutes, 2)))
    return element("tr", *heads, *(cell.markup() for cell in cells), class_=kind)


def phoneme_table(groups: Sequence[GroupScores]) -> str:
    """Return what becomes of each class: frames, F1, precision, recall, and what it is taken for most often."""
    rows = []
    for phoneme in SCORED_PHONEMES:
        confusions = [group.confusion for group in groups]
        n_frames = int(confusions[0][phoneme].sum())
        precision = [_share(c[phoneme, phoneme], c[:, phoneme].sum()) for c in confusions]
        recall = [_share(c[phoneme, phoneme], c[phoneme].sum()) for c in confusions]
        rows.append(
            element(
                "tr",
                element("td", dot(phoneme), text(phoneme.label)),
                element("td", text(n_frames)),
                Cell([group.f1_of(phoneme) for group in groups], 2).markup(),
                Cell(precision, 2).markup(),
                Cell(recall, 2).markup(),
                _mistakes(phoneme, groups),
            )
        )
    return _table(("", "Frames", "F1", "Precision", "Recall", "Most often taken for"), element("tbody", *rows))


def _mistakes(phoneme: Phoneme, groups: Sequence[GroupScores]) -> str:
    spans = []
    for k, group in enumerate(groups):
        row = group.confusion[phoneme].copy()
        row[phoneme] = 0
        worst, n = Phoneme(int(row.argmax())), int(group.confusion[phoneme].sum())
        words = f"{worst.label} {100 * row[worst] / n:.0f} %" if row[worst] else "–"
        spans.append(element("span", text(words), class_="ab"[k] if len(groups) > 1 else None))
    return element("td", *spans)


def mistakes_table(groups: Sequence[GroupScores]) -> str:
    """List what is taken for something else most often: how many frames, and what share of those of its class."""
    wrong = np.sum([group.confusion for group in groups], axis=0)
    wrong[np.diag_indices_from(wrong)] = wrong[Phoneme.UNIDENTIFIED] = 0
    most = np.argsort(-wrong, axis=None, kind="stable")[:MOST_MISTAKES].tolist()
    pairs = [divmod(place, len(Phoneme)) for place in most if wrong.flat[place]]
    rows = [
        element("tr", *_named(Phoneme(said)), *_named(Phoneme(answer)), *_mistaken(said, answer, groups))
        for said, answer in pairs
    ]
    headings = ["Said", "Answered", *(["A", "", "B", ""] if len(groups) > 1 else ["Frames", ""])]
    return _table(headings, element("tbody", *rows), n_words=2)


def _mistaken(said: int, answer: int, groups: Sequence[GroupScores]) -> Iterator[str]:
    for k, group in enumerate(groups):
        n, colour = group.confusion[said, answer], "ab"[k] if len(groups) > 1 else None
        yield element("td", str(n), class_=colour)
        yield element("td", text(f"{100 * _share(n, group.confusion[said].sum()):.0f} %"), class_=colour)


def _named(phoneme: Phoneme) -> Iterator[str]:
    yield element("td", dot(phoneme), text(phoneme.label), class_="words")


def gains_table(comparison: PresetComparison) -> str:
    """Return for each class how many frames both presets get right, one alone, and none."""
    rows = []
    for phoneme in CLASSES:
        counts = [
            int(part[phoneme])
            for part in (comparison.both, comparison.only_one, comparison.only_other, comparison.neither)
        ]
        classes = (None, "a", "b", "faint")
        cells = [element("td", str(n), class_=colour) for n, colour in zip(counts, classes, strict=True)]
        net = element(
            "td", text(signed(counts[1] - counts[2])), class_=("faint", "a", "b")[np.sign(counts[1] - counts[2])]
        )
        rows.append(element("tr", element("td", dot(phoneme), text(phoneme.label)), *cells, net))
    return _table(("", "Both right", "Only A", "Only B", "Neither", "A − B"), element("tbody", *rows))


def differences_table(report: Report, comparison: PresetComparison) -> str:
    """List the recordings in which the presets differ the most."""
    rows = [
        element(
            "tr",
            _place(report.name_of(d.utterance)),
            element("td", str(d.n_frames)),
            element("td", str(d.n_one), class_="a"),
            element("td", str(d.n_other), class_="b"),
        )
        for d in comparison.differences[:MOST_ROWS]
        if d.n_one or d.n_other
    ]
    return _table(("Recording", "Frames", "Only A", "Only B"), element("tbody", *rows))


def stretches_table(report: Report, stretches: Iterable[DifferingSegment], wrong: str) -> str:
    """List stretches that one preset gets right, with what the other, named by its letter, calls them."""
    rows = [
        element(
            "tr",
            element("td", text(f"{clock(s.start)}–{clock(s.end)}")),
            *_named(s.label),
            *_named(s.wrong),
            _place(report.name_of(s.utterance)),
        )
        for s in list(stretches)[:MOST_ROWS]
    ]
    headings = ("When", "Said", f"{wrong} calls it", "Recording")
    return _table(headings, element("tbody", *rows), n_words=4)


def _place(path: str) -> str:
    """Return the place of a recording, which may be broken after a folder and between the words of its name."""
    return element("td", re.sub(r"(?<=[/_ -])(?=.)", element("wbr"), text(path)), class_="path")


def dot(phoneme: Phoneme) -> str:
    """Return a dot in a phoneme's colour."""
    return element("i", class_="dot", style=f"background:{PHONEME_COLOURS[phoneme]}")


def _table(headings: Iterable[str], *bodies: str, n_words: int = 1) -> str:
    """Return a table whose first columns hold words, and the others numbers."""
    heads = [element("th", text(h), class_="words" if k < n_words else None) for k, h in enumerate(headings)]
    return element("div", element("table", element("thead", element("tr", *heads)), *bodies), class_="wide")


def _share(part: np.int64, whole: np.int64) -> float:
    return float(part / whole) if whole else math.nan
