"""Skins of a glTF: which bones carry which vertices, and what turning the bones of a face moves.

Vertices are placed by linear blend skinning (glTF 2.0, section 3.7.3). Turning the jaw or an eye becomes a movestate:
its offsets are those of linear blend skinning with that bone turned as far as the movestate of ARKit turns it.
"""

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, Int64Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.blendshape_names import BONE
from phonemeengine.mouth.files import gltf_document
from phonemeengine.mouth.files.vrm import human_bones
from phonemeengine.mouth.idle_motion import DOWN, SIDEWAYS, UP
from phonemeengine.mouth.movestate import Movestate, movestate_of

MOST_NODES = 1 << 14
MOST_SETS = 4
"""Sets of four bones that carry a vertex."""
HEAD, JAW, LEFT_EYE, RIGHT_EYE = "head", "jaw", "leftEye", "rightEye"
_KNOWN = {
    HEAD: r"head",
    JAW: r"(jaw|jawroot|lowerjaw|mandible)",
    LEFT_EYE: r"(lefteye|eyeleft|eyel|leye)",
    RIGHT_EYE: r"(righteye|eyeright|eyer|reye)",
}
"""What the bones of a face are called, letters alone, after prefixes such as ``mixamorig:`` or ``CC_Base_``."""
_PREFIX = r"(mixamorig\d*|ccbase|def|org|bip01?|valvebiped|facial|ffacial|c|jbip[clr]|jadj[clr])?"

JAW_OPEN, JAW_ASIDE = 20.0, 5.0
"""Degrees by which a jaw turns that is open, or as far to a side as it goes."""
_X, _Y = 0, 1
TURNS: dict[str, tuple[str, int, float]] = {
    "jawOpen": (JAW, _X, JAW_OPEN),
    "jawLeft": (JAW, _Y, JAW_ASIDE),
    "jawRight": (JAW, _Y, -JAW_ASIDE),
    "eyeLookUpLeft": (LEFT_EYE, _X, -UP),
    "eyeLookDownLeft": (LEFT_EYE, _X, DOWN),
    "eyeLookOutLeft": (LEFT_EYE, _Y, SIDEWAYS),
    "eyeLookInLeft": (LEFT_EYE, _Y, -SIDEWAYS),
    "eyeLookUpRight": (RIGHT_EYE, _X, -UP),
    "eyeLookDownRight": (RIGHT_EYE, _X, DOWN),
    "eyeLookOutRight": (RIGHT_EYE, _Y, -SIDEWAYS),
    "eyeLookInRight": (RIGHT_EYE, _Y, SIDEWAYS),
}
"""Which bone a movestate turns, about which axis of the face (x to its left, y upwards), by how many degrees."""


@dataclass(frozen=True)
class Skinned:
    """Where the bones of a skin put the vertices of a mesh.

    Attributes
    ----------
    transforms : float64, shape (n_vertices, 4, 4), what each vertex is moved by.
    shares : float32, shape (n_vertices,), how much of each vertex the bones of a face carry, by what these are.
    """

    transforms: Float64Array
    shares: dict[str, Float32Array]


