"""Analyse files without a window: each sound file becomes a table of phonemes, or of every frame's variables."""

import csv
import io
import json
import os
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from tqdm import tqdm

from engine.analyser import Analysis, analyses_of
from engine.audio.files import SUFFIXES, SoundReader
from engine.audio.opening import shown_name
from engine.errors import AudioError, EngineError
from engine.phonemes import Phoneme
from engine.presets.preset import Preset
from engine.recognition.runs import RUN_COLUMNS, runs_of
from engine.settings import FRAME_PERIOD, SAMPLE_RATE

BLOCK = 5 * SAMPLE_RATE
"""Samples that are read at a time."""


@dataclass(frozen=True)
class Job:
    """A sound file (or a folder without any), and where its table goes; None means standard output."""

    source: Path
    target: Path | None


@dataclass(frozen=True)
class Table:
    """What is written: ``csv`` or ``json``, of runs of equal phonemes or of every frame with its variables."""

    kind: str
    features: bool


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
    is_table = out.suffix != "" and not _is_folder(out)
    single = len(inputs) == 1 and not _is_folder(inputs[0]) and is_table
    for file, relative in found:
        yield Job(file, out if single else out / relative.with_suffix(f".{kind}"))


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
            _writer_of(table)(file, _watched(reader, preset, table, name), reader, preset)

        if job.target is None:
            _print_whole(write)
        else:
            _write_whole(job.target, write)


def _watched(reader: SoundReader, preset: Preset, table: Table, name: str) -> Iterator[Analysis]:
    """Analyse with a progress bar, which appears only where the work is long."""
    with tqdm(
        total=round(reader.duration), unit="s", desc=name, delay=1, leave=False, disable=None, file=sys.stderr
    ) as progress:
        for analysis in analyses_of(reader.blocks(BLOCK), preset, pitch=table.features):
            progress.update(len(analysis) * FRAME_PERIOD)
            yield analysis


def _print_whole(write: Callable[[TextIO], None]) -> None:
    """Print a table once it is complete, so that nothing is printed of a file that breaks in the middle."""
    text = io.StringIO()
    write(text)
    sys.stdout.write(text.getvalue())
    sys.stdout.flush()


def _write_whole(target: Path, write: Callable[[TextIO], None]) -> None:
    """Write a file so that it is there complete, or not at all."""
    name = ""
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=target.name, suffix=".part")
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            write(file)
        Path(name).chmod(0o644)
        Path(name).replace(target)
    except OSError as error:
        raise EngineError(f"{target}: cannot be written ({error.strerror}); choose another place with -o") from error
    finally:
        if name:
            Path(name).unlink(missing_ok=True)


Writer = Callable[[TextIO, Iterator[Analysis], SoundReader, Preset], None]


def _writer_of(table: Table) -> Writer:
    writers: dict[tuple[str, bool], Writer] = {
        ("csv", False): _csv_of_runs,
        ("csv", True): _csv_of_frames,
        ("json", False): _json_of_runs,
        ("json", True): _json_of_frames,
    }
    return writers[table.kind, table.features]


def _csv_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, _preset: Preset) -> None:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(RUN_COLUMNS)
    rows.writerows(run.values() for run in _runs(analyses, reader))


def _json_of_runs(file: TextIO, analyses: Iterator[Analysis], reader: SoundReader, preset: Preset) -> None:
    _write_json(file, _heading(reader, preset), "phonemes", _runs(analyses, reader))


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


def _runs(analyses: Iterator[Analysis], reader: SoundReader) -> Iterator[dict[str, Any]]:
    return (run.row() for run in runs_of(((a.phonemes, a.intensities) for a in analyses), reader.duration))


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
