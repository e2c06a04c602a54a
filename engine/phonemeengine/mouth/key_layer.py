"""Keys that an animator sets: a layer over the movement that is generated, kept in a file beside the sound.

The layer holds offsets, not weights: what is generated may change afterwards, by another driver or expression, and
the edits stay. An offset key lies at a time; between two keys of one blend shape the offset follows a monotone cubic
(Fritsch & Carlson 1980, as `scipy.interpolate.PchipInterpolator` has it), which does not overshoot; before the first
and after the last one it is 0.
"""

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from pathlib import Path

import numpy as np
import tomli_w
from typing_extensions import override

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray, ShortRepr
from phonemeengine.errors import MouthError
from phonemeengine.storage.files import write_file
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml

FORMAT = "phonemeanalyser-keys-1"
ENDING = ".keys.toml"
"""Ends the name of the file beside a sound: that of ``talk.wav`` is ``talk.keys.toml``."""
MOST_KEYS = 100_000
"""Of one blend shape: an hour of keys at 25 frames a second."""
LATEST = 86_400.0
"""Seconds; no key is later than a day."""
LARGEST = 64 * 2**20
"""Bytes of a file."""
TOLERANCE = 0.02
"""Of the weight, by which the lines between the points of a curve may miss it."""
PIECE = 256
"""Frames, for which points are found without a look at others."""


@dataclass(frozen=True, eq=False, repr=False)
class KeyCurve(ShortRepr):
    """The keys of one blend shape.

    Attributes
    ----------
    times : seconds, rising, float64, shape (n_keys,).
    offsets : what is added to the weight at these times, -1..1, float64, shape (n_keys,).

    Raises
    ------
    MouthError : the times do not rise or lie outside 0..86,400 s, an offset lies outside -1..1, or there is a single
        key, or too many.
    """

    times: Float64Array
    offsets: Float64Array

    def __post_init__(self) -> None:
        if len(self.times) == 1 or len(self.times) > MOST_KEYS:
            raise MouthError(f"an edited blend shape has 2..{MOST_KEYS} keys, got {len(self.times)}; correct them")
        bad = np.flatnonzero(~((self.times >= 0) & (self.times <= LATEST)))
        if len(bad):
            raise MouthError(f"a key lies at 0..{LATEST:g} s, found {self.times[bad[0]]:g} s; correct it")
        if np.any(np.diff(self.times) <= 0):
            early = self.times[1:][np.diff(self.times) <= 0][0]
            raise MouthError(f"each key follows the one before, found {early:g} s; sort them, one at each time")
        bad = np.flatnonzero(~(np.abs(self.offsets) <= 1))
        if len(bad):
            raise MouthError(f"an offset lies in -1..1, found {self.offsets[bad[0]]:g}; correct it")

    @override
    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, KeyCurve)
            and np.array_equal(self.times, other.times)
            and np.array_equal(self.offsets, other.offsets)
        )

    @override
    def __hash__(self) -> int:
        return hash((self.times.tobytes(), self.offsets.tobytes()))

    def at(self, times: Float64Array) -> Float64Array:
        """Return the offsets at some times, seconds, of the same shape."""
        if not len(self.times):
            return np.zeros(np.shape(times))
        within = (times >= self.times[0]) & (times <= self.times[-1])
        return np.where(within, self._interpolated(times), 0.0)

    @cached_property
    def _interpolated(self) -> Callable[[Float64Array], Float64Array]:
        from scipy.interpolate import PchipInterpolator  # noqa: PLC0415 - half a second that no start should wait for

        curve: Callable[[Float64Array], Float64Array] = PchipInterpolator(self.times, self.offsets)
        return curve

    def replaced(self, start: float, end: float, times: Sequence[float], offsets: Sequence[float]) -> "KeyCurve":
        """Return the curve with other keys from `start` to `end`, seconds, both included."""
        kept = (self.times < start) | (self.times > end)
        both = np.concatenate([self.times[kept], times]), np.concatenate([self.offsets[kept], offsets])
        order = np.argsort(both[0], kind="stable")
        return KeyCurve(both[0][order], both[1][order])


UNEDITED: KeyCurve = KeyCurve(np.zeros(0), np.zeros(0))
"""No keys: the blend shape moves as it is generated."""


