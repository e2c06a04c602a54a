"""Accessors of a glTF: arrays within its buffers, plain, interleaved, whole numbers as fractions, and sparse."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.glb import Table
from phonemeengine.mouth.files.gltf_document import Document, table_of, text_of, whole_of
from phonemeengine.mouth.mesh import MOST_TRIANGLES

COMPONENTS: Final = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
MOST_ENTRIES = 3 * MOST_TRIANGLES

Array = NDArray[Any]


def array_of(document: Document, place: int) -> Array:
    """Return the array of an accessor, shape (count, width); floats are float32, fractions are made floats.

    Raises
    ------
    MeshError : the accessor says what its buffer does not hold.
    """
    accessor = document.entry("accessors", place)
    n, dtype, width = _form_of(accessor)
    viewed = "bufferView" in accessor
    found = _viewed(document, accessor, n, dtype, width) if viewed else np.zeros((n, width), dtype)
    if "sparse" in accessor:
        found = _with_sparse(document, table_of(accessor, "sparse"), found)
    if accessor.get("normalized") is True and dtype.kind in "iu":
        most = (1 << (8 * dtype.itemsize - (dtype.kind == "i"))) - 1
        return np.maximum(found.astype(np.float32) / most, -1).astype(np.float32)
    return found


def count_of(document: Document, place: int) -> int:
    """Return how many entries an accessor says it has."""
    return _form_of(document.entry("accessors", place))[0]


def _form_of(accessor: Table) -> tuple[int, np.dtype[Any], int]:
    n = whole_of(accessor, "count")
    kind, shape = whole_of(accessor, "componentType"), text_of(accessor, "type")
    if kind not in COMPONENTS or shape not in WIDTHS:
        raise MeshError(f"an accessor is of type {kind} {shape[:20]!r}, which no vertex has; export it again")
    if n > MOST_ENTRIES:
        raise MeshError(f"an accessor has at most {MOST_ENTRIES} entries, got {n}; make the mesh coarser")
    return n, np.dtype(COMPONENTS[kind]), WIDTHS[shape]


def _viewed(document: Document, table: Table, n: int, dtype: np.dtype[Any], width: int) -> Array:
    """Look at a part of a buffer as an array, after checking that it is long enough; copies nothing."""
    view = document.entry("bufferViews", whole_of(table, "bufferView"))
    content = document.buffer(whole_of(view, "buffer"))
    begin, length = whole_of(view, "byteOffset", 0), whole_of(view, "byteLength")
    offset, row = whole_of(table, "byteOffset", 0), dtype.itemsize * width
    stride = whole_of(view, "byteStride", row)
    needed = offset + (stride * (n - 1) + row if n else 0)
    if stride < row or needed > length or begin + length > len(content):
        raise MeshError(
            f"an accessor needs {needed} bytes at {begin}, and its buffer has {len(content)}; it is damaged, "
            "export it again"
        )
    return np.ndarray((n, width), dtype, content, begin + offset, (stride, dtype.itemsize))


def _with_sparse(document: Document, sparse: Table, base: Array) -> Array:
    n = whole_of(sparse, "count")
    if n > len(base):
        raise MeshError(f"a sparse accessor changes {n} of {len(base)} entries; it is damaged, export it again")
    places = table_of(sparse, "indices")
    kind = whole_of(places, "componentType")
    if kind not in (5121, 5123, 5125):
        raise MeshError(f"the indices of a sparse accessor are of type {kind}; export it again")
    where = _viewed(document, places, n, np.dtype(COMPONENTS[kind]), 1)[:, 0].astype(np.int64)
    if n and where.max() >= len(base):
        raise MeshError(f"a sparse accessor changes entry {where.max()}, and it has {len(base)}; export it again")
    changed = base.copy()
    changed[where] = _viewed(document, table_of(sparse, "values"), n, base.dtype, base.shape[1])
    return changed
