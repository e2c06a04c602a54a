"""How a head turns on its neck."""

import math
from dataclasses import dataclass

import numpy as np

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
    (s, c), (u, v), (p, q) = (
        (math.sin(math.radians(angle)), math.cos(math.radians(angle))) for angle in (pose.yaw, pose.pitch, pose.roll)
    )
    yaw = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    pitch = np.array([[1, 0, 0], [0, v, u], [0, -u, v]])
    roll = np.array([[q, p, 0], [-p, q, 0], [0, 0, 1]])
    return np.asarray(yaw @ pitch @ roll, np.float32)
