"""Analyse files without a window: each sound file becomes a table of its phonemes, or of every frame's variables."""

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from phonemeanalyser.cli.arguments import (
    add_batch,
    add_channel,
    add_ear,
    add_overwrite,
    add_preset,
    add_script,
    add_sounds,
)
from phonemeanalyser.cli.jobs import (
    file_preset,
    finish_jobs,
    is_single,
    jobs_of,
    open_sound,
    share_paths,
)
from phonemeanalyser.cli.output_files import write_whole
from phonemeanalyser.cli.scripts import NO_TEXTS, SpokenTexts, made_of, spoken_texts
from phonemeengine import Channel, EngineError, Preset, difference
from phonemeengine.analyser import analyse_file
from phonemeengine.analysis_tables import TABLES, TableFormat, Writer
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Act, Job, Made, Say
from phonemeengine.files import begins_like, printable_name
from phonemeengine.preset_difference import DIFFERENCE_COLUMNS, format_difference
from phonemeengine.progress import Progress
from phonemeengine.replacing import Guard


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
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Analyse sound files as the command line asks; 1 where one could not be."""
    share_paths(options)
    if options.against is not None:
        return _compare(options)
    table = AnalysisTable(options.kind or kind_for(options.inputs, options.out), options.features)
    preset = file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, table.format.ending)
    texts = spoken_texts(options, [job.source for job in jobs])
    if texts is not NO_TEXTS and table.features:
        options.parser.error("--features are of frames, and --text or --script give words; leave one of them out")
    work = AnalysisWork(table, preset, options.channel, texts, options.overwrite)
    return finish_jobs(jobs, work, options)


def _compare(options: argparse.Namespace) -> int:
    """Write where two presets hear two things; 1 where a sound could not be heard."""
    if options.kind not in {None, "csv"} or options.features or options.text or options.script:
        options.parser.error("--against writes a table of its own; leave --format, --features and texts out")
    first, second = (file_preset(path, options.ear) for path in (options.preset, options.against))
    work = DifferenceWork(first, second, options.channel, options.overwrite)
    jobs = jobs_of(options.inputs, options.out, ".csv")
    return finish_jobs(jobs, work, options)


@dataclass(frozen=True)
class DifferenceWork:
    """Writes where two presets hear two things.

    Attributes
    ----------
    first, second : the presets.
    channel : what is heard.
    overwrite : whether whatever is there is replaced.
    """

    first: Preset
    second: Preset
    channel: Channel
    overwrite: bool

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("difference", self.first, self.second, self.channel)

    def known_of(self, _job: Job) -> str:
        """Return nothing: nothing is known of a file besides."""
        return ""

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what compares one file."""

        def act(job: Job, say: Say, progress: Progress) -> Made:
            guard = Guard(begins_like(",".join(DIFFERENCE_COLUMNS).encode()), self.overwrite, job.earlier)
            guard.check(job.target)
            with open_sound(job.source, self.channel, say) as reader:
                duration = reader.duration
            found = difference(job.source, self.first, self.second, channel=self.channel, progress=progress)
            say(printable_name(job.source), f"the presets differ in {100 * found.share:.1f} % of the frames")
            write_whole(job.target, lambda file: file.writelines([format_difference(found)]), guard)
            return Made(duration)

        yield act


def kind_for(inputs: list[Path], out: Path | None) -> str:
    """Return the format that the name of a single table asks for; ``csv`` where it asks for none."""
    if out is None or not is_single(inputs, out):
        return "csv"
    return {form.ending.lower(): kind for kind, form in TABLES.items()}.get(out.suffix.lower(), "csv")


@dataclass(frozen=True)
class AnalysisWork:
    """Writes tables of phonemes.

    Attributes
    ----------
    table : what is written.
    preset, channel : what is recognised with, and of what.
    texts : what is said in the sounds.
    overwrite : whether whatever is there is replaced.
    """

    table: AnalysisTable
    preset: Preset
    channel: Channel
    texts: SpokenTexts
    overwrite: bool

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        return fingerprint_of("analyse", self.table, self.preset, self.channel)

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound."""
        return self.texts.known_of(job.sound)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Give what analyses one file."""
        yield self._analyse

    def _analyse(self, job: Job, say: Say, progress: Progress) -> Made:
        guard = Guard(self.table.format.owns, self.overwrite, job.earlier)
        guard.check(job.target)
        with open_sound(job.source, self.channel, say) as reader:
            made = made_of(reader, None)

            def write(file: TextIO) -> None:
                nonlocal made
                analyses = analyse_file(reader, self.preset, pitch=self.table.features, progress=progress)
                found = self.texts.aligned(reader, job.sound, analyses, say)
                if found is None:
                    self.table.write(file, analyses, reader, self.preset)
                else:
                    self.table.format.write_words(file, *found, self.preset)
                    made = made_of(reader, found[0], self.texts.language)

            write_whole(job.target, write, guard)
        return made
