"""Analyse files without a window: each sound file becomes a table of its phonemes, or of every frame's variables."""

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from phonemeanalyser.cli.arguments import add_channel, add_ear, add_overwrite, add_preset, add_script, add_sounds
from phonemeanalyser.cli.jobs import (
    Job,
    analyse_with_progress,
    file_preset,
    is_single,
    jobs_of,
    open_sound,
    run_all,
    say_note,
)
from phonemeanalyser.cli.output_files import Guard, print_whole, write_whole
from phonemeanalyser.cli.scripts import NO_TEXTS, SpokenTexts, spoken_texts
from phonemeengine import Channel, EngineError, Preset, difference
from phonemeengine.analysis_tables import TABLES, TableFormat, Writer
from phonemeengine.files import begins_like, printable_name
from phonemeengine.preset_difference import DIFFERENCE_COLUMNS, format_difference


@dataclass(frozen=True)
class AnalysisTable:
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
        if self.features and self.format.write_frames is None:
            raise EngineError(
                f"a file of labels ({self.format.ending}) has no place for the variables of every frame; leave out "
                "--features, or write them with --format csv or json"
            )

    @property
    def format(self) -> TableFormat:
        """Its kind, as the engine knows it."""
        return TABLES[self.kind]

    @property
    def write(self) -> Writer:
        """What writes it."""
        return (self.format.write_frames if self.features else None) or self.format.write_runs


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is analysed, and how that is written."""
    add_sounds(parser)
    add_script(parser)
    add_preset(parser)
    add_ear(parser)
    parser.add_argument("--format", choices=list(TABLES), dest="kind", help="default: as OUT ends, else csv")
    words = "write where this preset hears something else, as start_s,end_s,first,second"
    parser.add_argument("--against", type=Path, metavar="B", help=words)
    parser.add_argument("--features", action="store_true", help="every 10 ms frame with every variable")
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Analyse sound files as the command line asks; 1 where one could not be."""
    if options.against is not None:
        return _compare(options)
    table = AnalysisTable(options.kind or kind_for(options.inputs, options.out), options.features)
    preset = file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, table.format.ending)
    guard = Guard(table.format.owns, options.overwrite)
    texts = spoken_texts(options, [job.source for job in jobs])
    if texts is not NO_TEXTS and table.features:
        options.parser.error("--features are of frames, and --text or --script give words; leave one of them out")
    return 1 if run_all(jobs, lambda job: _analyse(job, options.channel, preset, texts, table, guard)) else 0


def _compare(options: argparse.Namespace) -> int:
    """Write where two presets hear two things; 1 where a sound could not be heard."""
    if options.kind not in {None, "csv"} or options.features or options.text or options.script:
        options.parser.error("--against writes a table of its own; leave --format, --features and texts out")
    first, second = (file_preset(path, options.ear) for path in (options.preset, options.against))
    guard = Guard(begins_like(",".join(DIFFERENCE_COLUMNS).encode()), options.overwrite)

    def act(job: Job) -> None:
        guard.check(job.target)
        with open_sound(job, options.channel):  # says what is odd about it
            found = difference(job.source, first, second, channel=options.channel)
        text = format_difference(found)
        say_note(printable_name(job.source), f"the presets differ in {100 * found.share:.1f} % of the frames")
        if job.target is None:
            print_whole(lambda file: file.writelines([text]))
        else:
            write_whole(job.target, lambda file: file.writelines([text]), guard)

    return 1 if run_all(jobs_of(options.inputs, options.out, ".csv"), act) else 0


def kind_for(inputs: list[Path], out: Path | None) -> str:
    """Return the format that the name of a single table asks for; ``csv`` where it asks for none."""
    if out is None or not is_single(inputs, out):
        return "csv"
    return {form.ending.lower(): kind for kind, form in TABLES.items()}.get(out.suffix.lower(), "csv")


def _analyse(
    job: Job, channel: Channel, preset: Preset, texts: SpokenTexts, table: AnalysisTable, guard: Guard
) -> None:
    guard.check(job.target)
    with open_sound(job, channel) as reader:

        def write(file: TextIO) -> None:
            analyses = analyse_with_progress(reader, preset, pitch=table.features)
            found = texts.aligned(reader, job.source, analyses)
            if found is None:
                table.write(file, analyses, reader, preset)
            else:
                table.format.write_words(file, *found, preset)

        if job.target is None:
            print_whole(write)
        else:
            write_whole(job.target, write, guard)
