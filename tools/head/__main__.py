"""Makes the head that ships with the program: `python -m tools.head ORIGINAL`, where ORIGINAL is its source.

The original (CC0) has a ragged neck, eyes without irises, and no colours. Its arrays: P positions, F triangles,
part of each vertex, names of the blend shapes, M their offsets.
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from phonemeengine.mouth.mesh import normals_of
from tools.head.colours import brow_region, eye_colours, hair_share, hairline_region, painted
from tools.head.lids import kept_off_eye
from tools.head.shoulders import shoulders_below
from tools.head.teeth import LOWER, UPPER, Row, row_of_teeth

Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

OUT = Path(__file__).resolve().parents[2] / "engine" / "phonemeengine" / "mouth" / "head.npz"
PARTS = ("skin", "left eye", "lower teeth", "right eye", "tongue", "upper teeth")
PIVOT = np.array([0.0, 7.75, 0.25], np.float32)
"""Where the head turns on the neck, in the original's coordinates; becomes the origin."""
NECK, SLOPE, FLARE = 6.74, -0.16, 0.30
"""The cut through the neck: its height, how it falls towards the front, how it rises towards the shoulders."""
REST = {
    "jawOpen": -0.05,
    "mouthShrugLower": 0.12,
    "mouthSmileLeft": 0.04,
    "mouthSmileRight": 0.04,
    "eyeWideLeft": 0.45,
    "eyeWideRight": 0.45,
    "browInnerUp": -0.45,
    "mouthFrownLeft": -0.22,
    "mouthFrownRight": -0.22,
    "browOuterUpLeft": 0.15,
    "browOuterUpRight": 0.15,
}
"""What closes the lips, which stand a little apart in the original, and wakes the eyes."""
TEETH = {"upper teeth": (0.0, -0.035, 0.02), "lower teeth": (0.0, -0.06, -0.015)}
"""How the teeth are moved, so that they are seen where a person's are."""
TONGUE_LIFT, TONGUE_FLATTENED, TONGUE_BENDS = 0.08, 0.55, 0.45
"""How much higher the tip of a tongue that is put out comes to lie, and how much flatter, so that it passes between
teeth and lower lip and not through them; and where it begins to bend, as a share of its length from its root."""
ROUNDNESS = 0.75
"""How far new vertices go towards the planes of their neighbours."""
SKULL = 8.35
"""Above this height is the skull, which is made rounder."""
BULGE, STEEPEST, N_ROUNDED = 0.003, 0.9, 2
"""Edges are cut this many times where the arc over them rises so far; where it turns more (radians), it is a fold."""
HAIR, HIGHEST = (0.03, 0.10), 9.3
"""How thick the hair is at its edge and at the top, and how high that is."""
N_AROUND = 32
RINGS = np.radians([0, 6, 11, 11, 16, 21, 26.5, 26.5, 33, 45, 60, 80, 100])
"""Angles from the gaze; where two are alike the colour changes at an edge: pupil and iris."""


@dataclass
class Clay:
    """A mesh in the making: positions, triangles, the part of each vertex, and the offsets of each blend shape."""

    points: Floats
    triangles: Numbers
    part: NDArray[np.uint8]
    offsets: Floats

    def kept(self, keep: NDArray[np.bool_]) -> "Clay":
        """Give the triangles that are to be kept, and only the vertices that they use."""
        triangles = self.triangles[keep]
        used, renumbered = np.unique(triangles, return_inverse=True)
        shape = renumbered.reshape(triangles.shape)
        return Clay(self.points[used], shape, self.part[used], self.offsets[:, used])

    def with_vertices(self, begin: Numbers, end: Numbers, share: Floats) -> "Clay":
        """Add vertices that lie a share of the way from one vertex to another."""
        t = share[:, np.newaxis]
        points = (1 - t) * self.points[begin] + t * self.points[end]
        offsets = (1 - t) * self.offsets[:, begin] + t * self.offsets[:, end]
        return Clay(
            np.concatenate((self.points, points)),
            self.triangles,
            np.concatenate((self.part, self.part[begin])),
            np.concatenate((self.offsets, offsets), axis=1),
        )

    def joined(self, other: "Clay") -> "Clay":
        """Give both as one."""
        return Clay(
            np.concatenate((self.points, other.points)),
            np.concatenate((self.triangles, other.triangles + len(self.points))),
            np.concatenate((self.part, other.part)),
            np.concatenate((self.offsets, other.offsets), axis=1),
        )


