"""A report as text: the table of the corpus scorer, the confusion in percent, and what only one preset gets right."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, fields

from phonemeanalyser.reports.report import (
    CLASSES,
    Report,
    ScoredPreset,
    clock,
    confusion_shares,
    look_ahead_of,
    short,
    written,
)
from phonemeengine.calibration.scores.comparison import DifferingSegment, PresetComparison
from phonemeengine.calibration.scores.evaluation import CorpusScores, GroupScores
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.files import printable
from phonemeengine.presets.ears import ear_in_words

MOST_SHOWN = 10
"""Recordings and stretches that are listed of each preset."""
COARSE = {"changes_per_s", "label_changes_per_s", "minutes"}
"""Figures that are written with two digits."""
FIRST, COLUMN, CELL = 22, 15, 6
"""Widths, characters."""


def text_of(report: Report, by: str) -> str:
    """Write a report for the terminal; `by` is ``corpus`` or ``speaker``."""
    lines = [f"{report.name}: {report.conditions}"]
    for preset in report.presets:
        lines += ["", *_preset_lines(preset, by)]
    if report.comparison is not None:
        lines += ["", *_comparison_lines(report, report.comparison)]
    return "\n".join(lines) + "\n"


def _preset_lines(preset: ScoredPreset, by: str) -> Iterator[str]:
    scores = preset.scores
    yield f"{preset.title} (heard with: {ear_in_words(scores.preset)}; look-ahead {look_ahead_of(scores)})"
    yield f"lag {1000 * scores.delay:g} ms".ljust(FIRST) + "".join(f.name[:13].rjust(COLUMN) for f in fields(Scores))
    groups: Mapping[str, GroupScores] = scores.by_kind if by == "corpus" else scores.by_speaker
    for name, group in sorted({**groups, "all": scores.overall}.items()):
        yield printable(name).ljust(FIRST) + "".join(cell.rjust(COLUMN) for cell in _cells(group.scores))
    yield ""
    overall = scores.overall
    yield (
        f"confidence is off by {written(overall.calibration_error)} on average, and by "
        f"{written(overall.largest_gap)} at most (of tenths of it, where the labels are certain)"
    )
    yield ""
    yield from _confusion_lines(scores)


def _cells(scores: Scores) -> Iterator[str]:
    return (written(value, 2 if name in COARSE else 3) for name, value in asdict(scores).items())


def _confusion_lines(scores: CorpusScores) -> Iterator[str]:
    """Write what became of each label, in percent; answers in the columns."""
    names = [short(p) for p in CLASSES]
    width = max(CELL, *(len(name) + 1 for name in names))
    yield "label, % answered".ljust(FIRST) + "".join(name.rjust(width) for name in names) + "  frames"
    rows = confusion_shares(scores.overall.confusion).tolist()
    for name, phoneme, row in zip(names, CLASSES, rows, strict=True):
        shares = "".join((f"{100 * share:.0f}" if share else "·").rjust(width) for share in row)
        yield name.ljust(FIRST) + shares + f"{scores.overall.confusion[phoneme].sum():8d}"


def _comparison_lines(report: Report, comparison: PresetComparison) -> Iterator[str]:
    one, other = (preset.title for preset in report.presets)
    yield f"What {one} (A) gets right that {other} (B) misses, in frames of 10 ms"
    yield "label".ljust(FIRST) + "".join(w.rjust(COLUMN) for w in ("both", "only A", "only B", "neither", "A - B"))
    for phoneme in CLASSES:
        gains = comparison.only_one[phoneme], comparison.only_other[phoneme]
        cells = (comparison.both[phoneme], *gains, comparison.neither[phoneme], f"{gains[0] - gains[1]:+d}")
        yield phoneme.label.ljust(FIRST) + "".join(str(cell).rjust(COLUMN) for cell in cells)
    yield ""
    yield "recordings with the greatest difference (only A, only B, of so many frames)"
    for d in comparison.differences[:MOST_SHOWN]:
        yield f"  {d.n_one:5d} {d.n_other:5d} of {d.n_frames:5d}  {report.name_of(d.utterance)}"
    for title, against, stretches in (("A", "B", comparison.stretches_one), ("B", "A", comparison.stretches_other)):
        yield ""
        yield f"the longest stretches that only {title} gets right"
        yield from _stretch_lines(report, against, stretches[:MOST_SHOWN])


def _stretch_lines(report: Report, wrong: str, stretches: Iterable[DifferingSegment]) -> Iterator[str]:
    for s in stretches:
        words = f"{s.label.label}, which {wrong} calls {s.wrong.label}"
        yield f"  {clock(s.start)} to {clock(s.end)}  {words:40} {report.name_of(s.utterance)}"
