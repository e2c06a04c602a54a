"""A smoother mesh: four triangles for each one, on a surface without edges.

Loop 1987, "Smooth subdivision surfaces based on triangles", with the weights of Warren 1995. Where the surface has an
edge, or an end, that stays a smooth curve by itself; colours are kept apart where vertices are.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components

from phonemeanalyser.rendering.surface import places_of, points_of
from phonemeengine.arrays import BoolArray, Float32Array, IndexArray
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphMesh
from phonemeengine.mouth.movestate import Movestate, movestate_of

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
        form @ mesh.positions[first], apart.triangles, name=mesh.name, normals=form @ mesh.normals[first],
        colours=apart.weights @ mesh.colours, materials=mesh.materials, material_of=np.repeat(mesh.material_of, 4),
    )  # fmt: skip
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
    edges, edge_of = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True)
    edge_of = edge_of.reshape(-1)
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