def trimmed(clay: Clay, height: Floats) -> Clay:
    """Cut off what lies below height 0; triangles that cross it are cut through."""
    edges: dict[tuple[int, int], int] = {}
    triangles: list[tuple[int, int, int]] = []
    for triangle in clay.triangles[np.any(height[clay.triangles] >= 0, axis=1)].tolist():
        corners: list[int] = []
        for a, b in zip(triangle, triangle[1:] + triangle[:1], strict=True):
            if height[a] >= 0:
                corners.append(a)
            if (height[a] >= 0) != (height[b] >= 0):
                edge = (min(a, b), max(a, b))
                corners.append(edges.setdefault(edge, len(clay.points) + len(edges)))
        triangles += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    begin, end = np.array(list(edges)).T
    share = (height[begin] / (height[begin] - height[end])).astype(np.float32)
    longer = clay.with_vertices(begin, end, share)
    longer.triangles = np.array(triangles)
    return longer.kept(np.ones(len(triangles), bool))


def end_of_neck(clay: Clay) -> Floats:
    """Return the lower edge of the trimmed neck, in order, counter-clockwise seen from above, shape (n, 3)."""
    directed = np.concatenate([clay.triangles[:, (k, (k + 1) % 3)] for k in range(3)])
    known = set(map(tuple, directed.tolist()))
    low = clay.points[:, 1] < NECK + 0.5
    after = {a: b for a, b in directed.tolist() if (b, a) not in known and low[a] and low[b]}
    first = next(iter(after))
    loop, here = [first], after[first]
    while here != first:
        loop.append(here)
        here = after[here]
    ring = clay.points[loop]
    x, z = ring[:, 0], ring[:, 2]
    turns_right = np.sum(x * np.roll(z, -1) - z * np.roll(x, -1)) > 0
    return ring[::-1] if turns_right else ring


def refined(clay: Clay, where: NDArray[np.bool_]) -> Clay:
    """Cut the edges between vertices of a region in half, so that what is painted there has a finer edge."""
    sides = _sides_of(clay)
    return _cut(clay, sides[where[sides].all(axis=1)])


def rounded(clay: Clay) -> Clay:
    """Cut those edges of the skull in half that are seen as corners in its outline."""
    sides = _sides_of(clay)
    begin, end = sides.T
    normals = normals_of(clay.points, clay.triangles.astype(np.uint32))
    turned = np.arccos(np.clip((normals[begin] * normals[end]).sum(axis=1), -1, 1))
    apart = np.linalg.norm(clay.points[begin] - clay.points[end], axis=1)
    skull = (clay.points[begin, 1] > SKULL) & (clay.points[end, 1] > SKULL)
    return _cut(clay, sides[skull & (turned * apart / 8 > BULGE) & (turned < STEEPEST)])


def _sides_of(clay: Clay) -> Numbers:
    return np.unique(np.sort(np.concatenate([clay.triangles[:, (k, (k + 1) % 3)] for k in range(3)]), axis=1), axis=0)


def _cut(clay: Clay, cut: Numbers) -> Clay:
    """Cut edges in half; new vertices go towards the planes of both ends.

    Boubekeur and Alexa 2008, "Phong tessellation".
    """
    middle = {(int(a), int(b)): len(clay.points) + k for k, (a, b) in enumerate(cut)}
    longer = clay.with_vertices(cut[:, 0], cut[:, 1], np.full(len(cut), 0.5, np.float32))
    normals = normals_of(clay.points, clay.triangles.astype(np.uint32))
    added = longer.points[len(clay.points) :]
    off = [((added - clay.points[end]) * normals[end]).sum(axis=1, keepdims=True) * normals[end] for end in cut.T]
    added -= np.float32(ROUNDNESS) * (off[0] + off[1]) / 2
    triangles: list[tuple[int, int, int]] = []
    for a, b, c in clay.triangles.tolist():
        ab, bc, ca = (middle.get((min(side), max(side))) for side in ((a, b), (b, c), (c, a)))
        triangles += _halves((a, b, c), (ab, bc, ca))
    longer.triangles = np.array(triangles)
    return longer


