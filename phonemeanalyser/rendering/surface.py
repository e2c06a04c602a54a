"""The surface of a mesh: which way it faces while it moves, and where it is wet."""

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, IndexArray
from phonemeengine.mouth.mesh import Mesh

ROUND = 0.03
"""A part is a ball, an eye, where the distances from its centre vary by less than this share of them."""
FEWEST = 40
"""Vertices that a ball has at least."""
RED = (0.70, 0.60)
"""Green as a share of red: skin has more than the first, lips and tongue less than the second."""
WHITE = (0.86, 0.94)
"""The same from which on something is as white as teeth."""
DARKEST = 0.55
"""The red that lips and teeth have at least; brows and hair have less."""
LIPS, TEETH, EYES = 0.55, 0.75, 1.0

ALIKE = 0.5
"""The cosine of the angle between normals of vertices at one place from which on it is an edge."""


class Surface:
    """Computes normals anew for every frame: vertices that an exporter split at one place share theirs."""

    def __init__(self, mesh: Mesh) -> None:
        self._triangles = mesh.triangles.astype(np.intp).T
        self._point_of = points_of(mesh)
        n_points, n_triangles = int(self._point_of.max()) + 1, len(mesh.triangles)
        corners = self._point_of[mesh.triangles.ravel()]
        faces = np.repeat(np.arange(n_triangles), 3)
        ones = np.ones(len(corners), np.float32)
        self._sum = csr_array(coo_array((ones, (corners, faces)), shape=(n_points, n_triangles)))

    def normals(self, positions: Float32Array) -> Float32Array:
        """Return the normals of a moved mesh, float32, shape (n_vertices, 3), of length 1."""
        a, b, c = (positions.take(corner, axis=0) for corner in self._triangles)
        b -= a
        c -= a
        faces = np.empty_like(a)
        for axis in range(3):
            y, z = (axis + 1) % 3, (axis + 2) % 3
            faces[:, axis] = b[:, y] * c[:, z] - b[:, z] * c[:, y]
        summed = self._sum @ faces
        lengths = np.sqrt(np.einsum("ij,ij->i", summed, summed))
        summed[:, 2] += lengths == 0
        summed /= np.where(lengths > 0, lengths, 1)[:, np.newaxis]
        normals: Float32Array = summed.take(self._point_of, axis=0)
        return normals


def specular_mask(mesh: Mesh) -> Float32Array:
    """Return where a mesh is wet: eyes by their form, lips, tongue and teeth by their colour.

    Returns
    -------
    float32, shape (n_vertices,), 0..1; 0 everywhere but in its eyes for a mesh of one colour.
    """
    red, green, _ = mesh.colours.T
    share = green / np.maximum(red, 1e-6)
    lips = LIPS * np.clip((RED[0] - share) / (RED[0] - RED[1]), 0, 1)
    teeth = TEETH * np.clip((share - WHITE[0]) / (WHITE[1] - WHITE[0]), 0, 1)
    bright = red >= DARKEST if np.ptp(share) > 0 else np.zeros(len(mesh), bool)
    wet = np.where(bright, np.maximum(lips, teeth), 0)
    wet[_eyes_of(mesh)] = EYES
    return wet.astype(np.float32)


def places_of(mesh: Mesh) -> IndexArray:
    """Return the places where vertices are, numbered, and the number for each vertex."""
    _, numbers = np.unique(mesh.positions, axis=0, return_inverse=True)
    return np.asarray(numbers, np.intp).reshape(-1)


def points_of(mesh: Mesh) -> IndexArray:
    """Return numbers of the vertices; those at one place which face nearly alike have one number."""
    places = places_of(mesh)
    point_of = np.arange(len(mesh))
    shared = np.flatnonzero(np.bincount(places)[places] > 1)
    first: dict[int, list[int]] = {}
    for vertex, place in zip(shared.tolist(), places[shared].tolist(), strict=True):
        others = first.setdefault(place, [])
        alike = mesh.normals[others] @ mesh.normals[vertex] > ALIKE
        if alike.any():
            point_of[vertex] = others[int(np.argmax(alike))]
        else:
            others.append(vertex)
    return np.asarray(np.unique(point_of, return_inverse=True)[1], np.intp).reshape(-1)


def _eyes_of(mesh: Mesh) -> BoolArray:
    """Tell which vertices belong to balls, each a part of its own."""
    places = places_of(mesh)
    a, b, c = places[mesh.triangles.astype(np.intp)].T
    n = int(places.max()) + 1
    edges = coo_array((np.ones(2 * len(a), np.int8), (np.concatenate((a, b)), np.concatenate((b, c)))), shape=(n, n))
    n_parts, part_of_place = connected_components(edges, directed=False)
    part = part_of_place[places]
    found = np.zeros(len(mesh), bool)
    for number in np.flatnonzero(np.bincount(part, minlength=n_parts) >= FEWEST):
        inside = part == number
        found[inside] = _is_ball(mesh.positions[inside].astype(float))
    return found


def _is_ball(points: Float64Array) -> bool:
    """Tell whether points lie on a ball that is about as large as they reach, by least squares."""
    points = points - points.mean(axis=0)
    squares = np.square(points).sum(axis=1)
    (*centre, rest), *_ = np.linalg.lstsq(np.column_stack((2 * points, np.ones(len(points)))), squares, rcond=None)
    apart = np.linalg.norm(points - centre, axis=1)
    radius = float(np.sqrt(max(rest + np.square(centre).sum(), 0.0)))
    return bool(np.std(apart) < ROUND * radius < ROUND * np.ptp(points, axis=0).max())
