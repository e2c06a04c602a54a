"""The light that a head stands in."""

import math
from dataclasses import dataclass

import numpy as np

from phonemeanalyser.rendering.camera import Camera, Point
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.mesh import Mesh

MORE = 1.12
"""The key light sees so much more than the mesh at rest."""


@dataclass(frozen=True)
class Light:
    """Where the key light comes from, and how strong all light is; lights go with the camera.

    Attributes
    ----------
    azimuth, elevation : of the key light, radians, as the viewer sees it: to the right and above.
    strength : 1 is usual.
    """

    azimuth: float = -0.62
    elevation: float = 0.62
    strength: float = 1.0


LIGHT = Light()


def direction_of(camera: Camera, azimuth: float, elevation: float) -> Float64Array:
    """Return the direction towards a light that the viewer sees there, shape (3,), of length 1."""
    flat = math.cos(elevation)
    seen = (math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat)
    return np.asarray(seen @ np.stack(camera.axes))


@dataclass(frozen=True)
class BoundingSphere:
    """What the key light shines on: a ball around a mesh, and room for jaws that open and heads that turn."""

    centre: Point
    radius: float

    @classmethod
    def around(cls, mesh: Mesh) -> "BoundingSphere":
        """Return the room that a mesh needs."""
        low, high = mesh.positions.min(axis=0).astype(float), mesh.positions.max(axis=0).astype(float)
        x, y, z = ((low + high) / 2).tolist()
        return cls((x, y, z), MORE * max(float(np.linalg.norm(high - low)) / 2, 1e-6))

    def seen_from(self, towards: Float64Array) -> Float32Array:
        """Return what takes points to the picture that a light far away in a direction sees, shape (4, 4)."""
        right = np.cross((0.0, 1.0, 0.0), towards)
        right = right / np.linalg.norm(right) if np.any(right) else np.array((1.0, 0.0, 0.0))
        view = np.eye(4)
        view[:3, :3] = np.stack((right, np.cross(towards, right), -towards)) / self.radius
        view[:3, 3] = -view[:3, :3] @ self.centre
        return np.asarray(view, np.float32)
