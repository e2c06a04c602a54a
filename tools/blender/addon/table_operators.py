# SPDX-License-Identifier: MIT
"""Mouth tables: made for a face, loaded, edited and saved."""

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from phonemeengine.errors import MouthError
from phonemeengine.mouth.table import USUAL_TABLE, load_table, shipped_tables
from phonemeengine.storage.files import printable_name, write_file

from .mouth_tables import checked_toml, movements_on
from .refusal import RefusingOperator, chosen_face, chosen_path
from .shape_keys import names_of_keys
from .table_properties import show_table, table_of_face

ENDING = "*.toml"


class NewTable(RefusingOperator, bpy.types.Operator):
    """Make a mouth table for the chosen face: the shapes of one that ships, with what the face has shape keys for"""

    bl_idname = "lip_sync.new_table"
    bl_label = "New Mouth Table"
    bl_options = {"REGISTER", "UNDO"}

    table: EnumProperty(
        name="Like", items=[(name, name, load_table(name).name) for name in shipped_tables()], default=USUAL_TABLE
    )

    def act(self, context: bpy.types.Context) -> str:
        """Make it."""
        face, table = chosen_face(context), load_table(self.table)
        shapes = movements_on(table, names_of_keys(face))
        show_table(face.data, table, shapes)
        return f"{face.name} has a mouth table of {len(shapes)} shapes, of which {_n_moving(shapes)} move it"


class LoadTable(RefusingOperator, bpy.types.Operator, ImportHelper):
    """Load a mouth table for the chosen face"""

    bl_idname = "lip_sync.load_table"
    bl_label = "Load Mouth Table"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".toml"
    filter_glob: StringProperty(default=ENDING, options={"HIDDEN"})

    def act(self, context: bpy.types.Context) -> str:
        """Load it."""
        face, path = chosen_face(context), chosen_path(self)
        table = load_table(path)
        show_table(face.data, table, {shape: [*moved.items()] for shape, moved in table.shapes.items()})
        return f"{face.name} has the mouth table of {printable_name(path)}"


class SaveTable(RefusingOperator, bpy.types.Operator, ExportHelper):
    """Save the mouth table of the chosen face, for 'phonemeanalyser export --table'"""

    bl_idname = "lip_sync.save_table"
    bl_label = "Save Mouth Table"

    filename_ext = ".toml"
    filter_glob: StringProperty(default=ENDING, options={"HIDDEN"})

    def act(self, context: bpy.types.Context) -> str:
        """Save it."""
        path = chosen_path(self)
        write_file(path, checked_toml(table_of_face(chosen_face(context))).encode(), MouthError)
        return f"{printable_name(path)} has the mouth table"


class AddMovement(RefusingOperator, bpy.types.Operator):
    """Add a shape key to the mouth shape"""

    bl_idname = "lip_sync.add_movement"
    bl_label = "Add Shape Key"
    bl_options = {"INTERNAL", "UNDO"}

    def act(self, context: bpy.types.Context) -> str:
        """Add it."""
        table = chosen_face(context).data.lip_sync
        if not table.shapes:
            raise MouthError("there is no mouth shape; make a mouth table, or load one")
        table.shapes[table.active].movements.add()
        return f"{table.shapes[table.active].name} has a shape key more"


class RemoveMovement(RefusingOperator, bpy.types.Operator):
    """Remove a shape key from the mouth shape"""

    bl_idname = "lip_sync.remove_movement"
    bl_label = "Remove Shape Key"
    bl_options = {"INTERNAL", "UNDO"}

    index: IntProperty()

    def act(self, context: bpy.types.Context) -> str:
        """Remove it."""
        table = chosen_face(context).data.lip_sync
        table.shapes[table.active].movements.remove(self.index)
        return f"{table.shapes[table.active].name} has a shape key less"


def _n_moving(shapes: dict[str, list[tuple[str, float]]]) -> int:
    return sum(1 for movements in shapes.values() if movements)


CLASSES = (NewTable, LoadTable, SaveTable, AddMovement, RemoveMovement)
