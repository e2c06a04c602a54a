"""The CSV of Live Link Face: a row a frame with time code, 52 blend shapes of ARKit and nine angles.

Unreal, Blender, Maya and MotionBuilder read it. The time code is HH:MM:SS:FF with thousandths of a frame; angles of
head and eyes are in radians.
"""

from collections.abc import Iterator

import numpy as np

from phonemeengine.files import begins_like
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import LIVE_LINK_ANGLES, LIVE_LINK_COLUMNS
from phonemeengine.mouth.exports.export import Export
from phonemeengine.mouth.exports.number_lines import number_lines

HEADER = ",".join(LIVE_LINK_COLUMNS)
COUNT = len(LIVE_LINK_COLUMNS) - 2

owns = begins_like(b"%s\n00:00:00:00\\.000,%d(?:,-?\\d\\.\\d{5}){%d}\n" % (HEADER.encode(), COUNT, COUNT))
"""Whether the content of a file was written here: the recording of an actor begins at the time of day, and has more
digits."""


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    return lines_of(export.animation)


def lines_of(animation: Animation) -> Iterator[str]:
    """Return the lines of a file: the header, and a row for each frame of an animation of ARKit's movestates."""
    yield HEADER + "\n"
    eyes = np.zeros((len(animation.weights), len(LIVE_LINK_ANGLES) - 3), np.float32)
    rows = np.hstack((animation.weights, np.radians(animation.head), eyes))
    for frame, line in enumerate(number_lines(rows)):
        yield f"{timecode_of(frame, animation.rate)},{COUNT},{line}\n"


def timecode_of(frame: int, rate: float) -> str:
    """Write the time code of a frame; a rate that is no whole number counts frames as its neighbour does."""
    seconds, rest = divmod(frame, max(round(rate), 1))
    minutes, seconds = divmod(seconds, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}:{rest:02d}.000"
