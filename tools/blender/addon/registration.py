# SPDX-License-Identifier: MIT
"""What the add-on adds to Blender."""

import bpy

from . import curves_operator, movestate_operators, panel, sound_operator, table_operators, table_properties

MODULES = (table_properties, table_operators, movestate_operators, curves_operator, sound_operator, panel)


def register() -> None:
    """Add the panel, the operators and the entries of the menus File > Import and Export."""
    for module in MODULES:
        for kind in module.CLASSES:
            bpy.utils.register_class(kind)
    bpy.types.Mesh.lip_sync = bpy.props.PointerProperty(type=table_properties.LipSyncTable)
    bpy.types.TOPBAR_MT_file_import.append(panel.draw_import_menu)
    bpy.types.TOPBAR_MT_file_export.append(panel.draw_export_menu)


def unregister() -> None:
    """Remove all of that."""
    bpy.types.TOPBAR_MT_file_export.remove(panel.draw_export_menu)
    bpy.types.TOPBAR_MT_file_import.remove(panel.draw_import_menu)
    del bpy.types.Mesh.lip_sync
    for module in reversed(MODULES):
        for kind in reversed(module.CLASSES):
            bpy.utils.unregister_class(kind)
