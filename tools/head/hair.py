"""Makes hair as one closed surface around the skull, combed from the crown down."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tools.head.clay import Clay, first_hits, grid_triangles
from tools.head.people import Person

Floats = NDArray[np.float64]

CENTRE = np.array((0.0, 0.78, 0.22))
"""What the skull is measured from, decimetres from where the head turns; eyes are at a height of 0.52."""
EARS = (0.755, 6.85, 7.72, 0.25, 0.70)
"""Auricles in the source's mesh, which hair does not go around: how far aside, lowest, highest, back, front."""
ELEVATIONS = np.radians(np.linspace(87, -50, 36))
TOP = 0.10
"""How thick hair is at the crown."""
BURIED = 0.035
"""How far below the skin the edge of hair ends."""
LEAST = 0.45
"""The skull is nowhere nearer to its centre; a ray that goes through where an auricle was meets something else."""
N_INSIDE = 3
"""Rows of the inner surface."""
SHADE = 0.85
"""Of the colour of the inner surface."""
ON_SKIN = 0.7
"""What hangs, and yet ends above it, ends on the skin."""
SUNK = np.array((0.0, 0.05, 0.14, 0.30, 0.57, 1.0))
"""How far the last rows of what ends on the skin have gone into it."""
FADING = 0.24
"""Share of a column, at its end, whose colour nears that of the skin."""


@dataclass(frozen=True)
class Style:
    """How hair is cut.

    Attributes
    ----------
    edge : where it ends: angles around the head from the face, degrees, and heights, for either side.
    fringe : how much lower it ends at the right of the forehead than at the left.
    thickness : at angles around the head, degrees.
    top : how much thicker it is at the top.
    hangs : whether it falls from where the skull is widest, rather than following it.
    inward : how far the ends of what hangs curl in, as a share.
    inner : how thick the curtain of hanging hair is.
    n_columns, n_rows : of its vertices.
    groove : how deep strands are.
    uneven : how much longer or shorter single strands are.
    fade : how far the edge takes the colour of the skin, 0..1.
    """

    edge: tuple[tuple[float, ...], tuple[float, ...]]
    fringe: float
    thickness: tuple[tuple[float, ...], tuple[float, ...]]
    top: float
    hangs: bool
    inward: float
    inner: float
    n_columns: int
    n_rows: int
    groove: float
    uneven: float
    fade: float


STYLES = {
    "short": Style(
        edge=(
            (0, 22, 42, 55, 66, 76, 92, 104, 122, 150, 180),
            (1.24, 1.24, 1.16, 0.98, 0.74, 0.50, 0.52, 0.55, 0.22, 0.02, -0.02),
        ),
        fringe=0.0,
        thickness=((0, 30, 60, 90, 130, 180), (0.085, 0.075, 0.05, 0.04, 0.045, 0.055)),
        top=0.03,
        hangs=False,
        inward=0.0,
        inner=0.02,
        n_columns=84,
        n_rows=13,
        groove=0.012,
        uneven=0.012,
        fade=0.8,
    ),
    "bob": Style(
        edge=(
            (0, 20, 32, 42, 50, 57, 63, 70, 80, 110, 150, 180),
            (1.27, 1.23, 1.13, 0.93, 0.62, 0.20, -0.16, -0.40, -0.52, -0.53, -0.48, -0.47),
        ),
        fringe=0.10,
        thickness=((0, 30, 60, 90, 130, 180), (0.11, 0.12, 0.13, 0.14, 0.15, 0.16)),
        top=0.03,
        hangs=True,
        inward=0.26,
        inner=0.06,
        n_columns=88,
        n_rows=16,
        groove=0.016,
        uneven=0.008,
        fade=0.7,
    ),
}


