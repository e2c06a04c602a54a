"""A report as JSON: all numbers; null where there was nothing to count."""

import json
import math
from dataclasses import asdict
from typing import Any

from phonemeanalyser.reports.report import Report, ScoredPreset
from phonemeengine.arrays import Int64Array
from phonemeengine.calibration.scores.comparison import Difference, DifferingSegment, PresetComparison
from phonemeengine.calibration.scores.evaluation import GroupScores, Predictions
from phonemeengine.calibration.scores.scoring import scores_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.ears import ear_in_words
from phonemeengine.settings import FRAME_PERIOD


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
        "heard_with": ear_in_words(scores.preset),
        "look_ahead_ms": round(1000 * scores.look_ahead * FRAME_PERIOD, 3),
        "lag_ms": round(1000 * scores.delay, 3),
        "all": _group(scores.overall),
        "by_corpus": {name: _group(group) for name, group in scores.by_kind.items()},
        "by_speaker": {name: _group(group) for name, group in scores.by_speaker.items()},
        "recordings": [_recording(heard, report) for heard in scores.predictions if len(heard.phonemes)],
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


def _recording(heard: Predictions, report: Report) -> dict[str, Any]:
    utterance = heard.utterance
    names = {"file": report.name_of(utterance), "corpus": utterance.corpus, "speaker": utterance.speaker}
    return {**names, **asdict(scores_of([heard.answers]))}


def _comparison(comparison: PresetComparison, report: Report) -> dict[str, Any]:
    return {
        "both_right": _by_phoneme(comparison.both),
        "only_first": _by_phoneme(comparison.only_one),
        "only_second": _by_phoneme(comparison.only_other),
        "neither": _by_phoneme(comparison.neither),
        "recordings": [_difference(d, report) for d in comparison.differences],
        "stretches_only_first": [_stretch(s, report) for s in comparison.stretches_one],
        "stretches_only_second": [_stretch(s, report) for s in comparison.stretches_other],
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