def _halves(corners: tuple[int, int, int], middles: tuple[int | None, ...]) -> list[tuple[int, int, int]]:
    """Give the parts of a triangle, of whose sides some have a vertex in the middle."""
    if None not in middles:
        (a, b, c), (ab, bc, ca) = corners, middles
        return [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]  # type: ignore[list-item]
    loop = [v for pair in zip(corners, middles, strict=True) for v in pair if v is not None]
    ears = [k for k in range(len(loop)) if loop[k] in corners and loop[k - 1] not in corners]
    first = ears[0] if ears and len(loop) > 3 else 0
    turned = loop[first - 1 :] + loop[: first - 1] if len(loop) > 3 else loop
    return [(turned[0], turned[k], turned[k + 1]) for k in range(1, len(turned) - 1)]


def sphere_of(clay: Clay, part: int) -> tuple[Floats, float]:
    """Return centre and radius of an eye."""
    eye = clay.points[clay.part == part]
    centre = (eye.min(axis=0) + eye.max(axis=0)) / 2
    return centre, float(np.linalg.norm(eye - centre, axis=1).mean())


def with_lids(head: Clay, names: list[str], eyes: list[tuple[Floats, float]]) -> Clay:
    """Keep the skin of a head without eyes off where they will be."""
    points, offsets = head.points, head.offsets
    normals = normals_of(points, head.triangles.astype(np.uint32))
    for centre, radius in eyes:
        points, offsets = kept_off_eye(points, offsets, normals, names, centre, radius)
    return Clay(points, head.triangles, head.part, offsets)


def eyeball(clay: Clay, part: int) -> Clay:
    """Make an eye that looks ahead, with rings where pupil and iris end; it turns as the original's eye does."""
    old = clay.part == part
    centre, radius = sphere_of(clay, part)
    around = 2 * np.pi * np.arange(N_AROUND) / N_AROUND
    polar, turn = (grid.ravel() for grid in np.meshgrid(RINGS, around, indexing="ij"))
    ball = np.stack((np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)), axis=1)
    points = (centre + radius * ball).astype(np.float32)
    offsets = _carried(clay, old, points)
    triangles = []
    for ring in np.flatnonzero(np.diff(RINGS) > 0):
        for k in range(N_AROUND):
            a, b = ring * N_AROUND + k, ring * N_AROUND + (k + 1) % N_AROUND
            triangles += [(a, a + N_AROUND, b + N_AROUND), (a, b + N_AROUND, b)]
    triangles = [t for t in triangles if len({tuple(points[v].tolist()) for v in t}) == 3]
    return Clay(points, np.array(triangles), np.full(len(points), part, np.uint8), offsets)


def teeth(clay: Clay, part: int, row: Row) -> tuple[Clay, NDArray[np.uint8]]:
    """Make a row of teeth in place of a part, and its colours; it goes with the jaw as the original does."""
    old = clay.part == part
    points, triangles, colours = row_of_teeth(clay.points[old], row)
    return Clay(points, triangles, np.full(len(points), part, np.uint8), _carried(clay, old, points)), colours


def _carried(clay: Clay, old: NDArray[np.bool_], points: Floats) -> Floats:
    """Return the offsets of new vertices that go along with old ones, which move as one, shape (n_states, n, 3)."""
    known = np.column_stack((clay.points[old], np.ones(old.sum())))
    moved = np.column_stack((points, np.ones(len(points))))
    offsets = np.stack([moved @ np.linalg.lstsq(known, state[old], rcond=None)[0] for state in clay.offsets])
    offsets[np.abs(clay.offsets[:, old]).max(axis=(1, 2)) < 1e-4] = 0
    return offsets.astype(np.float32)


def rested(clay: Clay, names: list[str]) -> Clay:
    """Close the lips and wake the eyes; a closed eye stays where it was."""
    points, offsets = clay.points, clay.offsets.copy()
    for name, share in REST.items():
        moved = np.float32(share) * clay.offsets[names.index(name)]
        points = points + moved
        if name.startswith("eyeWide"):
            offsets[names.index(name.replace("Wide", "Blink"))] -= moved
    return Clay(points, clay.triangles, clay.part, offsets)


