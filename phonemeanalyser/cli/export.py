"""``phonemeanalyser export``: what sound files say, as mouth cues and movements for other programs."""

import argparse
import math
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
from phonemeanalyser.cli.driving import add_driver, driver_of
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_single, jobs_of, share_paths
from phonemeanalyser.cli.scripts import spoken_texts
from phonemeengine import FORMATS, EngineError, ExportOptions
from phonemeengine.conversion.work import ConversionWork, check_options
from phonemeengine.mouth.cues import MINIMUM
from phonemeengine.mouth.table import shipped_tables


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
    check_options(options.kind, written)
    if FORMATS[options.kind].moves_mesh and options.out is None:
        raise EngineError(f"{options.kind} is no text to be printed; name a file or a folder with -o")
    preset = file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, FORMATS[options.kind].full_ending)
    if options.units is not None and len(jobs) > 1:
        raise EngineError("--units tells of one sound, and there are several; leave it out, or name one alone")
    texts = spoken_texts(options, [job.source for job in jobs])
    work = ConversionWork(
        options.kind, preset, written, options.channel, texts, driver_of(options), options.longest, options.overwrite
    )
    return finish_jobs(jobs, work, options)


def _formats() -> str:
    lines = ["formats:"]
    for name, form in FORMATS.items():
        rate = f"{form.rate:g} fps, " if form.rate else ""
        lines.append(f"  {name:<13} {form.words} ({rate}ahead {form.anticipation:g} s, table {form.table})")
    return "\n".join(lines)
