"""Action units as OpenFace writes them, a row a frame: time, turns of the head in radians, and intensities, 0..5.

Both sides of a face are one unit; where the blend shapes of ARKit have no unit for what moves, it is left out.
"""

from collections.abc import Iterator

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.blendshape_names import ARKIT, OPENFACE_POSE, STRONGEST_UNIT
from phonemeengine.mouth.exports.export import Export, number_lines
from phonemeengine.mouth.face_mapping import units_shown
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
        for line in number_lines(
            np.hstack((_turns_of(block.head), np.clip(block.weights @ mixed, 0, STRONGEST_UNIT)))
        ):
            yield f"{frame + 1},{frame / block.rate:.5f},1,1,{line}\n"
            frame += 1


# Turns: OpenFace's rotation is Rx Ry Rz, about axes to the right, down, and away from the camera, each counted as a
# right-handed turn about its axis. A head here rolls first, then nods, then turns: Ry Rx Rz.


def head_turns(pose: Float64Array) -> Float64Array:
    """Return yaw, pitch and roll of heads, degrees, of turns that OpenFace wrote, radians; both of shape (n, 3)."""
    (s1, s2, s3), (c1, c2, c3) = np.sin(pose).T, np.cos(pose).T
    yaw, pitch = np.arctan2(s2, c1 * c2), np.arcsin(s1 * c2)
    roll = np.arctan2(c1 * s3 + s1 * s2 * c3, c1 * c3 - s1 * s2 * s3)
    turns: Float64Array = np.degrees(np.stack([-yaw, -pitch, roll], axis=1))
    return turns


def _turns_of(head: Float32Array) -> Float64Array:
    """Return the turns that OpenFace would write of heads; the opposite of `head_turns`."""
    angles = np.radians(head) * (-1, -1, 1)
    (sy, sx, sz), (cy, cx, cz) = np.sin(angles).T, np.cos(angles).T
    rx, ry = np.arctan2(sx, cy * cx), np.arcsin(sy * cx)
    turns: Float64Array = np.stack([rx, ry, np.arctan2(cy * sz - sy * sx * cz, cy * cz + sy * sx * sz)], axis=1)
    return turns
