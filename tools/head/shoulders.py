"""Makes the shoulders below the neck, in a shirt with a round collar."""

import numpy as np
from numpy.typing import NDArray

from tools.head.people import Person

Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

SQUARENESS = 2.5
"""Of the outline from above: a superellipse."""
AXIS_DEPTH = 0.08
"""Where the middle of that outline is, along z."""
COLLAR = 0.045
"""How high the collar is."""
RIM = ((0.6, 1.0), (1.6, 1.0), (2.4, -0.3))
"""Rows of the collar: how far out and up, in `COLLAR`."""
ROWS = ((0.12, 0.02), (0.34, 0.12), (0.56, 0.25), (0.76, 0.42), (0.92, 0.65), (1.0, 0.95), (1.0, 1.75))
"""Rows of vertices below the collar: how far from the neck to the outline, and how far down."""
STEEPER = 0.55
"""How much further down chest and back fall than shoulders do, at the same share of the way."""
SEAM, INSIDE = 0.78, 0.5
"""Of the shirt's brightness: of the collar, and of what is below it all."""


def shoulders_below(ring: Floats, person: Person) -> tuple[Floats, Numbers, Floats]:
    """Return vertices, triangles and colours of shoulders that begin at the lower end of a neck.

    Parameters
    ----------
    ring : the neck's end, in order around it, counter-clockwise seen from above, shape (n, 3).
    """
    n = len(ring)
    half_width, half_depth = person.shoulders
    shirt = np.array(person.shirt, np.float32)
    centre = np.array((0.0, AXIS_DEPTH))
    apart = ring[:, ::2] - centre
    reach = np.linalg.norm(apart, axis=1)
    towards = apart / reach[:, np.newaxis]
    outline = 1 / (
        np.abs(towards[:, 0] / half_width) ** SQUARENESS + np.abs(towards[:, 1] / half_depth) ** SQUARENESS
    ) ** (1 / SQUARENESS)
    outline = np.maximum(outline, reach + 0.12)
    fall = 1 + STEEPER * np.abs(towards[:, 1])
    level = ring[:, 1]
    rows = [(reach, level), *((reach + out * COLLAR, level + up * COLLAR) for out, up in RIM)]
    points = [_row(centre, towards, *row) for row in rows]
    colours = [SEAM] * len(rows)
    begin = rows[-1][0]
    for share, down in ROWS:
        evened = level + min(share, 1.0) * (level.mean() - level)
        points.append(_row(centre, towards, begin + share * (outline - begin), evened - down * fall ** (1 - share)))
        colours.append(1.0)
    bottom = np.array([(0.0, points[-1][:, 1].mean(), AXIS_DEPTH)])
    points.append(points[-1].copy())  # an edge of its own, so that it stays sharp
    colours.append(INSIDE)
    triangles = []
    for row in range(len(points) - 2):
        for k in range(n):
            a, b = row * n + k, row * n + (k + 1) % n
            triangles += [(a, a + n, b), (b, a + n, b + n)]
    first, last = (len(points) - 1) * n, len(points) * n
    triangles += [(first + (k + 1) % n, first + k, last) for k in range(n)]
    painted = np.append(np.repeat(np.array(colours, np.float32), n), INSIDE)[:, np.newaxis] * shirt
    return np.concatenate((*points, bottom)).astype(np.float32), np.array(triangles), painted


def _row(centre: Floats, towards: Floats, reach: Floats, height: Floats) -> Floats:
    around = centre + towards * reach[:, np.newaxis]
    return np.stack((around[:, 0], height, around[:, 1]), axis=1)
