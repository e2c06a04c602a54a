"""Switch data of Moho, which OpenToonz and Blender read too: the frame, counted from 1, on which a drawing begins."""

from collections.abc import Iterator

from phonemeengine.mouth.exports.export import Export, drawings_on_frames
from phonemeengine.phonemes import Phoneme


def write(export: Export) -> Iterator[str]:
    """Write a line with frame and drawing for each change, and a mouth at rest at the end."""
    yield "MohoSwitch1\n"
    end = 0
    for first, end, cue in drawings_on_frames(export):  # noqa: B007 - the last end counts
        yield f"{first + 1} {cue.shape}\n"
    yield f"{end + 1} {export.table.phonemes[Phoneme.SILENCE]}\n"
