"""The CSV of Live Link Face: a row a frame with time code, 52 blend shapes of ARKit and nine angles.

Unreal, Blender, Maya and MotionBuilder read it. The time code is HH:MM:SS:FF with thousandths of a frame; angles of
head and eyes are in radians.
"""

from collections.abc import Iterable, Iterator

import numpy as np

from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import LIVE_LINK_ANGLES, LIVE_LINK_COLUMNS
from phonemeengine.mouth.exports.export import Export, number_lines
from phonemeengine.storage.files import begins_like

HEADER = ",".join(LIVE_LINK_COLUMNS)
COUNT = len(LIVE_LINK_COLUMNS) - 2

owns = begins_like(b"%s\n00:00:00:00\\.000,%d(?:,-?\\d\\.\\d{5}){%d}\n" % (HEADER.encode(), COUNT, COUNT))
"""Whether the content of a file was written here: the recording of an actor begins at the time of day, and has more
digits."""


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    return _lines(export.animation_blocks())


def lines_of(animation: Animation) -> Iterator[str]:
    """Return the lines of a file: the header, and a row for each frame of an animation of ARKit's movestates."""
    return _lines([animation])


def _lines(blocks: Iterable[Animation]) -> Iterator[str]:
    yield HEADER + "\n"
    frame = 0
    for block in blocks:
        eyes = np.zeros((len(block.weights), len(LIVE_LINK_ANGLES) - 3), np.float32)
        for line in number_lines(np.hstack((block.weights, np.radians(block.head), eyes))):
            yield f"{timecode_of(frame, block.rate)},{COUNT},{line}\n"
            frame += 1


def timecode_of(frame: int, rate: float) -> str:
    """Write the time code of a frame; a rate that is no whole number counts frames as its neighbour does."""
    seconds, rest = divmod(frame, max(round(rate), 1))
    minutes, seconds = divmod(seconds, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}:{rest:02d}.000"