class Skeleton:
    """The nodes of a glTF, where they are at rest, and which of them are the bones of a face.

    Parameters
    ----------
    document : the file.
    turn : float64, shape (4, 4), what the whole scene is turned by.

    Raises
    ------
    MeshError : a node is above itself, or names one that is not there.
    """

    def __init__(self, document: gltf_document.Document, turn: Float64Array) -> None:
        self._document = document
        nodes = document.list_of("nodes")
        if len(nodes) > MOST_NODES:
            raise MeshError(f"a scene has at most {MOST_NODES} nodes, got {len(nodes)}; export less")
        self._parents = _parents_of(document)
        self.places = _places_of(document, self._parents, turn)
        self.bones = face_bones(document)
        self._below = {name: self._carried_by(node) for name, node in self.bones.items()}

    @property
    def neck(self) -> tuple[float, float, float] | None:
        """Where the head turns; None without a bone for it."""
        if HEAD not in self.bones:
            return None
        x, y, z = self._joint(HEAD).tolist()
        return x, y, z

    def skinned(self, skin: int, attributes: gltf_document.Table, n: int) -> Skinned | None:
        """Return how a skin puts n vertices; None where these name no bones.

        Raises
        ------
        MeshError : a vertex names a bone that the skin does not have.
        """
        if "JOINTS_0" not in attributes or "WEIGHTS_0" not in attributes:
            return None
        table = self._document.entry("skins", skin)
        joints = np.array(gltf_document.wholes_of(table, "joints"), np.int64)
        if not len(joints) or joints.max() >= len(self.places):
            raise MeshError("a skin names a bone that is not there; export it again")
        matrices = self.places[joints] @ self._inverse_binds(table, len(joints))
        transforms = np.zeros((n, 4, 4))
        shares = {name: np.zeros(n, np.float32) for name in self.bones}
        for bones, weights in self._sets(attributes, n, len(joints)):
            transforms += weights[:, np.newaxis, np.newaxis] * matrices[bones]
            for name, below in self._below.items():
                shares[name] += weights * below[joints[bones]]
        return Skinned(transforms, shares)

    def rigid(self, node: int, n: int) -> dict[str, Float32Array]:
        """Return the shares of n vertices that hang below a node, without a skin."""
        return {name: np.full(n, below[node], np.float32) for name, below in self._below.items()}

    def turned_bones(self, points: Float32Array, shares: dict[str, Float32Array]) -> Iterator[Movestate]:
        """Return a movestate for each turn of a bone of the face that moves anything."""
        for name, (bone, axis, degrees) in TURNS.items():
            if bone in shares and shares[bone].any():
                away = points - self._joint(bone)
                offsets = away @ (_rotation(axis, degrees) - np.eye(3)).T * shares[bone][:, np.newaxis]
                state = movestate_of(f"{BONE}{name}", offsets)
                if len(state):
                    yield state

    def _joint(self, bone: str) -> Float64Array:
        joint: Float64Array = self.places[self.bones[bone]][:3, 3]
        return joint

    def _inverse_binds(self, table: gltf_document.Table, n_joints: int) -> Float64Array:
        if "inverseBindMatrices" not in table:
            return np.tile(np.eye(4), (n_joints, 1, 1))
        found = gltf_document.array_of(self._document, gltf_document.whole_of(table, "inverseBindMatrices"))
        if len(found) < n_joints or found.shape[1] != 16 or not np.all(np.abs(found) < 1e9):
            raise MeshError(f"a skin of {n_joints} bones has {len(found)} matrices for them; export it again")
        return found[:n_joints].reshape(-1, 4, 4).transpose(0, 2, 1).astype(np.float64)

    def _sets(self, attributes: gltf_document.Table, n: int, n_joints: int) -> list[tuple[Int64Array, Float32Array]]:
        """Return bones and weights of all vertices, shape (n,) each; the weights of a vertex add up to 1."""
        found: list[tuple[Int64Array, Float32Array]] = []
        for number in range(MOST_SETS):
            keys = f"JOINTS_{number}", f"WEIGHTS_{number}"
            if not all(key in attributes for key in keys):
                break
            bones, weights = (
                gltf_document.array_of(self._document, gltf_document.whole_of(attributes, key)) for key in keys
            )
            if bones.shape != (n, 4) or weights.shape != (n, 4) or bones.dtype.kind != "u":
                raise MeshError(f"its {keys[0]} are no bones of {n} vertices; export it again")
            if n and bones.max() >= n_joints:
                raise MeshError(f"a vertex names bone {bones.max()}, and its skin has {n_joints}; export it again")
            if not np.all((weights >= 0) & (weights < 1e6)):
                raise MeshError(f"its {keys[1]} hold a number that is no weight; export it again")
            found += zip(bones.T.astype(np.int64), weights.T.astype(np.float32), strict=True)
        total = np.sum([weights for _, weights in found], axis=0)
        safe = np.where(total > 0, total, 1)
        return [
            (bones, (weights / safe + (total == 0) * (place == 0)).astype(np.float32))
            for place, (bones, weights) in enumerate(found)
        ]

    def _carried_by(self, bone: int) -> BoolArray:
        """Tell which nodes are a bone or below it."""
        known = {bone: True}
        for start in range(len(self.places)):
            way, node = [], start
            while node not in known and node in self._parents:
                way.append(node)
                node = self._parents[node]
            known |= dict.fromkeys((*way, node), known.get(node, False))
        return np.array([known[node] for node in range(len(self.places))], bool)