def with_hair(head: Clay, person: Person) -> Clay:
    """Put hair on a head, whose skin stands still below it."""
    style = STYLES[person.hair_style]
    angles = _angles(style)
    uneven = (
        style.uneven
        * np.clip(np.degrees(np.abs(angles)) / 30 - 1.2, 0, 1)
        * np.random.default_rng(5).uniform(-1, 1, style.n_columns)
    )
    ends = _edge_at(style, angles) + uneven
    columns = zip(angles, ends, _skull(head, angles), strict=True)
    rows = np.stack([_column(style, *column) for column in columns])
    rows, strands = _stranded(rows, style)
    inside = _inside(rows, style)
    points = np.concatenate((rows, inside), axis=1).transpose(1, 0, 2).reshape(-1, 3)
    n_rows = style.n_rows + N_INSIDE
    colours = _colours(person, strands, style, _lies_on_skin(style, ends))
    triangles = grid_triangles(n_rows, style.n_columns, closed=True)
    top = np.array([[rows[:, 0].mean(axis=0)[0], rows[:, 0, 1].mean() + 0.004, rows[:, 0].mean(axis=0)[2]]])
    ring = np.arange(style.n_columns)
    cap = np.stack((np.full(style.n_columns, len(points)), ring, np.roll(ring, -1)), axis=1)
    return head.added(
        "hair",
        np.concatenate((points, top)),
        np.concatenate((triangles, cap)),
        np.concatenate((colours, colours[: style.n_columns].mean(axis=0, keepdims=True))),
        None,
    )


def _angles(style: Style) -> Floats:
    """Return the angles of the columns around the head, more of them where the edge is steep, radians."""
    fine = np.radians(np.linspace(-180, 180, 1441))
    heights = _edge_at(style, fine)
    steps = np.hypot(np.diff(fine), 0.7 * np.diff(heights))
    along = np.concatenate(([0.0], np.cumsum(steps)))
    return np.interp(np.arange(style.n_columns) / style.n_columns * along[-1], along, fine)


def _edge_at(style: Style, angle: Floats) -> Floats:
    height = np.interp(np.degrees(np.abs(angle)), *style.edge)
    front = np.clip(1 - np.abs(np.degrees(angle)) / 45, 0, 1)
    return np.asarray(height - style.fringe * front * np.sin(angle * 2) * 2)


def _skull(head: Clay, angles: Floats) -> Floats:
    """Return how far the skull is from its centre, shape (n_columns, n_elevations), without the auricles."""
    aside, lowest, highest, back, front = EARS
    x, y, z = head.neutral.T
    ear = (np.abs(x) > aside) & (y > lowest) & (y < highest) & (z > back) & (z < front)
    skin = head.of_part("skin") & ~ear
    triangles = head.triangles[skin[head.triangles].all(axis=1)]
    triangles = triangles[head.points[triangles][:, :, 1].max(axis=1) > -0.6]
    flat, up = np.cos(ELEVATIONS), np.sin(ELEVATIONS)
    found = []
    for angle in angles:
        towards = np.stack((np.sin(angle) * flat, up, np.cos(angle) * flat), axis=1)
        origins = np.tile(CENTRE, (len(towards), 1)) + 3 * towards
        ways, _, _ = first_hits(head.points, triangles, origins, -towards)
        good = np.isfinite(ways) & (ways < 3 - LEAST)
        found.append(np.interp(np.arange(len(ways)), np.flatnonzero(good), 3 - ways[good]))
    smooth = np.stack(found)
    for _ in range(4):
        smooth = (np.roll(smooth, 1, axis=0) + 2 * smooth + np.roll(smooth, -1, axis=0)) / 4
    return smooth


def _column(style: Style, angle: float, end: float, ways: Floats) -> Floats:
    """Return the outer surface along one angle, from the crown to the edge, shape (n_rows, 3)."""
    steep = np.clip(np.degrees(ELEVATIONS) / 50, 0, 1)
    thick = np.interp(np.degrees(abs(angle)), *style.thickness)
    thick = thick + (TOP - thick + style.top) * steep * steep * (3 - 2 * steep)
    reach, height = (ways + thick) * np.cos(ELEVATIONS), CENTRE[1] + (ways + thick) * np.sin(ELEVATIONS)
    if style.hangs:
        widest = int(np.argmax(reach))
        lower = np.linspace(height[widest], -0.8, 40)[1:]
        fallen = (height[widest] - lower) / 1.2
        reach = np.concatenate((reach[: widest + 1], reach[widest] * (1 + 0.05 * fallen - style.inward * fallen**3)))
        height = np.concatenate((height[: widest + 1], lower))
    last = int(np.argmax(height < end)) if np.any(height < end) else len(height) - 1
    share = (height[last - 1] - end) / max(height[last - 1] - height[last], 1e-6)
    edge = reach[last - 1] + np.clip(share, 0, 1) * (reach[last] - reach[last - 1])
    reach, height = np.append(reach[:last], edge), np.append(height[:last], end)
    along = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(reach), np.diff(height)))))
    places = along[-1] * np.linspace(0, 1, style.n_rows) ** 0.9
    reach, height = np.interp(places, along, reach), np.interp(places, along, height)
    n = len(SUNK)
    sunk = SUNK * _lies_on_skin(style, np.array(end))
    reach[-n:] += sunk * (_skin_at(height[-n:], ways) - BURIED - reach[-n:])
    return np.stack((reach * np.sin(angle), height, CENTRE[2] + reach * np.cos(angle)), axis=1)


