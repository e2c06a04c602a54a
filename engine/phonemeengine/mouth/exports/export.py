"""What is written: speech as cues, as drawings, and as the movement of a face."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.animation import Animation, animation_blocks, animation_by, performer_of
from phonemeengine.mouth.cues import MOST_ANTICIPATION, Cue, joined_by_shape, joined_runs
from phonemeengine.mouth.key_layer import NO_KEYS, KeyLayer
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.transcript import Transcript
from phonemeengine.phonemes import Phoneme


def one_token(text: str) -> str:
    """Return a word without spaces, for formats that separate names by them."""
    return "_".join(text.split())


@dataclass(frozen=True)
class Export:
    """Everything that a format may write of one sound.

    Attributes
    ----------
    speech : what was said.
    table : the mouth shapes.
    cues : what was said, cleaned; without gaps from 0 to the end. None where the format has no cues.
    rate : frames per second, where the format counts frames.
    idle : what else the face does.
    mesh : the file of the face that shall move, where the format holds one; None for the program's own head.
    movement : how the face moves, where the mouth table does not say that.
    anticipation : by how much a movement may begin before its sound at most, seconds.
    keys : an animator's edits of the movement.
    """

    speech: Transcript
    table: MouthTable
    cues: tuple[Cue, ...]
    rate: float
    idle: IdleMotion = field(default_factory=IdleMotion)
    mesh: Path | None = None
    movement: Animation | None = None
    anticipation: float = MOST_ANTICIPATION
    keys: KeyLayer = NO_KEYS

    @cached_property
    def drawings(self) -> tuple[Cue, ...]:
        """The cues as drawings: neighbours of one shape are one."""
        return joined_by_shape(self.cues)

    @cached_property
    def animation(self) -> Animation:
        """The movement of the face."""
        made = self.movement or animation_by(self._performer(), self.speech, self.rate)
        return made.edited(self.keys)

    @cached_property
    def face_animation(self) -> Animation:
        """The movement, of the shapes of a face that the mouth table has other names for."""
        return self.animation.on_face(self.table)

    def animation_blocks(self) -> Iterator[Animation]:
        """Return the movement of the face in consecutive parts, for formats that have a row a frame."""
        made = [self.movement] if self.movement else animation_blocks(self._performer(), self.speech, self.rate)
        first = 0
        for block in made:
            yield block.edited(self.keys, first)
            first += len(block.weights)

    def _performer(self) -> Performer:
        return performer_of(self.speech, self.table, self.rate, self.idle, self.anticipation)


# Drawings on the frames of a film: each begins on a frame of its own.

NEARLY = 1e-6
"""Share of a frame by which times may differ where they are the same."""


def drawings_on_frames(export: Export) -> Iterator[tuple[int, int, Cue]]:
    """Return each drawing with its first frame and the frame after its last one, counted from 0.

    Of drawings that would begin on the same frame, the last one stays; but lips, teeth or tongue that meet have a
    frame of their own, however short they meet.
    """
    shown, before = _drawing_of_each_frame(export), -1
    for closure in _closures(export):
        lead = export.anticipation if export.speech.duration > closure.start > 0 else 0.0
        begin, end = (math.floor((time - lead) * export.rate) for time in (closure.start, closure.end))
        near = [frame for frame in range(max(begin, 0), end + 1) if frame < len(shown)]
        seen = [frame for frame in near if shown[frame].shape == closure.shape]
        if near and not seen:
            frames = range(max(near[0] - 1, before + 1), min(near[-1] + 2, len(shown)))
            seen = _free_frames(shown, frames, (closure.start + closure.end) / 2 - lead, export)[:1]
            for frame in seen:
                shown[frame] = closure
        before = max([before, *seen])
    first = 0
    for frame in range(1, len(shown) + 1):
        if frame == len(shown) or shown[frame] is not shown[first]:
            yield first, frame, shown[first]
            first = frame


def _drawing_of_each_frame(export: Export) -> list[Cue]:
    begun = [(frame_of(cue.start, export.rate), cue) for cue in export.drawings]
    end = max(frame_of(export.speech.duration, export.rate), 1)
    following = [frame for frame, _ in begun[1:]] + [end] * bool(begun)
    return [cue for (first, cue), after in zip(begun, following, strict=True) for _ in range(first, after)]


def _closures(export: Export) -> Iterator[Cue]:
    """Return each sound at which something meets, as it was said."""
    said = joined_runs((run for run in export.speech.runs if run.end > run.start), export.table)
    return (cue for cue in said if cue.phoneme is not Phoneme.SILENCE and export.table.closes(cue.phoneme, cue.phone))


def _free_frames(shown: list[Cue], frames: range, time: float, export: Export) -> list[int]:
    """Return those of some frames in which nothing else meets: that nearest to a time first."""
    free = (frame for frame in frames if not _closes(shown[frame], export))
    return sorted(free, key=lambda frame: abs((frame + 0.5) / export.rate - time))


def _closes(cue: Cue, export: Export) -> bool:
    return cue.phoneme is not Phoneme.SILENCE and export.table.closes(cue.phoneme, cue.phone)


def frame_of(time: float, rate: float) -> int:
    """Return the frame that is nearest to a time, seconds.

    Of two that are as near it is the later one for all times, however those are rounded: what lasts whole frames has
    as many.
    """
    return math.floor(time * rate + 0.5 + NEARLY)


# Weights as lines of numbers, fast: columns that never move cost nothing.

ROWS = 4096
"""Rows that are numbers of Python at a time, each of which takes eight times the memory."""


def number_lines(weights: Float32Array, separator: str = ",", digits: int = 5, rows: int = ROWS) -> Iterator[str]:
    """Return each row of weights, shape (n, n_columns), as text with a fixed number of digits."""
    moving = np.any(weights, axis=0)
    pattern = separator.join(f"%.{digits}f" if moves else f"{0:.{digits}f}" for moves in moving.tolist())
    for first in range(0, len(weights), rows):
        for row in weights[first : first + rows, moving].tolist():
            yield pattern % tuple(row)
