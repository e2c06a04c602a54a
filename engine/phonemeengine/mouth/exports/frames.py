"""Drawings on the frames of a film: each begins on a frame of its own."""

import math
from collections.abc import Iterator

from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.exports.export import Export


def drawings_on_frames(export: Export) -> Iterator[tuple[int, int, Cue]]:
    """Return each drawing with its first frame and the frame after its last one, counted from 0.

    Of drawings that would begin on the same frame, the last one stays.
    """
    begun = [(frame_of(cue.start, export.rate), cue) for cue in export.drawings]
    end = max(frame_of(export.speech.duration, export.rate), 1)
    following = [frame for frame, _ in begun[1:]] + [end] * bool(begun)
    for (first, cue), after in zip(begun, following, strict=True):
        if after > first:
            yield first, after, cue


def frame_of(time: float, rate: float) -> int:
    """Return the frame that is nearest to a time, seconds."""
    return math.floor(time * rate + 0.5)