def face_bones(document: gltf_document.Document) -> dict[str, int]:
    """Return the nodes that are head, jaw and eyes: what a VRM says they are, else by their names."""
    found = human_bones(document)
    if not found:
        names = [
            re.sub(r"[^a-z]", "", gltf_document.text_of(node, "name", "").lower())
            for node in document.list_of("nodes")
        ]
        patterns = {bone: re.compile(_PREFIX + pattern) for bone, pattern in _KNOWN.items()}
        for place, (name, node) in enumerate(zip(names, document.list_of("nodes"), strict=True)):
            for bone in (bone for bone, pattern in patterns.items() if pattern.fullmatch(name)):
                if "mesh" not in node:
                    found.setdefault(bone, place)
    n = len(document.list_of("nodes"))
    return {bone: node for bone, node in found.items() if bone in _KNOWN and 0 <= node < n}


def bone_angles(document: gltf_document.Document, weights: Mapping[str, Float32Array]) -> dict[int, Float64Array]:
    """Return how the bones of jaw and eyes turn while their movestates move.

    Parameters
    ----------
    weights : shape (n_frames,), 1 for the whole movement, by the name of the movestate, such as ``bone jawOpen``.

    Returns
    -------
    rotation vectors of the face, x to its left, y upwards, in degrees, shape (n_frames, 3), by the bone's node.
    """
    bones, angles = face_bones(document), dict[int, Float64Array]()
    for name, (bone, axis, degrees) in TURNS.items():
        weight = weights.get(f"{BONE}{name}")
        if weight is not None and bone in bones:
            angles.setdefault(bones[bone], np.zeros((len(weight), 3)))[:, axis] += degrees * weight
    return angles


def local_transform(node: gltf_document.Table) -> Float64Array:
    """Return a node's matrix; it is stated by columns, or as scale, rotation (x, y, z, w) and translation."""
    if "matrix" in node:
        return np.array(gltf_document.numbers_of(node, "matrix", [0.0] * 16)).reshape(4, 4).T
    x, y, z, w = gltf_document.numbers_of(node, "rotation", [0.0, 0.0, 0.0, 1.0])
    made = np.eye(4)
    made[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    made[:3, :3] *= gltf_document.numbers_of(node, "scale", [1.0, 1.0, 1.0])
    made[:3, 3] = gltf_document.numbers_of(node, "translation", [0.0, 0.0, 0.0])
    return made


def _parents_of(document: gltf_document.Document) -> dict[int, int]:
    parents: dict[int, int] = {}
    n = len(document.list_of("nodes"))
    for place, node in enumerate(document.list_of("nodes")):
        for child in gltf_document.wholes_of(node, "children"):
            if child >= n:
                raise MeshError(f"it names number {child} of its nodes, and there are {n}; export it again")
            if parents.setdefault(child, place) != place:
                raise MeshError(f"node {child} of its scene is below two others; export it again")
    return parents


def _places_of(document: gltf_document.Document, parents: dict[int, int], turn: Float64Array) -> Float64Array:
    """Return the matrix of each node in the scene, shape (n_nodes, 4, 4)."""
    nodes = document.list_of("nodes")
    places = np.zeros((len(nodes), 4, 4))
    done = np.zeros(len(nodes), bool)
    for start in range(len(nodes)):
        way: list[int] = []
        node: int | None = start
        while node is not None and not done[node]:
            if len(way) > len(nodes):
                raise MeshError(f"the bones of its skeleton go in a circle at node {node}; export it again")
            way.append(node)
            node = parents.get(node)
        for place in reversed(way):
            above = places[parents[place]] if place in parents else turn
            places[place], done[place] = above @ local_transform(nodes[place]), True
    return places


def _rotation(axis: int, degrees: float) -> Float64Array:
    """Return what turns points about x or y, shape (3, 3)."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]] if axis == _X else [[c, 0, s], [0, 1, 0], [-s, 0, c]])
