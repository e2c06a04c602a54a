"""What is written: speech as cues, as drawings, and as the movement of a face."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from phonemeengine.mouth.animation import Animation, animation_blocks, animation_of
from phonemeengine.mouth.cues import Cue, joined_by_shape
from phonemeengine.mouth.performer import IdleMotion, Performer
from phonemeengine.mouth.table import MouthTable
from phonemeengine.mouth.transcript import Transcript


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
    cues : what was said, cleaned; without gaps from 0 to the end.
    rate : frames per second, where the format counts frames.
    idle : what else the face does.
    mesh : the file of the face that shall move, where the format holds one; None for the program's own head.
    movement : how the face moves, where the cues do not say that.
    """

    speech: Transcript
    table: MouthTable
    cues: tuple[Cue, ...]
    rate: float
    idle: IdleMotion = field(default_factory=IdleMotion)
    mesh: Path | None = None
    movement: Animation | None = None

    @cached_property
    def drawings(self) -> tuple[Cue, ...]:
        """The cues as drawings: neighbours of one shape are one."""
        return joined_by_shape(self.cues)

    @cached_property
    def animation(self) -> Animation:
        """The movement of the face."""
        if self.movement is not None:
            return self.movement
        return animation_of(self.speech, self.cues, self.table, self.rate, self.idle)

    def animation_blocks(self) -> Iterator[Animation]:
        """Return the movement of the face in consecutive parts, for formats that have a row a frame."""
        if self.movement is not None:
            yield self.movement
            return
        performer = Performer(self.table, self.idle)
        performer.follow(self.cues)
        yield from animation_blocks(performer, self.speech, self.rate)
