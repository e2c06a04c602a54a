"""``phonemeanalyser movestates``: movestates from the files of any modelling program, and between formats."""

import argparse
import math
from collections.abc import Iterator
from pathlib import Path

import phonemeengine
from phonemeanalyser.cli.arguments import add_examples, add_options
from phonemeanalyser.cli.parser import file_place, number_in
from phonemeengine.mouth.face_mapping import ENOUGH, guess_mapping, mapped_table
from phonemeengine.mouth.files.io import MESH_SUFFIXES, TARGET_SUFFIXES, deformed_states
from phonemeengine.mouth.morph_mesh import TOLERANCE, Head
from phonemeengine.mouth.table import table_to_toml
from phonemeengine.storage.files import write_file
from phonemeengine.storage.replacing import Guard, guarded_text, nothing_is_own

EPILOG = (
    "Formats: .3dm, .3dma (text), .glb; meshes: .obj, .gltf, .glb, .vrm, .x, or the word head for the program's own. "
    "For each, movestates WHAT --help."
)

EXAMPLES = (
    "phonemeanalyser movestates convert woman face.glb",
    "phonemeanalyser movestates info face.glb",
    "phonemeanalyser movestates export base.obj smile.obj -o smile.3dm",
)
EXAMPLES_OF = {
    "convert": (
        "phonemeanalyser movestates convert woman face.glb",
        "phonemeanalyser movestates convert face.glb face.3dma",
        "phonemeanalyser movestates convert face.3dma face.3dm --overwrite",
    ),
    "info": (
        "phonemeanalyser movestates info face.glb",
        "phonemeanalyser movestates info face.3dma",
        "phonemeanalyser movestates info face.3dm",
    ),
    "export": (
        "phonemeanalyser movestates export base.obj smile.obj -o smile.3dm",
        "phonemeanalyser movestates export base.obj smile.obj frown.obj -o moods.glb",
        "phonemeanalyser movestates export face.glb -o copy.3dma --overwrite",
    ),
    "map": (
        "phonemeanalyser movestates map face.glb -o face.toml",
        "phonemeanalyser movestates map face.glb --basis arkit -o arkit.toml",
        "phonemeanalyser movestates map woman -o woman.toml",
    ),
}
"""Examples of what is done with movestates; each uses the files of those before it."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what is to be done with movestates."""
    parser.epilog = EPILOG
    kinds = parser.add_subparsers(required=True, metavar="WHAT")
    export = kinds.add_parser(
        "export", help="make movestates from meshes", description="Make movestates from a mesh and its targets."
    )
    export.add_argument("base", type=Path, metavar="BASE", help="mesh at rest; its morph targets are used")
    export.add_argument(
        "targets", type=Path, nargs="*", metavar="TARGET", help="the same mesh deformed; its name is the movestate's"
    )
    export.add_argument("-o", "--out", type=file_place, required=True, metavar="FACE", help=".3dm, .3dma or .glb")
    add_options(export, "overwrite")
    export.set_defaults(act=_export)
    info = kinds.add_parser("info", help="list a file", description="List the movestates of a file.")
    info.add_argument("file", type=Path, metavar="FILE", help=".3dm, .3dma, .glb or .gltf")
    info.set_defaults(act=_info)
    convert = kinds.add_parser("convert", help="convert a file", description="Write movestates in another format.")
    convert.add_argument("source", type=Path, metavar="IN", help="a file, or a head of the program: woman or man")
    convert.add_argument("out", type=file_place, metavar="OUT", help=".3dm, .3dma or .glb")
    convert.add_argument("--mesh", type=Path, metavar="M", help="mesh of IN, if its vertices are to be renumbered")
    distance = number_in(0, math.inf, "units of the mesh")
    convert.add_argument(
        "--tolerance",
        type=distance,
        default=TOLERANCE,
        metavar="D",
        help=f"distance of equal vertices (default: {TOLERANCE})",
    )
    add_options(convert, "overwrite")
    convert.set_defaults(act=_convert)
    mapping = kinds.add_parser(
        "map",
        help="make a mouth table for a face",
        description="Write a mouth table for the names of a face, which are guessed.",
    )
    mapping.add_argument("face", type=Path, metavar="FACE", help=f"{', '.join(MESH_SUFFIXES)}")
    mapping.add_argument("-o", "--out", type=file_place, required=True, metavar="TABLE", help=".toml, for --table")
    mapping.add_argument("--basis", choices=ENOUGH, default="", help="names that ours have (default: what fits best)")
    add_options(mapping, "overwrite")
    mapping.set_defaults(act=_map)
    add_examples(kinds, EXAMPLES_OF)