def bent_tongue(clay: Clay, names: list[str]) -> Clay:
    """Lift and flatten a tongue that is put out, from its middle on."""
    offsets, tongue, out = clay.offsets.copy(), clay.part == PARTS.index("tongue"), names.index("tongueOut")
    depth = clay.points[tongue, 2]
    along = (depth - depth.min()) / np.ptp(depth)
    bent = np.clip((along - TONGUE_BENDS) / (1 - TONGUE_BENDS), 0, 1) ** 1.5
    _, y, z = (clay.points + offsets[out])[tongue].T
    middle = np.polyval(np.polyfit(z, y, 3), z)
    offsets[out, tongue, 1] += bent * (TONGUE_LIFT - TONGUE_FLATTENED * (y - middle))
    return Clay(clay.points, clay.triangles, clay.part, offsets)


def haired(clay: Clay) -> Clay:
    """Have short hair stand on the skull, thickest at its top."""
    share = np.where(clay.part == 0, hair_share(clay.points), 0)
    normals = normals_of(clay.points, clay.triangles.astype(np.uint32))
    thick = HAIR[0] + (HAIR[1] - HAIR[0]) * np.clip((clay.points[:, 1] - SKULL) / (HIGHEST - SKULL), 0, 1)
    points = clay.points + (share * thick)[:, np.newaxis] * normals
    return Clay(points.astype(np.float32), clay.triangles, clay.part, clay.offsets)


def bust(clay: Clay) -> tuple[Clay, NDArray[np.uint8]]:
    """Give the trimmed head without eyes on its shoulders, and its colours."""
    x, y, z = clay.points.T
    clay = trimmed(clay, y - np.float32(NECK) - np.float32(SLOPE) * z - np.float32(FLARE) * x**2)
    clay = refined(clay, brow_region(clay.points))
    clay = refined(clay, hairline_region(clay.points) & (clay.part == 0))
    clay = haired(clay)
    for _ in range(N_ROUNDED):
        clay = rounded(clay)
    colours = painted(clay.points, clay.triangles, clay.part)
    points, triangles, shirt = shoulders_below(end_of_neck(clay))
    still = np.zeros((len(clay.offsets), *points.shape), np.float32)
    below = Clay(points, triangles, np.zeros(len(points), np.uint8), still)
    return clay.joined(below), np.concatenate((colours, shirt))


def main() -> None:
    """Write the head."""
    parser = argparse.ArgumentParser(prog="python -m tools.head", description=__doc__)
    parser.add_argument("original", type=Path)
    parser.add_argument("-o", "--out", type=Path, default=OUT)
    options = parser.parse_args()
    with np.load(options.original, allow_pickle=False) as file:
        names = file["names"]
        clay = Clay(file["P"], file["F"].astype(np.int64), file["part"], file["M"].astype(np.float32))
    clay = bent_tongue(rested(clay, names.tolist()), names.tolist())
    for part, moved in TEETH.items():
        clay.points[clay.part == PARTS.index(part)] += np.float32(moved)
    eyes = [PARTS.index(f"{side} eye") for side in ("left", "right")]
    rows = {PARTS.index("upper teeth"): UPPER, PARTS.index("lower teeth"): LOWER}
    head, colours = bust(clay.kept(~np.isin(clay.part[clay.triangles[:, 0]], [*eyes, *rows])))
    head = with_lids(head, names.tolist(), [sphere_of(clay, eye) for eye in eyes])
    for part, row in rows.items():
        made, painted_so = teeth(clay, part, row)
        head, colours = head.joined(made), np.concatenate((colours, painted_so))
    rings = np.repeat(np.arange(len(RINGS)), N_AROUND)
    for eye in eyes:
        head = head.joined(eyeball(clay, eye))
        colours = np.concatenate((colours, eye_colours(rings)))
    np.savez_compressed(
        options.out,
        allow_pickle=False,
        positions=head.points - PIVOT,
        triangles=head.triangles.astype(np.uint16),
        colours=colours,
        part=head.part,
        names=names,
        offsets=head.offsets.astype(np.float16),
    )
    print(f"{options.out}: {len(head.points)} vertices, {options.out.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
