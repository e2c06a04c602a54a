"""Opens and saves files of meshes and movestates; the ending says the format."""

import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.gltf import parse_gltf, parse_vrm
from phonemeengine.mouth.files.gltf_writing import format_glb, format_points
from phonemeengine.mouth.files.obj import parse_obj
from phonemeengine.mouth.files.threedm import format_3dm, format_3dma, parse_3dm, parse_3dma
from phonemeengine.mouth.files.x_file import parse_x
from phonemeengine.mouth.morph_mesh import (
    USUAL_HEAD,
    Head,
    MorphMesh,
    MorphTargets,
    bust_of,
    load_head,
    matched,
    morph_targets_of,
)
from phonemeengine.mouth.movestate import LONGEST_NAME, Movestate, movestate_of
from phonemeengine.storage.files import MEGABYTE, read_file, write_file

LARGEST = {".3dm": 64, ".3dma": 32, ".obj": 32, ".gltf": 4, ".glb": 64, ".vrm": 64, ".x": 16}
"""Megabytes of a file of each kind: so much is read, and no more."""
LARGEST_BESIDE = 64
TARGET_SUFFIXES = (".3dm", ".3dma")
RESTING = re.compile(r"(^|[^a-z])(neutral|base|basis|rest|default|idle)([^a-z]|$)")
"""In the names of files: the mesh at rest."""
MESH_SUFFIXES = (".obj", ".gltf", ".glb", ".vrm", ".x")

Beside = Callable[[str], bytes | None]


def load_morph_mesh(path: str | os.PathLike[str]) -> MorphMesh:
    """Load a mesh and the movestates of its file: .obj, .gltf, .glb, .vrm or .x; or a head, ``woman`` or ``man``.

    Raises
    ------
    MeshError : the file cannot be read or is no mesh; the message begins with the file's name.
    """
    path = Path(path)
    if str(path) in {*Head}:
        return load_head(str(path))
    kind = _kind_of(path, MESH_SUFFIXES)
    content = read_file(path, LARGEST[kind] * MEGABYTE, "such a file", MeshError)
    try:
        morph_mesh = _morph_mesh_of(kind, content, files_beside(path.parent))
    except MeshError as error:
        raise MeshError(f"{path.name}: {error}") from error
    return replace(morph_mesh, mesh=replace(morph_mesh.mesh, name=morph_mesh.mesh.name or path.stem))


@dataclass(frozen=True)
class FaceFiles:
    """The files of a face; without a mesh it is the usual one of the heads that ship with the program.

    Attributes
    ----------
    mesh : .obj, .gltf, .glb, .vrm or .x; or the name of a `Head`.
    movestates : .3dm or .3dma, where the mesh brings none of its own, or others are wanted; or files of the same
        mesh deformed, one for each movestate, beside those that it brings.
    """

    mesh: Path | None = None
    movestates: Path | tuple[Path, ...] | None = None

    @classmethod
    def of_meshes(cls, paths: Sequence[Path]) -> "FaceFiles":
        """Return one face of files of the same mesh: that at rest, by its name or else the shortest, is deformed."""
        rest = min(paths, key=lambda path: (RESTING.search(path.stem.lower()) is None, len(path.stem), path.stem))
        return cls(rest, tuple(path for path in paths if path != rest) or None)

    @property
    def head(self) -> Head | None:
        """Which head of the program it is, as it is; None for a face of the user's."""
        if self.movestates is not None:
            return None
        return USUAL_HEAD if self.mesh is None else Head(str(self.mesh)) if str(self.mesh) in {*Head} else None

    def load(self) -> MorphMesh:
        """Load it, of a whole body head and shoulders; it may have no movestates.

        Raises
        ------
        MeshError : a file cannot be read, or the movestates are those of another mesh.
        """
        face = load_morph_mesh(self.mesh) if self.mesh else load_head()
        if isinstance(self.movestates, tuple):
            states = deformed_states(face, self.movestates)
            face = replace(face, states=states)
        elif self.movestates is not None:
            face = replace(face, states=matched(load_morph_targets(self.movestates), face.mesh).states)
        return bust_of(face)


