"""Faces as animated glTF files: weights of morph targets with names of ARKit or FACS, turns of head, jaw and eyes.

Of several animations the last one that moves any of these counts; where an exporter thinned out the keys, there is
nothing to bridge. Bones stand in for blend shapes of jaw and eyes that are not there. See section 3.11 of the glTF
2.0 specification.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CorpusError, ExportError, MeshError
from phonemeengine.mouth.files import gltf_document
from phonemeengine.mouth.files.gltf import target_names
from phonemeengine.mouth.files.io import LARGEST, files_beside
from phonemeengine.mouth.files.skin import TURNS, face_bones
from phonemeengine.mouth.files.vrm import faces_back
from phonemeengine.performance.face_track import LONGEST, FaceTrack, check_weights, shapes_in
from phonemeengine.performance.recording import HEAD
from phonemeengine.storage.files import MEGABYTE, printable_name, read_file

CUBIC, IN_BETWEEN = "CUBICSPLINE", 1
"""Of a cubic key's three values, the middle one is the weight; its tangents are left out."""
Weights = dict[str, tuple[Float64Array, Float32Array]]
"""By channel: times in seconds, and the weights then."""


def read_gltf_face(path: Path) -> FaceTrack:
    """Read the weights of a .glb or .gltf file's animation.

    Raises
    ------
    CorpusError : it cannot be read, or moves no blend shape of ARKit.
    """
    largest = LARGEST[path.suffix.lower()] * MEGABYTE
    return parse_gltf_face(
        read_file(path, largest, "such a file", CorpusError), printable_name(path), files_beside(path.parent)
    )


def parse_gltf_face(content: bytes, file: str, beside: gltf_document.Beside = lambda _name: None) -> FaceTrack:
    """Read the weights of an animation in the content of a .glb or .gltf file.

    Parameters
    ----------
    file : what it is called in a refusal.
    beside : finds the buffers' files that a .gltf names.

    Raises
    ------
    CorpusError : it is no glTF, or moves no blend shape of ARKit.
    """
    try:
        document = gltf_document.Document(content, beside)
        found = next(filter(None, (_weights_in(document, x) for x in document.list_of("animations")[::-1])), None)
    except (MeshError, ExportError) as error:
        raise CorpusError(f"{file}: {error}") from error
    if found is None:
        raise CorpusError(
            f"{file}: no animation in it moves a blend shape of ARKit, such as jawOpen, or an action unit, such as "
            "AU26; name the morph targets so, and export the animation with them"
        )
    return _joined(found, file)


def _weights_in(document: gltf_document.Document, animation: gltf_document.Table) -> Weights:
    """Return what an animation moves; of a name in several meshes, the first one counts."""
    samplers = gltf_document.tables_of(animation, "samplers")
    found: Weights = {}
    turned: dict[int, tuple[Float64Array, Float32Array]] = {}
    for channel in gltf_document.tables_of(animation, "channels"):
        target = gltf_document.table_of(channel, "target")
        if target.get("path") not in {"weights", "rotation"} or "node" not in target:
            continue
        place, node = gltf_document.whole_of(channel, "sampler"), gltf_document.whole_of(target, "node")
        if place >= len(samplers):
            raise MeshError(f"an animation names sampler {place}, and there are {len(samplers)}; export it again")
        if target["path"] == "rotation":
            turned[node] = _keys_of(document, samplers[place], 4, f"turns of node {node}")
        else:
            for name, times, weights in _moved(document, node, samplers[place]):
                found.setdefault(name, (times, weights))
    return (
        found | {name: keys for name, keys in _turns_of(document, turned) if name not in found} if turned else found
    )


def _moved(
    document: gltf_document.Document, node: int, sampler: gltf_document.Table
) -> Iterator[tuple[str, Float64Array, Float32Array]]:
    names = target_names(document.entry("meshes", gltf_document.whole_of(document.entry("nodes", node), "mesh")))
    times, weights = _keys_of(document, sampler, len(names), f"{len(names)} morph targets")
    return ((shape, times, weights[:, list(some)].mean(axis=1)) for shape, some in shapes_in(names).items())


def _keys_of(
    document: gltf_document.Document, sampler: gltf_document.Table, width: int, what: str
) -> tuple[Float64Array, Float32Array]:
    """Return times, and what moves then, shape (n_times, width)."""
    times = gltf_document.array_of(document, gltf_document.whole_of(sampler, "input"))[:, 0].astype(np.float64)
    values = gltf_document.array_of(document, gltf_document.whole_of(sampler, "output")).astype(np.float32)
    n_each = 3 if gltf_document.text_of(sampler, "interpolation", "LINEAR") == CUBIC else 1
    if not times.size or not width or values.size != len(times) * n_each * width or values.shape[1] not in {1, width}:
        raise MeshError(f"an animation has {len(values)} values for {what} at {len(times)} times; export it again")
    return times, values.reshape(len(times), n_each, width)[:, IN_BETWEEN if n_each > 1 else 0]


def _turns_of(
    document: gltf_document.Document, turned: Mapping[int, tuple[Float64Array, Float32Array]]
) -> Iterator[tuple[str, tuple[Float64Array, Float32Array]]]:
    """Return the turns of the head in degrees, and of its bones as the blend shapes of ARKit that turn them."""
    from phonemeengine.mouth.exports.gltf_rotation import head_nodes, poses_of, turns_in  # noqa: PLC0415 - scipy is slow

    nodes, back = document.list_of("nodes"), faces_back(document)
    scene = {"nodes": nodes, "skins": document.list_of("skins")}
    faces = [k for k, node in enumerate(nodes) if "mesh" in node]
    head = next((node for node in head_nodes(scene, faces) if node in turned), None)
    if head is not None:
        times, quaternions = turned[head]
        poses = poses_of(turns_in(scene, head, quaternions, back=back)).astype(np.float32)
        yield from ((name, (times, column)) for name, column in zip(HEAD, poses.T, strict=True))
    bones = face_bones(document)
    for name, (bone, axis, degrees) in TURNS.items():
        if bone in bones and bones[bone] in turned:
            times, quaternions = turned[bones[bone]]
            angles = turns_in(scene, bones[bone], quaternions, back=back).as_rotvec(degrees=True)[:, axis]
            yield name, (times, np.maximum(angles / degrees, 0).astype(np.float32))


def _joined(found: Weights, file: str) -> FaceTrack:
    """Return all channels at the times at which any of them has a key."""
    if not all(np.isfinite(times).all() and (np.diff(times) > 0).all() for times, _ in found.values()):
        raise CorpusError(f"{file}: the times of its animation must increase; export it again")
    times = np.unique(np.concatenate([times for times, _ in found.values()]))
    if len(times) < 2 or times[0] < 0 or times[-1] > LONGEST:
        raise CorpusError(f"{file}: its animation needs two times or more within an hour; export it again")
    weights = np.stack([np.interp(times, *keys) for keys in found.values()], axis=1).astype(np.float32)
    check_weights(tuple(found), weights, file)
    return FaceTrack(times, tuple(found), weights)
