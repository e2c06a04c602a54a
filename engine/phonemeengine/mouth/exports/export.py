"""What is written: speech as cues, as drawings, and as the movement of a face."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from phonemeengine.mouth.animation import Animation, animation_blocks, animation_by, performer_of
from phonemeengine.mouth.cues import MOST_ANTICIPATION, Cue, joined_by_shape
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
    cues : what was said, cleaned; without gaps from 0 to the end. None where the format has no cues.
    rate : frames per second, where the format counts frames.
    idle : what else the face does.
    mesh : the file of the face that shall move, where the format holds one; None for the program's own head.
    movement : how the face moves, where the mouth table does not say that.
    anticipation : by how much a movement may begin before its sound at most, seconds.
    """

    speech: Transcript
    table: MouthTable
    cues: tuple[Cue, ...]
    rate: float
    idle: IdleMotion = field(default_factory=IdleMotion)
    mesh: Path | None = None
    movement: Animation | None = None
    anticipation: float = MOST_ANTICIPATION

    @cached_property
    def drawings(self) -> tuple[Cue, ...]:
        """The cues as drawings: neighbours of one shape are one."""
        return joined_by_shape(self.cues)

    @cached_property
    def animation(self) -> Animation:
        """The movement of the face."""
        if self.movement is not None:
            return self.movement
        return animation_by(self._performer(), self.speech, self.rate)

    def animation_blocks(self) -> Iterator[Animation]:
        """Return the movement of the face in consecutive parts, for formats that have a row a frame."""
        if self.movement is not None:
            yield self.movement
            return
        yield from animation_blocks(self._performer(), self.speech, self.rate)

    def _performer(self) -> Performer:
        return performer_of(self.speech, self.table, self.rate, self.idle, self.anticipation)
