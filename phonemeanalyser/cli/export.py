"""``phonemeanalyser export``: what sound files say, as mouth cues and movements for other programs."""

import argparse

from phonemeanalyser.cli.arguments import HEARD, MOVED, SAID, add_batch, add_options, add_sounds, format_of, given
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_single, jobs_of, say_note, share_paths
from phonemeengine import FORMATS, EngineError
from phonemeengine.conversion.options import DRIVEN
from phonemeengine.conversion.work import ConversionWork

EXAMPLES = (
    "phonemeanalyser export speech.wav -o mouth.json --format rhubarb-json",
    "phonemeanalyser export speech.wav -o face.csv --format livelink-csv --script speech.txt --language en-us",
    "phonemeanalyser export recordings -o cues --format moho-dat --fps 30",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is exported, and how."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _formats()
    add_sounds(parser)
    add_options(parser, *HEARD, *SAID, "format", "table", "fps", "minimum", *MOVED, *DRIVEN, "mesh", "keys")
    add_options(parser, "longest", "overwrite")
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Export sound files as the command line asks; 1 where one could not be."""
    share_paths(options)
    asked = given(options)
    kind = asked.format or format_of(options, options.out if is_single(options.inputs, options.out) else None)
    if FORMATS[kind].moves_mesh and options.out is None:
        raise EngineError(f"{kind} is no text to be printed; name a file or a folder with -o")
    jobs = jobs_of(options.inputs, options.out, FORMATS[kind].full_ending)
    if asked.units is not None and len(jobs) > 1:
        raise EngineError("--units tells of one sound, and there are several; leave it out, or name one alone")
    preset = file_preset(options)
    work = ConversionWork.of(asked, kind, preset, [job.source for job in jobs], say_note)
    return finish_jobs(jobs, work, options)


def _formats() -> str:
    lines = ["formats:"]
    for name, form in FORMATS.items():
        rate = f"{form.rate:g} fps, " if form.rate else ""
        lines.append(f"  {name:<13} {form.words} ({rate}anticipation {form.anticipation:g} s, table {form.table})")
    return "\n".join(lines)
