"""Clips: heads that move, one or several side by side, as a film with sound, a .gif, or a folder of pictures."""

import argparse
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from tqdm import tqdm

from phonemeanalyser.cli.output_files import write_whole_file
from phonemeanalyser.colours import DARK, LIGHT
from phonemeanalyser.rendering.animation_player import AnimationPlayer
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.offscreen import OffscreenRenderer
from phonemeanalyser.rendering.renderer import colour_of
from phonemeanalyser.rendering.side_by_side import SideBySide
from phonemeanalyser.rendering.video import SoundTrack, why_no_film, why_no_gif, write_film, write_gif, write_pictures
from phonemeengine import SAMPLE_RATE, Animation, MorphMesh, SoundReader
from phonemeengine.arrays import Float32Array, UInt8Array

ASIDE, ABOVE = 0.22, 0.03
"""Where the camera is, radians: lips that come forwards are seen from a little aside."""
BLOCK = SAMPLE_RATE // 10
"""Samples of the sound that are encoded at a time."""


def check_clip(out: Path, size: tuple[int, int]) -> None:
    """Refuse a clip that cannot be written, before anything is made of it.

    Raises
    ------
    RenderingError : it has no kind that there is, or another size than films have.
    """
    kind = out.suffix.lower()
    if kind not in {"", ".mp4", ".gif"} and not out.is_dir():
        raise RenderingError(f"{out.name}: a preview is an .mp4, a .gif or a folder; name one of them with -o")
    if kind == ".mp4" and (reason := why_no_film(size)):
        raise RenderingError(reason)


def write_clip(
    options: argparse.Namespace,
    morph_mesh: MorphMesh,
    animations: Sequence[Animation],
    captions: Sequence[str] = (),
    sound: SoundTrack | None = None,
) -> None:
    """Write the clip of a command line with the arguments of `add_clip`.

    Parameters
    ----------
    morph_mesh : whose heads are seen.
    animations : of each head, from left to right; equally long.
    captions : of each head; none for a single one.
    sound : what is heard in a film.

    Raises
    ------
    RenderingError : the mesh lacks the movestates, it cannot be drawn, or a .gif cannot be so long.
    EngineError : it cannot be written.
    """
    n_frames = len(animations[0].weights)
    if options.out.suffix.lower() == ".gif" and (reason := why_no_gif(n_frames, options.fps)):
        raise RenderingError(reason)
    theme = {"light": LIGHT, "dark": DARK}[options.theme]
    players = [AnimationPlayer(morph_mesh, animation) for animation in animations]
    sheet = SideBySide(options.size, captions, theme.text, theme.window)
    with OffscreenRenderer(morph_mesh, sheet.head_size) as offscreen:
        pictures = map(sheet.picture, _pictures_of(players, morph_mesh, offscreen, theme.window))
        _write(options, n_frames, pictures, sound)


def sound_track(reader: SoundReader, start: float = 0.0, end: float | None = None) -> SoundTrack:
    """Return what is heard of an open sound between two times, seconds; to its end where the second is None."""
    first = round(start * SAMPLE_RATE)
    last = reader.n_samples if end is None else round(end * SAMPLE_RATE)
    return SoundTrack(SAMPLE_RATE, reader.n_channels, _blocks_of(reader, first, last))


def _pictures_of(
    players: Sequence[AnimationPlayer], morph_mesh: MorphMesh, offscreen: OffscreenRenderer, background: str
) -> Iterator[list[UInt8Array]]:
    """Take the pictures of all heads, frame by frame, with a progress bar."""
    camera, colour = Camera.facing(morph_mesh.mesh).orbit(ASIDE, ABOVE), colour_of(background)
    scenes = zip(*(player.scenes() for player in players), strict=True)
    bar = tqdm(scenes, total=len(players[0]), unit="frame", disable=None, leave=False, file=sys.stderr)
    for heads in bar:
        yield [offscreen.picture(camera, positions, pose, background=colour) for positions, pose in heads]


def _write(
    options: argparse.Namespace, n_frames: int, pictures: Iterable[UInt8Array], sound: SoundTrack | None
) -> None:
    kind = options.out.suffix.lower()
    if kind == ".mp4":
        write_whole_file(options.out, lambda file: write_film(file, pictures, options.size, options.fps, sound))
    elif kind == ".gif":
        write_whole_file(options.out, lambda file: write_gif(file, pictures, n_frames, options.fps))
    else:
        write_pictures(options.out, pictures)


def _blocks_of(reader: SoundReader, first: int, last: int) -> Iterator[Float32Array]:
    reader.seek(first)
    while len(block := reader.read(min(BLOCK, last - reader.position))):
        yield block
