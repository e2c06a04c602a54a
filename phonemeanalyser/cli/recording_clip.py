"""``phonemeanalyser performance show``: a recording as a clip: the face as it was tracked, with its sound."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tqdm import tqdm

import phonemeengine
from phonemeanalyser.cli.arguments import given
from phonemeanalyser.cli.jobs import say_note
from phonemeanalyser.rendering.clip import check_clip, sound_track, write_clip
from phonemeanalyser.rendering.clip_options import ClipOptions
from phonemeanalyser.rendering.surface import subdivided
from phonemeanalyser.rendering.video import SoundTrack
from phonemeengine.conversion.spoken_texts import open_sound
from phonemeengine.execution import Progress
from phonemeengine.mouth.animation import animation_by
from phonemeengine.performance.recording import Performance
from phonemeengine.storage.files import printable
from phonemeengine.storage.replacing import STANDARD_OUTPUT, Guard, output_path

MILLISECOND = 0.001
"""The times of units are written as exactly."""


def write_recording_clip(options: argparse.Namespace) -> None:
    """Write the clip that the command line asks for.

    Raises
    ------
    EngineError : the table has no such recording, or the clip cannot be made.
    """
    printed = options.out == STANDARD_OUTPUT
    look = ClipOptions.of(given(options))
    check_clip(Path("clip.mp4") if printed else options.out, look)
    with phonemeengine.PerformanceTable.open(options.table) as table, ExitStack() as stack:
        performance = table.recording_called(options.recording)
        start, end = _part_of(performance, options)
        animation = _animation_of(performance, start, end, look.rate)
        caption = f"{performance.name}, as recorded: {table.about.title}"
        sound = _sound_of(table, start, end, options, stack)
        head = subdivided(phonemeengine.load_head())
        with _frames_bar(len(animation.weights)) as progress:
            guard = Guard(overwrite=options.overwrite)
            with output_path(options.out, ".mp4") as path:
                write_clip(path, head, [animation], look, [caption], sound, progress, guard)


def _part_of(performance: Performance, options: argparse.Namespace) -> tuple[float, float]:
    """Return from when to when the recording is shown, seconds."""
    duration, start = performance.duration, options.start or 0.0
    end = duration if options.end is None else options.end
    if not 0 <= start < end <= duration + MILLISECOND:
        raise phonemeengine.EngineError(
            f"{printable(performance.name)}: --from and --to must lie in 0..{duration:.3f} s, the second behind the "
            f"first, got {start:g} and {end:g}; choose others"
        )
    return start, end


def _animation_of(performance: Performance, start: float, end: float, rate: float) -> phonemeengine.Animation:
    face = phonemeengine.RecordedFace(performance)
    performer = phonemeengine.Performer(
        phonemeengine.face_table(), phonemeengine.IdleMotion(blinks=False, head=face.head(start) is not None)
    )
    performer.play(face, -start)
    return animation_by(performer, phonemeengine.Transcript(performance.name, end - start), rate)


def _sound_of(
    table: phonemeengine.PerformanceTable, start: float, end: float, options: argparse.Namespace, stack: ExitStack
) -> SoundTrack | None:
    """Return the sound of a recording, for a film; None, which is reported, where its sound is not found."""
    if options.out != STANDARD_OUTPUT and options.out.suffix.lower() != ".mp4":
        return None
    path = phonemeengine.original_sound(table, options.recording)
    if path is None:
        say_note(table.about.name, f"the sound of {printable(options.recording)} is not where it was; there is none")
        return None
    return sound_track(stack.enter_context(open_sound(path, phonemeengine.Channel.MIX, say_note)), start, end)


@contextmanager
def _frames_bar(n_frames: int) -> Iterator[Progress]:
    """Show a bar at terminals."""
    with tqdm(total=n_frames, unit="frame", disable=None, leave=False, file=sys.stderr) as bar:

        def show(share: float) -> bool:
            bar.update(round(share * n_frames) - bar.n)
            return True

        yield show
