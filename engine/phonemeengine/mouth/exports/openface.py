"""Action units as OpenFace writes them, a row a frame: time, turns of the head in radians, and intensities, 0..5.

Both sides of a face are one unit; where the blend shapes of ARKit have no unit for what moves, it is left out.
"""

from collections.abc import Iterator

import numpy as np

from phonemeengine.mouth.action_units import units_shown
from phonemeengine.mouth.blendshape_names import ARKIT, OPENFACE_POSE, STRONGEST_UNIT
from phonemeengine.mouth.exports.export import Export, number_lines
from phonemeengine.storage.files import begins_like

START = "frame,timestamp,confidence,success,"
owns = begins_like(START.encode() + b"pose_Rx,pose_Ry,pose_Rz,AU01_r,[A-Z0-9_r,]+\n1,0\\.00000,1,1,")
"""Whether the content of a file was written here: OpenFace itself has other columns between these."""


def write(export: Export) -> Iterator[str]:
    """Write the header and a row for each frame."""
    units = units_shown()
    mixed = np.zeros((len(ARKIT), len(units)), np.float32)
    for k, shapes in enumerate(units.values()):
        mixed[[ARKIT.index(shape) for shape in shapes], k] = STRONGEST_UNIT / len(shapes)
    yield START + ",".join((*OPENFACE_POSE, *(f"{name}_r" for name in units))) + "\n"
    frame = 0
    for block in export.animation_blocks():
        yaw, pitch, roll = np.radians(block.head).T
        turns = np.stack([-pitch, -yaw, roll], axis=1)
        for line in number_lines(np.hstack((turns, np.clip(block.weights @ mixed, 0, STRONGEST_UNIT)))):
            yield f"{frame + 1},{frame / block.rate:.5f},1,1,{line}\n"
            frame += 1
