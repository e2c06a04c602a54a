"""``phonemeanalyser preview``: a head says a sound file, as a film, a .gif, or a folder of pictures."""

import argparse
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from phonemeengine.audio.files import SoundReader
from phonemeengine.audio.file_access import shown_name
from phonemeengine.mouth.animation import Animation, Life, animation_of
from phonemeengine.mouth.cues import MOST_ANTICIPATION, cues_of
from phonemeengine.mouth.morph_mesh import Figure, fitted
from phonemeengine.mouth.files.io import load_face, load_figure
from phonemeengine.mouth.head import load_head
from phonemeengine.mouth.morpher import Detail
from phonemeengine.mouth.utterance import speech_of
from phonemeengine.mouth.table import USUAL_TABLE, load_table, shipped_tables
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from phonemeanalyser.cli.arguments import add_channel, add_mouth
from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.cli.jobs import Job, sound_of, watched
from phonemeanalyser.rendering.animation_player import Actor
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.video import Sound, why_no_film, why_no_gif, write_film, write_gif, write_pictures
from phonemeanalyser.rendering.offscreen import Photographer, Picture
from phonemeanalyser.rendering.renderer import colour_of
from phonemeanalyser.rendering.subdivision import smoothed
from phonemeanalyser.cli.output_files import write_whole_file

SMALLEST, LARGEST = 16, 4096
"""Pixels along an edge of the picture."""
RATE = 30.0
ASIDE, ABOVE = 0.22, 0.03
"""Where the camera is, radians: lips that come forwards are seen from a little aside."""
BLOCK = SAMPLE_RATE // 10
"""Samples of the sound that are encoded at a time."""


def preview(words: list[str]) -> int:
    """Make the clip that the command line asks for."""
    options = _options(words)
    _check_target(options.out, options.size)
    figure = smoothed(_figure_of(options.mesh, options.movestates))
    with sound_of(Job(options.file, options.out), options.channel) as reader:
        actor = Actor(figure, _animation_of(reader, options))
        if options.out.suffix.lower() == ".gif" and (reason := why_no_gif(len(actor), options.fps)):
            raise RenderingError(reason)
        with Photographer(figure, options.size) as photographer:
            background = colour_of({"light": LIGHT, "dark": DARK}[options.theme].window)
            _write(options, reader, len(actor), _pictures_of(actor, figure, photographer, background))
    return 0


def _check_target(out: Path, size: tuple[int, int]) -> None:
    kind = out.suffix.lower()
    if kind not in {"", ".mp4", ".gif"} and not out.is_dir():
        raise RenderingError(f"{out.name}: a preview is an .mp4, a .gif or a folder; name one of them with -o")
    if kind == ".mp4" and (reason := why_no_film(size)):
        raise RenderingError(reason)


def _figure_of(mesh: Path | None, movestates: Path | None) -> Figure:
    """Give the head that ships with the program, or a mesh with its movestates."""
    if mesh is None:
        if movestates is not None:
            raise RenderingError(f"{movestates.name}: movestates move a mesh of their own; name it with --mesh")
        return load_head()
    figure = load_figure(mesh)
    if movestates is not None:
        figure = Figure(figure.mesh, fitted(load_face(movestates), figure.mesh).states)
    if not figure.states:
        raise RenderingError(f"{mesh.name}: there are no morph targets in it; name its movestates with --movestates")
    return figure


def _animation_of(reader: SoundReader, options: argparse.Namespace) -> Animation:
    life = Life(not options.no_blinks, not options.no_head, options.seed, Detail(options.detail))
    table, preset = load_table(options.table), load_preset(options.preset)
    name = shown_name(options.file)
    speech = speech_of(watched(reader, preset, pitch=life.head), name, reader.duration)
    ahead = MOST_ANTICIPATION if options.anticipation is None else options.anticipation
    cues = cues_of(speech.runs, table, minimum=options.minimum, anticipation=ahead)
    return animation_of(speech, cues, table, options.fps, life)


def _pictures_of(
    actor: Actor, figure: Figure, photographer: Photographer, background: tuple[float, float, float]
) -> Iterator[Picture]:
    """Take the pictures with a progress bar."""
    camera = Camera.facing(figure.mesh).orbit(ASIDE, ABOVE)
    scenes = tqdm(actor.scenes(), total=len(actor), unit="frame", disable=None, leave=False, file=sys.stderr)
    for positions, pose in scenes:
        yield photographer.picture(camera, positions, pose, background=background)


def _write(options: argparse.Namespace, reader: SoundReader, n_frames: int, pictures: Iterable[Picture]) -> None:
    kind = options.out.suffix.lower()
    if kind == ".mp4":
        reader.seek(0)
        sound = Sound(SAMPLE_RATE, reader.n_channels, _blocks_of(reader))
        write_whole_file(options.out, lambda file: write_film(file, pictures, options.size, options.fps, sound))
    elif kind == ".gif":
        write_whole_file(options.out, lambda file: write_gif(file, pictures, n_frames, options.fps))
    else:
        write_pictures(options.out, pictures)


def _blocks_of(reader: SoundReader) -> Iterator[NDArray[np.float32]]:
    while len(block := reader.read(BLOCK)):
        yield block


def _options(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="phonemeanalyser preview", description="Make a clip in which a head says a sound file."
    )
    parser.add_argument("file", type=Path, metavar="FILE", help="sound file")
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="OUT", help=".mp4, .gif or a folder for .png"
    )
    parser.add_argument("--fps", type=float, default=RATE, metavar="N", help=f"frames per second ({RATE:g})")
    parser.add_argument("--size", type=_size, default=(640, 640), metavar="WxH", help="pixels (640x640)")
    parser.add_argument("--preset", type=Path, default=DEFAULT_PRESET, help="preset (.toml) or PhonemeData file")
    parser.add_argument("--table", default=USUAL_TABLE, metavar="T", help=f"a file, or {', '.join(shipped_tables())}")
    add_mouth(parser)
    add_channel(parser)
    parser.add_argument("--theme", choices=["light", "dark"], default="light")
    parser.add_argument("--mesh", type=Path, metavar="M", help="a face of yours: .obj, .glb, .gltf or .x")
    parser.add_argument("--movestates", type=Path, metavar="F", help="its movestates: .3dm or .3dma")
    parser.add_argument("--no-blinks", action="store_true", help="keep the eyes open")
    parser.add_argument("--no-head", action="store_true", help="keep the head still")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="another number makes another face")
    return parser.parse_args(words)


def _size(text: str) -> tuple[int, int]:
    try:
        width, height = (int(part) for part in text.lower().split("x"))
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be like 640x640, got {text!r}") from None
    if not (SMALLEST <= width <= LARGEST and SMALLEST <= height <= LARGEST):
        raise argparse.ArgumentTypeError(f"must lie in {SMALLEST}..{LARGEST} both ways, got {text!r}")
    return width, height
