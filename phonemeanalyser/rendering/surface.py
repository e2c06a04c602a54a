"""The surface of a mesh: which way it faces while it moves, and where it is wet."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, IndexArray
from phonemeengine.mouth.mesh import Mesh, mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import Movestate, movestate_of

ROUND = 0.03
"""A part is a ball, an eye, where the distances from its centre vary by less than this share of them."""
STRIP = 0.7
"""What reaches less far than this many radii along an axis is a strip of a ball, such as lashes."""
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
    order = np.lexsort(mesh.positions.T)  # faster by far than np.unique of rows
    there = mesh.positions[order]
    numbers = np.empty(len(mesh), np.intp)
    numbers[order] = np.append(0, np.any(there[1:] != there[:-1], axis=1).cumsum())
    return numbers


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
    reach = np.ptp(points, axis=0)
    return bool(np.std(apart) < ROUND * radius < ROUND * reach.max() and reach.min() > STRIP * radius)


# A smoother mesh: four triangles for each one, on a surface without edges.
#
# Loop 1987, "Smooth subdivision surfaces based on triangles", with the weights of Warren 1995. Where the surface has
# an edge, or an end, that stays a smooth curve by itself; colours are kept apart where vertices are.

MOST_TRIANGLES = 40_000
"""A mesh that has more is fine enough."""
SMALLEST = 100
"""A part with fewer vertices keeps its form, which it would lose: a row of teeth."""


def subdivided(morph_mesh: MorphMesh) -> MorphMesh:
    """Return a mesh with four times the triangles; a mesh that is fine already stays as it is."""
    mesh = morph_mesh.mesh
    if not 0 < len(mesh.triangles) <= MOST_TRIANGLES:
        return morph_mesh
    places, points = places_of(mesh), points_of(mesh)
    _, first = np.unique(points, return_index=True)
    apart = _refinement_of(mesh.triangles.astype(np.intp), places)
    welded = _refinement_of(points[mesh.triangles], places[first])
    rows = np.empty(apart.weights.shape[0], np.intp)
    rows[: len(mesh)], rows[len(mesh) + apart.edge_of] = points, len(first) + welded.edge_of
    form = welded.weights[rows]
    finer = mesh_of(
        form @ mesh.positions[first],
        apart.triangles,
        name=mesh.name,
        normals=form @ mesh.normals[first],
        colours=apart.weights @ mesh.colours,
        materials=mesh.materials,
        material_of=np.repeat(mesh.material_of, 4),
        uvs=apart.weights @ mesh.uvs,
    )
    return MorphMesh(finer, tuple(_moved(state, form, first, len(mesh)) for state in morph_mesh.states))


def _moved(state: Movestate, form: csr_array, first: IndexArray, n: int) -> Movestate:
    offsets = np.zeros((n, 3), np.float32)
    offsets[state.numbers] = state.offsets
    return movestate_of(state.name, form @ offsets[first], interactable=state.interactable)


@dataclass(frozen=True, eq=False)
class _Refinement:
    """Weights that make new vertices of old ones, shape (n_new, n): first the old ones moved, then one on each edge.

    Further the new triangles, shape (n_triangles, 3), and the edge of each side of the old ones.
    """

    weights: csr_array
    triangles: IndexArray
    edge_of: IndexArray


def _refinement_of(corners: IndexArray, places: IndexArray) -> _Refinement:
    n = len(places)
    sides = np.stack((corners, np.roll(corners, -1, axis=1)), axis=2).reshape(-1, 2)
    numbers, edge_of = np.unique(np.sort(sides, axis=1) @ (n, 1), return_inverse=True)
    edges = np.column_stack(np.divmod(numbers, n))
    opposite = np.roll(corners, 1, axis=1).reshape(-1)
    stiff = _small_parts(edges, places)
    inner = (np.bincount(edge_of, minlength=len(edges)) == 2) & ~stiff[edges[:, 0]]
    weights = _stacked(_kept(edges, inner, stiff), _halved(edges, edge_of, opposite, inner, n), n, len(edges))
    ab, bc, ca = (n + edge_of.reshape(-1, 3)).T
    a, b, c = corners.T
    new = np.stack([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))], axis=1)
    return _Refinement(weights, new.reshape(-1, 3), edge_of)


def _small_parts(edges: IndexArray, places: IndexArray) -> BoolArray:
    """Tell which vertices belong to small parts."""
    n = int(places.max()) + 1
    joined = coo_array((np.ones(len(edges), np.int8), places[edges].T), shape=(n, n))
    _, part = connected_components(joined, directed=False)
    return np.asarray((np.bincount(part)[part] < SMALLEST)[places])


Entries = tuple[Float32Array, IndexArray, IndexArray]
"""Weights, and the new and the old vertices that they are for."""


def _kept(edges: IndexArray, inner: BoolArray, stiff: BoolArray) -> Entries:
    """Move old vertices towards their neighbours; those on an open edge towards the two along it."""
    n, ends, others = len(stiff), edges.ravel(), edges[:, ::-1].ravel()
    open_end = ~np.repeat(inner, 2)
    n_open = np.bincount(ends[open_end], minlength=n)
    valence = np.maximum(np.bincount(ends, minlength=n), 1)
    share = np.where(valence == 3, 3 / 16, 3 / (8 * valence))
    share[n_open > 0] = np.where(n_open[n_open > 0] == 2, 1 / 8, 0)
    share[stiff] = 0
    counts = np.where(n_open > 0, n_open, valence)
    used = open_end | (n_open[ends] == 0)
    values = np.concatenate((1 - counts * share, share[ends[used]]))
    return (
        values.astype(np.float32),
        np.concatenate((np.arange(n), ends[used])),
        np.concatenate((np.arange(n), others[used])),
    )


def _halved(edges: IndexArray, edge_of: IndexArray, opposite: IndexArray, inner: BoolArray, n: int) -> Entries:
    """Put a vertex on each edge, drawn towards the corners opposite to it."""
    used = inner[edge_of]
    values = np.concatenate((np.repeat(np.where(inner, 3 / 8, 1 / 2), 2), np.full(int(used.sum()), 1 / 8)))
    rows = np.concatenate((np.repeat(np.arange(len(edges)), 2), edge_of[used]))
    return values.astype(np.float32), n + rows, np.concatenate((edges.ravel(), opposite[used]))


def _stacked(kept: Entries, halved: Entries, n: int, n_edges: int) -> csr_array:
    values, rows, columns = (np.concatenate((kept[k], halved[k])) for k in range(3))
    return csr_array(coo_array((values, (rows, columns)), shape=(n + n_edges, n)))