def _lies_on_skin(style: Style, ends: Floats) -> Floats:
    """Return how far an edge lies on the skin, which it goes into with a soft end, 0..1."""
    return np.clip((ends - ON_SKIN) / 0.1 + 1, 0, 1) if style.hangs else np.ones_like(ends)


def _skin_at(height: Floats, ways: Floats) -> Floats:
    """Return how far the skin is from the middle of the head at heights along one angle."""
    return np.interp(height, CENTRE[1] + (ways * np.sin(ELEVATIONS))[::-1], (ways * np.cos(ELEVATIONS))[::-1])


def _stranded(rows: Floats, style: Style) -> tuple[Floats, Floats]:
    """Return the surface with strands, and how bright each place of them is, -1..1."""
    random = np.random.default_rng(7)
    n = style.n_columns
    noise = random.standard_normal((3, n))
    smooth = noise[0] + 0.6 * (np.roll(noise[1], 1) + noise[1] + np.roll(noise[1], -1))
    smooth /= np.abs(smooth).max()
    wide = np.convolve(np.tile(noise[2], 3), np.hanning(9), "same")[n : 2 * n]
    wide /= np.abs(wide).max()
    share = np.linspace(0, 1, style.n_rows)
    ramp = np.clip(share * 4, 0, 1) * np.clip((1 - share) * 6 + (0.6 if style.hangs else 0), 0, 1)
    strands = 0.65 * smooth + 0.35 * wide
    out = rows - np.array((0.0, 0.6, CENTRE[2]))
    out[:, :, 1] *= 0.3
    out /= np.linalg.norm(out, axis=2, keepdims=True)
    depth = style.groove * (0.9 * smooth + 1.6 * wide)[:, np.newaxis] * ramp
    return rows + depth[:, :, np.newaxis] * out, strands


def _inside(rows: Floats, style: Style) -> Floats:
    """Return the inner surface, from the edge upwards, shape (n_columns, N_INSIDE, 3)."""
    taken = np.linspace(style.n_rows - 1, max(0, style.n_rows - 8), N_INSIDE).round().astype(int)
    inner = rows[:, taken].copy()
    flat = inner - CENTRE
    flat[:, :, 1] = 0
    reach = np.linalg.norm(flat, axis=2, keepdims=True)
    deeper = style.inner * np.array((0.6, 1.1, 1.4))
    return inner - flat / reach * np.minimum(deeper[np.newaxis, :, np.newaxis], 0.9 * reach)


def _colours(person: Person, strands: Floats, style: Style, on_skin: Floats) -> Floats:
    """Return the colours of all vertices but the top: strands, and a band that shines around the head.

    Parameters
    ----------
    on_skin : how far the edge of each column lies on the skin, whose colour it nears, 0..1.
    """
    share = np.linspace(0, 1, style.n_rows)
    shine = np.exp(-(((share - 0.36) / 0.16) ** 2)) + 0.35 * np.exp(-(((share - 0.85) / 0.2) ** 2))
    light = np.clip(0.22 + 0.55 * strands[np.newaxis, :] + 0.55 * shine[:, np.newaxis] * (0.5 + strands), 0, 1)
    hair, strand = np.array(person.hair, float), np.array(person.strand, float)
    outer = hair + light[:, :, np.newaxis] * (strand - hair)
    outer *= (0.80 + 0.20 * np.clip(share * 5, 0, 1))[:, np.newaxis, np.newaxis]
    fading = style.fade * np.clip(1 - (1 - share) / FADING, 0, 1) ** 1.3
    outer += (fading[:, np.newaxis] * on_skin)[:, :, np.newaxis] * (np.array(person.skin) * 0.85 - outer)
    inner = np.broadcast_to(hair * SHADE, (N_INSIDE, len(strands), 3))
    return np.concatenate((outer, inner)).reshape(-1, 3)
