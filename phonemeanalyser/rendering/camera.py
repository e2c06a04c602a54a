"""Where a head is looked at from."""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from phonemeanalyser.rendering.head_rotation import NeckPivot
from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.mesh import Mesh

FIELD_OF_VIEW = math.radians(24)
"""The angle between the upper and the lower edge of the picture; narrower in pictures that are taller than wide."""
HIGHEST = math.radians(85)
NEAREST, FARTHEST = 0.35, 4.0
"""Limits of the distance, as shares of that from which all is seen."""
PER_STEP = 0.9
"""By how much the distance shrinks with each step of zooming in."""
MOST_PAN = 0.75
"""How far the centre may be moved, as a share of the radius of what is looked at."""
MARGIN = 1.06
TURNING = 0.08
"""Room beside what is seen for a head that turns, as a share of it."""

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Camera:
    """A camera that looks at a point from all around it; moving it makes another.

    Attributes
    ----------
    azimuth : radians; 0 in front of the face, positive towards the viewer's right.
    elevation : radians; positive above.
    distance : from the centre, in units of the mesh: decimetres for the head that ships with the program.
    centre : what it looks at.
    home : where the centre was at first.
    radius : of what is looked at.
    whole : the distance from which all of it can be seen, from any side.
    """

    azimuth: float = 0.0
    elevation: float = 0.0
    distance: float = 10.0
    centre: Point = (0.0, 0.0, 0.0)
    home: Point = (0.0, 0.0, 0.0)
    radius: float = 2.0
    whole: float = 10.0

    @classmethod
    def facing(cls, mesh: Mesh) -> "Camera":
        """Return the camera that sees a head from the front, of shoulders what is in the picture then."""
        head = NeckPivot.of(mesh).turning(mesh)
        low, high = head.min(axis=0).astype(float), head.max(axis=0).astype(float)
        centre = (low + high) / 2
        across = float(np.linalg.norm((head - centre)[:, ::2], axis=1).max())
        radius = max(float(np.linalg.norm(mesh.positions - centre, axis=1).max()), 1e-6)
        whole = MARGIN * max(
            across / math.sin(FIELD_OF_VIEW / 2), across + (high - low)[1] / 2 / math.tan(FIELD_OF_VIEW / 2)
        )
        x, y, z = centre.tolist()
        return cls(0.0, 0.0, max(whole, radius), (x, y, z), (x, y, z), radius, max(whole, radius))

    def orbit(self, dx: float, dy: float) -> "Camera":
        """Return the camera after going round what it looks at: to the right and upwards, radians."""
        azimuth = math.remainder(self.azimuth + dx, 2 * math.pi)
        return replace(self, azimuth=azimuth, elevation=min(max(self.elevation + dy, -HIGHEST), HIGHEST))

    def pan(self, dx: float, dy: float) -> "Camera":
        """Return the camera moved sideways, to the right and upwards, in heights of the picture."""
        height = 2 * self.distance * math.tan(FIELD_OF_VIEW / 2)
        right, up, _ = self.axes
        moved = np.array(self.centre) + height * (dx * right + dy * up) - np.array(self.home)
        far = float(np.linalg.norm(moved))
        moved *= min(1.0, MOST_PAN * self.radius / far) if far else 1.0
        x, y, z = (np.array(self.home) + moved).tolist()
        return replace(self, centre=(x, y, z))

    def zoom(self, steps: float) -> "Camera":
        """Return the camera so many steps nearer; negative ones go away."""
        distance = self.distance * PER_STEP**steps
        return replace(self, distance=min(max(distance, NEAREST * self.whole), FARTHEST * self.whole))

    @property
    def eye(self) -> Float64Array:
        """Where the camera is, shape (3,)."""
        return np.array(self.centre) + self.distance * self.axes[2]

    def matrix(self, aspect: float) -> Float32Array:
        """Return what takes points to a picture that is `aspect` times as wide as high.

        Returns
        -------
        float32, shape (4, 4): OpenGL's clip coordinates are ``matrix @ (x, y, z, 1)``.
        """
        view = np.eye(4)
        view[:3, :3] = np.stack(self.axes)
        view[:3, 3] = -view[:3, :3] @ self.eye
        return np.asarray(_perspective(aspect, self._near, self._far) @ view, np.float32)

    def place_of(self, points: Float32Array, size: tuple[int, int]) -> tuple[int, int, int, int]:
        """Return where points, shape (n, 3), lie in a picture: left, lower edge, width and height, pixels.

        There is room around them for a head that turns; the whole picture, where one lies behind the camera.
        """
        width, height = size
        across = self.matrix(width / height)
        seen = points @ across[:, :3].T + across[:, 3]
        if seen[:, 3].min() <= 0:
            return 0, 0, width, height
        low, high = (edge(seen[:, :2] / seen[:, 3:], axis=0) for edge in (np.min, np.max))
        room = TURNING * (high - low)
        low, high = (np.clip((edge + 1) / 2, 0, 1) * size for edge in (low - room, high + room))
        (left, bottom), (right, top) = np.floor(low).astype(int).tolist(), np.ceil(high).astype(int).tolist()
        return left, bottom, max(1, right - left), max(1, top - bottom)

    @property
    def _near(self) -> float:
        return max(self.distance - 2 * self.radius, 0.01 * self.radius)

    @property
    def _far(self) -> float:
        return self.distance + 3 * self.radius

    @cached_property
    def axes(self) -> tuple[Float64Array, Float64Array, Float64Array]:
        """Return the directions to the right, upwards, and towards the viewer."""
        s, c, u, v = (f(a) for a in (self.azimuth, self.elevation) for f in (math.sin, math.cos))
        back = np.array([s * v, u, c * v])
        return np.array([c, 0.0, -s]), np.array([-s * u, v, -c * u]), back


def _perspective(aspect: float, near: float, far: float) -> Float64Array:
    scale = 1 / math.tan(FIELD_OF_VIEW / 2)
    tall = min(aspect, 1.0)
    return np.array([
        [scale * tall / aspect, 0, 0, 0],
        [0, scale * tall, 0, 0],
        [0, 0, (near + far) / (near - far), 2 * near * far / (near - far)],
        [0, 0, -1, 0],
    ])  # fmt: skip
