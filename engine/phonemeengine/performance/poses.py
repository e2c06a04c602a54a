"""Model visemes: the shapes of closures and roundings, laid over what is looked up.

They are TOML files that an animator edits, read strictly; ``poses.toml`` is the one that ships.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import MouthError
from phonemeengine.labels.articulation import articulations_of, letters_of
from phonemeengine.mouth.table import movestates_of, phone_named, shape_named, shapes_in
from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.units import Sentence
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml

FORMAT = "phonemeanalyser poses 1"
USUAL_POSES = Path(__file__).with_name("poses.toml")
MOST_PRIORITY = 100.0
PLATEAU, PLACE = 0.25, 0.35
"""Share of a phone for which its pose holds, and share after which the middle of that comes: early, not late."""
COMING, LEAST_COMING, MOST_COMING = 0.25, 0.015, 0.05
LEAVING, LEAST_LEAVING, MOST_LEAVING = 0.18, 0.012, 0.04
"""Standard deviations of the flanks, beside the phone before and the one after, and their limits, seconds."""
LONGEST_NEIGHBOUR = 0.12
"""Seconds; a longer phone counts as so long."""
FULL_LENGTH = 0.07
"""Seconds that a phone lasts whose pose is met wholly, unless it is firm."""


@dataclass(frozen=True)
class Pose:
    """The pose of a phone, or of a class of them.

    Attributes
    ----------
    shape : its name.
    priority : of poses that overlap, those of a lower one take what is left.
    firm : whether lips or teeth meet, however short the phone is.
    """

    shape: str
    priority: float = 1.0
    firm: bool = False


@dataclass(frozen=True)
class PoseTable:
    """Model visemes.

    Attributes
    ----------
    name : what people call them.
    movestates : the names of the movestates.
    phones : the pose of each letter of the IPA, or class of `ARTICULATIONS`, that has one.
    shapes : for each shape the percentages of its movestates, 100 for the whole movement.
    """

    name: str
    movestates: tuple[str, ...]
    phones: Mapping[str, Pose]
    shapes: Mapping[str, Mapping[str, float]]

    def pose_of(self, name: str) -> Pose | None:
        """Return the pose of a phone, that of the narrowest class that has one; None for none."""
        letters = letters_of(name)[:1] if name != SILENCE else ()
        names = (entry for letter in letters for entry in (letter, *articulations_of(letter)))
        return next((self.phones[entry] for entry in names if entry in self.phones), None)

    def weights(self, shape: str, channels: tuple[str, ...]) -> Float32Array:
        """Return the weights of a shape, 1 for the whole movement; nan where it says nothing of a channel."""
        percentages = self.shapes[shape]
        return np.array([percentages.get(channel, np.nan) / 100 for channel in channels], np.float32)


@dataclass(frozen=True, eq=False)
class PoseShares:
    """How far a face takes which poses.

    Attributes
    ----------
    shares : float32, shape (n_frames, n_posed), 0..1; those of a frame sum to 1 at most.
    shapes : the names of the shapes, one for each.
    firm : float32, shape (n_frames,): how far lips or teeth meet.
    """

    shares: Float32Array
    shapes: tuple[str, ...]
    firm: Float32Array


def pose_shares(sentence: Sentence, poses: PoseTable, times: Float64Array, frame: float) -> PoseShares:
    """Return the shares of all poses of a sentence at some times.

    Parameters
    ----------
    sentence : its phones.
    times : seconds.
    frame : how long a picture is shown, seconds: no pose holds for less.
    """
    posed = [(k, pose) for k, phone in enumerate(sentence) if (pose := poses.pose_of(phone.name)) is not None]
    curves = np.zeros((len(posed), len(times)))
    for row, (k, pose) in zip(curves, posed, strict=True):
        row[:] = _curve(sentence, k, pose, times, frame)
    _share_out(curves, [pose.priority for _, pose in posed])
    firm = sum((row for row, (_, pose) in zip(curves, posed, strict=True) if pose.firm), np.zeros(len(times)))
    return PoseShares(curves.T.astype(np.float32), tuple(pose.shape for _, pose in posed), firm.astype(np.float32))


def posed_weights(
    weights: Float32Array, shares: PoseShares, poses: PoseTable, channels: tuple[str, ...]
) -> Float32Array:
    """Lay poses over weights, shape (n_frames, n_channels), of these channels: what they take, the weights lose."""
    if not shares.shapes:
        return weights
    shapes = np.stack([poses.weights(shape, channels) for shape in shares.shapes])
    decides = np.isfinite(shapes)
    taken = shares.shares @ decides.astype(np.float32)
    laid: Float32Array = shares.shares @ np.where(decides, shapes, 0.0) + (1 - taken) * weights
    return laid


def load_poses(path: str | os.PathLike[str] = USUAL_POSES) -> PoseTable:
    """Load model visemes from a file; those that ship, unless told otherwise.

    Raises
    ------
    MouthError : it cannot be read, or says something impossible; the message names the file and the entry.
    """
    return load_text(path, "a file of poses (.toml)", MouthError, poses_of)


def poses_of(text: str) -> PoseTable:
    """Read model visemes from the text of a TOML file.

    Raises
    ------
    MouthError : not TOML, not of this format, an unknown or missing name, or a value out of range.
    """
    top = parse_toml(text, "a file of poses", FORMAT, MouthError)
    top.check_keys(("movestates", "phones", "shapes"), ("name", "notes"))
    movestates = movestates_of(top)
    shapes = shapes_in(top, movestates)
    phones: dict[str, Pose] = {}
    for key, entry in top.table("phones").tables_by_name():
        name = phone_named(key)
        if name in phones:
            raise MouthError(f"[phones] says twice what {name} is; remove one")
        phones[name] = _pose_of(entry, shapes)
    return PoseTable(top.value("name", str, "untitled"), movestates, phones, shapes)


def _pose_of(entry: StrictTable, shapes: Mapping[str, Mapping[str, float]]) -> Pose:
    entry.check_keys(("shape",), ("priority", "firm"))
    shape = shape_named(entry.name, entry.value("shape", str), shapes)
    what = f"a number in 0..{MOST_PRIORITY:g}"
    priority = entry.limited("priority", 0, MOST_PRIORITY, what, Pose.priority)
    return Pose(shape, priority, entry.value("firm", bool, Pose.firm))


def _curve(sentence: Sentence, k: int, pose: Pose, times: Float64Array, frame: float) -> Float64Array:
    """Return how far the pose of a phone is taken: a plateau with two flanks, each half a Gaussian."""
    phone = sentence[k]
    plateau = max(frame, PLATEAU * phone.duration)
    begin = phone.start + PLACE * phone.duration - plateau / 2
    distance = np.where(times < begin, begin - times, np.maximum(times - begin - plateau, 0.0))
    before = sentence[k - 1].duration if k else 0.0
    after = sentence[k + 1].duration if k + 1 < len(sentence) else 0.0
    coming = np.clip(COMING * min(before, LONGEST_NEIGHBOUR), LEAST_COMING, MOST_COMING)
    leaving = np.clip(LEAVING * min(after, LONGEST_NEIGHBOUR), LEAST_LEAVING, MOST_LEAVING)
    width = np.where(times < begin, coming, leaving)
    height = 1.0 if pose.firm else min(1.0, phone.duration / FULL_LENGTH)
    curve: Float64Array = height * np.exp(-0.5 * (distance / width) ** 2)
    return curve


def _share_out(curves: Float64Array, priorities: list[float]) -> None:
    """Make curves, shape (n, n_times), sum to 1 at most: the lower priorities get what the higher ones leave."""
    left = np.ones(curves.shape[1])
    order = sorted(range(len(curves)), key=lambda k: -priorities[k])
    for _, rows in groupby(order, key=priorities.__getitem__):
        equal = [*rows]
        total = curves[equal].sum(axis=0)
        curves[equal] *= np.minimum(1.0, left / np.maximum(total, 1e-12))
        left = np.maximum(left - curves[equal].sum(axis=0), 0.0)
