"""Makes eyeballs with a round pupil, the hairs of brows and lids, and skin that stays in front of the eyeballs."""

import numpy as np
from numpy.typing import NDArray

from tools.head.clay import Clay, Floats, Numbers, first_hits, grid_triangles
from tools.head.people import Person

N_AROUND = 32
RINGS = np.radians([0, 10, 10, 13, 18, 23, 26.5, 28, 31, 44, 62, 82, 104])
"""Angles from the gaze; where two are alike the colour changes at an edge: pupil and iris."""
PUPIL_END, IRIS_END = 1, 6
"""The last ring of each."""
CORNEA = 0.05
"""How far the cornea stands out, as a share of the radius."""
PUPIL, WHITE, CORNER = (14, 12, 12), (240, 238, 234), (226, 196, 186)

N_BROW = 80
"""Hairs of a brow."""
BROW_FROM, BROW_TO = (0.10, 7.435), (0.545, 7.425)
"""Its ends in the source's mesh, seen from the front; the other one is its mirror image."""
ABOVE_SKIN = 0.006
ROOT = 0.008
"""Lashes that are no farther from the skin begin there."""
BELOW_BROW = 0.62
"""How dark the skin is between the hairs of a brow."""
STRIP = 14
"""Places along a brow where the skin below its hairs is dark."""


