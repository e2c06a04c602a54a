"""``phonemeanalyser align``: how well sounds say their lines, and which take of each line is the best."""

import argparse
import csv
from collections.abc import Sequence
from pathlib import Path
from typing import TextIO

from phonemeanalyser.cli.arguments import add_channel, add_ear, add_overwrite, add_preset, add_script, add_sounds
from phonemeanalyser.cli.jobs import Job, analyse_with_progress, file_preset, jobs_of, open_sound, run_all
from phonemeanalyser.cli.output_files import Guard, print_whole, write_whole
from phonemeanalyser.cli.scripts import SpokenTexts, spoken_texts
from phonemeengine import Channel, EngineError, Preset
from phonemeengine.alignment.best_takes import ScoredTake, best_marked, scored_take
from phonemeengine.files import begins_like

COLUMNS = ("file", "text", "score", "skipped", "unknown", "best")
OTHER_TEXT = "another text"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is aligned, and with which words."""
    parser.epilog = "Writes a CSV: file, text, score (0 is best), words that nobody says, stretches of others, best."
    add_sounds(parser)
    add_script(parser)
    add_preset(parser)
    add_ear(parser)
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Align sound files with their texts; 1 where one could not be."""
    if options.text is None and options.script is None:
        options.parser.error("say what is said in the sounds, with --text or --script")
    preset = file_preset(options.preset, options.ear)
    guard = Guard(begins_like(",".join(COLUMNS).encode() + b"\n"), options.overwrite)
    guard.check(options.out)
    jobs = jobs_of(options.inputs, Path(), "")
    texts = spoken_texts(options, [job.source for job in jobs])
    if texts.labels is not None:
        raise EngineError(f"{texts.labels.name}: its words are aligned already; name a script of text")
    takes: list[ScoredTake] = []
    failures = run_all(jobs, lambda job: takes.extend(_take_of(job, options.channel, preset, texts)))
    if takes:
        _write(best_marked(takes), options.out, guard)
    return 1 if failures or not takes else 0


def _take_of(job: Job, channel: Channel, preset: Preset, texts: SpokenTexts) -> list[ScoredTake]:
    """Return how well a sound says its line; nothing where it has none."""
    with open_sound(job, channel) as reader:
        found = texts.aligned(reader, job.source, analyse_with_progress(reader, preset, pitch=False))
    return [] if found is None else [scored_take(job.source, texts.texts[job.source], found[0])]


def _write(takes: Sequence[ScoredTake], out: Path | None, guard: Guard) -> None:
    def write(file: TextIO) -> None:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        rows.writerows(_row(take) for take in takes)

    if out is None:
        print_whole(write)
    else:
        write_whole(out, write, guard)


def _row(take: ScoredTake) -> tuple[str, ...]:
    skipped = OTHER_TEXT if take.is_other else " ".join(take.skipped)
    score = "" if take.score is None or take.is_other else f"{take.score:.3f}"
    text = " ".join(take.text.split())
    return take.path.as_posix(), text, score, skipped, str(take.n_unknown), "best" if take.is_best else ""
