# SPDX-License-Identifier: MIT
"""Import of movement: curves JSON and Live Link CSV, as curves or as strips."""

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from phonemeengine.storage.files import printable_name

from .animation import animate_face, turn_head
from .refusal import RefusingOperator, chosen_face, chosen_path
from .strips import add_strips
from .table_properties import table_of_face
from .tracks import SpokenTrack, read_track

FORMS = (
    ("CURVES", "Curves", "An action with a key on each frame"),
    ("CUES", "Cues", "Strips of poses, one for each cue of curves JSON, by the mouth table of the face"),
)


class MovingOperator(RefusingOperator):
    """An operator that moves the chosen face with a sound."""

    form: EnumProperty(name="As", items=FORMS)
    first: IntProperty(name="First Frame", description="The frame on which the sound begins", default=1)
    with_head: BoolProperty(name="Turn the Head", description="Turn the object about its origin as well")

    def move(self, context: bpy.types.Context, track: SpokenTrack, name: str) -> str:
        """Move the face, and return a sentence about it."""
        face, scene = chosen_face(context), context.scene
        place = (name, self.first, frame_rate(scene))
        missing: tuple[str, ...] = ()
        if self.form == "CUES":
            add_strips(face, track.cues, table_of_face(face), *place)
        else:
            missing = animate_face(face, track, *place)
        if self.with_head:
            turn_head(face, track, *place)
        scene.frame_end = max(scene.frame_end, self.first + round(track.movement.duration * frame_rate(scene)))
        lacks = f", and has no shape key for {', '.join(missing[:5])}{' ...' * (len(missing) > 5)}" if missing else ""
        return f"{face.name} moves by {name}{lacks}"


def frame_rate(scene: bpy.types.Scene) -> float:
    """Return a scene's frames a second."""
    return scene.render.fps / scene.render.fps_base


class ImportCurves(MovingOperator, bpy.types.Operator, ImportHelper):
    """Move the chosen face by curves JSON, or by a recording of Live Link Face"""

    bl_idname = "lip_sync.import_curves"
    bl_label = "Import Curves"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: StringProperty(default="*.json;*.csv", options={"HIDDEN"})

    def act(self, context: bpy.types.Context) -> str:
        """Move it."""
        path = chosen_path(self)
        return self.move(context, read_track(path), printable_name(path))


CLASSES = (ImportCurves,)
