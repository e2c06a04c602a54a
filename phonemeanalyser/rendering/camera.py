"""Where a head is looked at from, and the light that it stands in."""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.mouth.idle_motion import HeadPose
from phonemeengine.mouth.mesh import Mesh
from phonemeengine.mouth.morph_mesh import Framing

# How a head turns on its neck.

NECK_LENGTH = 0.34
"""How far down the neck of a head with shoulders reaches from where it turns, as a share of all that is below."""
SHOULDERS = 1.4
"""What is below the neck are shoulders where it is this many times as wide as what is above."""


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


MOUTH_HEIGHT, MOUTH_SHARE = 0.25, 0.36
"""Where a mouth is in a head with its neck, from below, and how much of the head is seen around it, as shares."""
BUST_SHARE, BUST_DOWN = 1.3, 0.17
"""How much more than the head is seen of a bust, and how far its middle is below the head's, in its heights."""
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
    def facing(cls, mesh: Mesh, framing: Framing = Framing.FACE) -> "Camera":
        """Return the camera that sees a head from the front, of shoulders what is in the picture then.

        Parameters
        ----------
        framing : the face with its hair and neck, the mouth alone, or shoulders, too.
        """
        head = NeckPivot.of(mesh).turning(mesh)
        low, high = head.min(axis=0).astype(float), head.max(axis=0).astype(float)
        centre, height = (low + high) / 2, float(high[1] - low[1])
        across = float(np.linalg.norm((head - centre)[:, ::2], axis=1).max())
        radius = max(float(np.linalg.norm(mesh.positions - centre, axis=1).max()), 1e-6)
        whole = MARGIN * max(
            across / math.sin(FIELD_OF_VIEW / 2), across + (high - low)[1] / 2 / math.tan(FIELD_OF_VIEW / 2)
        )
        x, y, z = centre.tolist()
        far = max(whole, radius)
        if framing is Framing.MOUTH:
            return cls(0.0, 0.0, MOUTH_SHARE * far, (x, y - (0.5 - MOUTH_HEIGHT) * height, z), (x, y, z), radius, far)
        if framing is Framing.BUST and len(head) < len(mesh):
            return cls(0.0, 0.0, BUST_SHARE * far, (x, y - BUST_DOWN * height, z), (x, y, z), radius, far)
        return cls(0.0, 0.0, far, (x, y, z), (x, y, z), radius, far)

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
        """Return the camera some steps nearer; negative ones go away."""
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
    return np.array(
        [
            [scale * tall / aspect, 0, 0, 0],
            [0, scale * tall, 0, 0],
            [0, 0, (near + far) / (near - far), 2 * near * far / (near - far)],
            [0, 0, -1, 0],
        ]
    )


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
