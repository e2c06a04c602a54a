"""Clips: heads that move, one or several side by side, as a film with sound, a .gif, or a folder of pictures."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from phonemeanalyser.rendering.animation_player import AnimationPlayer
from phonemeanalyser.rendering.camera import Camera
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeanalyser.rendering.errors import RenderingError
from phonemeanalyser.rendering.offscreen import OffscreenRenderer
from phonemeanalyser.rendering.renderer import colour_of
from phonemeanalyser.rendering.side_by_side import SideBySide
from phonemeanalyser.rendering.video import SoundTrack, why_no_film, why_no_gif, write_film, write_gif, write_pictures
from phonemeengine import Animation, ExportOptions, MorphMesh, SoundReader, Transcript, animation_of, load_table
from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.mouth.cues import MOST_ANTICIPATION
from phonemeengine.mouth.table import USUAL_TABLE
from phonemeengine.progress import Progress, no_progress, report_progress
from phonemeengine.replacing import Guard, guarded_write
from phonemeengine.settings import SAMPLE_RATE

ASIDE, ABOVE = 0.22, 0.03
"""Where the camera is, radians: lips that come forwards are seen from a little aside."""
BLOCK = SAMPLE_RATE // 10
"""Samples of the sound that are encoded at a time."""


REPLACING = Guard(overwrite=True)


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
    out: Path, morph_mesh: MorphMesh, animations: Sequence[Animation], options: ClipOptions,
    captions: Sequence[str] = (), sound: SoundTrack | None = None, progress: Progress = no_progress,
    guard: Guard = REPLACING,
) -> None:  # fmt: skip
    """Write a clip so that it is there complete, or not at all; a folder of pictures may be left in part.

    Parameters
    ----------
    out : an .mp4, a .gif, or a folder for pictures.
    morph_mesh : whose heads are seen.
    animations : of each head, from left to right; a shorter one stays at its end.
    captions : of each head; none for a single one.
    sound : what is heard in a film.
    progress : called with the share that is done, 0..1.
    guard : says whether a film that is there may be replaced.

    Raises
    ------
    EngineError : the guard keeps what is there.
    RenderingError : the mesh lacks the movestates, it cannot be drawn or written, or a .gif cannot be so long.
    Cancelled : `progress` did not want to go on.
    """
    n_frames = max(len(animation.weights) for animation in animations)
    if out.suffix.lower() == ".gif" and (reason := why_no_gif(n_frames, options.rate)):
        raise RenderingError(reason)
    players = [AnimationPlayer(morph_mesh, animation.held(n_frames)) for animation in animations]
    sheet = SideBySide(options.size, captions, options.theme.text, options.theme.window)
    with OffscreenRenderer(morph_mesh, sheet.head_size) as offscreen:
        heads = _pictures_of(players, morph_mesh, offscreen, options.theme.window, progress)
        _write(out, n_frames, map(sheet.picture, heads), options, sound, guard)


def animation_by_rules(speech: Transcript, options: ExportOptions, rate: float) -> Animation:
    """Return how a face says speech by the shapes of a mouth table, at a rate in frames per second.

    Raises
    ------
    MouthError : the table cannot be used.
    """
    ahead = MOST_ANTICIPATION if options.anticipation is None else options.anticipation
    table = load_table(options.table or USUAL_TABLE)
    return animation_of(speech, table, rate, options.idle, anticipation=ahead)


def sound_track(reader: SoundReader, start: float = 0.0, end: float | None = None) -> SoundTrack:
    """Return what is heard of an open sound between two times, seconds; to its end where the second is None."""
    first = round(start * SAMPLE_RATE)
    last = reader.n_samples if end is None else round(end * SAMPLE_RATE)
    return SoundTrack(SAMPLE_RATE, reader.n_channels, _blocks_of(reader, first, last))


def _pictures_of(
    players: Sequence[AnimationPlayer], morph_mesh: MorphMesh, offscreen: OffscreenRenderer, background: str,
    progress: Progress,
) -> Iterator[list[UInt8Array]]:  # fmt: skip
    """Take the pictures of all heads, frame by frame."""
    camera, colour = Camera.facing(morph_mesh.mesh).orbit(ASIDE, ABOVE), colour_of(background)
    for k, heads in enumerate(zip(*(player.scenes() for player in players), strict=True)):
        report_progress(progress, k / max(1, len(players[0])))
        yield [offscreen.picture(camera, positions, pose, background=colour, glow=True) for positions, pose in heads]


def _write(
    out: Path, n_frames: int, pictures: Iterable[UInt8Array], options: ClipOptions, sound: SoundTrack | None,
    guard: Guard,
) -> None:  # fmt: skip
    kind = out.suffix.lower()
    if kind not in {".mp4", ".gif"}:
        write_pictures(out, pictures)
        return
    with guarded_write(out, guard) as file:
        if kind == ".mp4":
            write_film(file, pictures, options.size, options.rate, sound)
        else:
            write_gif(file, pictures, n_frames, options.rate)


def _blocks_of(reader: SoundReader, first: int, last: int) -> Iterator[Float32Array]:
    reader.seek(first)
    while len(block := reader.read(min(BLOCK, last - reader.position))):
        yield block
