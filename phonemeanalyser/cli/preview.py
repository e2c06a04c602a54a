"""``phonemeanalyser preview``: a head speaks an audio file, as a video, a .gif, or a folder of pictures.

Two heads speak it side by side, in step, where drivers are compared.
"""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import HEARD, MOVED, SAID, add_batch, add_clip, add_options, given
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_batch, jobs_of, say_note, share_paths
from phonemeanalyser.rendering.clip import ClipWork, check_clip
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeengine.batch.order import n_cores
from phonemeengine.batch.work import Job
from phonemeengine.conversion.options import DRIVEN
from phonemeengine.storage.replacing import STANDARD_OUTPUT

CLIPS = ("mp4", "gif")
"""What the clips of several sounds are."""

EXAMPLES = (
    "phonemeanalyser preview speech.wav -o speech.mp4",
    "phonemeanalyser preview speech.wav -o pictures --mesh man --view bust --size 1080x1350 --transparent",
    "phonemeanalyser preview recordings -o clips --size 320x320 --theme dark",
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("inputs", type=Path, nargs="+", metavar="FILE", help="audio files, or folders of them")
    add_clip(parser)
    parser.add_argument("--format", choices=CLIPS, dest="kind", help=f"format of several clips (default: {CLIPS[0]})")
    add_options(parser, *SAID, *HEARD, "table", *MOVED, *DRIVEN, "beside", "mesh", "movestates", "keys", "overwrite")
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Make the clips that the command line asks for; 1 where one could not be made."""
    share_paths(options)
    printed = options.out == STANDARD_OUTPUT
    if options.kind is not None and not is_batch(options.inputs) and not printed:
        options.parser.error("--format goes with several files; for one, end the name of OUT with the format")
    kind = options.kind or CLIPS[0]
    asked = given(options)
    out = Path(f"clip.{kind}") if is_batch(options.inputs) or printed else options.out
    check_clip(out, ClipOptions.of(asked))
    preset = file_preset(options)
    jobs = jobs_of(options.inputs, options.out, f".{kind}") if is_batch(options.inputs) else _single(options)
    work = ClipWork.of(asked, preset, f".{kind}", [job.source for job in jobs], say_note)
    return finish_jobs(jobs, work, options, n_cores() if is_batch(options.inputs) else 1)


def _single(options: argparse.Namespace) -> list[Job]:
    return [Job(options.inputs[0], None if options.out == STANDARD_OUTPUT else options.out)]
