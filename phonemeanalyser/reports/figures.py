"""The figures of a report, as text for a terminal and as numbers for other programs."""

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, fields
from typing import Any

import numpy as np

from phonemeanalyser.reports.report import CLASSES, Report, ScoredPreset, clock, confusion_shares, short, written
from phonemeengine.arrays import Int64Array
from phonemeengine.calibration.scores.comparison import Difference, DifferingSegment, PresetComparison
from phonemeengine.calibration.scores.evaluation import CorpusScores, GroupScores, Predictions
from phonemeengine.calibration.scores.scoring import Scores, scores_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.presets.preset import rules_of
from phonemeengine.recognition.rules import active_rules
from phonemeengine.settings import FRAME_PERIOD
from phonemeengine.storage.files import printable

# A report as text: the table of the corpus scorer, the confusion in percent, and what only one preset gets right.

MOST_SHOWN = 10
"""Recordings and segments that are listed of each preset."""
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
    yield f"{preset.title} (model: {model_in_words(scores.preset)})"
    yield f"lag {1000 * scores.delay:g} ms".ljust(FIRST) + "".join(f"  {f.name}" for f in fields(Scores))
    groups: Mapping[str, GroupScores] = scores.by_kind if by == "corpus" else scores.by_speaker
    for name, group in sorted({**groups, "all": scores.overall}.items()):
        yield printable(name).ljust(FIRST) + "".join(_cells(group.scores))
    yield ""
    overall = scores.overall
    yield (
        f"confidence is off by {written(overall.calibration_error)} on average, and by "
        f"{written(overall.largest_gap)} at most (of tenths of it, where the labels are certain)"
    )
    if rules := active_rules(rules_of(scores.preset)):
        n = sum(len(rule.conditions) for rule in rules)
        yield f"{len(rules)} rules with {n} conditions; phonemeanalyser explain lists them"
    yield ""
    yield from _confusion_lines(scores)


def _cells(scores: Scores) -> Iterator[str]:
    return (written(value, 2 if name in COARSE else 3).rjust(len(name) + 2) for name, value in asdict(scores).items())


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
    yield from _changed_lines(comparison)
    yield ""
    yield "recordings with the greatest difference (frames that only A and only B gets right, of all)"
    for d in comparison.differences[:MOST_SHOWN]:
        yield f"  {d.n_one:5d} {d.n_other:5d} of {d.n_frames:5d}  {report.name_of(d.utterance)}"
    for title, against, stretches in (("A", "B", comparison.segments_one), ("B", "A", comparison.segments_other)):
        yield ""
        yield f"the longest segments that only {title} gets right"
        yield from _stretch_lines(report, against, stretches[:MOST_SHOWN])


def _changed_lines(comparison: PresetComparison) -> Iterator[str]:
    """Write how many frames have another phoneme with B, and which."""
    changed = comparison.changed - np.diag(comparison.changed.diagonal())
    yield f"frames whose phoneme is another one with B: {changed.sum()} of {comparison.changed.sum()}"
    yield "phoneme".ljust(FIRST) + "".join(w.rjust(COLUMN) for w in ("with A", "with B", "B - A")) + "  becomes"
    for phoneme in CLASSES:
        n, other = comparison.changed[phoneme].sum(), comparison.changed[:, phoneme].sum()
        becomes = sorted(((int(changed[phoneme, p]), short(p)) for p in CLASSES), reverse=True)
        words = ", ".join(f"{name} {count}" for count, name in becomes if count)
        yield (
            phoneme.label.ljust(FIRST)
            + "".join(str(c).rjust(COLUMN) for c in (n, other, f"{other - n:+d}"))
            + (f"  {words}" if words else "")
        )


def _stretch_lines(report: Report, wrong: str, stretches: Iterable[DifferingSegment]) -> Iterator[str]:
    for s in stretches:
        words = f"{s.label.label}, which {wrong} calls {s.wrong.label}"
        yield f"  {clock(s.start)} to {clock(s.end)}  {words:40} {report.name_of(s.utterance)}"


# A report as JSON: all numbers; null where there was nothing to count.


def json_of(report: Report) -> str:
    """Write a report for other programs; phonemes are listed as in ``phonemes``, labels being the rows."""
    noise = report.noise
    document = {
        "corpus": report.name,
        "phonemes": [p.label for p in Phoneme],
        "noise": noise and {"kind": noise.kind.value, "snr_db": noise.snr, "seed": noise.seed},
        "left_out": list(report.left_out),
        "presets": [_preset(preset, report) for preset in report.presets],
        "comparison": report.comparison and _comparison(report.comparison, report),
    }
    return json.dumps(_without_nan(document), indent=1, allow_nan=False) + "\n"


def _preset(preset: ScoredPreset, report: Report) -> dict[str, Any]:
    scores = preset.scores
    return {
        "title": preset.title,
        "name": scores.preset.name,
        "recogniser": scores.preset.recogniser,
        "model": model_in_words(scores.preset),
        "look_ahead_ms": round(1000 * scores.look_ahead * FRAME_PERIOD, 3),
        "lag_ms": round(1000 * scores.delay, 3),
        "all": _group(scores.overall),
        "rules": preset.rules,
        "by_corpus": {name: _group(group) for name, group in scores.by_kind.items()},
        "by_speaker": {name: _group(group) for name, group in scores.by_speaker.items()},
        "recordings": [_recording(found, report) for found in scores.predictions if len(found.phonemes)],
    }


def _group(group: GroupScores) -> dict[str, Any]:
    return {
        **asdict(group.scores),
        "recordings": group.n_recordings,
        "changes": group.changes,
        "label_changes": group.label_changes,
        "mean_intensity": group.intensity,
        "confidence_error": group.calibration_error,
        "confidence_largest_gap": group.largest_gap,
        "f1": {p.label: group.f1_of(p) for p in Phoneme},
        "confusion": group.confusion.tolist(),
    }


def _recording(found: Predictions, report: Report) -> dict[str, Any]:
    utterance = found.utterance
    names = {"file": report.name_of(utterance), "corpus": utterance.corpus, "speaker": utterance.speaker}
    return {**names, **asdict(scores_of([found.answers]))}


def _comparison(comparison: PresetComparison, report: Report) -> dict[str, Any]:
    return {
        "both_right": _by_phoneme(comparison.both),
        "only_first": _by_phoneme(comparison.only_one),
        "only_second": _by_phoneme(comparison.only_other),
        "neither": _by_phoneme(comparison.neither),
        "changed": comparison.changed.tolist(),
        "recordings": [_difference(d, report) for d in comparison.differences],
        "stretches_only_first": [_stretch(s, report) for s in comparison.segments_one],
        "stretches_only_second": [_stretch(s, report) for s in comparison.segments_other],
    }


def _by_phoneme(counts: Int64Array) -> dict[str, int]:
    return {p.label: int(counts[p]) for p in Phoneme}


def _difference(d: Difference, report: Report) -> dict[str, Any]:
    counts = {"frames": d.n_frames, "both_right": d.n_both, "only_first": d.n_one, "only_second": d.n_other}
    return {"file": report.name_of(d.utterance), **counts}


def _stretch(s: DifferingSegment, report: Report) -> dict[str, Any]:
    times = {"start_s": round(s.start, 6), "end_s": round(s.end, 6)}
    return {"file": report.name_of(s.utterance), **times, "label": s.label.label, "wrong": s.wrong.label}


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _without_nan(part) for name, part in value.items()}
    if isinstance(value, list):
        return [_without_nan(part) for part in value]
    return None if isinstance(value, float) and math.isnan(value) else value
