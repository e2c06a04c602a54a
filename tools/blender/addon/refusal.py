# SPDX-License-Identifier: MIT
"""Operators that say in one sentence what they refuse, and leave everything as it was."""

from pathlib import Path
from typing import Any

import bpy

from phonemeengine.errors import EngineError, MeshError


class RefusingOperator:
    """What an operator does stands in `act`, which returns a sentence about it, or raises an `EngineError`."""

    def act(self, context: bpy.types.Context) -> str:
        """Do it."""
        raise NotImplementedError

    def execute(self: Any, context: bpy.types.Context) -> set[str]:
        """Do it, and report what was done or refused."""
        try:
            done = self.act(context)
        except EngineError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, done)
        return {"FINISHED"}


def chosen_path(operator: Any) -> Path:
    """Return the file that an operator's dialogue has chosen; // is the folder of Blender's own file."""
    return Path(bpy.path.abspath(operator.filepath))


def chosen_face(context: bpy.types.Context) -> bpy.types.Object:
    """Return the active object.

    Raises
    ------
    MeshError : there is none, it is no mesh, it is being edited, or it belongs to another file.
    """
    face = context.object
    if face is None or face.type != "MESH":
        raise MeshError("no mesh is chosen; click on the face")
    if face.mode != "OBJECT":
        raise MeshError(f"{face.name} is being edited; go back to object mode")
    if face.data.library is not None:
        raise MeshError(f"{face.name} is linked from another file; make it local")
    return face
