"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures.

Two heads say it side by side, in step, where drivers are compared.
"""

import argparse
from pathlib import Path

from phonemeanalyser.cli.arguments import add_channel, add_clip, add_ear, add_mouth, add_preset, add_script
from phonemeanalyser.cli.clips import clip_options, frames_bar
from phonemeanalyser.cli.driving import DRIVERS, Driving, add_driver, driving
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import Job, analyse_with_progress, file_preset, open_sound
from phonemeanalyser.cli.scripts import spoken_texts
from phonemeanalyser.rendering.clip import animation_by_rules, check_clip, sound_track, write_clip
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.subdivision import subdivided
from phonemeengine import (
    Animation,
    EngineError,
    ExportOptions,
    FaceDriver,
    MorphMesh,
    MouthTable,
    SoundReader,
    Utterance,
    load_head,
    load_morph_mesh,
    load_morph_targets,
    load_table,
    matched,
)
from phonemeengine.files import printable_name
from phonemeengine.mouth.table import USUAL_TABLE, shipped_tables
from phonemeengine.mouth.transcript import transcript_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("file", type=Path, metavar="FILE", help="sound file")
    add_clip(parser)
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


def run(options: argparse.Namespace) -> int:
    """Make the clip that the command line asks for."""
    check_clip(options.out, options.size)
    morph_mesh = subdivided(_morph_mesh_of(options.mesh, options.movestates))
    with open_sound(Job(options.file, options.out), options.channel) as reader:
        animations, captions = _faces_of(reader, options)
        look, sound = clip_options(options), sound_track(reader)
        with frames_bar(len(animations[0].weights)) as progress:
            write_clip(options.out, morph_mesh, animations, look, captions, sound, progress)
    return 0


def _morph_mesh_of(mesh: Path | None, movestates: Path | None) -> MorphMesh:
    """Return the head that ships with the program, or a mesh with its movestates."""
    if mesh is None:
        if movestates is not None:
            raise RenderingError(f"{movestates.name}: movestates move a mesh of their own; name it with --mesh")
        return load_head()
    morph_mesh = load_morph_mesh(mesh)
    if movestates is not None:
        morph_mesh = MorphMesh(morph_mesh.mesh, matched(load_morph_targets(movestates), morph_mesh.mesh).states)
    if not morph_mesh.states:
        raise RenderingError(f"{mesh.name}: there are no morph targets in it; name its movestates with --movestates")
    return morph_mesh


def _faces_of(reader: SoundReader, options: argparse.Namespace) -> tuple[list[Animation], list[str]]:
    """Return how each head moves, and their captions where there are two."""
    idle, name = idle_of(options), printable_name(options.file)
    table, preset = load_table(options.table), file_preset(options.preset, options.ear)
    if idle.expression is not None:
        idle.expression.check_fits(table.movestates, table.name)
    texts, beside = spoken_texts(options, [options.file]), FaceDriver(options.beside) if options.beside else None
    analyses = analyse_with_progress(reader, preset, pitch=idle.head or options.performance is not None)
    with driving(options, beside) as moved:
        found = texts.aligned(reader, options.file, analyses)
        drivers = _drivers_of(moved, beside, found and found[0], name, table)
        utterance, speech = found or (None, transcript_of(analyses, name, reader.duration, options.file))
        tracks = [moved.track(driver, utterance, speech) for driver in drivers]
        by_rules = ExportOptions(
            minimum=options.minimum, anticipation=options.anticipation, table=options.table, idle=idle
        )
        animations = [
            track.animation(speech, options.fps, idle) if track else animation_by_rules(speech, by_rules, options.fps)
            for track in tracks
        ]
        return animations, [moved.caption(driver) for driver in drivers] if beside else []


def _drivers_of(
    moved: Driving, beside: FaceDriver | None, utterance: Utterance | None, name: str, table: MouthTable
) -> list[FaceDriver]:
    """Return what moves the first head, and the second one, if there is one."""
    drivers = [moved.chosen(utterance, name, lambda movestates: {*table.movestates} <= {*movestates})]
    if beside is not None:
        drivers.append(moved.chosen(utterance, name, driver=beside))
    if len({*drivers}) < len(drivers):
        raise EngineError(
            f"{name}: --beside {beside} would be what moves the first head, too; choose another one, or another "
            "--text-driver"
        )
    return drivers
