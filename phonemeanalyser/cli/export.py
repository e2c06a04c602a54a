"""``phonemeanalyser export``: what sound files say, as mouth cues and movements for other programs."""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import (
    add_channel,
    add_ear,
    add_mouth,
    add_overwrite,
    add_preset,
    add_script,
    add_sounds,
    number,
)
from phonemeanalyser.cli.driving import Driving, add_driver, driving
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import Job, analyse_with_progress, file_preset, jobs_of, open_sound, run_all
from phonemeanalyser.cli.output_files import Guard, print_whole, write_whole_bytes
from phonemeanalyser.cli.scripts import SpokenTexts, spoken_texts
from phonemeengine import FORMATS, Channel, EngineError, ExportOptions, Preset
from phonemeengine.files import printable_name
from phonemeengine.mouth.exports.exporter import Exporter
from phonemeengine.mouth.table import shipped_tables
from phonemeengine.mouth.transcript import transcript_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is exported, and how."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _formats()
    add_sounds(parser)
    add_script(parser)
    parser.add_argument("--format", choices=FORMATS, required=True, dest="kind", metavar="F", help="see below")
    add_preset(parser)
    add_ear(parser)
    parser.add_argument("--table", metavar="T", help=f"mouth table: a file, or one of {', '.join(shipped_tables())}")
    parser.add_argument("--fps", type=number, metavar="N", help="frames per second (default: see below)")
    add_mouth(parser)
    add_expression(parser)
    add_driver(parser)
    parser.add_argument("--mesh", type=Path, metavar="GLB", help="another face than the program's, for gltf")
    add_channel(parser)
    add_overwrite(parser)


def run(options: argparse.Namespace) -> int:
    """Export sound files as the command line asks; 1 where one could not be."""
    idle = idle_of(options)
    written = ExportOptions(options.fps, options.minimum, options.anticipation, options.table, options.mesh, idle)
    exporter = Exporter(options.kind, written)
    if exporter.format.moves_mesh and options.out is None:
        raise EngineError(f"{options.kind} is no text to be printed; name a file or a folder with -o")
    preset = file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, exporter.format.full_ending)
    guard = Guard(exporter.format.owns, options.overwrite)
    if options.units is not None and len(jobs) > 1:
        raise EngineError("--units tells of one sound, and there are several; leave it out, or name one alone")
    texts = spoken_texts(options, [job.source for job in jobs])
    with driving(options) as moved:

        def act(job: Job) -> None:
            _export(job, options.channel, preset, texts, exporter, guard, moved)

        return 1 if run_all(jobs, act) else 0


def _export(
    job: Job,
    channel: Channel,
    preset: Preset,
    texts: SpokenTexts,
    exporter: Exporter,
    guard: Guard,
    moved: Driving,
) -> None:
    guard.check(job.target)
    with open_sound(job, channel) as reader:
        pitch = moved.performer is not None or (exporter.format.moves_head and exporter.idle.head)
        analyses = analyse_with_progress(reader, preset, pitch=pitch)
        name, found = printable_name(job.source), texts.aligned(reader, job.source, analyses)
        utterance = None if found is None else found[0]
        driver = moved.chosen(utterance, name, exporter.takes)
        speech = transcript_of(analyses, name, reader.duration, job.source) if found is None else found[1]
        movement = moved.movement(moved.track(driver, utterance, speech), speech, exporter)
    parts = exporter.chunks_of(speech, movement)
    if job.target is None:
        text = b"".join(parts).decode()
        print_whole(lambda file: file.writelines([text]))
    else:
        write_whole_bytes(job.target, parts, guard)


def _formats() -> str:
    lines = ["formats:"]
    for name, form in FORMATS.items():
        rate = f"{form.rate:g} fps, " if form.rate else ""
        lines.append(f"  {name:<13} {form.words} ({rate}ahead {form.anticipation:g} s, table {form.table})")
    return "\n".join(lines)