def deformed_states(base: MorphMesh, paths: Sequence[Path]) -> tuple[Movestate, ...]:
    """Return the movestates of a face, and those that files of the same mesh deformed make, by their names.

    Raises
    ------
    MeshError : a file cannot be read, is of another mesh, or no vertex moves in it; or two movestates have one name.
    """
    states = (*base.states, *(state for path in paths for state in _states_of(path, base)))
    try:
        return morph_targets_of(base.mesh, states).states
    except MeshError as error:
        raise MeshError(f"{error}, or rename a target's file") from error


def _states_of(path: Path, base: MorphMesh) -> list[Movestate]:
    """Return what a target's file holds: its mesh as a movestate of the file's name, and its own morph targets."""
    target = load_morph_mesh(path)
    if len(target.mesh) != len(base.mesh):
        raise MeshError(
            f"{path.name}: it has {len(target.mesh)} vertices, and the base has {len(base.mesh)}; export both alike"
        )
    name = "".join(c for c in path.stem if c.isprintable()).strip()[: LONGEST_NAME // 4] or "target"
    moved = movestate_of(name, target.mesh.positions - base.mesh.positions)
    if not len(moved) and not target.states:
        raise MeshError(f"{path.name}: no vertex moves, it is the base's shape; leave it out, or export it again")
    return [*([moved] if len(moved) else []), *target.states]


def load_morph_targets(path: str | os.PathLike[str]) -> MorphTargets:
    """Load movestates: .3dm or .3dma, or a mesh with morph targets.

    Raises
    ------
    MeshError : the file cannot be read or holds no movestates; the message begins with the file's name.
    """
    path = Path(path)
    kind = _kind_of(path, (*TARGET_SUFFIXES, *MESH_SUFFIXES))
    if kind in MESH_SUFFIXES:
        morph_mesh = load_morph_mesh(path)
        if not morph_mesh.states:
            raise MeshError(f"{path.name}: this is a mesh without morph targets; use 'movestates export'")
        return morph_targets_of(morph_mesh.mesh, morph_mesh.states)
    content = read_file(path, LARGEST[kind] * MEGABYTE, "such a file", MeshError)
    try:
        return parse_3dm(content) if kind == ".3dm" else parse_3dma(content)
    except MeshError as error:
        raise MeshError(f"{path.name}: {error}") from error


def save_morph_targets(
    targets: MorphTargets, path: str | os.PathLike[str], morph_mesh: MorphMesh | None = None
) -> None:
    """Save movestates: .3dm, .3dma, or .glb, which holds the mesh too if it is given, else just points.

    The old file stays until the new one is complete.

    Raises
    ------
    MeshError : the file cannot be written; the message begins with its name.
    """
    path = Path(path)
    kind = _kind_of(path, (*TARGET_SUFFIXES, ".glb"))
    try:
        if kind == ".glb":
            content = (
                format_points(targets)
                if morph_mesh is None
                else format_glb(MorphMesh(morph_mesh.mesh, targets.states))
            )
        else:
            content = format_3dm(targets) if kind == ".3dm" else format_3dma(targets)
    except MeshError as error:
        raise MeshError(f"{path.name}: {error}") from error
    if len(content) > LARGEST[kind] * MEGABYTE:
        raise MeshError(f"{path.name}: would be larger than {LARGEST[kind]} MB; leave out some movestates")
    write_file(path, content, MeshError)


def _morph_mesh_of(kind: str, content: bytes, beside: Beside) -> MorphMesh:
    if kind == ".obj":
        return parse_obj(content, beside)
    if kind == ".vrm":
        return parse_vrm(content)
    return parse_x(content) if kind == ".x" else parse_gltf(content, beside)


def _kind_of(path: Path, kinds: tuple[str, ...]) -> str:
    kind = path.suffix.lower()
    if kind == ".fbx":
        raise MeshError(
            f"{path.name}: FBX cannot be read; open it in Blender, and export it as glTF (.glb) with shape keys"
        )
    if kind not in kinds:
        raise MeshError(f"{path.name}: its ending must be one of {', '.join(kinds)}; choose another file")
    return kind


def files_beside(folder: Path) -> Beside:
    """Return what reads a file of the same folder, or below it; never one elsewhere."""

    def read(name: str) -> bytes | None:
        try:
            path = (folder / name).resolve()
            if not path.is_relative_to(folder.resolve()) or not path.is_file():
                return None
        except (OSError, ValueError):
            return None
        return read_file(path, LARGEST_BESIDE * MEGABYTE, "a file beside a mesh", MeshError)

    return read
