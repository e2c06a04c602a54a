"""Shapes what the source's mouth lacks: a tongue that comes out flat, and lips that touch from corner to corner."""

import numpy as np

from tools.head.clay import Clay, Floats, Numbers, first_hits

TONGUE_LIFT, TONGUE_FLATTENED, TONGUE_BENDS = 0.08, 0.55, 0.45
"""How much higher the tip of a tongue that is put out comes to lie, and how much flatter, so that it passes between
teeth and lower lip and not through them; and where it begins to bend, as a share of its length from its root."""
CLOSED = (
    "mouthPress",
    "mouthRoll",
    "mouthDimple",
    "mouthSmile",
    "mouthFrown",
    "mouthLeft",
    "mouthRight",
    "cheekPuff",
)
"""Blend shapes in which the lips stay closed begin so."""
SLIT, AXIS, REACH = (6.58, 6.65), 0.62, 0.035
"""Between which heights of the source's mesh lips meet, the depth of the axis from which is looked there, and how far
around them closing reaches."""
STEP, MOST_OPEN, N_TIMES = 0.005, 0.12, 2
"""How finely is looked, how far lips stand apart at most that should touch, and how often they are closed."""


def with_mouth(clay: Clay, names: list[str]) -> Clay:
    """Lift and flatten a tongue that is put out, from its middle on."""
    offsets, tongue, out = clay.offsets.copy(), clay.of_part("tongue"), names.index("tongueOut")
    depth = clay.points[tongue, 2]
    along = (depth - depth.min()) / np.ptp(depth)
    bent = np.clip((along - TONGUE_BENDS) / (1 - TONGUE_BENDS), 0, 1) ** 1.5
    _, y, z = (clay.points + offsets[out])[tongue].T
    middle = np.polyval(np.polyfit(z, y, 3), z)
    offsets[out, tongue, 1] += bent * (TONGUE_LIFT - TONGUE_FLATTENED * (y - middle))
    clay.offsets = offsets
    return clay


def with_sealed_lips(clay: Clay, names: list[str], outer: Numbers) -> Clay:
    """Close what is open between lips that should touch: at rest, and in blend shapes that keep them closed.

    Parameters
    ----------
    outer : the triangles of the skin around the mouth and of the lips, without the inside of the mouth.
    """
    for _ in range(2 * N_TIMES):
        clay.points = clay.points + _closing(clay, clay.points, outer)
    for number, name in enumerate(names):
        if name.startswith(CLOSED):
            for _ in range(N_TIMES):
                clay.offsets[number] += _closing(clay, clay.points + clay.offsets[number], outer)
    return clay


def _closing(clay: Clay, points: Floats, outer: Numbers) -> Floats:
    """Return what moves the lips onto each other, shape (n, 3)."""
    angles = np.radians(np.linspace(-33, 33, 61))
    middle, open_by = np.zeros(len(angles)), np.zeros(len(angles))
    x, y, z = clay.neutral[outer].reshape(-1, 3).T
    meeting = (np.abs(x) < 0.03) & (y > SLIT[0]) & (y < SLIT[1])
    mouth = float(clay.points[outer].reshape(-1, 3)[meeting, 1].mean())
    heights = np.arange(mouth - 0.1, mouth + 0.1, STEP)
    for place, angle in enumerate(angles):
        towards = np.array((-np.sin(angle), 0.0, -np.cos(angle)))
        origins = np.stack((np.zeros_like(heights), heights, np.full_like(heights, AXIS)), axis=1) - 1.5 * towards
        ways, _, _ = first_hits(points, outer, origins, np.tile(towards, (len(heights), 1)))
        through = np.flatnonzero(~(ways < 1.5))
        if len(through) and len(through) < MOST_OPEN / STEP:
            middle[place], open_by[place] = heights[through].mean(), STEP * len(through)
    if not open_by.any():
        return np.zeros_like(points)
    seen = open_by > 0
    middle = np.interp(angles, angles[seen], middle[seen])
    open_by = np.maximum.reduce([open_by, 0.9 * np.roll(open_by, 1), 0.9 * np.roll(open_by, -1)])
    x, y, z = points.T
    angle = np.arctan2(x, z - AXIS)
    gap, line = np.interp(angle, angles, open_by), np.interp(angle, angles, middle)
    away = y - line
    near = np.exp(-((np.maximum(np.abs(away) - gap / 2, 0) / REACH) ** 2)) * (z > AXIS + 0.2)
    moved = np.zeros_like(points)
    moved[:, 1] = -np.sign(away) * (gap / 2 + STEP * (gap > 0)) * near * clay.of_part("skin")
    return moved
