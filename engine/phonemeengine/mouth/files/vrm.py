"""Avatars as VRM 0 and VRM 1 have them: a glTF that says which node is which bone, and has expressions.

See the specifications ``VRM`` (0.0) and ``VRMC_vrm-1.0`` of the VRM Consortium.
"""

from collections.abc import Iterator
from typing import NamedTuple

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files import gltf_document

VRM0, VRM1 = "VRM", "VRMC_vrm"
MOST_EXPRESSIONS = 1024
MOST_BINDS = 1 << 14
_PRESETS0 = {
    "a": "A",
    "i": "I",
    "u": "U",
    "e": "E",
    "o": "O",
    "blink": "Blink",
    "blink_l": "Blink_L",
    "blink_r": "Blink_R",
    "joy": "Joy",
    "angry": "Angry",
    "sorrow": "Sorrow",
    "fun": "Fun",
    "lookup": "LookUp",
    "lookdown": "LookDown",
    "lookleft": "LookLeft",
    "lookright": "LookRight",
    "neutral": "Neutral",
}
"""What programs of VMC call the presets of VRM 0."""


class Bind(NamedTuple):
    """A morph target that an expression moves.

    Attributes
    ----------
    mesh, target : the place of the mesh, and of the target in it.
    weight : 1 for the whole movement.
    """

    mesh: int
    target: int
    weight: float


def is_vrm(document: gltf_document.Document) -> bool:
    """Return whether a glTF is an avatar."""
    return bool(_extension(document, VRM0) or _extension(document, VRM1))


def faces_back(document: gltf_document.Document) -> bool:
    """Return whether an avatar faces along -z, as those of VRM 0 do; those of VRM 1 face along z."""
    return bool(_extension(document, VRM0)) and not _extension(document, VRM1)


def human_bones(document: gltf_document.Document) -> dict[str, int]:
    """Return the node of each bone, by the name that VRM has for it, such as ``leftEye``."""
    bones = gltf_document.table_of(_extension(document, VRM1), "humanoid").get("humanBones")
    if isinstance(bones, dict):
        return {name: gltf_document.whole_of(gltf_document.table_of(bones, name), "node") for name in bones}
    listed = gltf_document.tables_of(gltf_document.table_of(_extension(document, VRM0), "humanoid"), "humanBones")
    return {gltf_document.text_of(bone, "bone"): gltf_document.whole_of(bone, "node") for bone in listed}


def material_properties(document: gltf_document.Document) -> list[gltf_document.Table]:
    """Return what VRM 0 says of each material beside glTF; empty where it says nothing."""
    return gltf_document.tables_of(_extension(document, VRM0), "materialProperties")


def expressions_of(document: gltf_document.Document) -> dict[str, tuple[Bind, ...]]:
    """Return the morph targets that each expression of an avatar moves.

    Raises
    ------
    MeshError : there are more than any face has, or one names a node without a mesh.
    """
    found: dict[str, tuple[Bind, ...]] = {}
    n = 0
    for name, binds in (*_expressions0(document), *_expressions1(document)):
        n += len(binds)
        if len(found) >= MOST_EXPRESSIONS or n > MOST_BINDS:
            raise MeshError(f"an avatar has at most {MOST_EXPRESSIONS} expressions; leave some out")
        if binds and name:
            found.setdefault(name, binds)
    return found


def _extension(document: gltf_document.Document, name: str) -> gltf_document.Table:
    return gltf_document.table_of(document.table("extensions"), name)


def _expressions0(document: gltf_document.Document) -> Iterator[tuple[str, tuple[Bind, ...]]]:
    master = gltf_document.table_of(_extension(document, VRM0), "blendShapeMaster")
    for group in gltf_document.tables_of(master, "blendShapeGroups"):
        preset = gltf_document.text_of(group, "presetName", "").lower()
        name = _PRESETS0.get(preset) or _printable(gltf_document.text_of(group, "name", ""))
        binds = (
            Bind(
                gltf_document.whole_of(bind, "mesh"),
                gltf_document.whole_of(bind, "index"),
                _weight(bind, 100.0) / 100,
            )
            for bind in gltf_document.tables_of(group, "binds")
        )
        yield name, tuple(binds)


def _expressions1(document: gltf_document.Document) -> Iterator[tuple[str, tuple[Bind, ...]]]:
    expressions = gltf_document.table_of(_extension(document, VRM1), "expressions")
    for kind in ("preset", "custom"):
        named = gltf_document.table_of(expressions, kind)
        for name in named:
            binds = (
                Bind(
                    _mesh_at(document, gltf_document.whole_of(bind, "node")),
                    gltf_document.whole_of(bind, "index"),
                    _weight(bind, 1.0),
                )
                for bind in gltf_document.tables_of(gltf_document.table_of(named, name), "morphTargetBinds")
            )
            yield _printable(name), tuple(binds)


def _mesh_at(document: gltf_document.Document, node: int) -> int:
    return gltf_document.whole_of(document.entry("nodes", node), "mesh")


def _weight(bind: gltf_document.Table, default: float) -> float:
    return gltf_document.numbers_of({"weight": [bind.get("weight", default)]}, "weight", [default])[0]


def _printable(name: str) -> str:
    return "".join(filter(str.isprintable, name)).strip()[:60]
