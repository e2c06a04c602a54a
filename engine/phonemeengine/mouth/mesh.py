"""A mesh: vertices, triangles, and how they look.

Coordinates are those of glTF: right-handed, y upwards, z towards the viewer; triangles run counter-clockwise as
seen from outside.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray, ShortRepr, UInt8Array, UInt32Array
from phonemeengine.errors import MeshError

MOST_VERTICES = 1 << 20
MOST_TRIANGLES = 1 << 21
MOST_MATERIALS = 1 << 12
FARTHEST = 1e9
"""The largest coordinate; beyond it a float32 has no room for the offsets of a face."""
GREY = (0.8, 0.8, 0.8)


class AlphaMode(StrEnum):
    """How a surface uses the alpha of its colour, as glTF names it."""

    OPAQUE = "OPAQUE"
    MASK = "MASK"
    BLEND = "BLEND"


@dataclass(frozen=True, eq=False, repr=False)
class Texture(ShortRepr):
    """A picture on a surface, as it stands in the file.

    Attributes
    ----------
    name : of the picture, may be empty.
    content : the bytes of a PNG or JPEG file, sRGB.
    width, height : pixels.
    pixels : uint8, shape (height, width, 4), red, green, blue and alpha from the upper left, after `content` was
        decoded, and scaled down where it is large; None before.
    """

    name: str
    content: bytes = field(repr=False)
    width: int
    height: int
    pixels: UInt8Array | None = None


@dataclass(frozen=True)
class ToonShading:
    """Light in two steps, as MToon of VRM has it: base colour in the light, another one in the shade.

    Attributes
    ----------
    shade : colour in the shade, red, green, blue in 0..1 (sRGB); times its texture.
    texture : None where `shade` is all.
    shift : -1..1, how much farther the shade ends on the side of the light.
    toony : 0..1, how sharp the end of the shade is.
    """

    shade: tuple[float, float, float] = (1.0, 1.0, 1.0)
    texture: Texture | None = None
    shift: float = 0.0
    toony: float = 0.9


@dataclass(frozen=True)
class Material:
    """What some triangles are made of, after the metallic-roughness model of glTF.

    Attributes
    ----------
    name : what it is called.
    colour : red, green, blue in 0..1 (sRGB); times the texture, where there is one.
    alpha : 0..1; times that of the texture.
    texture : the base colour, looked up by `Mesh.uvs`; None where `colour` is all.
    metallic, roughness : 0..1.
    alpha_mode : whether alpha is ignored, cut off below `alpha_cutoff`, or blended.
    alpha_cutoff : 0..1.
    two_sided : whether the surface is seen from behind, too.
    surface : the texture that has roughness as green and metal as blue, times the numbers.
    normal : the texture of normals in tangent space, and `normal_scale`, how much of them.
    glow : what it emits, red, green, blue from 0 (linear), times `glow_texture`.
    toon : where light comes in steps; None for what metallic-roughness says.
    """

    name: str
    colour: tuple[float, float, float] = GREY
    alpha: float = 1.0
    texture: Texture | None = None
    metallic: float = 0.0
    roughness: float = 0.7
    alpha_mode: AlphaMode = AlphaMode.OPAQUE
    alpha_cutoff: float = 0.5
    two_sided: bool = False
    surface: Texture | None = None
    normal: Texture | None = None
    normal_scale: float = 1.0
    glow: tuple[float, float, float] = (0.0, 0.0, 0.0)
    glow_texture: Texture | None = None
    toon: ToonShading | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Mesh(ShortRepr):
    """Vertices and triangles; make one with `mesh_of`, which looks at them first.

    Attributes
    ----------
    name : what it is called, may be empty.
    positions : float32, shape (n_vertices, 3).
    triangles : uint32, shape (n_triangles, 3), vertex numbers.
    normals : float32, shape (n_vertices, 3), of length 1.
    colours : float32, shape (n_vertices, 3), red, green, blue in 0..1 (sRGB).
    materials : what the triangles are made of, may be empty.
    material_of : uint16, shape (n_triangles,), the place of each triangle's material in `materials`.
    uvs : float32, shape (n_vertices, 2), where each vertex is in the textures, from their upper left corner, 1 for
        their whole width or height; zeros where there are no textures.
    """

    name: str
    positions: Float32Array
    triangles: UInt32Array
    normals: Float32Array
    colours: Float32Array
    materials: tuple[Material, ...]
    material_of: NDArray[np.uint16]
    uvs: Float32Array

    def __len__(self) -> int:
        return len(self.positions)

    def vertices(self, numbers: ArrayLike) -> Float32Array:
        """Return where some vertices are, float32, shape (n, 3); shape (3,) for a single number.

        Raises
        ------
        MeshError : there is no such vertex; here and below.
        """
        found: Float32Array = self.positions[self._checked(numbers)].copy()
        return found

    def with_vertices(self, numbers: ArrayLike, positions: ArrayLike) -> "Mesh":
        """Return a mesh with some vertices elsewhere, shape (n, 3); this one stays as it is.

        Where triangles changed, the normals are computed anew.

        Raises
        ------
        MeshError : as many positions are needed as there are vertices, or one is no number.
        """
        places, points = self._checked(numbers), self.positions.copy()
        with np.errstate(over="ignore"):  # what overflows is refused as infinite
            given = np.asarray(positions, np.float32)
        if given.shape not in {(3,), (*places.shape, 3)}:
            raise MeshError(f"{places.size} vertices need positions of shape ({places.size}, 3), got {given.shape}")
        points[places] = given
        _look_at(points, self.triangles)
        touched = self.triangles[np.any(points != self.positions, axis=1)[self.triangles].any(axis=1)].ravel()
        normals = self.normals.copy()
        normals[touched] = normals_of(points, self.triangles)[touched]
        for array in (points, normals):
            array.setflags(write=False)
        return replace(self, positions=points, normals=normals)

    def moved(self, numbers: ArrayLike, offsets: ArrayLike) -> "Mesh":
        """Return a mesh with some vertices moved by one offset, shape (3,), or by one each, shape (n, 3)."""
        return self.with_vertices(numbers, self.vertices(numbers) + np.asarray(offsets, np.float32))

    def within(self, centre: ArrayLike, radius: float) -> UInt32Array:
        """Return the numbers of all vertices within a sphere, uint32, ascending; those on its surface are in it."""
        apart = np.linalg.norm(self.positions.astype(np.float64) - np.asarray(centre, np.float64), axis=1)
        return np.flatnonzero(apart <= radius).astype(np.uint32)

    def _checked(self, numbers: ArrayLike) -> IndexArray:
        asked = np.asarray(numbers)
        if asked.size and (asked.dtype.kind not in "iu" or not 0 <= asked.min() <= asked.max() < len(self)):
            worst = asked.max() if asked.dtype.kind not in "iu" or asked.min() >= 0 else asked.min()
            raise MeshError(f"the mesh has the vertices 0..{len(self) - 1}, got {worst}; choose one of them")
        return asked.astype(np.intp)


def mesh_of(
    positions: ArrayLike,
    triangles: ArrayLike = (),
    *,
    name: str = "",
    normals: Float32Array | None = None,
    colours: Float32Array | None = None,
    materials: Sequence[Material] = (),
    material_of: ArrayLike | None = None,
    uvs: Float32Array | None = None,
) -> Mesh:
    """Make a mesh of its parts.

    Parameters
    ----------
    positions : shape (n_vertices, 3).
    triangles : shape (n_triangles, 3), vertex numbers.
    normals : shape (n_vertices, 3) of any length; computed where they are missing or zero.
    colours : shape (n_vertices, 3); those of the materials where they are missing.
    uvs : shape (n_vertices, 2), places in the textures.

    Raises
    ------
    MeshError : too many or no vertices, coordinates that are no numbers, a triangle with a vertex that is not there.
    """
    with np.errstate(over="ignore"):  # what overflows is refused as infinite
        points = np.array(positions, np.float32, order="C").reshape(-1, 3)
    corners = np.asarray(triangles).reshape(-1, 3)
    _look_at(points, corners)
    corners = np.array(corners, np.uint32, order="C")
    kinds = np.zeros(len(corners), np.uint16) if material_of is None else np.array(material_of, np.uint16)
    made = tuple(materials)
    if len(kinds) != len(corners) or (made and len(kinds) and kinds.max() >= len(made)):
        raise MeshError(f"each triangle names one of {len(made)} materials, and one does not; export it again")
    if colours is None:
        colours = _colours_by(made, kinds, corners, len(points))
    arrays = (
        points,
        corners,
        _unit_normals(points, corners, normals),
        _colours(colours),
        kinds,
        np.zeros((len(points), 2), np.float32) if uvs is None else np.nan_to_num(uvs).astype(np.float32),
    )
    for array in arrays:
        array.setflags(write=False)
    return Mesh(name, *arrays[:4], made, *arrays[4:])


def normals_of(positions: Float32Array, triangles: UInt32Array) -> Float32Array:
    """Compute the normals of vertices: the sum of those of their triangles, weighed by area.

    Returns
    -------
    float32, shape (n_vertices, 3), of length 1; a vertex without an area points along z.
    """
    a, b, c = (positions[triangles[:, k]].astype(np.float64) for k in range(3))
    faces = np.cross(b - a, c - a)
    return _unit(summed_at(triangles.ravel(), np.repeat(faces, 3, axis=0), len(positions)))


def summed_at(numbers: NDArray[np.integer], vectors: NDArray[np.floating], n: int) -> Float64Array:
    """Add vectors, shape (m, 3), at the vertices that `numbers`, shape (m,), gives; shape (n, 3)."""
    columns = [np.bincount(numbers, vectors[:, axis], minlength=n)[:n] for axis in range(3)]
    return np.stack(columns, axis=1)


def _look_at(points: Float32Array, corners: NDArray[np.generic]) -> None:
    if not 0 < len(points) <= MOST_VERTICES:
        raise MeshError(f"a mesh has 1..{MOST_VERTICES} vertices, this has {len(points)}; choose another file")
    if len(corners) > MOST_TRIANGLES:
        raise MeshError(f"a mesh has at most {MOST_TRIANGLES} triangles, this has {len(corners)}; make it coarser")
    good = np.abs(points) <= FARTHEST  # false for NaN
    if not good.all():
        first = int(np.argmin(good.all(axis=1)))
        raise MeshError(f"vertex {first} has no finite position ({points[first]}); export it again")
    if len(corners) and not 0 <= int(corners.min()) <= int(corners.max()) < len(points):
        worst = int(corners.max()) if int(corners.min()) >= 0 else int(corners.min())
        raise MeshError(f"a triangle names vertex {worst}, and there are {len(points)}; export it again")


def _unit_normals(points: Float32Array, corners: UInt32Array, given: Float32Array | None) -> Float32Array:
    if given is None or not np.all(np.abs(given) <= FARTHEST):
        return normals_of(points, corners)
    lengths = np.linalg.norm(given, axis=1)
    if np.all(lengths > 0):
        return _unit(given.astype(np.float64))
    return _unit(np.where(lengths[:, np.newaxis] > 0, given, normals_of(points, corners)).astype(np.float64))


def _unit(vectors: Float64Array) -> Float32Array:
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    ahead = np.array([0.0, 0.0, 1.0])
    return np.where(lengths > 0, vectors / np.where(lengths > 0, lengths, 1), ahead).astype(np.float32)


def _colours(given: Float32Array) -> Float32Array:
    return np.clip(np.nan_to_num(given, nan=GREY[0]), 0, 1).astype(np.float32)


def _colours_by(
    materials: tuple[Material, ...], kinds: NDArray[np.uint16], corners: UInt32Array, n: int
) -> Float32Array:
    colours = np.tile(np.array(GREY, np.float32), (n, 1))
    if materials:
        table = np.array([material.colour for material in materials], np.float32)
        colours[corners] = table[kinds][:, np.newaxis]
    return colours
