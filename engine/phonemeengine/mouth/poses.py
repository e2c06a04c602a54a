"""Model visemes: the shapes of closures and roundings, and of the tongue, which a style lays over a face.

They are TOML files that an animator edits, read strictly; ``poses.toml`` and ``tongue.toml`` ship.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.labels.phone_sets import ARTICULATIONS, narrowest
from phonemeengine.mouth.style_numbers import PoseNumbers
from phonemeengine.mouth.table import movestates_of, phone_named, shape_named, shapes_in
from phonemeengine.storage.strict_table import StrictTable, load_text, parse_toml

FORMAT = "phonemeanalyser poses 1"
USUAL_POSES, USUAL_TONGUE = (Path(__file__).with_name(name) for name in ("poses.toml", "tongue.toml"))
MOST_PRIORITY = 100.0
LEAST_WIDTH, MOST_WIDTH = 0.2, 5.0


@dataclass(frozen=True)
class Pose:
    """The pose of a phone, or of a class of them.

    Attributes
    ----------
    shape : its name.
    priority : of poses that overlap, those of a lower one take what is left.
    firm : whether lips or teeth meet, however short the phone is.
    width : factor of the time for which it holds, and in which it comes and goes.
    """

    shape: str
    priority: float = 1.0
    firm: bool = False
    width: float = 1.0


@dataclass(frozen=True)
class PoseTable:
    """Model visemes.

    Attributes
    ----------
    name : what people call them.
    movestates : the names of the movestates.
    phones : the pose of each letter of the IPA, or class of `ARTICULATIONS`, that has one.
    shapes : for each shape the percentages of its movestates, 100 for the whole movement.
    curve : how poses come and go.
    """

    name: str
    movestates: tuple[str, ...]
    phones: Mapping[str, Pose]
    shapes: Mapping[str, Mapping[str, float]]
    curve: PoseNumbers = field(default_factory=PoseNumbers)

    def pose_of(self, name: str) -> Pose | None:
        """Return the pose of a phone, that of the narrowest class that has one; None for none, and for no phone."""
        return narrowest(self.phones, name, None)

    def entry(self, name: str) -> Pose | None:
        """Return the pose of a class, or of a letter, which may be that of its narrowest class; None for none."""
        return self.phones.get(name) if name in ARTICULATIONS else self.pose_of(name)

    def weights(self, shape: str, channels: tuple[str, ...]) -> Float32Array:
        """Return the weights of a shape, 1 for the whole movement; nan where it says nothing of a channel."""
        percentages = self.shapes[shape]
        return np.array([percentages.get(channel, np.nan) / 100 for channel in channels], np.float32)


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
    entry.check_keys(("shape",), ("priority", "firm", "width"))
    shape = shape_named(entry.name, entry.value("shape", str), shapes)
    return pose_numbers(entry, Pose(shape))


def pose_numbers(entry: StrictTable, pose: Pose) -> Pose:
    """Return a pose with the priority, the width and the firmness that an entry gives, else its own."""
    what = f"a number in 0..{MOST_PRIORITY:g}"
    priority = entry.limited("priority", 0, MOST_PRIORITY, what, pose.priority)
    what = f"a number in {LEAST_WIDTH:g}..{MOST_WIDTH:g}"
    width = entry.limited("width", LEAST_WIDTH, MOST_WIDTH, what, pose.width)
    return Pose(pose.shape, priority, entry.value("firm", bool, pose.firm), width)
