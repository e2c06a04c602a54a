"""Paints the head: skin, lips, tongue, and the dark inside; places are those of the source's mesh."""

import numpy as np

from phonemeengine.arrays import BoolArray
from tools.head.clay import Clay, Floats, Numbers
from tools.head.people import Person

INSIDE, TONGUE, TEAR = (96, 38, 36), (190, 98, 96), (214, 138, 126)
STUBBLE = (166, 132, 120)
LIPS_SHARP = 2.2
"""How sharp the edge of the lips is."""
LOWEST = 5.5
"""What is below is not looked at."""
EYE_AT = (0.31, 7.30, 1.36)
BLUSHING = (((0.37, 6.93, 1.30), 0.34), ((0.0, 6.93, 1.66), 0.20), ((0.85, 7.25, 0.45), 0.45))
"""Where blood shines through, and how far around."""


def painted(clay: Clay, lips: Floats, inside: Floats, person: Person) -> Floats:
    """Give each vertex of skin and tongue its colour, 0..255, shape (n, 3).

    Parameters
    ----------
    lips, inside : how much each vertex belongs to lips and to the inside of the mouth, 0..1.
    """
    neutral = clay.neutral
    colours = np.tile(np.float32(person.skin), (len(neutral), 1))
    _tint(colours, STUBBLE, person.stubble * _stubble(neutral))
    for place, radius in BLUSHING:
        _tint(colours, person.blush, 0.7 * _near(neutral, place, radius))
    _tint(colours, person.lid, 0.5 * _near(neutral, EYE_AT, 0.20))
    _tint(colours, person.lips, np.clip(LIPS_SHARP * (lips - 0.5) + 0.5, 0, 1))
    _tint(colours, INSIDE, np.clip(2.5 * inside - 1.2, 0, 1))
    skin = clay.of_part("skin")
    hidden = np.zeros(len(neutral), bool)
    triangles = clay.triangles[(skin & (neutral[:, 1] > LOWEST))[clay.triangles].all(axis=1)]
    head = np.unique(triangles)
    hidden[head] = _hidden(clay.points, triangles)[head]
    _tint(colours, INSIDE, (hidden & (inside < 0.2) & (lips < 0.3)).astype(np.float32))
    colours[clay.of_part("tongue")] = TONGUE
    colours[clay.of_part("brows and lashes")] = 0.5 * np.float32(person.hair)
    return colours


def _tint(colours: Floats, colour: tuple[int, int, int], share: Floats) -> None:
    colours += share[:, np.newaxis] * (np.float32(colour) - colours)


def _stubble(points: Floats) -> Floats:
    """Tell where a beard would grow."""
    _, y, z = points.T
    below = np.clip((6.86 - y) / 0.18, 0, 1) * np.clip((y - 6.02) / 0.15, 0, 1) * np.clip((z - 0.62) / 0.35, 0, 1)
    return (below * (1 - 0.6 * _near(points, (0.32, 6.88, 1.30), 0.22))).astype(np.float32)


def _near(points: Floats, place: tuple[float, float, float], radius: float) -> Floats:
    """Tell how near points are to a place or its mirror image: 1 there, 0 from a radius on."""
    one_side = np.column_stack((np.abs(points[:, 0]), points[:, 1:]))
    share = np.clip(1 - np.linalg.norm(one_side - np.float32(place), axis=1) / radius, 0, 1)
    return (share * share * (3 - 2 * share)).astype(np.float32)


def _hidden(points: Floats, triangles: Numbers, size: int = 400) -> BoolArray:
    """Tell which vertices no eye outside sees, from the front and the sides: mouth, nostrils, sockets."""
    seen = np.zeros(len(points), bool)
    for yaw in np.radians(np.arange(-180, 180, 30)):
        for pitch in np.radians((-50, 0, 50)):
            c, s, u, v = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
            turn = np.array([[1, 0, 0], [0, u, -v], [0, v, u]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
            seen |= _seen(points @ turn.T, triangles, size)
    return ~seen


def _seen(points: Floats, triangles: Numbers, size: int) -> BoolArray:
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
