# SPDX-License-Identifier: MIT
"""A face that moves by curves: an action for its shape keys, and one for its head."""

import bpy
import numpy as np
from mathutils import Euler

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import MeshError

from .actions import add_curve, mute_tracks, new_action, path_of_key, play_action
from .mouth_tables import key_named
from .shape_keys import names_of_keys
from .tracks import ANGLES, SpokenTrack

HEAD_ORDER = "YXZ"
"""A head rolls first, then nods, then turns."""


def animate_face(face: bpy.types.Object, track: SpokenTrack, name: str, first: float, rate: float) -> tuple[str, ...]:
    """Move a face's shape keys by a track.

    Parameters
    ----------
    name : of the action.
    first : the frame on which the track begins.
    rate : frames a second.

    Returns
    -------
    The movestates that the face has no shape key for.

    Raises
    ------
    MeshError : it has none of them; nothing changes.
    """
    keys = names_of_keys(face)
    wanted = track.movestates
    channels = {key: channel for channel in wanted if (key := key_named(channel, keys))}
    if not channels:
        raise MeshError(
            f"{face.name} has no shape key called like what moves, {', '.join(wanted[:3]) or 'which is nothing'}; "
            "choose another face, or export with a mouth table of its own"
        )
    action, curves = new_action(name, "KEY")
    for key, values in track.columns_of(channels, rate).items():
        allow(face, key, values)
        add_curve(curves, path_of_key(key), first, values)
    play_action(face.data.shape_keys, action)
    mute_tracks(face.data.shape_keys)
    return tuple(channel for channel in wanted if channel not in channels.values())


def allow(face: bpy.types.Object, key: str, values: Float32Array) -> None:
    """Widen a shape key's range so that it can have some values."""
    block = face.data.shape_keys.key_blocks[key]
    block.slider_max = max(block.slider_max, float(values.max()))
    block.slider_min = min(block.slider_min, float(values.min()))


def turn_head(face: bpy.types.Object, track: SpokenTrack, name: str, first: float, rate: float) -> None:
    """Turn a face, which looks along -y and whose origin is where its head turns, as a track has it.

    Raises
    ------
    MeshError : it is turned by axis and angle.
    """
    if face.rotation_mode == "AXIS_ANGLE":
        raise MeshError(f"{face.name} is turned by axis and angle; choose quaternions or an order of angles for it")
    degrees = track.columns_of({angle: angle for angle in ANGLES}, rate)
    yaw, pitch, roll = (np.radians(degrees[angle]) for angle in ANGLES)
    path, rows = _turns_of(face.rotation_mode, np.stack((-pitch, roll, yaw), axis=1))
    action, curves = new_action(name, "OBJECT")
    for index, values in enumerate(rows.T):
        add_curve(curves, path, first, values, index)
    play_action(face, action)


def _turns_of(mode: str, angles: Float32Array) -> tuple[str, Float32Array]:
    """Return which property turns an object, and its value on each frame, shape (n, 3) or (n, 4)."""
    turns = [Euler(row, HEAD_ORDER).to_quaternion() for row in angles.tolist()]
    if mode == "QUATERNION":
        return "delta_rotation_quaternion", np.array([tuple(turn) for turn in turns], np.float32)
    return "delta_rotation_euler", np.array([tuple(turn.to_euler(mode)) for turn in turns], np.float32)