def sphere_of(points: Floats) -> tuple[Floats, float]:
    """Return centre and radius of an eye."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre, float(np.linalg.norm(points - centre, axis=1).mean())


def with_eyeball(head: Clay, whole: Clay, part: str, person: Person, more: dict[int, float]) -> Clay:
    """Add an eye that looks ahead; it turns as the source's eye would.

    Parameters
    ----------
    more : for blend shapes that turn the eye, by number: how far, radians around its axes.
    """
    centre, radius = sphere_of(whole.points[whole.of_part(part)])
    around = 2 * np.pi * np.arange(N_AROUND) / N_AROUND
    polar, turn = (grid.ravel() for grid in np.meshgrid(RINGS, around, indexing="ij"))
    ball = np.stack((np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)), axis=1)
    out = 1 + CORNEA * np.clip(1 - (polar / RINGS[IRIS_END + 2]) ** 2, 0, 1)
    local = radius * ball * out[:, np.newaxis]
    triangles: list[tuple[int, int, int]] = []
    for ring in np.flatnonzero(np.diff(RINGS) > 0):
        for k in range(N_AROUND):
            a, b = ring * N_AROUND + k, ring * N_AROUND + (k + 1) % N_AROUND
            triangles += [(a, a + N_AROUND, b + N_AROUND)] + ([(a, b + N_AROUND, b)] if ring else [])
    offsets = np.zeros((len(head.offsets), len(local), 3), np.float32)
    for state, (yaw, pitch) in more.items():
        c, s, u, v = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
        turned = (
            local @ np.array([[1, 0, 0], [0, u, -v], [0, v, u]]).T @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
        )
        offsets[state] = turned - local
    rings = np.repeat(np.arange(len(RINGS)), N_AROUND)
    colours = _eye_colours(rings, np.tile(np.arange(N_AROUND), len(RINGS)), person)
    return head.added(part, centre + local, np.array(triangles), colours, offsets)


def _eye_colours(ring: Numbers, column: Numbers, person: Person) -> Floats:
    colours = np.tile(np.float32(WHITE), (len(ring), 1))
    red = np.clip((np.degrees(RINGS[ring]) - 40) / 35, 0, 1)[:, np.newaxis]
    colours += 0.8 * red * (np.float32(CORNER) - colours)
    streaks = np.random.default_rng(3).uniform(-1, 1, N_AROUND)[column][:, np.newaxis]
    first = PUPIL_END + 1
    share = np.clip((ring - first) / (IRIS_END - first), 0, 1)[:, np.newaxis]
    bright = np.float32(person.iris) * (1.28 - 0.25 * share + 0.14 * streaks)
    iris = bright + share**3 * (np.float32(person.limbus) - bright)
    among = (ring >= first) & (ring <= IRIS_END)
    colours[among] = np.clip(iris, 0, 255)[among]
    colours[ring <= PUPIL_END] = PUPIL
    return colours


def with_brows(head: Clay, person: Person) -> Clay:
    """Add the hairs of both brows, each a thin triangle that goes with the skin below it."""
    random = np.random.default_rng(11)
    width, arch = person.brow
    along = (np.arange(N_BROW) + random.uniform(-0.5, 0.5, N_BROW)) / (N_BROW - 1)
    along = np.clip(along, 0, 1)
    across = random.uniform(-1, 1, N_BROW)
    narrow = np.clip(along / 0.1 + 0.55, 0, 1) * np.clip((1 - along) / 0.45, 0.12, 1) ** 0.8
    middle = _brow_line(along, arch)
    roots = middle + np.stack((np.zeros(N_BROW), across * width * narrow), axis=1)
    tangent = _brow_line(np.clip(along + 0.02, 0, 1.02), arch) - middle
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    lean = np.radians(np.interp(along, (0, 0.15, 0.5, 1), (48, 32, 14, 2)) * np.where(across > 0.2, -0.25, 1.0))
    c, s = np.cos(lean), np.sin(lean)
    towards = np.stack((c * tangent[:, 0] - s * tangent[:, 1], s * tangent[:, 0] + c * tangent[:, 1]), axis=1)
    length = random.uniform(0.045, 0.075, N_BROW) * (0.6 + 0.4 * narrow)
    thick = 0.0052 + 0.35 * width * random.uniform(0.25, 0.42, N_BROW)
    aside = np.stack((-towards[:, 1], towards[:, 0]), axis=1) * (thick / 2)[:, np.newaxis]
    tips = roots + towards * length[:, np.newaxis]
    flat = np.stack((roots - aside, roots + aside, tips), axis=1).reshape(-1, 2)
    shade = np.repeat(random.uniform(0.75, 1.1, N_BROW), 3)[:, np.newaxis]
    hairs = np.clip(np.float32(person.hair) * 1.05 * shade + 8, 0, 255)
    below, below_triangles, share = _brow_strip(width, arch)
    shadow = np.float32(person.skin) + share[:, np.newaxis] * (np.float32(person.hair) - np.float32(person.skin))
    triangles = np.concatenate((below_triangles, len(below) + np.arange(len(flat)).reshape(-1, 3)[:, ::-1]))
    flat, colours = np.concatenate((below, flat)), np.concatenate((shadow, hairs))
    above = np.where(np.arange(len(flat)) < len(below), ABOVE_SKIN / 2, ABOVE_SKIN)[:, np.newaxis]
    for side in (1, -1):
        points, normals, offsets = _on_skin(head, flat * (side, 1))
        points += above * normals
        head = head.added("brows and lashes", points, triangles[:, ::side], colours, offsets)
    return head


def _brow_strip(width: float, arch: float) -> tuple[NDArray[np.float64], Numbers, NDArray[np.float64]]:
    """Return the dark skin below a brow, seen from the front: points, triangles, and how dark each one is, 0..1."""
    along = np.linspace(-0.02, 1.0, STRIP)
    half = width * np.clip(along / 0.1 + 0.6, 0, 1) * np.clip((1.03 - along) / 0.45, 0.1, 1) ** 0.8
    middle = _brow_line(along, arch)
    rows = [middle + np.stack((np.zeros(STRIP), up * half), axis=1) for up in (1.5, 0.75, -0.75, -1.5)]
    dark = np.clip(np.minimum(along / 0.12, 1) + 0.25, 0, 1)
    share = np.concatenate([BELOW_BROW * dark * centre for centre in (0, 1, 1, 0)])
    return np.concatenate(rows), grid_triangles(4, STRIP, closed=False), share


def with_short_lashes(head: Clay, person: Person) -> Clay:
    """Make the lashes of the source, which are of one length, as long as those of a person."""
    lashes = np.flatnonzero(head.of_part("brows and lashes"))
    skin = np.flatnonzero(head.of_part("skin") & (head.neutral[:, 2] > 1.2))
    apart = np.linalg.norm(head.neutral[lashes, np.newaxis] - head.neutral[skin], axis=2).min(axis=1)
    roots = lashes[apart < ROOT]
    root_of = roots[np.linalg.norm(head.neutral[lashes, np.newaxis] - head.neutral[roots], axis=2).argmin(axis=1)]
    for values in (head.points, *head.offsets):
        values[lashes] = values[root_of] + person.lashes * (values[lashes] - values[root_of])
    return head


def _brow_line(along: NDArray[np.float64], arch: float) -> NDArray[np.float64]:
    x = BROW_FROM[0] + along * (BROW_TO[0] - BROW_FROM[0])
    rise = np.sin(np.pi * np.clip(along, 0, 1) ** 1.25) * (arch + 0.02)
    return np.stack((x, BROW_FROM[1] + along * (BROW_TO[1] - BROW_FROM[1]) + rise), axis=1)


def _on_skin(head: Clay, flat: NDArray[np.float64]) -> tuple[Floats, Floats, Floats]:
    """Return points on the skin, normals and offsets, for places in the source's mesh as seen from the front."""
    skin = head.of_part("skin") & (head.neutral[:, 2] > 0.9) & (head.neutral[:, 1] > 7.2) & (head.neutral[:, 1] < 7.8)
    triangles = head.triangles[skin[head.triangles].all(axis=1)]
    origins = np.column_stack((flat, np.full(len(flat), 4.0)))
    ways, numbers, shares = first_hits(head.neutral, triangles, origins, np.tile((0.0, 0.0, -1.0), (len(flat), 1)))
    assert np.all(np.isfinite(ways))
    corners = triangles[numbers]
    points = np.einsum("nk,nkd->nd", shares, head.points[corners])
    a, b, c = (head.points[corners[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    offsets = np.einsum("nk,snkd->snd", shares, head.offsets[:, corners])
    return points.astype(np.float32), normals.astype(np.float32), offsets.astype(np.float32)


Floats = NDArray[np.float32]

NEAR, CLEARANCE = 1.7, 0.03
"""How far around an eyeball its skin reaches, and how far in front of it skin stays, in radii."""
SOCKET = 0.8
"""How far from the eyeball's centre the back of the lids is at most, in radii: well behind its surface."""
OUTWARD, INWARD = 0.1, -0.3
"""Cosine between a vertex's normal and the way out of the eyeball: of skin in front, and of the back of the lids."""
ALONG_THE_EYE = ("eyeBlink", "eyeLook")
"""Blend shapes whose lids slide over the eyeball, and so neither lead into it nor away from it."""


def kept_off_eye(
    points: Floats, offsets: Floats, normals: Floats, names: list[str], centre: Floats, radius: float
) -> tuple[Floats, Floats]:
    """Return positions and offsets of skin of which no sum of blend shapes goes into an eyeball.

    What leads into the eyeball is made less, for all blend shapes of a vertex by the same share, so that all of them
    together, each at 100 %, still end before it. The back of the lids is laid deeper, so that skin does not go
    through it.

    Parameters
    ----------
    points : of the skin, shape (n, 3).
    offsets : of each blend shape, shape (n_states, n, 3).
    normals : of length 1, shape (n, 3).
    names : of the blend shapes.
    centre, radius : of the eyeball.
    """
    points, offsets = points.copy(), offsets.copy()
    from_centre = points - centre
    apart = np.linalg.norm(from_centre, axis=1)
    out = from_centre / apart[:, np.newaxis]
    faces = (normals * out).sum(axis=1)
    behind = (apart > SOCKET * radius) & (apart < NEAR * radius) & (faces < INWARD)
    points[behind] = centre + SOCKET * radius * out[behind]
    front = np.flatnonzero((apart < NEAR * radius) & (from_centre[:, 2] > 0) & (faces > OUTWARD))
    out = out[front]
    least = radius * (1 + CLEARANCE)
    points[front] += np.maximum(least - apart[front], 0)[:, np.newaxis] * out
    room = np.maximum(apart[front], least) - least
    leading = [k for k, name in enumerate(names) if not name.startswith(ALONG_THE_EYE)]
    inward = np.maximum(-np.einsum("snk,nk->sn", offsets[np.ix_(leading, front)], out), 0)
    share = np.minimum(room / np.maximum(inward.sum(axis=0), 1e-9), 1)
    offsets[np.ix_(leading, front)] += ((1 - share) * inward)[..., np.newaxis] * out
    return points.astype(np.float32), offsets.astype(np.float32)
