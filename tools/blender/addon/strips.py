# SPDX-License-Identifier: MIT
"""A face that moves by cues: a pose of each mouth shape as an action, and strips that show them one after the other.

Two tracks take turns. A strip lasts until the next one, on the other track, is wholly there; the upper track's strips
fade in over what is below, and out again when the next one below has begun.
"""

from collections.abc import Sequence
from itertools import pairwise

import bpy
import numpy as np

from phonemeengine.errors import MeshError
from phonemeengine.mouth.cues import Cue
from phonemeengine.mouth.table import MouthTable
from phonemeengine.phonemes import Phoneme

from .actions import TRACK, add_curve, mute_tracks, new_action, path_of_key, play_action
from .animation import allow
from .mouth_tables import key_named
from .shape_keys import names_of_keys


def add_strips(
    face: bpy.types.Object, cues: Sequence[Cue], table: MouthTable, name: str, first: float, rate: float
) -> None:
    """Move a face's shape keys by strips, one for each cue.

    Parameters
    ----------
    table : which movestates a mouth shape has, and how fast the mouth comes to it.
    name : of the tracks.
    first : the frame on which the sound begins.
    rate : frames a second.

    Raises
    ------
    MeshError : there are no cues, or the face has none of the shape keys that the table names; nothing changes.
    """
    if not cues:
        raise MeshError("there are no cues in it; choose curves JSON, or import its curves")
    cues = [cue for cue in cues if cue.end > cue.start]
    poses = _poses_of(face, cues, table)
    actions = {shape: _action_of(face, shape, pose) for shape, pose in poses.items()}
    keys = face.data.shape_keys
    play_action(keys, None)
    mute_tracks(keys)
    tracks = [keys.animation_data.nla_tracks.new() for _ in range(2)]
    for track in tracks:
        track.name = f"{TRACK} {name}"
    times = _times_of(cues, table)
    for k, cue in enumerate(cues):
        track, action = tracks[k % 2], actions[table.shape_of(cue.phoneme, cue.phone)]
        fade_in, fade_out = rate * times[k], rate * times[k + 1]
        strip = track.strips.new(f"{action.name} {k + 1}", round(_last_end(track) + 1), action)
        strip.frame_end = first + rate * cue.end + fade_out
        strip.frame_start = first + rate * cue.start
        strip.frame_end = first + rate * cue.end + fade_out
        strip.extrapolation = "NOTHING"
        strip.blend_in = fade_in if k % 2 or not k else 0.0
        strip.blend_out = fade_out if k % 2 or k == len(cues) - 1 else 0.0


def _last_end(track: bpy.types.NlaTrack) -> float:
    return track.strips[-1].frame_end if track.strips else 0.0


def _poses_of(face: bpy.types.Object, cues: Sequence[Cue], table: MouthTable) -> dict[str, dict[str, float]]:
    """Return the values of shape keys for each mouth shape; every pose has all keys that any of them moves."""
    names = names_of_keys(face)
    poses = {}
    for shape in dict.fromkeys(table.shape_of(cue.phoneme, cue.phone) for cue in cues):
        percentages = table.shapes[shape].items()
        poses[shape] = {key: percent / 100 for name, percent in percentages if (key := key_named(name, names))}
    moved = dict.fromkeys(key for pose in poses.values() for key in pose)
    if not moved:
        raise MeshError(f"{face.name} has no shape key that its mouth table names; choose some in the panel")
    return {shape: dict.fromkeys(moved, 0.0) | pose for shape, pose in poses.items()}


def _action_of(face: bpy.types.Object, shape: str, pose: dict[str, float]) -> bpy.types.Action:
    action, curves = new_action(f"{face.name} {shape}", "KEY")
    for key, value in pose.items():
        values = np.array([value], np.float32)
        allow(face, key, values)
        add_curve(curves, path_of_key(key), 0, values)
    return action


def _times_of(cues: Sequence[Cue], table: MouthTable) -> list[float]:
    """Return how long the mouth takes to each cue's shape, seconds, no longer than the cue; and 0 for the end."""
    times = [0.0]
    for before, cue in pairwise(cues):
        times.append(min(_to_shape(before, cue, table), cue.end - cue.start))
    return [*times, 0.0]


def _to_shape(before: Cue, cue: Cue, table: MouthTable) -> float:
    if cue.phoneme is not Phoneme.SILENCE:
        return table.times_of(cue.phoneme, cue.phone).to_shape
    return 0.0 if before.phoneme is Phoneme.SILENCE else table.times_of(before.phoneme, before.phone).to_rest
