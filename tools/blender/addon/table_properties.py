# SPDX-License-Identifier: MIT
"""What a mesh keeps of its mouth table, in the file of Blender."""

import bpy
from bpy.props import CollectionProperty, FloatProperty, IntProperty, StringProperty

from phonemeengine.errors import MouthError
from phonemeengine.mouth.table import STRONGEST, MouthTable

from .mouth_tables import Movement, cached_table, checked_toml, with_movements
from .shape_keys import names_of_keys


class LipSyncMovement(bpy.types.PropertyGroup):
    """A shape key, and how far it moves."""

    key: StringProperty(name="Shape Key", description="The shape key that moves")
    percent: FloatProperty(
        name="Percent", description="How far it moves", default=100, min=-STRONGEST, max=STRONGEST, precision=0
    )


class LipSyncShape(bpy.types.PropertyGroup):
    """A mouth shape, and what moves in it."""

    movements: CollectionProperty(type=LipSyncMovement)


class LipSyncTable(bpy.types.PropertyGroup):
    """A mouth table: the text of the file that it came from, and its shapes as they are now."""

    base: StringProperty()
    shapes: CollectionProperty(type=LipSyncShape)
    active: IntProperty()


def show_table(mesh: bpy.types.Mesh, table: MouthTable, shapes: dict[str, list[Movement]]) -> None:
    """Have the panel of a mesh show the shapes of a table."""
    shown = mesh.lip_sync
    shown.base = checked_toml(table)
    shown.shapes.clear()
    shown.active = 0
    for name, movements in shapes.items():
        shape = shown.shapes.add()
        shape.name = name
        for key, percent in movements:
            movement = shape.movements.add()
            movement.key, movement.percent = key, percent


def table_of_face(face: bpy.types.Object) -> MouthTable:
    """Return the mouth table of a face as its panel has it.

    Raises
    ------
    MouthError : it has none, or a movement of it is impossible.
    """
    shown = face.data.lip_sync
    if not shown.shapes:
        raise MouthError(f"{face.name} has no mouth table; make one in the panel, or load one")
    shapes = {shape.name: [(m.key, m.percent) for m in shape.movements] for shape in shown.shapes}
    return with_movements(cached_table(shown.base), shapes, names_of_keys(face))


CLASSES = (LipSyncMovement, LipSyncShape, LipSyncTable)
