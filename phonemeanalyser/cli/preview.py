"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures.

Two heads say it side by side, in step, where drivers are compared.
"""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import DRIVEN, HEARD, MOVED, SAID, add_batch, add_clip, add_options, given
from phonemeanalyser.cli.clips import clip_options
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_batch, jobs_of, say_note, share_paths
from phonemeanalyser.rendering.clip import ClipWork, check_clip
from phonemeengine.batch.pool import n_cores
from phonemeengine.batch.work import Job
from phonemeengine.storage.replacing import STANDARD_OUTPUT

CLIPS = ("mp4", "gif")
"""What the clips of several sounds are."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("inputs", type=Path, nargs="+", metavar="FILE", help="sound files, or folders of them")
    add_clip(parser)
    parser.add_argument("--format", choices=CLIPS, dest="kind", help=f"of several clips (default: {CLIPS[0]})")
    add_options(parser, *SAID, *HEARD, "table", *MOVED, *DRIVEN, "beside", "mesh", "movestates", "overwrite")
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Make the clips that the command line asks for; 1 where one could not be made."""
    share_paths(options)
    printed = options.out == STANDARD_OUTPUT
    if options.kind is not None and not is_batch(options.inputs) and not printed:
        options.parser.error("--format is of the clips of several sounds; of a single one, the name of OUT says it")
    kind = options.kind or CLIPS[0]
    check_clip(Path(f"clip.{kind}") if is_batch(options.inputs) or printed else options.out, options.size)
    asked = given(options)
    preset = file_preset(asked.preset, asked.ear)
    jobs = jobs_of(options.inputs, options.out, f".{kind}") if is_batch(options.inputs) else _single(options)
    look = clip_options(options)
    work = ClipWork.of(asked, preset, look, f".{kind}", [job.source for job in jobs], say_note)
    return finish_jobs(jobs, work, options, n_cores() if is_batch(options.inputs) else 1)


def _single(options: argparse.Namespace) -> list[Job]:
    return [Job(options.inputs[0], None if options.out == STANDARD_OUTPUT else options.out)]