@dataclass(frozen=True)
class KeyLayer:
    """The keys of a sound, by the name of the blend shape."""

    curves: Mapping[str, KeyCurve]

    def __bool__(self) -> bool:
        return any(len(curve.times) for curve in self.curves.values())

    def curve_of(self, movestate: str) -> KeyCurve:
        """Return the keys of a blend shape; an empty curve where there are none."""
        return self.curves.get(movestate, UNEDITED)

    def with_curve(self, movestate: str, curve: KeyCurve) -> "KeyLayer":
        """Return the layer with other keys of a blend shape."""
        others = {name: keys for name, keys in self.curves.items() if name != movestate}
        return KeyLayer(others | {movestate: curve} if len(curve.times) else others)

    def over(self, weights: Float32Array, movestates: Sequence[str], times: Float64Array) -> Float32Array:
        """Return weights with the offsets added, within 0..1 where there is one.

        Parameters
        ----------
        weights : what is generated, shape (n_times, n_movestates); it is not changed.
        movestates : the names of its columns; keys of others have no effect.
        times : of its rows, seconds.
        """
        shown = weights
        for column, name in enumerate(movestates):
            if name in self.curves:
                offsets = self.curves[name].at(times)
                moved = offsets != 0  # what is not edited stays as it is, also outside 0..1
                if np.any(moved):
                    shown = weights.copy() if shown is weights else shown
                    shown[moved, column] = np.clip(weights[moved, column] + offsets[moved], 0.0, 1.0)
        return shown

    def over_one(self, weights: Float32Array, movestates: Sequence[str], time: float) -> Float32Array:
        """Return the weights of one time, shape (n_movestates,), with the offsets added; see `over`."""
        if not self.curves:
            return weights
        edited: Float32Array = self.over(weights[np.newaxis], movestates, np.array([time]))[0]
        return edited


NO_KEYS: KeyLayer = KeyLayer({})
"""Nothing was edited."""


# The edits of an animator: each takes what is shown now, and gives the offsets that show what is wanted.


