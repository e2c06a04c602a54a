"""A mesh in the making: its parts, and how it is cut and joined."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Colours = NDArray[np.uint8]
Floats = NDArray[np.float32]
Numbers = NDArray[np.int64]

PARTS = ("skin", "left eye", "lower teeth", "right eye", "tongue", "upper teeth", "hair", "brows and lashes")


@dataclass
class Clay:
    """A mesh in the making.

    Attributes
    ----------
    points : where its vertices are, shape (n, 3).
    neutral : where they are in the source's mesh, before any target; landmarks are places in it.
    triangles : shape (n_triangles, 3).
    part : of each vertex, a place in `PARTS`.
    offsets : of each blend shape, shape (n_states, n, 3).
    colours : of each vertex, 0..255, shape (n, 3).
    """

    points: Floats
    neutral: Floats
    triangles: Numbers
    part: NDArray[np.uint8]
    offsets: Floats
    colours: Floats

    def kept(self, keep: NDArray[np.bool_]) -> "Clay":
        """Give the triangles that are to be kept, and only the vertices that they use."""
        triangles = self.triangles[keep]
        used, renumbered = np.unique(triangles, return_inverse=True)
        return Clay(
            self.points[used],
            self.neutral[used],
            renumbered.reshape(triangles.shape),
            self.part[used],
            self.offsets[:, used],
            self.colours[used],
        )

    def with_vertices(self, begin: Numbers, end: Numbers, share: Floats) -> "Clay":
        """Add vertices that lie a share of the way from one vertex to another."""
        t = share[:, np.newaxis]

        def between(values: Floats) -> Floats:
            added = (1 - t) * values[..., begin, :] + t * values[..., end, :]
            return np.concatenate((values, added), axis=-2).astype(np.float32)

        return replace(
            self,
            points=between(self.points),
            neutral=between(self.neutral),
            part=np.concatenate((self.part, self.part[begin])),
            offsets=between(self.offsets),
            colours=between(self.colours),
        )

    def joined(self, other: "Clay") -> "Clay":
        """Give both as one."""
        return Clay(
            np.concatenate((self.points, other.points)),
            np.concatenate((self.neutral, other.neutral)),
            np.concatenate((self.triangles, other.triangles + len(self.points))),
            np.concatenate((self.part, other.part)),
            np.concatenate((self.offsets, other.offsets), axis=1),
            np.concatenate((self.colours, other.colours)),
        )

    def added(self, part: str, points: Floats, triangles: Numbers, colours: Floats, offsets: Floats | None) -> "Clay":
        """Give it with a new part; without offsets it stands still."""
        if offsets is None:
            offsets = np.zeros((len(self.offsets), *points.shape), np.float32)
        number = np.full(len(points), PARTS.index(part), np.uint8)
        points = points.astype(np.float32)
        return self.joined(Clay(points, points, triangles, number, offsets, colours.astype(np.float32)))

    def of_part(self, part: str) -> NDArray[np.bool_]:
        """Tell which vertices belong to a part."""
        return self.part == PARTS.index(part)

    def carried(self, old: NDArray[np.bool_], points: Floats) -> Floats:
        """Return the offsets of new vertices that go along with old ones: they move as one, (n_states, n, 3)."""
        known = np.column_stack((self.points[old], np.ones(old.sum())))
        moved = np.column_stack((points, np.ones(len(points))))
        offsets = np.stack([moved @ np.linalg.lstsq(known, state[old], rcond=None)[0] for state in self.offsets])
        offsets[np.abs(self.offsets[:, old]).max(axis=(1, 2)) < 1e-4] = 0
        return offsets.astype(np.float32)


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


def lower_edge(clay: Clay, below: float) -> Floats:
    """Return the lower edge of the trimmed neck, in order, counter-clockwise seen from above, shape (n, 3)."""
    directed = np.concatenate([clay.triangles[:, (k, (k + 1) % 3)] for k in range(3)])
    known = set(map(tuple, directed.tolist()))
    low = clay.neutral[:, 1] < below
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


def grid_triangles(n_rows: int, n_columns: int, *, closed: bool) -> Numbers:
    """Return the triangles of rows of vertices, shape (n, 3); `closed` where the last column joins the first."""
    r, k = np.meshgrid(np.arange(n_rows - 1), np.arange(n_columns - (not closed)), indexing="ij")
    right = (k + 1) % n_columns
    a, b = r * n_columns + k, r * n_columns + right
    below_a, below_b = a + n_columns, b + n_columns
    return np.stack((a, below_a, b, b, below_a, below_b), axis=-1).reshape(-1, 3)


def first_hits(
    points: Floats, triangles: Numbers, origins: Floats, directions: Floats
) -> tuple[Floats, Numbers, Floats]:
    """Return what rays meet first: the way to it, the triangle, and the shares of its corners, shape (n, 3).

    The way is infinite where a ray meets nothing (Möller and Trumbore 1997).
    """
    a, b, c = (points[triangles[:, k]].astype(float) for k in range(3))
    ab, ac = b - a, c - a
    ways, numbers, shares = np.full(len(origins), np.inf), np.zeros(len(origins), int), np.zeros((len(origins), 3))
    for ray, (origin, towards) in enumerate(zip(origins, directions, strict=True)):
        across = np.cross(towards, ac)
        area = (ab * across).sum(axis=1)
        inverse = 1 / np.where(np.abs(area) < 1e-12, np.inf, area)
        from_a = origin - a
        u = (from_a * across).sum(axis=1) * inverse
        turned = np.cross(from_a, ab)
        v = turned @ towards * inverse
        way = (ac * turned).sum(axis=1) * inverse
        way[(np.abs(area) < 1e-12) | (u < -1e-6) | (v < -1e-6) | (u + v > 1 + 1e-6) | (way < 1e-6)] = np.inf
        best = int(np.argmin(way))
        ways[ray], numbers[ray] = way[best], best
        shares[ray] = (1 - u[best] - v[best], u[best], v[best])
    return ways, numbers, shares
