"""Shapes what the source's mouth lacks: a flat tongue, lips that touch, and teeth that one can tell apart."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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


Colours = NDArray[np.uint8]
Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

ALONG = np.array([0.0, 0.12, 0.5, 0.88])
"""Where each tooth has vertices, as shares of its width."""
ROWS = ((0.0, 0.0), (0.35, 1.0), (0.78, 0.95), (0.97, 0.55), (1.0, -0.6), (0.45, -1.6))
"""Rows from the gum over the edge to the back: how far towards the edge, 0..1, and how far out, in `BULGE`."""
BULGE = 0.022
"""How far a tooth stands out of its row."""
GROOVE = 0.7
"""Of that, what is left between two teeth."""
ROUNDNESS = 0.05
"""How much shorter a tooth is at its corners, as a share of its height."""
ENAMEL, GUM, GAP = (248, 244, 234), (196, 112, 110), (196, 180, 166)


@dataclass(frozen=True)
class Row:
    """Which teeth a row has.

    Attributes
    ----------
    widths : of the teeth of one side, from the middle on.
    lengths : of these, as shares of the row's height.
    upper : whether their edges are below.
    """

    widths: tuple[float, ...]
    lengths: tuple[float, ...]
    upper: bool


UPPER = Row((0.086, 0.070, 0.076, 0.070, 0.068, 0.096), (1.0, 0.95, 0.97, 0.90, 0.86, 0.80), True)
LOWER = Row((0.058, 0.062, 0.068, 0.072, 0.072, 0.104), (0.97, 0.97, 1.0, 0.95, 0.9, 0.84), False)


def row_of_teeth(old: Floats, row: Row) -> tuple[Floats, Numbers, Colours]:
    """Return vertices, triangles and colours of a row of teeth that stands where a band of vertices stood.

    Parameters
    ----------
    old : the band, shape (n, 3): an arch that is open to the back.
    row : which teeth it has.
    """
    low, high = old.min(axis=0), old.max(axis=0)
    width, depth = high[0], high[2] - low[2]
    bounds = np.concatenate(([0.0], np.cumsum(row.widths)))
    u, tooth, place = _samples(row, bounds)
    corners = np.abs(2 * u - 1) ** 4
    out = (1 - corners) * (1 - GROOVE) + GROOVE
    lengths = np.array(row.lengths)
    meeting = np.minimum(
        lengths, lengths[np.maximum(np.arange(len(lengths)) - 1, 0)]
    )  # of a tooth and the one before
    length = np.where(u == 0, meeting[tooth], lengths[tooth]) * (1 - ROUNDNESS * corners)
    angle = _angles(width, depth, place)
    outward = np.stack((np.sin(angle) / width, np.zeros(len(angle)), np.cos(angle) / depth), axis=1)
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    base = np.stack((width * np.sin(angle), np.zeros(len(angle)), low[2] + depth * np.cos(angle)), axis=1)
    gum, edge = (high[1], low[1]) if row.upper else (low[1], high[1])
    points, colours = [], []
    for along, stands in ROWS:
        ring = base + outward * (BULGE * (stands * out - 1.0))[:, np.newaxis]
        ring[:, 1] = gum + (edge - gum) * along * length
        points.append(ring)
        colours.append(_colours(along, stands, corners))
    n = len(u)
    triangles = []
    for r in range(len(ROWS) - 1):
        for k in range(n - 1):
            a, b, c, d = r * n + k, r * n + k + 1, (r + 1) * n + k, (r + 1) * n + k + 1
            triangles += [(a, c, b), (b, c, d)] if row.upper else [(a, b, c), (b, d, c)]
    return np.concatenate(points).astype(np.float32), np.array(triangles), np.concatenate(colours)


def _samples(row: Row, bounds: NDArray[np.float64]) -> tuple[NDArray[np.float64], Numbers, NDArray[np.float64]]:
    """Return, from the right end of the row to the left: the share of a tooth's width, its number, and the place."""
    side_u, side_tooth, side_place = [], [], []
    for k, width in enumerate(row.widths):
        for u in ALONG:
            side_u.append(u)
            side_tooth.append(k)
            side_place.append(bounds[k] + u * width)
    side_u.append(1.0)
    side_tooth.append(len(row.widths) - 1)
    side_place.append(bounds[-1])
    u, tooth, place = np.array(side_u), np.array(side_tooth), np.array(side_place)
    mirrored = slice(None, 0, -1)
    return (
        np.concatenate((u[mirrored], u)),
        np.concatenate((tooth[mirrored], tooth)),
        np.concatenate((-place[mirrored], place)),
    )


def _angles(width: float, depth: float, place: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angles of an ellipse, from its front, at lengths along it."""
    fine = np.linspace(0, np.pi / 2, 400)
    steps = np.hypot(width * np.cos(fine), depth * np.sin(fine))
    lengths = np.concatenate(([0.0], np.cumsum((steps[1:] + steps[:-1]) / 2 * np.diff(fine))))
    return np.sign(place) * np.interp(np.abs(place), lengths, fine)


def _colours(along: float, stands: float, corners: NDArray[np.float64]) -> Colours:
    """Return the colours of a row of vertices: gums above, gaps between, and shade behind."""
    gap = np.clip(corners * (1.25 - 0.5 * along), 0, 1)[:, np.newaxis]
    colour = (1 - gap) * np.float64(ENAMEL) + gap * np.float64(GAP)
    if along == 0.0:
        colour = np.tile(np.float64(GUM), (len(corners), 1))
    if stands < 0:
        colour *= 0.7
    return np.round(colour).astype(np.uint8)
