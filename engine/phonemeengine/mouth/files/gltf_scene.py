"""The scene of a glTF: which meshes it has, where its nodes put them, and what their morph targets are called."""

from collections.abc import Iterator

import numpy as np

from phonemeengine.arrays import Float64Array
from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.glb import Table
from phonemeengine.mouth.files.gltf_document import Document, numbers_of, text_of, whole_of, wholes_of

MOST_NODES = 1 << 14


def target_names(mesh: Table) -> list[str]:
    """Return the names of morph targets, as most exporters write them."""
    extras = mesh.get("extras")
    names = extras.get("targetNames") if isinstance(extras, dict) else None
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        return []
    return ["".join(c for c in name if c.isprintable()).strip()[:60] or f"target_{k}" for k, name in enumerate(names)]


def name_of(document: Document) -> str:
    """Return the name of the first mesh, if it has one."""
    meshes = document.list_of("meshes")
    return text_of(meshes[0], "name", "")[:255] if meshes else ""


def placed(document: Document) -> Iterator[tuple[int, Float64Array]]:
    """Return each mesh of the scene and where it is; all meshes where they are if no node has one."""
    nodes = document.list_of("nodes")
    if len(nodes) > MOST_NODES:
        raise MeshError(f"a scene has at most {MOST_NODES} nodes, got {len(nodes)}; export less")
    children = {child for node in nodes for child in wholes_of(node, "children")}
    waiting = [(place, np.eye(4)) for place in range(len(nodes)) if place not in children]
    scenes = document.list_of("scenes")
    if scenes:
        scene = document.entry("scenes", document.whole("scene"))
        waiting = [(place, np.eye(4)) for place in wholes_of(scene, "nodes")]
    seen: set[int] = set()
    found = False
    while waiting:
        place, above = waiting.pop(0)
        if place in seen:
            raise MeshError(f"node {place} of its scene is below two others; export it again")
        seen.add(place)
        node = document.entry("nodes", place)
        transform = above @ _transform_of(node)
        if "mesh" in node:
            found = True
            yield whole_of(node, "mesh"), (np.eye(4) if "skin" in node else transform)
        waiting += [(child, transform) for child in wholes_of(node, "children")]
    if not found:
        yield from ((place, np.eye(4)) for place in range(len(document.list_of("meshes"))))


def _transform_of(node: Table) -> Float64Array:
    """Return a node's matrix; it is stated by columns, or as scale, rotation (x, y, z, w) and translation."""
    if "matrix" in node:
        return np.array(numbers_of(node, "matrix", [0.0] * 16)).reshape(4, 4).T
    x, y, z, w = numbers_of(node, "rotation", [0.0, 0.0, 0.0, 1.0])
    made = np.eye(4)
    made[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    made[:3, :3] *= numbers_of(node, "scale", [1.0, 1.0, 1.0])
    made[:3, 3] = numbers_of(node, "translation", [0.0, 0.0, 0.0])
    return made
