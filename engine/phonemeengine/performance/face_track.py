"""A face's movement as a capture has it: frames at times of their own, some of them missing."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import CorpusError
from phonemeengine.mouth.blendshape_names import ARKIT, SHOULDERS
from phonemeengine.mouth.face_mapping import shapes_moved_by

LONGEST_GAP = 0.1
"""Seconds without a frame that are bridged."""
LARGEST_WEIGHT = 10.0
"""Beyond this a blend shape's weight is none: captures reach a little beyond 1."""
LONGEST = 3600.0
"""Seconds of a face's movement at most."""
_SHAPES = {name.lower(): name for name in (*ARKIT, *SHOULDERS)}


@dataclass(frozen=True, eq=False)
class FaceTrack:
    """A face's movement.

    Attributes
    ----------
    times : float64, shape (n_frames,): seconds since the face's beginning, increasing.
    channels : the names of the columns.
    weights : float32, shape (n_frames, n_channels), as in `Performance`.
    notes : what is odd about it, a sentence each.
    """

    times: Float64Array
    channels: tuple[str, ...]
    weights: Float32Array
    notes: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """From the beginning to the last frame, seconds."""
        return float(self.times[-1])

    def sampled(self, times: Float64Array) -> Float32Array:
        """Return the weights at some times, between frames on straight lines, beyond them as at the nearest one."""
        columns = (np.interp(times, self.times, column) for column in self.weights.T)
        return np.stack([*columns], axis=1).astype(np.float32)


def captured(times: Float64Array, channels: Sequence[str], weights: Float32Array, file: str) -> FaceTrack:
    """Return frames as a camera gave them: repeated ones are left out, short gaps are bridged, and both are said.

    Parameters
    ----------
    times : seconds of any clock, not decreasing.
    file : what the file is called in a refusal.

    Raises
    ------
    CorpusError : there are fewer than two frames, times go back, a gap is too long, or a weight is none.
    """
    if (back := np.flatnonzero(np.diff(times) < 0)).size:
        raise CorpusError(
            f"{file}, frame {back[0] + 2}: the times of frames must not go back, found {times[back[0] + 1]:.3f} s "
            f"after {times[back[0]]:.3f} s; record it again, or leave it out"
        )
    kept = np.diff(times, prepend=-np.inf) > 0
    times, weights = times[kept] - times[0], weights[kept]
    check_weights(channels, weights, file)
    if len(times) < 2 or times[-1] > LONGEST:
        raise CorpusError(f"{file}: it needs two frames or more within an hour, found {len(times)}; record it again")
    notes = (*_repeated(int(np.sum(~kept))), *_bridged(times, file))
    return FaceTrack(times, tuple(channels), weights, notes)


def shapes_in(names: Sequence[str]) -> dict[str, tuple[int, ...]]:
    """Return the blend shapes that some names stand for, with the places of the names; a shape is the mean of these.

    Names of ARKit and of the shoulders count in any case, and action units such as ``AU12`` for shapes without.
    """
    own: dict[str, tuple[int, ...]] = {}
    for k, name in enumerate(names):
        if (shape := shape_name(name)) is not None:
            own.setdefault(shape, (k,))
    return own | {shape: units for shape, units in shapes_moved_by(names).items() if shape not in own}


def shape_name(name: str) -> str | None:
    """Return a blend shape of ARKit as it spells it, or a shift of the shoulders, in any case; None for others."""
    return _SHAPES.get(name.lower())


def check_weights(channels: Sequence[str], weights: Float32Array, file: str) -> None:
    """Refuse weights that no face has.

    Raises
    ------
    CorpusError : a number is not finite, or a blend shape's is far beyond 0..1.
    """
    shapes = [k for k, name in enumerate(channels) if name in _SHAPES.values()]
    fits = np.isfinite(weights).all(axis=1) & (np.abs(weights[:, shapes]) <= LARGEST_WEIGHT).all(axis=1)
    if not fits.all():
        raise CorpusError(
            f"{file}, frame {fits.argmin() + 1}: a blend shape's weight must lie in 0..1, and angles must be finite, "
            "found others; export it again"
        )


def _repeated(n: int) -> Iterator[str]:
    if n:
        yield f"{n} frames stand there twice; the first of each counts"


def _bridged(times: Float64Array, file: str) -> Iterator[str]:
    """Tell of frames that are missing; refuse a gap that is too long."""
    steps = np.diff(times)
    longest = int(steps.argmax())
    if steps[longest] > LONGEST_GAP:
        raise CorpusError(
            f"{file}: frames may be missing for {LONGEST_GAP:g} s at most, found {steps[longest]:.2f} s without one "
            f"after {times[longest]:.2f} s; record it again, or leave it out"
        )
    n_gaps = int(np.sum(steps > 1.5 * np.median(steps)))
    if n_gaps:
        yield f"frames are missing at {n_gaps} places, for {steps.max():.3f} s at most; they are bridged"
