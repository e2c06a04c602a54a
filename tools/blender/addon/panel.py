# SPDX-License-Identifier: MIT
"""Where a person finds all of this: the sidebar of the 3D view, and the menus File > Import and Export."""

from typing import Any

import bpy

from .curves_operator import ImportCurves
from .mouth_tables import cached_table, sounds_of
from .movestate_operators import ExportMovestates, ImportMovestates
from .sound_operator import SpeakSound
from .table_operators import AddMovement, LoadTable, NewTable, RemoveMovement, SaveTable

MOVESTATES = "Movestates (.3dm, .3dma)"
CURVES = "Lip Sync Curves (.json, .csv)"


class LipSyncPanel:
    """A panel in the sidebar, for a mesh."""

    bl_category = "Lip Sync"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return whether a mesh is chosen."""
        return context.object is not None and context.object.type == "MESH"


class FacePanel(LipSyncPanel, bpy.types.Panel):
    """Movestates, and how the chosen face moves"""

    bl_idname = "LIPSYNC_PT_face"
    bl_label = "Face"

    def draw(self, context: bpy.types.Context) -> None:
        """Draw the buttons."""
        layout = self.layout
        layout.label(text=context.object.name, icon="MESH_DATA")
        column = layout.column(align=True)
        column.operator(ImportMovestates.bl_idname)
        column.operator(ExportMovestates.bl_idname)
        column = layout.column(align=True)
        column.operator(SpeakSound.bl_idname, icon="PLAY_SOUND")
        column.operator(ImportCurves.bl_idname)


class ShapeList(bpy.types.UIList):
    """The mouth shapes of a table."""

    bl_idname = "LIPSYNC_UL_shapes"

    def draw_item(
        self, _context: Any, layout: Any, table: Any, shape: Any, _icon: Any, _active_data: Any, _active: Any
    ) -> None:
        """Draw a mouth shape: its name, and the sounds that have it."""
        row = layout.split(factor=0.3)
        row.label(text=shape.name, icon="NONE" if shape.movements else "DOT")
        row.label(text=sounds_of(cached_table(table.base), shape.name))


class TablePanel(LipSyncPanel, bpy.types.Panel):
    """Which shape keys move for which sound"""

    bl_idname = "LIPSYNC_PT_table"
    bl_label = "Mouth Table"

    def draw(self, context: bpy.types.Context) -> None:
        """Draw the shapes, and the shape keys of the active one."""
        layout, mesh = self.layout, context.object.data
        row = layout.row(align=True)
        row.operator_menu_enum(NewTable.bl_idname, "table", text="New")
        row.operator(LoadTable.bl_idname, text="Load")
        row.operator(SaveTable.bl_idname, text="Save")
        table = mesh.lip_sync
        if not table.shapes:
            return
        layout.template_list(ShapeList.bl_idname, "", table, "shapes", table, "active")
        for index, movement in enumerate(table.shapes[table.active].movements):
            _draw_movement(layout.row(align=True), mesh.shape_keys, movement, index)
        layout.operator(AddMovement.bl_idname, icon="ADD")


def _draw_movement(row: Any, keys: bpy.types.Key | None, movement: Any, index: int) -> None:
    if keys is None:
        row.prop(movement, "key", text="")
    else:
        missing = movement.key not in keys.key_blocks
        row.prop_search(movement, "key", keys, "key_blocks", text="", icon="ERROR" if missing else "SHAPEKEY_DATA")
    row.prop(movement, "percent", text="")
    row.operator(RemoveMovement.bl_idname, text="", icon="REMOVE").index = index


def draw_import_menu(menu: Any, _context: bpy.types.Context) -> None:
    """Draw what File > Import has."""
    menu.layout.operator(ImportMovestates.bl_idname, text=MOVESTATES)
    menu.layout.operator(ImportCurves.bl_idname, text=CURVES)


def draw_export_menu(menu: Any, _context: bpy.types.Context) -> None:
    """Draw what File > Export has."""
    menu.layout.operator(ExportMovestates.bl_idname, text=MOVESTATES)


CLASSES = (FacePanel, ShapeList, TablePanel)
