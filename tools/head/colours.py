"""Paints the head: skin, lips, brows, teeth, tongue, the dark inside, and the rings of an eye."""

import numpy as np
from numpy.typing import NDArray

Colours = NDArray[np.uint8]
Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

SKIN, LIPS, BROWS, INSIDE = (216, 172, 150), (184, 108, 100), (84, 58, 46), (84, 32, 32)
BLUSH, STUBBLE, LID = (210, 140, 122), (196, 156, 138), (196, 142, 124)
HAIR, STRAND = (66, 48, 38), (104, 78, 60)
TEETH, TONGUE = (236, 230, 214), (176, 86, 86)
SHADED = 0.66
"""Of the lower teeth, which stand in the lips' shade."""
EYE = {"pupil": (0, 2), "iris": (3, 6), "white": (7, 12)}
"""First and last ring of each."""
PUPIL, IRIS, LIMBUS, WHITE = (16, 14, 14), (104, 138, 156), (44, 62, 78), (238, 236, 232)

HAIRLINE = np.radians([0, 25, 48, 62, 74, 100, 122, 150, 180]), (9.00, 9.00, 8.93, 8.62, 8.42, 8.42, 8.02, 7.83, 7.80)
"""How high the hair begins, by the angle from the gaze around the head's axis."""
HAIR_AXIS, HAIR_EDGE = (0.0, 0.42), 0.11
"""Where that axis stands, and over what height the hair begins."""
MOUTH_WIDTH, MOUTH_HEIGHT, LIPS_FRONT = 0.235, 7.492, 1.28
EYE_AT = (0.305, 8.27, 1.44)
BLUSHING = (((0.38, 7.92, 1.28), 0.34), ((0.0, 7.84, 1.72), 0.22), ((0.80, 8.05, 0.35), 0.42))
"""Where blood shines through, and how far around."""
UPPER_LIP, LOWER_LIP = 0.088, 0.100
"""Half the width of the mouth, where its corners are, and how high the lips are above and below them."""


def painted(points: Floats, triangles: Numbers, part: NDArray[np.uint8]) -> Colours:
    """Give each vertex of skin, teeth and tongue its colour, uint8, shape (n, 3)."""
    colours = np.tile(np.float32(SKIN), (len(points), 1))
    _tint(colours, STUBBLE, 0.8 * _stubble(points))
    _tint(colours, BLUSH, 0.65 * _blush(points))
    _tint(colours, LID, 0.7 * _near(points, EYE_AT, 0.17))
    _tint(colours, BROWS, 0.8 * _brows(points))
    _tint(colours, HAIR, 0.94 * hair_share(points))
    _tint(colours, STRAND, 0.5 * hair_share(points) * _strands(points))
    _tint(colours, LIPS, _lips(points))
    _tint(colours, INSIDE, _hidden(points, triangles).astype(np.float32))
    depth = 0.35 + 0.65 * np.clip((points[:, 2:] - 1.05) / 0.4, 0, 1)
    colours = np.where((part == 2)[:, np.newaxis], np.float32(TEETH) * depth * SHADED, colours)
    colours = np.where((part == 5)[:, np.newaxis], np.float32(TEETH) * depth, colours)
    colours = np.where((part == 4)[:, np.newaxis], np.float32(TONGUE) * depth, colours)
    return np.round(colours).astype(np.uint8)


def eye_colours(ring: Numbers) -> Colours:
    """Give the colours of an eye's vertices, which lie in rings around the gaze."""
    colours = np.tile(np.float32(WHITE), (len(ring), 1))
    colours[ring <= EYE["pupil"][1]] = PUPIL
    first, last = EYE["iris"]
    share = np.clip((ring - first) / (last - first), 0, 1)[:, np.newaxis] ** 2
    iris = (1 - share) * np.float32(IRIS) + share * np.float32(LIMBUS)
    among = (ring >= first) & (ring <= last)
    colours[among] = iris[among]
    return np.round(colours).astype(np.uint8)


def _tint(colours: Floats, colour: tuple[int, int, int], share: Floats) -> None:
    colours += share[:, np.newaxis] * (np.float32(colour) - colours)


def _lips(points: Floats) -> Floats:
    x, y, z = points.T
    bow = np.clip(1 - (x / MOUTH_WIDTH) ** 2, 0, None)
    above = (y - MOUTH_HEIGHT) / (UPPER_LIP * bow**0.6 + 1e-6)
    below = (MOUTH_HEIGHT - y) / (LOWER_LIP * bow**0.5 + 1e-6)
    inside = np.clip((1.25 - np.maximum(above, below)) / 0.25, 0, 1)
    return np.where(z > LIPS_FRONT, inside, 0).astype(np.float32)


