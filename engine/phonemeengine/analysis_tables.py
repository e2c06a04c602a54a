"""The tables that tell what was recognised in a sound: stretches of equal phonemes, or every frame's variables."""

import csv
import json
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, TextIO

from phonemeengine.analyser import Analysis
from phonemeengine.audio.files import SoundReader
from phonemeengine.features.variables import BUILT_IN_NAMES
from phonemeengine.files import JSON_TEXT, Owns, begins_like
from phonemeengine.labels import textgrid
from phonemeengine.labels.audacity import format_audacity
from phonemeengine.labels.label import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.segments import SEGMENT_COLUMNS, Segment, labels_of_segments, segments_of
from phonemeengine.settings import FRAME_PERIOD

Writer = Callable[[TextIO, Iterator[Analysis], SoundReader, Preset], None]
"""Writes the consecutive analyses of a sound, with its reader and the preset, into a file."""


@dataclass(frozen=True)
class TableFormat:
    """A kind of table.

    Attributes
    ----------
    ending : of its files, such as ``.csv``.
    write_runs : writes stretches of equal phonemes.
    write_frames : writes every frame of 10 ms with its variables; None where the format has no place for them.
    owns : says which files the format wrote; None where those of another program look alike.
    """

    ending: str
    write_runs: Writer
    write_frames: Writer | None = None
    owns: Owns | None = None


def _csv_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(SEGMENT_COLUMNS)
    rows.writerows(run.row().values() for run in _runs(analyses, reader))


def _json_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    _write_json(file, _heading(reader, preset), "phonemes", (run.row() for run in _runs(analyses, reader)))


def _textgrid_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    file.write(textgrid.format_textgrid(_labels(analyses, reader), reader.duration))


def _audacity_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    file.write(format_audacity(_labels(analyses, reader)))


def _csv_of_frames(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    begun = False
    for frame in _frames(analyses, reader):
        if not begun:
            rows.writerow(frame)
            begun = True
        rows.writerow(frame.values())


def _json_of_frames(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    _write_json(file, _heading(reader, preset), "frames", _frames(analyses, reader))


def _write_json(file: TextIO, heading: dict[str, Any], name: str, rows: Iterator[dict[str, Any]]) -> None:
    """Write an object with a list of rows, a line each, as they come: a long file has too many to hold."""
    file.write(json.dumps(heading, indent=1)[:-2] + f',\n "{name}": [')
    file.writelines((",\n  " if k else "\n  ") + json.dumps(row) for k, row in enumerate(rows))
    file.write("\n ]\n}\n")


def _heading(reader: SoundReader, preset: Preset) -> dict[str, Any]:
    return {"file": reader.path.name, "duration_s": _seconds(reader.duration), "preset": preset.name}


def _runs(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[Segment]:
    return segments_of(((a.phonemes, a.intensities) for a in analyses), reader.duration)


def _labels(analyses: Iterator[Analysis], reader: SoundReader) -> tuple[Label, ...]:
    return labels_of_segments(_runs(analyses, reader))


def _frames(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[dict[str, Any]]:
    for analysis in analyses:
        for k in range(len(analysis)):
            start = (analysis.start + k) * FRAME_PERIOD
            yield {
                "start_s": _seconds(start),
                "end_s": _seconds(min(start + FRAME_PERIOD, max(reader.duration, start))),
                "phoneme": Phoneme(int(analysis.phonemes[k])).label,
                "intensity": round(float(analysis.intensities[k]), 3),
                **{name: float(f"{value:.6g}") for name, value in analysis.features.frame(k).items()},
            }


def _seconds(value: float) -> float:
    return round(value, 6)


_RUNS = re.compile(
    b"%s\n(?:[0-9.e-]+,[0-9.e-]+,(?:%s),[0-9.e-]+\n)*"
    % (",".join(SEGMENT_COLUMNS).encode(), "|".join(phoneme.label for phoneme in Phoneme).encode())
)
_FRAMES = ",".join([*SEGMENT_COLUMNS, *BUILT_IN_NAMES]).encode() + b","


def _owns_csv(content: bytes) -> bool:
    """Take tables with all the columns that were written, and of runs with no other row either."""
    return content.startswith(_FRAMES) or _RUNS.fullmatch(content) is not None


_owns_json = begins_like(
    rb'\{\n "file": %s,\n "duration_s": [0-9.e-]+,\n "preset": %s,\n "(?:phonemes|frames)": \['
    % (JSON_TEXT, JSON_TEXT)
)

TABLES: dict[str, TableFormat] = {
    "csv": TableFormat(".csv", _csv_of_runs, _csv_of_frames, _owns_csv),
    "json": TableFormat(".json", _json_of_runs, _json_of_frames, _owns_json),
    "textgrid": TableFormat(".TextGrid", _textgrid_of_runs, owns=textgrid.owns),
    "audacity": TableFormat(".txt", _audacity_of_runs),
}
"""What can be written, by the names that the command line has for it."""
