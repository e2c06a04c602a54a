"""Drawings on the frames of a film: each begins on a frame of its own."""

import math
from collections.abc import Iterator

from phonemeengine.mouth.cues import Cue, joined_runs
from phonemeengine.mouth.exports.export import Export
from phonemeengine.phonemes import Phoneme

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
