"""glTF 2.0 and .glb files with morph targets: all meshes of the scene become one."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array, Int64Array, UInt32Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.files import gltf_document
from phonemeengine.mouth.files.gltf_materials import materials_of, srgb_of
from phonemeengine.mouth.files.skin import Skeleton
from phonemeengine.mouth.files.vrm import expressions_of, faces_back, is_vrm
from phonemeengine.mouth.mesh import MOST_MATERIALS, MOST_TRIANGLES, MOST_VERTICES, Material, mesh_of, summed_at
from phonemeengine.mouth.morph_mesh import MOST_STATES, MorphMesh
from phonemeengine.mouth.movestate import LEAST_MOVE, Movestate, movestate_at

# The scene of a glTF: which meshes it has, where its nodes put them, and what their morph targets are called.


def target_names(mesh: gltf_document.Table) -> list[str]:
    """Return the names of morph targets, as most exporters write them."""
    extras = mesh.get("extras")
    names = extras.get("targetNames") if isinstance(extras, dict) else None
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        return []
    return ["".join(c for c in name if c.isprintable()).strip()[:60] or f"target_{k}" for k, name in enumerate(names)]


def name_of(document: gltf_document.Document) -> str:
    """Return the name of the first mesh, if it has one."""
    meshes = document.list_of("meshes")
    return gltf_document.text_of(meshes[0], "name", "")[:255] if meshes else ""


class Placed(NamedTuple):
    """A mesh of the scene.

    Attributes
    ----------
    mesh : its place among the meshes.
    node, skin : the node that has it, and the skin that carries it; None where there is none.
    """

    mesh: int
    node: int | None = None
    skin: int | None = None


def placed(document: gltf_document.Document) -> Iterator[Placed]:
    """Return each mesh of the scene; all meshes, if no node has one."""
    nodes = document.list_of("nodes")
    children = {child for node in nodes for child in gltf_document.wholes_of(node, "children")}
    waiting = [place for place in range(len(nodes)) if place not in children]
    scenes = document.list_of("scenes")
    if scenes:
        waiting = gltf_document.wholes_of(document.entry("scenes", document.whole("scene")), "nodes")
    seen: set[int] = set()
    found = False
    while waiting:
        place = waiting.pop(0)
        if place in seen:
            raise MeshError(f"node {place} of its scene is below two others; export it again")
        seen.add(place)
        node = document.entry("nodes", place)
        if "mesh" in node:
            found = True
            yield Placed(
                gltf_document.whole_of(node, "mesh"),
                place,
                gltf_document.whole_of(node, "skin") if "skin" in node else None,
            )
        waiting += gltf_document.wholes_of(node, "children")
    if not found:
        yield from map(Placed, range(len(document.list_of("meshes"))))


TRIANGLES, STRIP, FAN = 4, 5, 6
MOST_OFFSETS = 1 << 25
"""Of all morph targets, moving or not."""
MOST_PRIMITIVES = 4096
NUMBER = "_VERTEX"
"""The attribute that keeps the numbers of vertices of which a .3dm file tells no more."""


def parse_gltf(content: bytes, beside: gltf_document.Beside = lambda _name: None) -> MorphMesh:
    """Read a .glb, .vrm or .gltf file: positions, normals, colours, materials, triangles, and morph targets.

    The meshes are put where the scene's nodes, or the bones of their skins, put them. Morph targets of one name in
    several meshes are one movestate. The expressions of an avatar are movestates, too, and so are the turns of
    the bones of jaw and eyes; a name that the face has already stays that of its morph target.

    Parameters
    ----------
    beside : finds the files of buffers and pictures that a .gltf names.

    Raises
    ------
    MeshError : it is no glTF, is compressed, or says something impossible.
    """
    document = gltf_document.Document(content, beside)
    turn = np.diag([-1.0, 1.0, -1.0, 1.0]) if faces_back(document) else np.eye(4)
    gathered = _Gathered(document, Skeleton(document, turn), turn, materials_of(document))
    with np.errstate(all="ignore"):  # what overflows is refused as infinite
        for place in placed(document):
            table = document.entry("meshes", place.mesh)
            names = target_names(table)
            for primitive in gltf_document.tables_of(table, "primitives"):
                gathered.add_primitive(primitive, names, place)
        return gathered.morph_mesh(name_of(document))


def parse_vrm(content: bytes) -> MorphMesh:
    """Read an avatar; see `parse_gltf`.

    Raises
    ------
    MeshError : it is no VRM, or none that can be used.
    """
    if not is_vrm(gltf_document.Document(content, lambda _name: None)):
        raise MeshError("this is no VRM, it tells of no bones and expressions; rename it to .glb, or choose another")
    return parse_gltf(content)


@dataclass
class _Gathered:
    """What the primitives that were read so far make together."""

    document: gltf_document.Document
    skeleton: Skeleton
    turn: Float64Array
    materials: list[Material]
    points: list[Float32Array] = field(default_factory=list)
    normals: list[Float32Array] = field(default_factory=list)
    colours: list[Float32Array] = field(default_factory=list)
    uvs: list[Float32Array] = field(default_factory=list)
    shares: list[dict[str, Float32Array]] = field(default_factory=list)
    triangles: list[UInt32Array] = field(default_factory=list)
    kinds: list[NDArray[np.uint16]] = field(default_factory=list)
    numbers: list[Int64Array] = field(default_factory=list)
    moved: dict[str, list[Movestate]] = field(default_factory=dict)
    targets: dict[tuple[int, int], list[Movestate]] = field(default_factory=dict)
    n: int = 0
    n_triangles: int = 0
    n_offsets: int = 0
    n_primitives: int = 0

    def add_primitive(self, primitive: gltf_document.Table, names: list[str], place: Placed) -> None:
        attributes, targets = (
            gltf_document.table_of(primitive, "attributes"),
            gltf_document.tables_of(primitive, "targets"),
        )
        n = self._count(attributes, len(targets))
        if not n:
            return
        transform, shares = self._where(place, attributes, n)
        self.points.append(_moved(self._vectors(attributes, "POSITION", n), transform))
        self.shares.append(shares)
        self.normals.append(self._normals(attributes, n, transform))
        self.colours.append(self._colours(attributes, primitive, n))
        self.uvs.append(self._uvs(attributes, primitive, n))
        self._push_triangles(primitive, n)
        self._push_numbers(attributes, n)
        for number, target in enumerate(targets):
            name = names[number] if number < len(names) else f"target_{number}"
            parts = self._push_target(name, target, n, transform)
            self.targets.setdefault((place.mesh, number), []).extend(parts)
        self.n += n

    def morph_mesh(self, name: str) -> MorphMesh:
        if not self.n:
            raise MeshError("there is no mesh in it; export one with it")
        numbers = np.concatenate(self.numbers)
        mesh = mesh_of(
            np.concatenate(self.points),
            np.concatenate([np.empty((0, 3), np.uint32), *self.triangles]),
            name=name,
            normals=np.concatenate(self.normals),
            colours=np.concatenate(self.colours),
            materials=self.materials,
            material_of=self._material_of(),
            uvs=np.concatenate(self.uvs),
        )
        states = tuple(self._states(mesh.positions))
        if np.array_equal(numbers, np.arange(self.n)):
            return MorphMesh(mesh, states, self.skeleton.neck)
        return _renumbered(MorphMesh(mesh, states), numbers)

    def _count(self, attributes: gltf_document.Table, n_targets: int) -> int:
        self.n_primitives += 1
        if self.n_primitives > MOST_PRIMITIVES:
            raise MeshError(f"a mesh has at most {MOST_PRIMITIVES} parts; join some")
        if "POSITION" not in attributes:
            return 0
        n = gltf_document.count_of(self.document, gltf_document.whole_of(attributes, "POSITION"))
        if self.n + n > MOST_VERTICES:
            raise MeshError(f"a mesh has at most {MOST_VERTICES} vertices; make it coarser")
        self.n_offsets += n * n_targets
        if self.n_offsets > MOST_OFFSETS:
            raise MeshError(f"all morph targets have at most {MOST_OFFSETS} vertices together; make it coarser")
        return n

    def _vectors(self, attributes: gltf_document.Table, key: str, n: int) -> Float32Array:
        found = gltf_document.array_of(self.document, gltf_document.whole_of(attributes, key))
        if found.shape != (n, 3):
            raise MeshError(f"its {key} is of shape {found.shape}, and there are {n} vertices; export it again")
        vectors = found.astype(np.float32)
        if not np.all(np.abs(vectors) < 1e18):  # false for NaN
            raise MeshError(f"its {key} holds a number that is not finite; export it again")
        return vectors

    def _normals(self, attributes: gltf_document.Table, n: int, transform: Float64Array) -> Float32Array:
        if "NORMAL" not in attributes:
            return np.zeros((n, 3), np.float32)
        cofactors = np.cross(transform[..., [1, 2, 0], :3], transform[..., [2, 0, 1], :3])
        return _turned(self._vectors(attributes, "NORMAL", n), cofactors)

    def _colours(self, attributes: gltf_document.Table, primitive: gltf_document.Table, n: int) -> Float32Array:
        colours = np.ones((n, 3), np.float32)
        if "COLOR_0" in attributes:
            found = gltf_document.array_of(self.document, gltf_document.whole_of(attributes, "COLOR_0"))
            if len(found) != n or found.shape[1] not in (3, 4) or found.dtype.kind != "f":
                raise MeshError(f"its COLOR_0 is of shape {found.shape}, with {n} vertices; export it again")
            colours = np.clip(np.nan_to_num(found[:, :3]), 0, 1).astype(np.float32)
        return srgb_of(colours * self._base_colour(primitive))

    def _base_colour(self, primitive: gltf_document.Table) -> Float32Array:
        if "material" not in primitive:
            return np.ones(3, np.float32)
        material = self.document.entry("materials", gltf_document.whole_of(primitive, "material"))
        colour = gltf_document.numbers_of(
            gltf_document.table_of(material, "pbrMetallicRoughness"), "baseColorFactor", [1.0] * 4
        )
        return np.clip(np.array(colour[:3], np.float32), 0, 1)

    def _uvs(self, attributes: gltf_document.Table, primitive: gltf_document.Table, n: int) -> Float32Array:
        place = gltf_document.whole_of(primitive, "material", 0)
        table = self.document.entry("materials", place) if "material" in primitive else {}
        texture = gltf_document.table_of(gltf_document.table_of(table, "pbrMetallicRoughness"), "baseColorTexture")
        moved = gltf_document.table_of(gltf_document.table_of(texture, "extensions"), "KHR_texture_transform")
        key = f"TEXCOORD_{gltf_document.whole_of(moved, 'texCoord', gltf_document.whole_of(texture, 'texCoord', 0))}"
        if key not in attributes:
            return np.zeros((n, 2), np.float32)
        found = gltf_document.array_of(self.document, gltf_document.whole_of(attributes, key))
        if found.shape != (n, 2):
            raise MeshError(f"its {key} is of shape {found.shape}, and there are {n} vertices; export it again")
        (turn,) = gltf_document.numbers_of({"rotation": [moved.get("rotation", 0.0)]}, "rotation", [0.0])
        matrix = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        scaled = found * np.array(gltf_document.numbers_of(moved, "scale", [1.0, 1.0])) @ matrix.T
        uvs: Float32Array = (scaled + np.array(gltf_document.numbers_of(moved, "offset", [0.0, 0.0]))).astype(
            np.float32
        )
        return uvs

    def _where(
        self, place: Placed, attributes: gltf_document.Table, n: int
    ) -> tuple[Float64Array, dict[str, Float32Array]]:
        """Return what moves n vertices into the scene, one matrix or one each, and which bones carry them."""
        if place.node is None:
            return self.turn, {}
        skinned = None if place.skin is None else self.skeleton.skinned(place.skin, attributes, n)
        if skinned is not None:
            return skinned.transforms, skinned.shares
        transform = self.turn if place.skin is not None else self.skeleton.places[place.node]
        return transform, self.skeleton.rigid(place.node, n)

    def _material_of(self) -> NDArray[np.uint16]:
        kinds = np.concatenate([np.empty(0, np.uint16), *self.kinds])
        bounded: NDArray[np.uint16] = np.minimum(kinds, np.uint16(max(len(self.materials) - 1, 0)))
        return bounded

    def _states(self, points: Float32Array) -> Iterator[Movestate]:
        """Return all movestates: the morph targets, the expressions of an avatar, and bones that turn."""
        yield from (_joined(name, parts) for name, parts in self.moved.items())
        for name, binds in expressions_of(self.document).items():
            if name not in self.moved:
                parts = [(part, bind.weight) for bind in binds for part in self.targets.get(bind[:2], [])]
                yield _mixed(name, parts)
        sizes = [*map(len, self.points)]
        shares = {bone: self._share(bone, sizes) for bone in self.skeleton.bones}
        yield from self.skeleton.turned_bones(points, shares)

    def _share(self, bone: str, sizes: list[int]) -> Float32Array:
        """Return how much of each vertex a bone carries, shape (n_vertices,)."""
        parts = zip(self.shares, sizes, strict=True)
        return np.concatenate([shares.get(bone, np.zeros(n, np.float32)) for shares, n in parts])

    def _push_triangles(self, primitive: gltf_document.Table, n: int) -> None:
        mode = gltf_document.whole_of(primitive, "mode", TRIANGLES)
        if mode not in (TRIANGLES, STRIP, FAN):
            return
        corners = np.arange(n)
        if "indices" in primitive:
            found = gltf_document.array_of(self.document, gltf_document.whole_of(primitive, "indices"))
            if found.dtype.kind != "u" or found.shape[1] != 1:
                raise MeshError("the corners of its triangles are no whole numbers; export it again")
            corners = found[:, 0].astype(np.int64)
        if len(corners) and corners.max() >= n:
            raise MeshError(f"a triangle names vertex {corners.max()}, and there are {n}; export it again")
        triangles = _triangles(corners, mode)
        self.n_triangles += len(triangles)
        if self.n_triangles > MOST_TRIANGLES:
            raise MeshError(f"a mesh has at most {MOST_TRIANGLES} triangles; make it coarser")
        self.triangles.append((triangles + self.n).astype(np.uint32))
        material = min(gltf_document.whole_of(primitive, "material", 0), MOST_MATERIALS - 1)
        self.kinds.append(np.full(len(triangles), material, np.uint16))

    def _push_numbers(self, attributes: gltf_document.Table, n: int) -> None:
        numbers = self.n + np.arange(n)
        if NUMBER in attributes:
            found = gltf_document.array_of(self.document, gltf_document.whole_of(attributes, NUMBER))
            if found.shape != (n, 1) or not np.all((found >= 0) & (found < MOST_VERTICES)):
                raise MeshError(f"its {NUMBER} are no numbers of vertices; export it again")
            numbers = found[:, 0].astype(np.int64)
        self.numbers.append(numbers)

    def _push_target(
        self, name: str, target: gltf_document.Table, n: int, transform: Float64Array
    ) -> list[Movestate]:
        """Take a morph target of n vertices, and return what it moves."""
        if len(self.moved) >= MOST_STATES and name not in self.moved:
            raise MeshError(f"a face has at most {MOST_STATES} morph targets; leave some out")
        parts = self.moved.setdefault(name, [])
        if "POSITION" not in target:
            return []
        offsets = _turned(self._vectors(target, "POSITION", n), transform[..., :3, :3])
        moving = np.flatnonzero(np.linalg.norm(offsets, axis=1) > LEAST_MOVE)
        made = [movestate_at(name, moving + self.n, offsets[moving])] if len(moving) else []
        parts += made
        return made


def _moved(points: Float32Array, transform: Float64Array) -> Float32Array:
    """Return points moved by one matrix, or by one each, float32, shape (n, 3)."""
    return (_turned(points, transform[..., :3, :3]) + transform[..., :3, 3]).astype(np.float32)


def _turned(vectors: Float32Array, matrices: Float64Array) -> Float32Array:
    """Return vectors, shape (n, 3), turned by one matrix, or by one each, float32."""
    turned = vectors @ matrices.T if matrices.ndim == 2 else np.einsum("nij,nj->ni", matrices, vectors)
    return turned.astype(np.float32)


def _mixed(name: str, parts: list[tuple[Movestate, float]]) -> Movestate:
    """Return several morph targets at once, each by so much of it, as one movestate."""
    numbers = np.concatenate([np.empty(0, np.int64), *(part.numbers for part, _ in parts)])
    offsets = np.concatenate([np.empty((0, 3)), *(weight * part.offsets for part, weight in parts)])
    moving, places = np.unique(numbers, return_inverse=True)
    return movestate_at(name, moving, summed_at(places, offsets, len(moving)))


def _joined(name: str, parts: list[Movestate]) -> Movestate:
    numbers = [np.empty(0, np.uint32), *(part.numbers for part in parts)]
    return movestate_at(
        name, np.concatenate(numbers), np.concatenate([np.empty((0, 3)), *(p.offsets for p in parts)])
    )


def _triangles(corners: Int64Array, mode: int) -> Int64Array:
    if mode == TRIANGLES:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    if len(corners) < 3:
        return np.empty((0, 3), np.int64)
    if mode == FAN:
        return np.stack((np.full(len(corners) - 2, corners[0]), corners[1:-1], corners[2:]), axis=1)
    strip = np.stack((corners[:-2], corners[1:-1], corners[2:]), axis=1)
    strip[1::2] = strip[1::2, [1, 0, 2]]
    return strip


def _renumbered(morph_mesh: MorphMesh, numbers: Int64Array) -> MorphMesh:
    """Return the vertices the numbers that they had; those between are at the origin, and nothing uses them."""
    if len(np.unique(numbers)) < len(numbers):
        raise MeshError(f"its {NUMBER} names a vertex twice; export it again")
    mesh, n = morph_mesh.mesh, int(numbers.max()) + 1
    points, colours, uvs = np.zeros((n, 3), np.float32), np.ones((n, 3), np.float32), np.zeros((n, 2), np.float32)
    points[numbers], colours[numbers], uvs[numbers] = mesh.positions, mesh.colours, mesh.uvs
    triangles = numbers[mesh.triangles]
    states = [movestate_at(state.name, numbers[state.numbers], state.offsets) for state in morph_mesh.states]
    made = mesh_of(
        points,
        triangles,
        name=mesh.name,
        colours=colours,
        materials=mesh.materials,
        material_of=mesh.material_of,
        uvs=uvs,
    )
    return MorphMesh(made, tuple(states))
