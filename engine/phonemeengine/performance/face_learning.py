"""Learning a face that follows the sound alone, from a folder of recorded performances.

Principal components of its shapes are fewer numbers a frame, from which its weights come back.
"""

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import ModelError, PerformanceError
from phonemeengine.execution import Progress, no_progress, report_progress
from phonemeengine.labels.phone_sets import ARTICULATIONS, letters_of
from phonemeengine.mouth.blendshape_names import ARKIT
from phonemeengine.mouth.table import USUAL_TABLE, MouthTable, load_table
from phonemeengine.performance import face_network
from phonemeengine.performance.corpus import CorpusReading, find_recordings
from phonemeengine.performance.driver import MOUTH
from phonemeengine.performance.face_track import shape_name
from phonemeengine.performance.recording import Basis, Performance, PerformedPhone
from phonemeengine.performance.table_file import PerformanceTable, TableAbout, write_table
from phonemeengine.recognition.model import Model
from phonemeengine.settings import FRAME_PERIOD

PENALTY = 100.0
"""Of ridge regression, in frames: how many would have to speak against a weight of 1 on a standardised state."""
FEWEST_CLOSURES = 5
"""Phones of a class from which its pose is known."""
LEFT_OUT = 5
"""Recordings of which one is left out when the error is measured."""
LEAST_SECONDS = 30.0
"""Of performances, to learn from."""


@dataclass(frozen=True)
class LearnedFace:
    """What came of learning.

    Attributes
    ----------
    network : what was learned, from all recordings.
    error, still : how far the weights are off in recordings that were left out, root mean square over frames and
        channels, 0..1; and a face that stays at its mean.
    left_out, notes : as of `BuiltTable`.
    """

    network: face_network.FaceNetwork
    error: float
    still: float
    left_out: tuple[str, ...]
    notes: tuple[str, ...]


class _Moments:
    """Sums over frames from which ridge regression is solved, so that no frame is kept."""

    def __init__(self) -> None:
        self.n = 0.0
        self._sums: list[Float64Array] = []

    def add(self, states: Float32Array, face: Float32Array) -> None:
        """Take frames."""
        rows, values = states.astype(np.float64), face.astype(np.float64)
        found = [rows.sum(axis=0), values.sum(axis=0), rows.T @ rows, rows.T @ values]
        self._sums = [a + b for a, b in zip(self._sums, found, strict=True)] if self._sums else found
        self.n += len(rows)

    @property
    def mean(self) -> Float64Array:
        """The face's mean weights, shape (n_channels,)."""
        return self._sums[1] / self.n

    def solved(self) -> face_network.FaceLayer:
        """Return the layer with the least squared error, and a penalty on large weights of standardised states."""
        x, y, xx, xy = self._sums
        scatter = xx - np.outer(x, x) / self.n
        spread = np.diag(scatter) / self.n  # the variance of each state: as if states were standardised
        scatter[np.diag_indices(len(x))] += PENALTY * spread + 1e-9
        weights = np.linalg.solve(scatter, xy - np.outer(x, y) / self.n)
        bias = (y - x @ weights) / self.n
        return face_network.FaceLayer(weights.astype(np.float16).astype(np.float32), bias.astype(np.float32))


class _FaceExample(NamedTuple):
    """A recording: its sound, and the weights of its channels for each frame of 10 ms."""

    samples: Float32Array
    face: Float32Array
    phones: tuple[PerformedPhone, ...]