def hair_share(points: Floats) -> Floats:
    """Tell where hair grows: 1 there, 0 on bare skin."""
    return np.clip(_above_hairline(points) / HAIR_EDGE, 0, 1).astype(np.float32)


def hairline_region(points: Floats) -> NDArray[np.bool_]:
    """Tell which vertices lie about the edge of the hair."""
    return (np.abs(_above_hairline(points)) < 0.16) & (points[:, 1] > 7.7)


def _above_hairline(points: Floats) -> Floats:
    x, y, z = points.T
    angle = np.arctan2(np.abs(x - HAIR_AXIS[0]), z - HAIR_AXIS[1])
    line = np.interp(angle, *HAIRLINE)
    ear = (np.abs(x) > 0.775) & (y < 8.5)
    return np.where(ear, -1.0, y - line).astype(np.float32)


def _strands(points: Floats) -> Floats:
    """Tell how light each strand is, 0..1: combed from the crown forwards and down."""
    x, y, z = points.T
    along = np.arctan2(x, y - 8.4) * 9 + np.sin(5 * z) * 0.8
    return (0.5 + 0.5 * np.sin(along * 3.1) * np.cos(7 * z + 3 * x)).astype(np.float32)


def brow_region(points: Floats) -> NDArray[np.bool_]:
    """Tell which vertices lie where the brows and their edges are."""
    x, y, z = points.T
    return (np.abs(x) > 0.05) & (np.abs(x) < 0.58) & (y > 8.37) & (y < 8.57) & (z > 1.0)


def _brows(points: Floats) -> Floats:
    x, y, z = points.T
    along = (np.abs(x) - 0.10) / 0.44
    arch = 8.435 + 0.05 * np.sin(np.pi * np.clip(along, 0, 1) ** 0.8 * 0.9)
    across = np.abs(y - arch) / (0.050 * (1 - 0.5 * np.clip(along, 0, 1)))
    inside = np.clip(1.7 - across, 0, 1) * np.clip(7 * along + 0.5, 0, 1) * np.clip(5 * (1 - along) + 0.1, 0, 1)
    return np.where(z > 1.0, inside, 0).astype(np.float32)


def _blush(points: Floats) -> Floats:
    """Tell where blood shines through: cheeks, the tip of the nose, earlobes."""
    return np.maximum.reduce([_near(points, *place) for place in BLUSHING])


def _stubble(points: Floats) -> Floats:
    """Tell where a beard would grow."""
    _, y, z = points.T
    below = np.clip((7.72 - y) / 0.15, 0, 1) * np.clip((y - 6.98) / 0.15, 0, 1) * np.clip((z - 0.72) / 0.3, 0, 1)
    return (below * (1 - 0.6 * _near(points, (0.30, 7.75, 1.30), 0.25))).astype(np.float32)


def _near(points: Floats, place: tuple[float, float, float], radius: float) -> Floats:
    """Tell how near points are to a place or its mirror image: 1 there, 0 from a radius on."""
    one_side = np.column_stack((np.abs(points[:, 0]), points[:, 1:]))
    share = np.clip(1 - np.linalg.norm(one_side - np.float32(place), axis=1) / radius, 0, 1)
    return (share * share * (3 - 2 * share)).astype(np.float32)


def _hidden(points: Floats, triangles: Numbers, size: int = 400) -> NDArray[np.bool_]:
    """Tell which vertices no eye outside sees, from the front and the sides: mouth, nostrils, sockets."""
    seen = np.zeros(len(points), bool)
    for yaw in np.radians(np.arange(-180, 180, 30)):
        for pitch in np.radians((-50, 0, 50)):
            c, s, u, v = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
            turn = np.array([[1, 0, 0], [0, u, -v], [0, v, u]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
            seen |= _seen(points @ turn.T, triangles, size)
    return ~seen


def _seen(points: Floats, triangles: Numbers, size: int) -> NDArray[np.bool_]:
    """Tell which vertices stand in front of everything, as seen from far along z."""
    low, span = points.min(axis=0), np.ptp(points[:, :2], axis=0).max()
    at = (points - low) / span * (size - 1)
    depth = np.full((size, size), -np.inf)
    for steps in range(12):  # points within each triangle: finer than the picture's grid
        for k in range(12 - steps):
            weights = np.array([steps, k, 11 - steps - k]) / 11
            inside = np.tensordot(weights, at[triangles].transpose(1, 0, 2), axes=1)
            row, column = np.round(inside[:, 1]).astype(int), np.round(inside[:, 0]).astype(int)
            np.maximum.at(depth, (row, column), inside[:, 2])
    row, column = np.round(at[:, 1]).astype(int), np.round(at[:, 0]).astype(int)
    return at[:, 2] > depth[row, column] - 2.5
