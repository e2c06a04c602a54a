"""``phonemeanalyser export``: what sound files say, as mouth cues and movements for other programs."""

import argparse
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeanalyser.cli.arguments import (
    add_batch,
    add_channel,
    add_ear,
    add_mouth,
    add_overwrite,
    add_preset,
    add_script,
    add_sounds,
    format_of,
    number,
    number_in,
)
from phonemeanalyser.cli.driving import Driving, add_driver, driving, driving_key, driving_options
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import (
    file_preset,
    finish_jobs,
    is_single,
    jobs_of,
    open_sound,
    share_paths,
)
from phonemeanalyser.cli.output_files import print_bytes, print_whole
from phonemeanalyser.cli.scripts import SpokenTexts, made_of, spoken_texts
from phonemeengine import FORMATS, Channel, EngineError, ExportOptions, Preset
from phonemeengine.analyser import analyse_file
from phonemeengine.batch.fingerprint import fingerprint_of
from phonemeengine.batch.work import Act, Job, Made, Say
from phonemeengine.files import printable_name
from phonemeengine.mouth.cues import MINIMUM
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.table import load_table, shipped_tables
from phonemeengine.mouth.transcript import transcript_of
from phonemeengine.progress import Progress
from phonemeengine.replacing import Guard, write_guarded


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is exported, and how."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _formats()
    add_sounds(parser)
    add_script(parser)
    parser.add_argument(
        "--format",
        choices=FORMATS,
        dest="kind",
        metavar="F",
        help="see below (default: as OUT ends, if one alone does)",
    )
    add_preset(parser)
    add_ear(parser)
    parser.add_argument("--table", metavar="T", help=f"mouth table: a file, or one of {', '.join(shipped_tables())}")
    parser.add_argument("--fps", type=number, metavar="N", help="frames per second (default: see below)")
    words = f"shortest cue ({MINIMUM} s), for formats that have cues"
    parser.add_argument("--minimum", type=number, metavar="S", help=words)
    add_mouth(parser)
    add_expression(parser)
    add_driver(parser)
    parser.add_argument(
        "--mesh", type=Path, metavar="M", help="another face than the program's, for gltf: .glb, .gltf, .obj or .x"
    )
    add_channel(parser)
    longest = "refuse sounds that last longer than so many seconds"
    parser.add_argument("--longest", type=number_in(0, math.inf, "s"), default=math.inf, metavar="S", help=longest)
    add_overwrite(parser)
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Export sound files as the command line asks; 1 where one could not be."""
    share_paths(options)
    idle = idle_of(options)
    options.kind = options.kind or format_of(options, options.out if is_single(options.inputs, options.out) else None)
    written = ExportOptions(options.fps, options.minimum, options.anticipation, options.table, options.mesh, idle)
    exporter = Exporter(options.kind, written)
    if exporter.format.moves_mesh and options.out is None:
        raise EngineError(f"{options.kind} is no text to be printed; name a file or a folder with -o")
    preset = file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, exporter.format.full_ending)
    if options.units is not None and len(jobs) > 1:
        raise EngineError("--units tells of one sound, and there are several; leave it out, or name one alone")
    texts = spoken_texts(options, [job.source for job in jobs])
    with driving(options):  # says what it has to say, and refuses what it must, before any sound is heard
        work = ExportWork(
            options.kind, written, preset, options.channel, texts, driving_options(options), options.longest
        )
        return finish_jobs(jobs, work, options)


@dataclass(frozen=True)
class ExportWork:
    """Writes what sounds say for other programs.

    Attributes
    ----------
    kind, written : the format, and how it is written.
    preset, channel : what is recognised with, and of what.
    texts : what is said in the sounds.
    driving : arguments of what moves a face, and whether whatever is there is replaced.
    longest : seconds that a sound may last.
    """

    kind: str
    written: ExportOptions
    preset: Preset
    channel: Channel
    texts: SpokenTexts
    driving: argparse.Namespace
    longest: float = math.inf

    def fingerprint(self) -> str:
        """Return what tells it from other work."""
        table = load_table(self.written.table or FORMATS[self.kind].table)
        options = replace(self.written, table=None)
        return fingerprint_of(
            "export", self.kind, table, options, self.preset, self.channel, driving_key(self.driving)
        )

    def known_of(self, job: Job) -> str:
        """Return what is said in a sound."""
        return self.texts.known_of(job.sound)

    @contextmanager
    def opened(self) -> Iterator[Act]:
        """Open what moves a face, and give what exports one file."""
        exporter = Exporter(self.kind, self.written)
        with driving(self.driving, say=lambda _name, _note: None) as moved:
            yield lambda job, say, progress: self._export(job, exporter, moved, say, progress)

    def _export(self, job: Job, exporter: Exporter, moved: Driving, say: Say, progress: Progress) -> Made:
        guard = Guard(exporter.format.owns, self.driving.overwrite, job.earlier)
        guard.check(job.target)
        with open_sound(job.source, self.channel, say, self.longest) as reader:
            pitch = moved.performer is not None or (exporter.format.moves_head and exporter.idle.head)
            analyses = analyse_file(reader, self.preset, pitch=pitch, progress=progress)
            name, found = printable_name(job.source), self.texts.aligned(reader, job.sound, analyses, say)
            utterance = None if found is None else found[0]
            driver = moved.chosen(utterance, name, exporter.takes)
            speech = transcript_of(analyses, name, reader.duration, job.source) if found is None else found[1]
            track = moved.track(driver, utterance, speech, say=say)
            movement = moved.movement(track, speech, exporter, say)
            made = made_of(reader, utterance, self.texts.language)
        parts = exporter.chunks_of(speech, movement)
        if job.target is not None:
            write_guarded(job.target, parts, guard)
        elif exporter.format.moves_mesh:
            print_bytes(parts)
        else:
            text = b"".join(parts).decode()
            print_whole(lambda file: file.writelines([text]))
        return made


def _formats() -> str:
    lines = ["formats:"]
    for name, form in FORMATS.items():
        rate = f"{form.rate:g} fps, " if form.rate else ""
        lines.append(f"  {name:<13} {form.words} ({rate}ahead {form.anticipation:g} s, table {form.table})")
    return "\n".join(lines)
