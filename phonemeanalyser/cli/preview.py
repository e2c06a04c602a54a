"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures.

Two heads say it side by side, in step, where drivers are compared.
"""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import (
    add_batch,
    add_channel,
    add_clip,
    add_ear,
    add_mouth,
    add_overwrite,
    add_preset,
    add_script,
)
from phonemeanalyser.cli.clips import clip_options
from phonemeanalyser.cli.driving import DRIVERS, add_driver, driver_of
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import file_preset, finish_jobs, is_batch, jobs_of, share_paths
from phonemeanalyser.cli.scripts import spoken_texts
from phonemeanalyser.rendering.clip import ClipWork, ShownFace, check_clip
from phonemeengine import ExportOptions, load_table
from phonemeengine.batch.pool import n_cores
from phonemeengine.batch.work import Job
from phonemeengine.mouth.face_driver import FaceDriver
from phonemeengine.mouth.table import USUAL_TABLE, shipped_tables
from phonemeengine.storage.replacing import STANDARD_OUTPUT

CLIPS = ("mp4", "gif")
"""What the clips of several sounds are."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("inputs", type=Path, nargs="+", metavar="FILE", help="sound files, or folders of them")
    add_clip(parser)
    parser.add_argument("--format", choices=CLIPS, dest="kind", help=f"of several clips (default: {CLIPS[0]})")
    add_script(parser)
    add_preset(parser)
    add_ear(parser)
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=f"a file, or {', '.join(shipped_tables())}")
    add_mouth(parser)
    add_expression(parser)
    add_driver(parser)
    others = [driver for driver in DRIVERS if driver != FaceDriver.AUTO]
    parser.add_argument("--beside", choices=others, help="a second head beside the first, which this driver moves")
    add_channel(parser)
    parser.add_argument("--mesh", type=Path, metavar="M", help="a face of yours: .obj, .glb, .gltf or .x")
    parser.add_argument("--movestates", type=Path, metavar="F", help="its movestates: .3dm or .3dma")
    add_overwrite(parser)
    add_batch(parser)


def run(options: argparse.Namespace) -> int:
    """Make the clips that the command line asks for; 1 where one could not be made."""
    share_paths(options)
    printed = options.out == STANDARD_OUTPUT
    if options.kind is not None and not is_batch(options.inputs) and not printed:
        options.parser.error("--format is of the clips of several sounds; of a single one, the name of OUT says it")
    kind = options.kind or CLIPS[0]
    check_clip(Path(f"clip.{kind}") if is_batch(options.inputs) or printed else options.out, options.size)
    idle, preset = idle_of(options), file_preset(options.preset, options.ear)
    jobs = jobs_of(options.inputs, options.out, f".{kind}") if is_batch(options.inputs) else _single(options)
    texts, table = spoken_texts(options, [job.source for job in jobs]), load_table(options.table)
    if idle.expression is not None:
        idle.expression.check_fits(table.movestates, table.name)
    by_rules = ExportOptions(anticipation=options.anticipation, table=options.table, idle=idle)
    faces = ShownFace(options.mesh, options.movestates)
    faces.morph_mesh()
    work = ClipWork(
        by_rules, preset, options.channel, texts, driver_of(options), faces, clip_options(options), f".{kind}",
        options.overwrite,
    )  # fmt: skip
    return finish_jobs(jobs, work, options, n_cores() if is_batch(options.inputs) else 1)


def _single(options: argparse.Namespace) -> list[Job]:
    return [Job(options.inputs[0], None if options.out == STANDARD_OUTPUT else options.out)]
