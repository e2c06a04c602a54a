"""How a head turns on its neck."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.head_motion import HeadPose
from phonemeengine.mouth.mesh import Mesh

NECK_LENGTH = 0.42
"""How far down the neck of a head with shoulders reaches from where it turns, as a share of all that is below."""
SHOULDERS = 1.4
"""What is below the neck are shoulders where it is so many times as wide as what is above."""


@dataclass(frozen=True)
class NeckPivot:
    """Where a head turns: about the origin where that lies inside the mesh, else about the middle of its lower edge.

    Attributes
    ----------
    pivot : the point that it turns about.
    stem : heights: below the first nothing turns, such as shoulders; above the second everything.
    """

    pivot: tuple[float, float, float]
    stem: tuple[float, float]

    @classmethod
    def of(cls, mesh: Mesh) -> "NeckPivot":
        """Find the neck of a mesh."""
        low, high = mesh.positions.min(axis=0).astype(float), mesh.positions.max(axis=0).astype(float)
        if np.all((low < 0) & (high > 0)):
            neck = NECK_LENGTH * float(low[1])
            below = mesh.positions[:, 1] < neck
            widths = [float(np.abs(mesh.positions[where, 0]).max()) for where in (below, ~below)]
            return cls((0.0, 0.0, 0.0), (neck if widths[0] > SHOULDERS * widths[1] else float(low[1]), 0.0))
        x, _, z = ((low + high) / 2).tolist()
        bottom = float(low[1])
        return cls((x, bottom, z), (bottom - 2.0, bottom - 1.0))

    def turning(self, mesh: Mesh) -> Float32Array:
        """Return the vertices of the head and its neck, without shoulders, shape (n, 3)."""
        return mesh.positions[mesh.positions[:, 1] >= self.stem[0]]


def rotation_of(pose: HeadPose) -> Float32Array:
    """Return what turns a head as a pose says, float32, shape (3, 3): it nods, then turns; rolls first of all."""
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - 150 ms that a window should not wait for

    turn = Rotation.from_euler("YXZ", (pose.yaw, -pose.pitch, -pose.roll), degrees=True)
    return np.asarray(turn.as_matrix(), np.float32)
