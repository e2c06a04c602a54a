"""The CSV of Live Link Face: a row a frame with time code, 52 blend shapes of ARKit and nine angles.

Unreal, Blender, Maya and MotionBuilder read it. The time code is HH:MM:SS:FF with thousandths of a frame; angles of
head and eyes are in radians.
"""

from collections.abc import Iterator

import numpy as np

from engine.mouth.exports.export import Export
from engine.mouth.exports.rows import lines_of

ANGLES = (
    "HeadYaw", "HeadPitch", "HeadRoll", "LeftEyeYaw", "LeftEyePitch", "LeftEyeRoll", "RightEyeYaw", "RightEyePitch",
    "RightEyeRoll",
)  # fmt: skip


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    animation = export.animation
    names = [name[0].upper() + name[1:] for name in animation.movestates]
    yield ",".join(["Timecode", "BlendShapeCount", *names, *ANGLES]) + "\n"
    count = len(names) + len(ANGLES)
    eyes = np.zeros((len(animation.weights), len(ANGLES) - 3), np.float32)
    rows = np.hstack((animation.weights, np.radians(animation.head), eyes))
    for frame, line in enumerate(lines_of(rows)):
        yield f"{timecode_of(frame, animation.rate)},{count},{line}\n"


def timecode_of(frame: int, rate: float) -> str:
    """Write the time code of a frame; a rate that is no whole number counts frames as its neighbour does."""
    seconds, rest = divmod(frame, max(round(rate), 1))
    minutes, seconds = divmod(seconds, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}:{rest:02d}.000"
