# SPDX-License-Identifier: MIT
"""Actions: the curves by which Blender moves a value from frame to frame."""

from typing import Any

import bpy
import numpy as np

from phonemeengine.arrays import Float32Array

TRACK = "Lip Sync"
"""How the names of tracks begin that were made here."""
LINEAR = 1
"""Straight from key to key, as Blender numbers it."""


def new_action(name: str, id_type: str) -> tuple[bpy.types.Action, Any]:
    """Return a new action for data of a type, such as KEY, and the collection of its curves."""
    action = bpy.data.actions.new(name)
    if not hasattr(action, "slots"):  # before Blender 4.4
        action.id_root = id_type
        return action, action.fcurves
    slot = action.slots.new(id_type=id_type, name=name)
    strip = action.layers.new(name).strips.new(type="KEYFRAME")
    return action, strip.channelbag(slot, ensure=True).fcurves


def play_action(owner: bpy.types.ID, action: bpy.types.Action | None) -> None:
    """Have an action move a data block, or none; the one before is kept in the file."""
    animation = owner.animation_data or owner.animation_data_create()
    if animation.action is not None:
        animation.action.use_fake_user = True
    animation.action = action
    if action is not None and hasattr(animation, "action_slot"):
        animation.action_slot = action.slots[0]


def mute_tracks(keys: bpy.types.Key) -> None:
    """Silence the strips that were made for other sounds; they stay in the file."""
    for track in keys.animation_data.nla_tracks:
        if track.name.startswith(TRACK):
            track.mute = True


def add_curve(curves: Any, path: str, first: float, values: Float32Array, index: int = 0) -> None:
    """Add a curve with a key on each frame from the first; one that never moves has a single key."""
    kept = values[:1] if np.all(values == values[0]) else values
    points = np.stack((first + np.arange(len(kept)), kept), axis=1).astype(np.float32)
    curve = curves.new(data_path=path, index=index)
    curve.keyframe_points.add(len(kept))
    curve.keyframe_points.foreach_set("co", points.ravel())
    curve.keyframe_points.foreach_set("interpolation", [LINEAR] * len(kept))
    curve.update()


def path_of_key(name: str) -> str:
    """Return the data path of a shape key's value."""
    return f'key_blocks["{bpy.utils.escape_identifier(name)}"].value'
