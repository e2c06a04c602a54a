"""Analyse files without a window: each sound file becomes a table of its phonemes, or of every frame's variables."""

import argparse
import csv
import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from engine.analyser import Analysis
from engine.audio.files import SoundReader
from engine.calibration.labels.audacity import format_audacity
from engine.calibration.labels.label import Label, labels_of_runs
from engine.calibration.labels.textgrid import format_textgrid
from engine.errors import EngineError
from engine.phonemes import Phoneme
from engine.presets.files import DEFAULT_PRESET, load_preset
from engine.presets.preset import Preset
from engine.recognition.runs import RUN_COLUMNS, Run, runs_of
from engine.settings import FRAME_PERIOD
from phonemeanalyser.jobs import Job, is_single, jobs_of, sound_of, watched, work_through
from phonemeanalyser.writing import print_whole, write_whole

SUFFIX_OF = {"csv": ".csv", "json": ".json", "textgrid": ".TextGrid", "audacity": ".txt"}
"""What the names of tables end with, by their format."""


@dataclass(frozen=True)
class Table:
    """What is written.

    Attributes
    ----------
    kind : ``csv``, ``json``, ``textgrid`` (labels for Praat) or ``audacity`` (labels for Audacity).
    features : every frame with its variables, not runs of equal phonemes.

    Raises
    ------
    EngineError : labels hold no variables.
    """

    kind: str
    features: bool

    def __post_init__(self) -> None:
        if (self.kind, self.features) not in _WRITERS:
            raise EngineError(
                f"a file of labels ({SUFFIX_OF[self.kind]}) has no place for the variables of every frame; leave out "
                "--features, or write them with --format csv or json"
            )


def analyse(words: list[str]) -> int:
    """Analyse sound files as the command line asks; 1 where one could not be."""
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser analyse", description="Write the phonemes of sound files as tables."
    )
    parser.add_argument("inputs", type=Path, nargs="+", metavar="INPUT", help="sound files, or folders of them")
    parser.add_argument("-o", "--out", type=Path, help="folder for the tables, or a file for one (default: print)")
    parser.add_argument("--preset", type=Path, default=DEFAULT_PRESET, help="preset (.toml) or PhonemeData file")
    parser.add_argument("--format", choices=list(SUFFIX_OF), dest="kind", help="default: as OUT ends, else csv")
    parser.add_argument("--features", action="store_true", help="every 10 ms frame with every variable")
    options = parser.parse_args(words)
    table = Table(options.kind or kind_for(options.inputs, options.out), options.features)
    preset = load_preset(options.preset)
    jobs = jobs_of(options.inputs, options.out, SUFFIX_OF[table.kind])
    return 1 if analyse_all(jobs, preset, table) else 0


def kind_for(inputs: list[Path], out: Path | None) -> str:
    """Give the format that the name of a single table asks for; ``csv`` where it asks for none."""
    if out is None or not is_single(inputs, out):
        return "csv"
    return {suffix.lower(): kind for kind, suffix in SUFFIX_OF.items()}.get(out.suffix.lower(), "csv")


def analyse_all(jobs: Iterable[Job], preset: Preset, table: Table) -> int:
    """Analyse every file; report those that fail on standard error and go on. Returns how many failed."""
    return work_through(jobs, lambda job: _analyse(job, preset, table))


def _analyse(job: Job, preset: Preset, table: Table) -> None:
    with sound_of(job) as reader:

        def write(file: TextIO) -> None:
            found = watched(reader, preset, pitch=table.features)
            _WRITERS[table.kind, table.features](file, found, reader, preset)

        if job.target is None:
            print_whole(write)
        else:
            write_whole(job.target, write)


Writer = Callable[[TextIO, Iterator[Analysis], SoundReader, Preset], None]


def _csv_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(RUN_COLUMNS)
    rows.writerows(run.row().values() for run in _runs(analyses, reader))


def _json_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    _write_json(file, _heading(reader, preset), "phonemes", (run.row() for run in _runs(analyses, reader)))


def _textgrid_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    file.write(format_textgrid(_labels(analyses, reader), reader.duration))


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


def _runs(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[Run]:
    return runs_of(((a.phonemes, a.intensities) for a in analyses), reader.duration)


def _labels(analyses: Iterator[Analysis], reader: SoundReader) -> tuple[Label, ...]:
    return labels_of_runs(_runs(analyses, reader))


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


_WRITERS: dict[tuple[str, bool], Writer] = {
    ("csv", False): _csv_of_runs,
    ("csv", True): _csv_of_frames,
    ("json", False): _json_of_runs,
    ("json", True): _json_of_frames,
    ("textgrid", False): _textgrid_of_runs,
    ("audacity", False): _audacity_of_runs,
}