def run(options: argparse.Namespace) -> int:
    """Run the command; returns its exit code."""
    lines: list[str] = list(options.act(options))
    with guarded_text(None) as file:
        file.writelines(f"{line}\n" for line in lines)
    return 0


def _export(options: argparse.Namespace) -> Iterator[str]:
    Guard(nothing_is_own, options.overwrite).check(options.out)
    base = phonemeengine.load_morph_mesh(options.base)
    states = deformed_states(base, options.targets)
    if not states:
        raise phonemeengine.MeshError(
            f"{options.base.name}: there are no morph targets in it; name the files of targets after it"
        )
    targets = phonemeengine.morph_targets_of(base.mesh, states)
    phonemeengine.save_morph_targets(targets, options.out, base)
    yield _summary(options.out, targets)


def _map(options: argparse.Namespace) -> Iterator[str]:
    Guard(nothing_is_own, options.overwrite).check(options.out)
    names = [state.name for state in phonemeengine.load_morph_mesh(options.face).states]
    mapping = guess_mapping(names, options.basis)
    if not mapping.targets:
        raise phonemeengine.MeshError(
            f"{options.face.name}: none of its {len(names)} shapes has a name that is known; name some anew"
        )
    text = table_to_toml(mapped_table(mapping, options.face.stem))
    write_file(options.out, text.encode(errors="replace"), phonemeengine.MeshError)
    yield f"{options.out.name}: {len(mapping.targets)} of {len(mapping.ours)} movestates of {mapping.basis} are found"
    yield from (f"{ours}  {', '.join(shapes)}" for ours, shapes in mapping.targets.items())
    for what, left in (("not found", mapping.missing), ("left over", mapping.left_over)):
        if left:
            yield f"{what}: {', '.join(left)}"


def _info(options: argparse.Namespace) -> Iterator[str]:
    path: Path = options.file
    if path.suffix.lower() in MESH_SUFFIXES or str(path) in {*Head}:
        morph_mesh = phonemeengine.load_morph_mesh(path)
        mesh = morph_mesh.mesh
        yield f"{path.name}: {_many(len(mesh), 'vertex')}, {_many(len(mesh.triangles), 'triangle')}, " + _many(
            len(mesh.materials), "material"
        )
        yield from _table(morph_mesh.states)
        return
    targets = _targets_of(path)
    yield _summary(path, targets)
    yield from _table(targets.states)


def _convert(options: argparse.Namespace) -> Iterator[str]:
    Guard(nothing_is_own, options.overwrite).check(options.out)
    targets = _targets_of(options.source)
    morph_mesh = (
        phonemeengine.load_morph_mesh(options.source)
        if options.source.suffix.lower() not in TARGET_SUFFIXES
        else None
    )
    if options.mesh is not None:
        morph_mesh = phonemeengine.load_morph_mesh(options.mesh)
        as_it_was, targets = targets, phonemeengine.matched(targets, morph_mesh.mesh, options.tolerance)
        if targets is not as_it_was:
            yield f"{options.source.name}: the vertices are renumbered as {options.mesh.name} has them"
    phonemeengine.save_morph_targets(targets, options.out, morph_mesh)
    yield _summary(options.out, targets)


def _targets_of(path: Path) -> phonemeengine.MorphTargets:
    if str(path) in {*Head}:
        head = phonemeengine.load_head(str(path))
        return phonemeengine.morph_targets_of(head.mesh, head.states)
    return phonemeengine.load_morph_targets(path)


def _summary(path: Path, targets: phonemeengine.MorphTargets) -> str:
    size = path.stat().st_size / 1000
    return (
        f"{path.name}: {_many(len(targets.states), 'movestate')}, {len(targets.numbers)} vertices move, {size:.0f} kB"
    )


def _table(states: tuple[phonemeengine.Movestate, ...]) -> Iterator[str]:
    if not states:
        return
    width = max(9, *(len(state.name) for state in states))
    yield f"{'movestate':{width}}  vertices  farthest"
    for state in states:
        yield f"{state.name:{width}}  {len(state):8}  {state.reach:8.4f}"


def _many(n: int, what: str) -> str:
    plural = "vertices" if what == "vertex" else f"{what}s"
    return f"{n} {what if n == 1 else plural}"
