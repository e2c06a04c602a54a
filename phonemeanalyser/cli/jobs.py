"""Files that a command works through, one after the other: where each goes, and what is said of those that fail."""

import logging
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from phonemeengine import (
    FRAME_PERIOD,
    Analysis,
    AudioError,
    Channel,
    Ear,
    EngineError,
    LabelledUtterance,
    Preset,
    SoundReader,
    ear_in_words,
    for_files,
    load_preset,
)
from phonemeengine.analyser import analyse_file
from phonemeengine.audio.files import SUFFIXES
from phonemeengine.files import printable, printable_name

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Job:
    """A sound file (or a folder without any), and the file that is written of it; None means standard output."""

    source: Path
    target: Path | None


def jobs_of(inputs: list[Path], out: Path | None, ending: str) -> list[Job]:
    """List the files to work on: files as they are, folders walked, their tree mirrored under `out`.

    Parameters
    ----------
    inputs : sound files and folders.
    out : a folder; for a single sound a file too, if its name has an ending; None prints.
    ending : of the files that are written, such as ``.csv``.

    Raises
    ------
    EngineError : several files but no place for what is written of them.
    """
    found = [(file, relative) for path in inputs for file, relative in _files_under(path)]
    if out is None:
        if len(found) > 1 or any(_is_folder(path) for path in inputs):
            raise EngineError("several files need a folder for what is written of them; name one with -o")
        return [Job(file, None) for file, _ in found]
    single = is_single(inputs, out)
    return [Job(file, out if single else out / relative.with_suffix(ending)) for file, relative in found]


def is_single(inputs: list[Path], out: Path) -> bool:
    """Return whether what is asked for is one file of one sound, not a folder of them."""
    return len(inputs) == 1 and out.suffix != "" and not _is_folder(inputs[0]) and not _is_folder(out)


def run_all(jobs: Iterable[Job], act: Callable[[Job], None]) -> int:
    """Do something with every file; report those that fail on standard error and go on. Returns how many failed."""
    jobs = list(jobs)
    failures = 0
    taken: dict[Path, Path] = {}
    with tqdm(total=len(jobs), unit="file", disable=None if len(jobs) > 1 else True, file=sys.stderr) as progress:
        for job in jobs:
            try:
                _refuse_collision(job, taken)
                act(job)
            except EngineError as error:
                progress.write(f"phonemeanalyser: {error}", file=sys.stderr)
                _log.warning("%s", error)
                failures += 1
            progress.update()
    return failures


def file_preset(path: Path, ear: str | None) -> Preset:
    """Return the preset with which a command hears files; say what it lacks, and at a terminal what is heard with.

    Parameters
    ----------
    path : the preset's file, or its name.
    ear : what is asked for; None for the best there is.

    Raises
    ------
    EngineError : it cannot be read or used.
    """
    preset = for_files(load_preset(path), None if ear is None else Ear(ear))
    for warning in preset.warnings:
        say_note(printable(preset.name), warning)
    if sys.stderr.isatty():
        tqdm.write(f"phonemeanalyser: heard with: {ear_in_words(preset)}", file=sys.stderr)
    return preset


@contextmanager
def open_sound(job: Job, channel: Channel) -> Iterator[SoundReader]:
    """Open the sound of a job to analyse one of its channels, and say what is odd about it.

    Raises
    ------
    AudioError : it cannot be read, or lacks the channel, or there is none.
    """
    name = printable_name(job.source)
    if _is_folder(job.source):
        raise AudioError(f"{name}: there is no sound file in this folder; name another")
    with SoundReader(job.source, channel) as reader:
        for note in reader.notes:
            say_note(name, note)
        yield reader


def say_cut_off(utterances: Iterable[LabelledUtterance]) -> None:
    """Return of which recordings a part is missing."""
    for utterance in utterances:
        if utterance.cut_off:
            say_note(printable_name(utterance.path), utterance.cut_off)


def say_note(name: str, note: str) -> None:
    """Return what is odd about a file that is worked on all the same."""
    tqdm.write(f"phonemeanalyser: {name}: note: {note}", file=sys.stderr)


def analyse_with_progress(reader: SoundReader, preset: Preset, *, pitch: bool) -> Iterator[Analysis]:
    """Analyse with a progress bar, which appears only where the work is long."""
    total, name = round(reader.duration), printable_name(reader.path)
    with tqdm(
        total=total, unit="s", desc=name, delay=1, leave=False, disable=None, file=sys.stderr
    ) as progress:  # fmt: skip
        for analysis in analyse_file(reader, preset, pitch=pitch):
            progress.update(len(analysis) * FRAME_PERIOD)
            yield analysis


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
            f"{job.source.name}: its file {job.target.name} is already that of {taken[job.target].name}; "
            "rename one of them"
        )
    taken[job.target] = job.source
