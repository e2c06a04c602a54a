"""How a head turns on its neck."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from phonemeanalyser.rendering.camera import Point
from phonemeengine.arrays import Float32Array
from phonemeengine.mouth.head_motion import HeadPose
from phonemeengine.mouth.mesh import Mesh


@dataclass(frozen=True)
class NeckPivot:
    """Where a head turns: about the origin where that lies inside the mesh, else about the middle of its lower edge.

    Attributes
    ----------
    pivot : the point that it turns about.
    stem : heights: below the first nothing turns, above the second everything.
    """

    pivot: Point
    stem: tuple[float, float]

    @classmethod
    def of(cls, mesh: Mesh) -> "NeckPivot":
        """Find the neck of a mesh."""
        low, high = mesh.positions.min(axis=0).astype(float), mesh.positions.max(axis=0).astype(float)
        if np.all((low < 0) & (high > 0)):
            return cls((0.0, 0.0, 0.0), (float(low[1]), 0.0))
        x, _, z = ((low + high) / 2).tolist()
        bottom = float(low[1])
        return cls((x, bottom, z), (bottom - 2.0, bottom - 1.0))


def rotation_of(pose: HeadPose) -> Float32Array:
    """Return what turns a head as a pose says, float32, shape (3, 3): it nods, then turns; rolls first of all."""
    turn = Rotation.from_euler("YXZ", (pose.yaw, -pose.pitch, -pose.roll), degrees=True)
    return np.asarray(turn.as_matrix(), np.float32)