@dataclass(frozen=True, eq=False)
class ShownCurve:
    """One blend shape as it is shown: what is generated and the offsets of a layer, on the frames of an animation.

    Attributes
    ----------
    generated : the weights without the layer, shape (n_frames,).
    rate : frames per second.
    keys : the offsets.
    """

    generated: Float32Array
    rate: float
    keys: KeyCurve = UNEDITED

    @cached_property
    def times(self) -> Float64Array:
        """The time of each frame, seconds."""
        return np.arange(len(self.generated)) / self.rate

    @cached_property
    def shown(self) -> Float64Array:
        """The weights with the offsets, shape (n_frames,)."""
        offsets = self.keys.at(self.times)
        return np.where(offsets != 0, np.clip(self.generated + offsets, 0.0, 1.0), self.generated)

    def points(self, start: float = 0.0, end: float = math.inf) -> Float64Array:
        """Return the times of the keys in a range, and of few points whose joining lines are near the curve there.

        They are seconds, and rise. The points are those of Ramer (1972) and Douglas & Peucker (1973): the frame that
        is farthest from the line between two points becomes a point, until none is farther than `TOLERANCE`. Each
        `PIECE` begins with a point, so that a range of a long sound is as quick as that of a short one.
        """
        last = max(len(self.shown) - 1, 0)
        first = int(min(max(start, 0.0) * self.rate, last)) // PIECE * PIECE
        behind = PIECE * (int(min(end * self.rate, last)) // PIECE + 1) + 1
        points = (first + _corners_of(self.shown[first:behind])) / self.rate
        keys = self.keys.times[self.keys.times * self.rate <= last + 1e-6]
        found = np.unique(np.concatenate([points, keys]))
        return found[(found >= start) & (found <= end)]

    def with_point(self, time: float, weight: float, before: float, after: float) -> KeyCurve:
        """Return the keys by which the curve goes through a weight at a time; outside of `before`..`after` it stays.

        Raises
        ------
        MouthError : the times do not rise, or lie outside the sound.
        """
        self._check_within(before, time, after)
        offset = min(max(weight, 0.0), 1.0) - self._generated_at(time)
        return self._pinned(before, after, [time], [min(max(offset, -1.0), 1.0)])

    def without_point(self, before: float, after: float) -> KeyCurve:
        """Return the keys by which the curve goes straight from the point before to the point after.

        Raises
        ------
        MouthError : the times do not rise, or lie outside the sound.
        """
        self._check_within(before, after)
        ends = np.interp([before, after], self.times, self.shown)
        times = self.times[(self.times > before) & (self.times < after)]
        return self._through(before, after, times, np.interp(times, [before, after], ends))

    def smoothed(self, start: float, end: float, width: float = 0.04) -> KeyCurve:
        """Return the keys by which the curve is smooth from start to end: a Gaussian mean.

        Parameters
        ----------
        width : its standard deviation, seconds.

        Raises
        ------
        MouthError : the times do not rise, or lie outside the sound.
        """
        from scipy.ndimage import gaussian_filter1d  # noqa: PLC0415 - who plays faces needs no image filters

        self._check_within(start, end)
        smooth = gaussian_filter1d(self.shown, width * self.rate, mode="nearest")
        inside = (self.times > start) & (self.times < end)
        return self._through(start, end, self.times[inside], smooth[inside])

    def raised(self, start: float, end: float, by: float) -> KeyCurve:
        """Return the keys by which the curve is higher from start to end, or lower; it stays at both ends.

        Raises
        ------
        MouthError : the times do not rise, or lie outside the sound.
        """
        self._check_within(start, end)
        inside = (self.times > start) & (self.times < end)
        return self._through(start, end, self.times[inside], self.shown[inside] + by)

    def as_generated(self, start: float, end: float) -> KeyCurve:
        """Return the keys without those from start to end."""
        return self.keys.replaced(start, end, [], [])

    def _through(self, start: float, end: float, times: Float64Array, weights: Float64Array) -> KeyCurve:
        offsets = np.clip(weights, 0.0, 1.0) - np.interp(times, self.times, self.generated)
        return self._pinned(start, end, times.tolist(), np.clip(offsets, -1.0, 1.0).tolist())

    def _pinned(self, start: float, end: float, times: list[float], offsets: list[float]) -> KeyCurve:
        """Return the keys with others between two times, where the offsets stay what they are."""
        pins = self.keys.at(np.array([start, end])).tolist()
        return self.keys.replaced(start, end, [start, *times, end], [pins[0], *offsets, pins[1]])

    def _generated_at(self, time: float) -> float:
        return float(np.interp(time, self.times, self.generated))

    def _check_within(self, *times: float) -> None:
        end = (len(self.generated) - 1) / self.rate
        rises = all(early < late for early, late in pairwise(times))
        if not rises or not (times[0] >= 0 and times[-1] <= end + 1e-9):
            shown = ", ".join(f"{time:.3f}" for time in times)
            raise MouthError(
                f"keys lie one after the other within the sound, 0..{end:.3f} s, got {shown} s; move them"
            )


def _corners_of(weights: Float64Array) -> IndexArray:
    """Return the frames of the points by which few lines are near a curve; those between all points at once."""
    frames = np.arange(len(weights))
    corners = np.unique(np.concatenate([frames[::PIECE], frames[-1:]]))
    while len(corners) > 1:
        far = np.abs(weights - np.interp(frames, corners, weights[corners]))
        far[far <= TOLERANCE] = -1.0  # is no farthest one
        farthest = np.maximum.reduceat(far[:-1], corners[:-1])
        found = frames[:-1][(far[:-1] > 0) & (far[:-1] == np.repeat(farthest, np.diff(corners)))]
        _, first = np.unique(np.searchsorted(corners, found), return_index=True)  # of frames that are equally far
        if not len(first):
            break
        corners = np.sort(np.concatenate([corners, found[first]]))
    return corners


# Files.


def keys_beside(sound: Path) -> Path:
    """Return the name of the file of keys beside a sound."""
    return sound.with_suffix(ENDING)


def read_keys(path: str | os.PathLike[str]) -> KeyLayer:
    """Return the keys of a file.

    Raises
    ------
    MouthError : it cannot be read, or is none; the message begins with its name.
    """
    return load_text(path, f"a file of keys ({ENDING})", MouthError, parse_keys, LARGEST)


def parse_keys(text: str) -> KeyLayer:
    """Return the keys that a text tells of.

    Raises
    ------
    MouthError : it is no TOML or not of this format, or a number lies outside its range.
    """
    top = parse_toml(text, "a file of keys", FORMAT, MouthError)
    top.check_keys((), ("curves",))
    curves: dict[str, KeyCurve] = {}
    for table in top.tables("curves"):
        table.check_keys(("movestate", "times", "offsets"))
        name = table.value("movestate", str)
        if name in curves:
            raise MouthError(f"{name[:60]!r} has two curves; join them")
        curves[name] = _curve_of(table, name)
    return KeyLayer(curves)


def _curve_of(table: StrictTable, name: str) -> KeyCurve:
    times, offsets = np.array(table.numbers("times"), float), np.array(table.numbers("offsets"), float)
    if len(times) != len(offsets):
        raise MouthError(f"{name[:60]!r} has {len(times)} times and {len(offsets)} offsets; give as many of each")
    return KeyCurve(times, offsets)


def format_keys(layer: KeyLayer) -> str:
    """Return the text of a file of keys; see `parse_keys`."""
    curves = [
        {
            "movestate": name,
            "times": [round(time, 6) for time in curve.times.tolist()],
            "offsets": [round(offset, 6) for offset in curve.offsets.tolist()],
        }
        for name, curve in layer.curves.items()
    ]
    return tomli_w.dumps({"format": FORMAT, "curves": curves})


def write_keys(layer: KeyLayer, path: str | os.PathLike[str]) -> None:
    """Write keys to a file; what was there stays until the new one is complete.

    Raises
    ------
    MouthError : it cannot be written.
    """
    write_file(Path(path), format_keys(layer).encode(), MouthError)
