"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures."""

import argparse
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.arguments import add_channel, add_mouth, add_preset, add_script, add_theme, size_in
from phonemeanalyser.cli.expression import add_expression, idle_of
from phonemeanalyser.cli.jobs import Job, analyse_with_progress, open_sound
from phonemeanalyser.cli.output_files import write_whole_file
from phonemeanalyser.cli.performing import add_performance, performing
from phonemeanalyser.cli.scripts import spoken_texts
from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.rendering.animation_player import AnimationPlayer
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.offscreen import OffscreenRenderer
from phonemeanalyser.rendering.renderer import colour_of
from phonemeanalyser.rendering.subdivision import subdivided
from phonemeanalyser.rendering.video import SoundTrack, why_no_film, why_no_gif, write_film, write_gif, write_pictures
from phonemeengine import (
    SAMPLE_RATE,
    MorphMesh,
    SoundReader,
    load_head,
    load_morph_mesh,
    load_morph_targets,
    load_preset,
    load_table,
    matched,
)
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.mouth.animation import Animation, animation_of
from phonemeengine.mouth.cues import MOST_ANTICIPATION, cues_of
from phonemeengine.mouth.table import USUAL_TABLE, shipped_tables

SMALLEST, LARGEST = 16, 4096
"""Pixels along an edge of the picture."""
RATE = 30.0
ASIDE, ABOVE = 0.22, 0.03
"""Where the camera is, radians: lips that come forwards are seen from a little aside."""
BLOCK = SAMPLE_RATE // 10
"""Samples of the sound that are encoded at a time."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is shown, and how."""
    parser.add_argument("file", type=Path, metavar="FILE", help="sound file")
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="OUT", help=".mp4, .gif or a folder for .png"
    )
    parser.add_argument("--fps", type=float, default=RATE, metavar="N", help=f"frames per second ({RATE:g})")
    size = size_in((SMALLEST, SMALLEST), (LARGEST, LARGEST))
    parser.add_argument("--size", type=size, default=(640, 640), metavar="WxH", help="pixels (640x640)")
    add_script(parser)
    add_preset(parser)
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=f"a file, or {', '.join(shipped_tables())}")
    add_mouth(parser)
    add_expression(parser)
    add_performance(parser)
    add_channel(parser)
    add_theme(parser)
    parser.add_argument("--mesh", type=Path, metavar="M", help="a face of yours: .obj, .glb, .gltf or .x")
    parser.add_argument("--movestates", type=Path, metavar="F", help="its movestates: .3dm or .3dma")


def run(options: argparse.Namespace) -> int:
    """Make the clip that the command line asks for."""
    _check_target(options.out, options.size)
    morph_mesh = subdivided(_morph_mesh_of(options.mesh, options.movestates))
    with open_sound(Job(options.file, options.out), options.channel) as reader:
        player = AnimationPlayer(morph_mesh, _animation_of(reader, options))
        if options.out.suffix.lower() == ".gif" and (reason := why_no_gif(len(player), options.fps)):
            raise RenderingError(reason)
        with OffscreenRenderer(morph_mesh, options.size) as offscreen:
            background = colour_of({"light": LIGHT, "dark": DARK}[options.theme].window)
            _write(options, reader, len(player), _pictures_of(player, morph_mesh, offscreen, background))
    return 0


def _check_target(out: Path, size: tuple[int, int]) -> None:
    kind = out.suffix.lower()
    if kind not in {"", ".mp4", ".gif"} and not out.is_dir():
        raise RenderingError(f"{out.name}: a preview is an .mp4, a .gif or a folder; name one of them with -o")
    if kind == ".mp4" and (reason := why_no_film(size)):
        raise RenderingError(reason)


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


def _animation_of(reader: SoundReader, options: argparse.Namespace) -> Animation:
    idle = idle_of(options)
    table, preset = load_table(options.table), load_preset(options.preset)
    if idle.expression is not None:
        idle.expression.check_fits(table.movestates, table.name)
    texts = spoken_texts(options, [options.file])
    analyses = analyse_with_progress(reader, preset, pitch=idle.head or options.performance is not None)
    with performing(options) as performer:
        if performer is not None:
            utterance, speech = texts.known(reader, options.file, analyses)
            return performer.track(utterance, speech).animation(speech, options.fps, idle)
    speech = texts.transcript(reader, options.file, analyses)
    ahead = MOST_ANTICIPATION if options.anticipation is None else options.anticipation
    cues = cues_of(speech.runs, table, minimum=options.minimum, anticipation=ahead)
    return animation_of(speech, cues, table, options.fps, idle)


def _pictures_of(
    player: AnimationPlayer,
    morph_mesh: MorphMesh,
    offscreen: OffscreenRenderer,
    background: tuple[float, float, float],
) -> Iterator[UInt8Array]:
    """Take the pictures with a progress bar."""
    camera = Camera.facing(morph_mesh.mesh).orbit(ASIDE, ABOVE)
    scenes = tqdm(player.scenes(), total=len(player), unit="frame", disable=None, leave=False, file=sys.stderr)
    for positions, pose in scenes:
        yield offscreen.picture(camera, positions, pose, background=background)


def _write(options: argparse.Namespace, reader: SoundReader, n_frames: int, pictures: Iterable[UInt8Array]) -> None:
    kind = options.out.suffix.lower()
    if kind == ".mp4":
        reader.seek(0)
        sound = SoundTrack(SAMPLE_RATE, reader.n_channels, _blocks_of(reader))
        write_whole_file(options.out, lambda file: write_film(file, pictures, options.size, options.fps, sound))
    elif kind == ".gif":
        write_whole_file(options.out, lambda file: write_gif(file, pictures, n_frames, options.fps))
    else:
        write_pictures(options.out, pictures)


def _blocks_of(reader: SoundReader) -> Iterator[Float32Array]:
    while len(block := reader.read(BLOCK)):
        yield block
