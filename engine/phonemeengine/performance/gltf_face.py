"""Faces as animated glTF files: weights of morph targets that bear the names of ARKit's blend shapes, or shoulders'.

Of several animations the last one that moves weights counts; where an exporter thinned out the keys, there is nothing
to bridge. See section 3.11 of the glTF 2.0 specification.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CorpusError, MeshError
from phonemeengine.mouth.files.gltf import target_names
from phonemeengine.mouth.files.gltf_document import (
    Beside,
    Document,
    Table,
    array_of,
    table_of,
    tables_of,
    text_of,
    whole_of,
)
from phonemeengine.mouth.files.io import LARGEST, files_beside
from phonemeengine.performance.face_track import LONGEST, FaceTrack, check_weights, shape_name
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


def parse_gltf_face(content: bytes, file: str, beside: Beside = lambda _name: None) -> FaceTrack:
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
        document = Document(content, beside)
        found = next(filter(None, (_weights_in(document, x) for x in document.list_of("animations")[::-1])), None)
    except MeshError as error:
        raise CorpusError(f"{file}: {error}") from error
    if found is None:
        raise CorpusError(
            f"{file}: no animation in it moves a blend shape of ARKit, such as jawOpen; name the morph targets so, "
            "and export the animation with them"
        )
    return _joined(found, file)


def _weights_in(document: Document, animation: Table) -> Weights:
    """Return what an animation moves; of a name in several meshes, the first one counts."""
    samplers = tables_of(animation, "samplers")
    found: Weights = {}
    for channel in tables_of(animation, "channels"):
        target = table_of(channel, "target")
        if target.get("path") == "weights" and "node" in target:
            place = whole_of(channel, "sampler")
            if place >= len(samplers):
                raise MeshError(f"an animation names sampler {place}, and there are {len(samplers)}; export it again")
            for name, times, weights in _moved(document, whole_of(target, "node"), samplers[place]):
                found.setdefault(name, (times, weights))
    return found


def _moved(document: Document, node: int, sampler: Table) -> Iterator[tuple[str, Float64Array, Float32Array]]:
    names = target_names(document.entry("meshes", whole_of(document.entry("nodes", node), "mesh")))
    times = array_of(document, whole_of(sampler, "input"))[:, 0].astype(np.float64)
    values = array_of(document, whole_of(sampler, "output")).astype(np.float32)
    n_each = 3 if text_of(sampler, "interpolation", "LINEAR") == CUBIC else 1
    if not len(times) or not names or values.shape != (len(times) * n_each * len(names), 1):
        raise MeshError(
            f"an animation has {len(values)} weights for {len(names)} morph targets at {len(times)} times; export it "
            "again"
        )
    weights = values.reshape(len(times), n_each, len(names))[:, IN_BETWEEN if n_each > 1 else 0]
    known = ((shape_name(name), column) for name, column in zip(names, weights.T, strict=True))
    return ((name, times, column) for name, column in known if name is not None)


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
