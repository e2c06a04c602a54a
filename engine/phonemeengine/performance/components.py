"""Principal components of the shapes of a face: fewer numbers a frame, from which its weights come back."""

import os
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from phonemeengine.errors import PerformanceError
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.performance.face_track import shape_name
from phonemeengine.performance.recording import Performance
from phonemeengine.performance.table_file import PerformanceTable, TableAbout, write_table
from phonemeengine.performance.table_rows import Basis

USUAL_SHARE = 0.99
"""The share of the variance of all shapes that components explain."""


def principal_components(performances: Iterable[Performance], share: float = USUAL_SHARE) -> Basis:
    """Return the fewest components that explain a share of the variance of blend shapes; one at least.

    Parameters
    ----------
    performances : of the same channels, at least one with a blend shape among them; one after the other is taken.
    share : 0..1.

    Raises
    ------
    PerformanceError : there is no blend shape in them, or the share is out of range.
    """
    if not 0 < share <= 1:
        raise PerformanceError(f"components explain a share in 0..1 of what moves, got {share:g}; choose another")
    names: tuple[str, ...] = ()
    n, total, squares = 0, np.zeros(0), np.zeros((0, 0))
    for performance in performances:
        if not names:
            names = tuple(name for name in performance.channels if shape_name(name) is not None)
            total, squares = np.zeros(len(names)), np.zeros((len(names), len(names)))
        weights = performance.weights[:, [*map(performance.channels.index, names)]].astype(np.float64)
        n, total, squares = n + len(weights), total + weights.sum(axis=0), squares + weights.T @ weights
    if not names:
        raise PerformanceError("components are of blend shapes, and no channel of the recordings is one; name others")
    mean = total / n
    variances, vectors = np.linalg.eigh(squares / n - np.outer(mean, mean))
    explained = np.cumsum(np.maximum(variances[::-1], 0))
    k = min(int(np.searchsorted(explained, share * explained[-1])) + 1, len(names))
    return Basis(names, mean.astype(np.float32), vectors[:, ::-1][:, :k].T.astype(np.float32))


def reduce_table(table: PerformanceTable, path: str | os.PathLike[str], basis: Basis) -> TableAbout:
    """Write a table once more, with components in place of its blend shapes; it is read as any other.

    Raises
    ------
    PerformanceError : the table is damaged, or the new one cannot be written.
    """
    about = table.about
    folder = table.path.parent / about.folder if about.folder else None
    performances = (found for _, found in table.recordings())
    return write_table(
        path,
        performances,
        name=about.name,
        folder=folder,
        person=about.person,
        language=about.language,
        clips=about.clips,
        basis=basis,
    )


def component_table(basis: Basis, name: str) -> MouthTable:
    """Return a mouth table whose curves are those of the components, for a rig that has a shape for each, ``pc1`` on.

    A component's shape is the sum of the face's shapes by its numbers; weights are counted from the neutral face.
    """
    percent = np.round(100.0 * basis.components.T, 4).tolist()
    targets = {
        shape: {f"pc{k + 1}": share for k, share in enumerate(row)}
        for shape, row in zip(basis.shapes, percent, strict=True)
    }
    return replace(load_table(USUAL_TABLE), name=name, targets=targets)


def rms_between(pairs: Iterable[tuple[Performance, Performance]]) -> float:
    """Return the root mean square difference of all blend shapes of performances, pair by pair."""
    squares, n = 0.0, 0
    for before, after in pairs:
        for k, name in enumerate(before.channels):
            if shape_name(name) is not None:
                apart = before.weights[:, k] - after.weights[:, after.channels.index(name)]
                squares, n = squares + float(apart @ apart), n + len(apart)
    return float(np.sqrt(squares / max(n, 1)))
