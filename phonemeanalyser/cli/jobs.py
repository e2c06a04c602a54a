"""Files that a command works through: where each goes, how far it is, and what is said of those that fail."""

import argparse
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from tqdm import tqdm

from phonemeanalyser.reports.page import write_batch_report
from phonemeengine import EngineError, LabelledUtterance, Preset, for_files, load_preset
from phonemeengine.audio.files import sounds_under
from phonemeengine.batch.runner import BatchOptions, BatchProgress, run_batch
from phonemeengine.batch.work import Job, JobState, Outcome, Work
from phonemeengine.presets.model_choice import model_in_words
from phonemeengine.storage.files import is_device, is_folder, printable, printable_name
from phonemeengine.storage.replacing import STANDARD_OUTPUT

DRIVING = {"performance", "face_network", "keywords", "units", "pinyin_table"}
SHARED = {"corpus", "keep", "inputs", "out", "mesh", "movestates"} | DRIVING
"""Arguments that name files which are opened where the work is done."""
BAR = "{percentage:3.0f}%|{bar}| {desc} [{elapsed}<{remaining}]"
BAR_DELAY = 1.0
"""Seconds of work before a bar is shown for a single file."""


def jobs_of(inputs: list[Path], out: Path | None, ending: str) -> list[Job]:
    """List the files to work on: files as they are, folders walked, their tree mirrored under `out`.

    Parameters
    ----------
    inputs : sound files and folders.
    out : a folder; for a single sound a file too, if its name has an ending; None and ``-`` print.
    ending : of the files that are written, such as ``.csv``.

    Raises
    ------
    EngineError : several files but no place for what is written of them.
    """
    found = [(file, relative) for path in inputs for file, relative in _files_under(path)]
    if out is None or out == STANDARD_OUTPUT:
        if len(found) > 1 or any(is_folder(path) for path in inputs):
            raise EngineError("several files need a folder for what is written of them; name one with -o")
        return [Job(file, None) for file, _ in found]
    single = is_single(inputs, out)
    return [Job(file, out if single else (out / relative).with_suffix(ending)) for file, relative in found]


def sounds_in(inputs: list[Path]) -> list[Path]:
    """Return sound files as they are, and those in folders."""
    return [file for path in inputs for file, _ in _files_under(path)]


def is_single(inputs: list[Path], out: Path | None) -> bool:
    """Return whether what is asked for is one file of one sound, not a folder of them."""
    return (
        out is not None
        and len(inputs) == 1
        and (out.suffix != "" or is_device(out))
        and not is_folder(inputs[0])
        and not is_folder(out)
    )


def is_batch(inputs: list[Path]) -> bool:
    """Return whether there are enough files for a record of what was done."""
    return len(inputs) > 1 or is_folder(inputs[0])


def share_paths(options: argparse.Namespace) -> None:
    """Name the files of a command line from the root, where a cluster works: its workers stand elsewhere."""
    if options.dask is not None:
        for name in SHARED & vars(options).keys():
            value = getattr(options, name)
            setattr(options, name, [*map(_from_root, value)] if isinstance(value, list) else _from_root(value))


def _from_root(value: Any) -> Any:
    return value.absolute() if isinstance(value, Path) and value != STANDARD_OUTPUT else value


def batch_options(options: argparse.Namespace, jobs: int | None = None) -> BatchOptions:
    """Return how the files of a command line with the arguments of `add_sounds` and `add_batch` are worked through.

    Parameters
    ----------
    jobs : processes at a time, unless the user says how many.
    """
    folder = options.out if options.out is not None and is_batch(options.inputs) else None
    return BatchOptions(options.jobs or jobs, folder, options.dask)


