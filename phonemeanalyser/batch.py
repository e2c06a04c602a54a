"""Analyse files without a window: each sound file becomes a table of its phonemes, or of every frame's variables."""

import csv
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from tqdm import tqdm

from engine.analyser import Analysis, analyses_of
from engine.audio.files import SUFFIXES, SoundReader
from engine.audio.opening import shown_name
from engine.calibration.labels.audacity import format_audacity
from engine.calibration.labels.label import Label, labels_of_runs
from engine.calibration.labels.textgrid import format_textgrid
from engine.errors import AudioError, EngineError
from engine.phonemes import Phoneme
from engine.presets.preset import Preset
from engine.recognition.runs import RUN_COLUMNS, Run, runs_of
from engine.settings import FRAME_PERIOD, SAMPLE_RATE
from phonemeanalyser.writing import print_whole, write_whole

BLOCK = 5 * SAMPLE_RATE
"""Samples that are read at a time."""
SUFFIX_OF = {"csv": ".csv", "json": ".json", "textgrid": ".TextGrid", "audacity": ".txt"}
"""What the names of tables end with, by their format."""


@dataclass(frozen=True)
class Job:
    """A sound file (or a folder without any), and where its table goes; None means standard output."""

    source: Path
    target: Path | None


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


def kind_for(inputs: list[Path], out: Path | None) -> str:
    """Give the format that the name of a single table asks for; ``csv`` where it asks for none."""
    if out is None or not _is_table(inputs, out):
        return "csv"
    return {suffix.lower(): kind for kind, suffix in SUFFIX_OF.items()}.get(out.suffix.lower(), "csv")


def jobs_of(inputs: list[Path], out: Path | None, kind: str) -> Iterator[Job]:
    """List the files to analyse: files as they are, folders walked, their tree mirrored under `out`.

    Raises
    ------
    EngineError : several files but no place for their tables.
    """
    found = [(file, relative) for path in inputs for file, relative in _files_under(path)]
    if out is None:
        if len(found) > 1 or any(_is_folder(path) for path in inputs):
            raise EngineError("several files need a folder for their tables; name one with -o")
        yield from (Job(file, None) for file, _ in found)
        return
    single = _is_table(inputs, out)
    for file, relative in found:
        yield Job(file, out if single else out / relative.with_suffix(SUFFIX_OF[kind]))


def analyse_all(jobs: Iterable[Job], preset: Preset, table: Table) -> int:
    """Analyse every file; report those that fail on standard error and go on. Returns how many failed."""
    jobs = list(jobs)
    failures = 0
    taken: dict[Path, Path] = {}
    with tqdm(total=len(jobs), unit="file", disable=None if len(jobs) > 1 else True, file=sys.stderr) as progress:
        for job in jobs:
            try:
                _refuse_collision(job, taken)
                _analyse(job, preset, table)
            except EngineError as error:
                progress.write(f"phonemeanalyser: {error}", file=sys.stderr)
                failures += 1
            progress.update()
    return failures


def _files_under(path: Path) -> Iterator[tuple[Path, Path]]:
    inside = sorted(path.rglob("*")) if _is_folder(path) else []
    found = [file for file in inside if file.is_file() and file.suffix.lower() in SUFFIXES]
    if found:
        yield from ((file, file.relative_to(path)) for file in found)
    else:
        yield path, Path(path.name or "folder")


def _is_table(inputs: list[Path], out: Path) -> bool:
    """Say whether what is asked for is one table of one file, not a folder of them."""
    return len(inputs) == 1 and out.suffix != "" and not _is_folder(inputs[0]) and not _is_folder(out)


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except OSError:  # a name too long, or a folder that may not be entered: whoever opens it says so
        return False


def _refuse_collision(job: Job, taken: dict[Path, Path]) -> None:
    if job.target is None:
        return
    if job.target in taken:
        raise AudioError(
            f"{job.source.name}: its table {job.target.name} is already that of {taken[job.target].name}; "
            "rename one of them"
        )
    taken[job.target] = job.source


def _analyse(job: Job, preset: Preset, table: Table) -> None:
    name = shown_name(job.source)
    if _is_folder(job.source):
        raise AudioError(f"{name}: there is no sound file in this folder; name another")
    with SoundReader(job.source) as reader:
        for note in reader.notes:
            tqdm.write(f"phonemeanalyser: {name}: note: {note}", file=sys.stderr)

        def write(file: TextIO) -> None:
            _WRITERS[table.kind, table.features](file, _watched(reader, preset, table, name), reader, preset)

        if job.target is None:
            print_whole(write)
        else:
            write_whole(job.target, write)


def _watched(reader: SoundReader, preset: Preset, table: Table, name: str) -> Iterator[Analysis]:
    """Analyse with a progress bar, which appears only where the work is long."""
    with tqdm(
        total=round(reader.duration), unit="s", desc=name, delay=1, leave=False, disable=None, file=sys.stderr
    ) as progress:
        for analysis in analyses_of(reader.blocks(BLOCK), preset, pitch=table.features):
            progress.update(len(analysis) * FRAME_PERIOD)
            yield analysis


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
