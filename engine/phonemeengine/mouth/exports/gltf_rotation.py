"""Where a head turns in the scene of a glTF, and what its nodes have to do for that.

A face that hangs on bones turns with the bone that is called head, one that is part of a group of that name with the
group, and any other by itself: about its origin where that lies inside it, else about the middle of its lower edge.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import ExportError

HEAD = re.compile(r"(?:.*[^a-z])?head", re.IGNORECASE)
"""What a node of the head is called, whatever stands before, as in ``mixamorig:Head``."""
LARGEST = 1e30
"""How far from the origin a node may be."""
ORTHOGONAL = 1e-3
"""How far axes may be from right angles, as a cosine, and still turn."""

DAMAGED = "the mesh is a damaged glTF file; export it anew from your modelling program"
NO_BONES: Mapping[int, Float64Array] = {}

Node = dict[str, Any]


@dataclass(frozen=True)
class Turning:
    """What a node does while the head turns.

    Attributes
    ----------
    node : its number.
    rotations : shape (n_frames, 4): quaternions x, y, z, w.
    translations : shape (n_frames, 3), or None where it turns about its own origin.
    """

    node: int
    rotations: Float64Array
    translations: Float64Array | None

    def tracks(self) -> dict[str, Float64Array]:
        """Return what moves, by the name that glTF has for it."""
        moved = {} if self.translations is None else {"translation": self.translations}
        return {"rotation": self.rotations, **moved}


def rotations_of(poses: Float32Array) -> Rotation:
    """Return poses of the head, shape (n, 3): yaw, pitch and roll in degrees, as rotations.

    The head looks along z, and its left is x. It rolls first, then nods, then turns.
    """
    return Rotation.from_euler("YXZ", poses * np.array((1.0, -1.0, -1.0)), degrees=True)


def turnings_of(
    document: dict[str, Any],
    faces: Iterable[int],
    turns: Rotation | None,
    bones: Mapping[int, Float64Array] = NO_BONES,
    *,
    back: bool = False,
) -> list[Turning]:
    """Return what turns a head and the bones of its face; nothing where none of its nodes can.

    Parameters
    ----------
    document : of the glTF; nodes that turn and state a matrix state its parts from now on.
    faces : numbers of the nodes whose meshes have morph targets.
    turns : how the head is turned at each frame, as `rotations_of` says; None where it stays.
    bones : how nodes turn besides, see `bone_angles`.
    back : whether the face looks along -z.

    Raises
    ------
    ExportError : the scene is damaged.
    """
    try:
        scene = _NodeTree(document)
        facing = Rotation.from_euler("Y", 180.0 * back, degrees=True)
        turned = {node: Rotation.from_rotvec(angles, degrees=True) for node, angles in bones.items()}
        if turns is not None:
            turned |= dict.fromkeys(scene.nodes_that_turn(faces), turns)
        with np.errstate(over="raise", invalid="raise"):
            found = [scene.turning_of(node, facing * turned[node] * facing.inv()) for node in sorted(turned)]
        return [turning for turning in found if turning is not None]
    except (TypeError, KeyError, IndexError, ValueError, AttributeError, ArithmeticError) as error:
        raise ExportError(DAMAGED) from error


def turns_in(document: dict[str, Any], node: int, quaternions: Float32Array, *, back: bool = False) -> Rotation:
    """Return how the head or a bone of a face turns, from what its node states: the converse of `turnings_of`.

    Parameters
    ----------
    node : its number.
    quaternions : shape (n_frames, 4): x, y, z, w.
    back : whether the face looks along -z.

    Raises
    ------
    ExportError : the scene is damaged.
    """
    try:
        scene = _NodeTree(document)
        facing, rest = Rotation.from_euler("Y", 180.0 * back, degrees=True), _rotation_of(document["nodes"][node])
        above = facing * scene.rotation_above(node)
        return above * Rotation.from_quat(quaternions) * rest.inv() * above.inv()
    except (TypeError, KeyError, IndexError, ValueError, AttributeError, ArithmeticError) as error:
        raise ExportError(DAMAGED) from error


def poses_of(turns: Rotation) -> Float64Array:
    """Return yaw, pitch and roll in degrees, shape (n, 3), of turns of the head, as `rotations_of` takes them."""
    poses: Float64Array = turns.as_euler("YXZ", degrees=True) * np.array((1.0, -1.0, -1.0))
    return poses


def head_nodes(document: dict[str, Any], faces: Iterable[int]) -> list[int]:
    """Return the topmost nodes with which faces turn, by the numbers of these.

    Raises
    ------
    ExportError : the scene is damaged.
    """
    try:
        return _NodeTree(document).nodes_that_turn(faces)
    except (TypeError, KeyError, IndexError, ValueError, AttributeError) as error:
        raise ExportError(DAMAGED) from error


class _NodeTree:
    """The nodes of a document, and which lies below which."""

    def __init__(self, document: dict[str, Any]) -> None:
        self._document = document
        self._nodes: list[Node] = document["nodes"]
        self._above = {child: k for k, node in enumerate(self._nodes) for child in node.get("children", ())}

    def nodes_that_turn(self, faces: Iterable[int]) -> list[int]:
        """Return the topmost nodes with which the faces turn."""
        found = {node for face in faces if (node := self._node_of(face)) is not None}
        return sorted(node for node in found if not found & set(list(self._chain(node))[1:]))

    def turning_of(self, number: int, turns: Rotation) -> Turning | None:
        """Return how a node turns; None where its axes are not at right angles."""
        node = self._nodes[number]
        if "matrix" in node and not _take_apart(node):
            return None
        rotation, above = _rotation_of(node), self.rotation_above(number)
        turned = above.inv() * turns * above
        turning = Turning(number, (turned * rotation).as_quat(), self._translations_of(node, rotation, turned))
        if not all(np.abs(track).max() < LARGEST for track in turning.tracks().values()):
            raise ValueError("a number is too large, or none")
        return turning

    def _node_of(self, face: int) -> int | None:
        skin = self._nodes[face].get("skin")
        around = self._chain(face) if skin is None else self._document["skins"][skin]["joints"]
        named = (node for node in around if HEAD.fullmatch(str(self._nodes[node].get("name", ""))))
        return next(named, face if skin is None else None)

    def _chain(self, node: int) -> Iterator[int]:
        """Return a node, and those above it."""
        for _ in self._nodes:
            yield node
            if node not in self._above:
                return
            node = self._above[node]
        raise ValueError("a node lies below itself")

    def rotation_above(self, number: int) -> Rotation:
        """Return how the nodes above a node turn it at rest."""
        rotation = Rotation.identity()
        for k in list(self._chain(number))[1:]:
            node = self._nodes[k]
            rotation = (_parts_of(node)[1] if "matrix" in node else _rotation_of(node)) * rotation
        return rotation

    def _translations_of(self, node: Node, rotation: Rotation, turned: Rotation) -> Float64Array | None:
        """Keep in its place what a mesh turns about, unless that is the node's origin."""
        pivot = self._pivot_of(node)
        if not pivot.any():
            return None
        arm = rotation.apply(pivot * np.array(node.get("scale", (1, 1, 1)), float))
        stays = np.array(node.get("translation", (0, 0, 0)), float) + arm
        moved: Float64Array = stays - turned.apply(arm)
        return moved

    def _pivot_of(self, node: Node) -> Float64Array:
        if "mesh" not in node:
            return np.zeros(3)
        parts = self._document["meshes"][node["mesh"]]["primitives"]
        bounds = [self._document["accessors"][part["attributes"]["POSITION"]] for part in parts]
        low = np.min([bound["min"] for bound in bounds], axis=0).astype(float)
        high = np.max([bound["max"] for bound in bounds], axis=0).astype(float)
        if np.all((low < 0) & (high > 0)):
            return np.zeros(3)
        return np.array(((low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2))


def _take_apart(node: Node) -> bool:
    """Have a node state its translation, rotation and scale instead of its matrix, if it has no shear."""
    translation, rotation, scale, straight = _parts_of(node)
    if straight:
        del node["matrix"]
        parts = {"translation": translation, "rotation": rotation.as_quat(), "scale": scale}
        node.update({name: values.tolist() for name, values in parts.items()})
    return straight


def _rotation_of(node: Node) -> Rotation:
    """Return the rotation that a node states."""
    return Rotation.from_quat(np.array(node.get("rotation", (0, 0, 0, 1)), float))


def _parts_of(node: Node) -> tuple[Float64Array, Rotation, Float64Array, bool]:
    """Return the translation, rotation and scale of a node's matrix, and whether they are all that is in it."""
    matrix = np.array(node["matrix"], float).reshape(4, 4).T
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    scale[0] *= -1 if np.linalg.det(matrix[:3, :3]) < 0 else 1
    if not scale.all():
        return matrix[:3, 3], Rotation.identity(), scale, False
    axes = matrix[:3, :3] / scale
    straight = bool(np.abs(axes.T @ axes - np.eye(3)).max() < ORTHOGONAL)
    return matrix[:3, 3], Rotation.from_matrix(axes), scale, straight