def learn_face(
    folder: str | os.PathLike[str], trunk: Model, *, name: str | None = None, progress: Progress = no_progress
) -> LearnedFace:
    """Learn how a face moves from a folder of recorded performances; see `find_recordings` for what it holds.

    One recording in five is left out at first, to tell how far the network is off; then it learns from all.

    Parameters
    ----------
    trunk : the small network of a learned preset, which tells the fifteen visemes apart.
    name : what the network is called; as the folder, where it is None.

    Raises
    ------
    CorpusError : there is no recording in the folder.
    PerformanceError : no recording can be used, they are too short or have no mouth.
    ModelError : the trunk knows no such visemes.
    Cancelled : it was not wanted any more.
    """
    if not face_network.knows_closures(trunk):
        raise ModelError("a face is learned on a real-time model with the usual visemes; choose the preset learned")
    corpus = find_recordings(Path(folder))
    reading = CorpusReading(corpus, lambda share: progress(0.9 * share))
    parts, whole = ({ahead: _Moments() for ahead in (face_network.LIVE, face_network.WHOLE)} for _ in range(2))
    held_out: list[_FaceExample] = []
    poses = _PoseMeans()
    channels: tuple[str, ...] = ()
    for number, (files, performance) in enumerate(reading.recordings(), 1):
        channels = channels or _moved(performance)
        with SoundReader(files.sound) as reader:
            recorded = _recorded(performance, reader.read_mono(), channels)
        poses.add(recorded)
        states, n = _states_of(trunk, recorded), len(recorded.face)
        for moments in (whole, parts) if number % LEFT_OUT else (whole,):
            for ahead, sums in moments.items():
                sums.add(states[ahead : ahead + n], recorded.face)
        if not number % LEFT_OUT:
            held_out.append(recorded)
    duration = whole[face_network.WHOLE].n * FRAME_PERIOD
    if duration < LEAST_SECONDS or not held_out:
        raise PerformanceError(
            f"a face is learned from {LEAST_SECONDS:g} s of performances and {LEFT_OUT} recordings at least, found "
            f"{duration:.0f} s; record more"
        )
    about: dict[str, Any] = {"name": name or corpus.name, "synthetic": corpus.synthetic, "seconds": round(duration)}
    small = face_network.FaceNetwork(_bare(trunk), channels, _solved(parts), poses.means(), about)
    error, still = _errors(small, held_out, parts[face_network.WHOLE].mean)
    about |= {"error": round(error, 4), "still": round(still, 4), "left_out": len(held_out)}
    report_progress(progress, 1.0)
    notes = (*corpus.notes, *reading.notes)
    return LearnedFace(replace(small, layers=_solved(whole)), error, still, tuple(reading.left_out), notes)


def _bare(trunk: Model) -> Model:
    """Return the model without what only its adaptation needs."""
    return replace(trunk, anchors=trunk.anchors[:0], about={}, live_head=None)


def _solved(moments: dict[int, _Moments]) -> dict[int, face_network.FaceLayer]:
    return {ahead: sums.solved() for ahead, sums in moments.items()}


def _moved(performance: Performance) -> tuple[str, ...]:
    channels = tuple(name for name in performance.channels if name in ARKIT and name.startswith(MOUTH))
    if not channels:
        raise PerformanceError(f"{performance.name}: its face has no blend shapes of a mouth; record ARKit's")
    return channels


def _recorded(performance: Performance, samples: Float32Array, channels: tuple[str, ...]) -> _FaceExample:
    n = sum(len(windows) for windows in face_network.windows_of([samples], 0))
    middles = (np.arange(n) + 0.5) * FRAME_PERIOD * performance.rate
    frames = np.arange(len(performance.weights))
    columns = (performance.weights[:, performance.channels.index(name)] for name in channels)
    face = np.stack([np.interp(middles, frames, column) for column in columns], axis=1)
    return _FaceExample(samples, face.astype(np.float32), performance.phones)


def _states_of(trunk: Model, recorded: _FaceExample) -> Float32Array:
    """Return what answers are made of that wait for nothing; those that wait for n frames are made of later rows."""
    reader = face_network.StateReader(trunk, face_network.LIVE)
    return np.concatenate(
        [reader.follow(windows)[0] for windows in face_network.windows_of([recorded.samples], face_network.WHOLE)]
    )


class _PoseMeans:
    """The mean face in the middle of closures."""

    def __init__(self) -> None:
        self._found: list[list[Float32Array]] = [[] for _ in face_network.CLOSURES]

    def add(self, recorded: _FaceExample) -> None:
        """Take the closures of a recording."""
        for phone in recorded.phones:
            letters = letters_of(phone.name)
            for found, kind in zip(self._found, face_network.CLOSURES.values(), strict=True):
                if letters and letters[0] in ARTICULATIONS[kind]:
                    frame = int((phone.start + phone.end) / 2 / FRAME_PERIOD)
                    found.append(recorded.face[min(frame, len(recorded.face) - 1)])

    def means(self) -> Float32Array:
        """Return the poses, NaN where there were too few closures to know one."""
        width = max((len(found[0]) for found in self._found if found), default=1)
        unknown = np.full(width, np.nan, np.float32)
        return np.stack(
            [np.mean(found, axis=0) if len(found) >= FEWEST_CLOSURES else unknown for found in self._found]
        )


def _errors(
    network: face_network.FaceNetwork, recordings: Iterable[_FaceExample], mean: Float64Array
) -> tuple[float, float]:
    """Return how far a network is off, and a face at a mean; root mean squares."""
    squares = np.zeros(2)
    n = 0
    for recorded in recordings:
        follower = face_network.FaceFollower(network, face_network.WHOLE)
        moved = np.concatenate(
            [follower.follow(w) for w in face_network.windows_of([recorded.samples], face_network.WHOLE)]
        )
        squares += np.sum((moved - recorded.face) ** 2), np.sum((mean - recorded.face) ** 2)
        n += recorded.face.size
    error, still = np.sqrt(squares / n).tolist()
    return error, still


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
