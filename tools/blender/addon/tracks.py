# SPDX-License-Identifier: MIT
"""How a face moves with a sound, out of a file: curves JSON, or the CSV of Live Link Face."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.blendshape_names import LIVE_LINK_ANGLES
from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.curves_file import HEAD, ExportedCurves, read_curves
from phonemeengine.performance.face_track import FaceTrack, read_livelink
from phonemeengine.storage.files import printable_name

ANGLES = tuple(f"head{angle.capitalize()}" for angle in HEAD)
"""The channels that turn the head, degrees: how Live Link calls them."""
ALL_ANGLES = frozenset(name[0].lower() + name[1:] for name in LIVE_LINK_ANGLES)
"""Those, and the channels that turn the eyes."""


@dataclass(frozen=True, eq=False)
class SpokenTrack:
    """What a file says.

    Attributes
    ----------
    movement : weights of movestates, 1 for the whole movement, and angles of the head in degrees.
    cues : which mouth shape from when to when; empty where the file has none.
    """

    movement: FaceTrack
    cues: tuple[Cue, ...] = ()

    @property
    def movestates(self) -> tuple[str, ...]:
        """The channels that are no angles."""
        return tuple(name for name in self.movement.channels if name not in ALL_ANGLES)

    def columns_of(self, channels: Mapping[str, str], rate: float) -> dict[str, Float32Array]:
        """Return the values of some channels at each frame, at a frame rate, under other names."""
        frames = np.arange(int(self.movement.duration * rate + 1e-6) + 1)
        values = self.movement.sampled(frames / rate)
        return {name: values[:, self.movement.channels.index(channel)] for name, channel in channels.items()}


def read_track(path: Path) -> SpokenTrack:
    """Read a file; its ending says what it is.

    Raises
    ------
    EngineError : it cannot be read, or says something impossible.
    """
    if path.suffix.lower() == ".csv":
        return SpokenTrack(read_livelink(path))
    if path.suffix.lower() != ".json":
        raise MouthError(f"{printable_name(path)}: its ending must be .json or .csv; choose another file")
    curves = read_curves(path)
    return SpokenTrack(_movement_of(curves), curves.cues)


def _movement_of(curves: ExportedCurves) -> FaceTrack:
    values = np.hstack((curves.weights, curves.head))
    if not len(values):  # nothing moves
        values = np.zeros((1, values.shape[1]), np.float32)
    return FaceTrack(np.arange(len(values)) / curves.rate, (*curves.movestates, *ANGLES), values)