def work_through(
    jobs: Sequence[Job],
    work: Work,
    options: BatchOptions | None = None,
    then: Callable[[Outcome], object] = lambda _: None,
) -> list[Outcome]:
    """Do something with every file; say what is odd, report those that fail on standard error and go on.

    Where there is a record, two files in the folder list what went wrong as well. `then` is called with what
    became of each file.
    """
    options = options or BatchOptions(jobs=1)

    seen: list[Outcome] = []
    told: set[tuple[str, str]] = set()

    def take(outcome: Outcome) -> None:
        seen.append(outcome)
        _say_outcome(outcome, told)
        then(outcome)

    try:
        with batch_bar(len(jobs)) as show:
            outcomes = run_batch(jobs, work, options, on_outcome=take, on_progress=show)
    except BaseException:
        if options.folder is not None and seen:
            with suppress(EngineError):  # such as a full disk, which is reported already
                write_batch_report(seen, options.folder)
        raise
    if options.folder is not None:
        write_batch_report(outcomes, options.folder)
    n_skipped = sum(outcome.state is JobState.SKIPPED for outcome in outcomes)
    if n_skipped and sys.stderr.isatty():
        tqdm.write(f"phonemeanalyser: {n_skipped} of {len(jobs)} files were done before", file=sys.stderr)
    return outcomes


def finish_jobs(jobs: Sequence[Job], work: Work, options: argparse.Namespace, processes: int | None = None) -> int:
    """Do what a command line with the arguments of `add_batch` asks with every file; return the exit code.

    Parameters
    ----------
    processes : at a time, unless the user says how many.
    """
    return 1 if n_failed(work_through(jobs, work, batch_options(options, processes))) else 0


def n_failed(outcomes: Iterable[Outcome]) -> int:
    """Return how many files could not be worked on."""
    return sum(outcome.state is JobState.FAILED for outcome in outcomes)


def file_preset(options: argparse.Namespace, path: Path | None = None) -> Preset:
    """Return the preset with which a command recognises files; say what it lacks, and at a terminal its model.

    Parameters
    ----------
    options : its options ``preset``, ``model`` and ``decoder``.
    path : another preset instead.

    Raises
    ------
    EngineError : it cannot be read or used.
    """
    preset = for_files(load_preset(path or options.preset).with_decoder(options.decoder), options.model)
    for warning in preset.warnings:
        say_note(printable(preset.name), warning)
    if sys.stderr.isatty():
        tqdm.write(f"phonemeanalyser: model: {model_in_words(preset)}", file=sys.stderr)
    return preset


def say_cut_off(utterances: Iterable[LabelledUtterance]) -> None:
    """Print of which recordings a part is missing."""
    for utterance in utterances:
        if utterance.cut_off:
            say_note(printable_name(utterance.path), utterance.cut_off)


def say_note(name: str, note: str) -> None:
    """Print what is odd about a file that is worked on all the same."""
    tqdm.write(f"phonemeanalyser: {name}: note: {note}", file=sys.stderr)


def _say_outcome(outcome: Outcome, told: set[tuple[str, str]]) -> None:
    """Say what is odd; what is not of a sound itself, but of a table, once for all sounds."""
    if outcome.state is not JobState.SKIPPED:
        for name, note in outcome.notes:
            if (name, note) not in told or name == printable_name(outcome.job.source):
                say_note(name, note)
        told.update(outcome.notes)
    if outcome.words and not outcome.is_fatal:  # of a full disk, the batch tells as it ends
        tqdm.write(f"phonemeanalyser: {outcome.words}", file=sys.stderr)


def _files_under(path: Path) -> Iterator[tuple[Path, str]]:
    found = sounds_under(path) if is_folder(path) else []
    if found:
        yield from ((file, str(file.relative_to(path))) for file in found)
    else:
        yield path, path.name or "folder"


@contextmanager
def batch_bar(n_files: int) -> Iterator[Callable[[BatchProgress], bool]]:
    """Show a bar at terminals; of a single file only where the work is long."""
    delay = BAR_DELAY if n_files == 1 else 0.0
    with tqdm(total=1.0, bar_format=BAR, delay=delay, leave=n_files > 1, disable=None, file=sys.stderr) as bar:

        def show(progress: BatchProgress) -> bool:
            bar.set_description_str(_words_of(progress), refresh=False)
            bar.update(progress.share - bar.n)
            return True

        yield show


def _words_of(progress: BatchProgress) -> str:
    over = progress.n_done + progress.n_failed
    parts = [f"{over}/{progress.n_files} files"]
    if progress.analysed:
        parts.append(f"{progress.speed:.0f} x real time")
    if progress.n_failed:
        parts.append(f"{progress.n_failed} failed")
    return ", ".join(parts)
