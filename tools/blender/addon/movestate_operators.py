# SPDX-License-Identifier: MIT
"""Import and export of movestates: .3dm and .3dma."""

import bpy
from bpy.props import EnumProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from phonemeengine.errors import MeshError
from phonemeengine.mouth.files.io import TARGET_SUFFIXES, load_morph_targets, save_morph_targets
from phonemeengine.mouth.morph_mesh import TOLERANCE
from phonemeengine.storage.files import printable_name

from .axes import Axes
from .refusal import RefusingOperator, chosen_face, chosen_path
from .shape_keys import add_movestates, axes_of, movestates_of

ENDINGS = "*.3dm;*.3dma"


class ImportMovestates(RefusingOperator, bpy.types.Operator, ImportHelper):
    """Add the movestates of a .3dm or .3dma file to the chosen face, as shape keys"""

    bl_idname = "lip_sync.import_movestates"
    bl_label = "Import Movestates"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".3dm"
    filter_glob: StringProperty(default=ENDINGS, options={"HIDDEN"})
    tolerance: FloatProperty(
        name="Tolerance",
        description="How far apart two vertices may be and still be the same one",
        default=TOLERANCE,
        min=0,
        precision=5,
    )

    def act(self, context: bpy.types.Context) -> str:
        """Add them."""
        path = chosen_path(self)
        face, targets = chosen_face(context), load_morph_targets(path)
        try:
            add_movestates(face, targets, self.tolerance)
        except MeshError as error:
            raise MeshError(f"{printable_name(path)}: {error}") from error
        return f"{face.name} has {len(targets.states)} movestates of {printable_name(path)}"


class ExportMovestates(RefusingOperator, bpy.types.Operator, ExportHelper):
    """Write the shape keys of the chosen face as movestates, into a .3dm or .3dma file"""

    bl_idname = "lip_sync.export_movestates"
    bl_label = "Export Movestates"

    filename_ext = ".3dm"
    check_extension = None  # the ending says the format
    filter_glob: StringProperty(default=ENDINGS, options={"HIDDEN"})
    axes: EnumProperty(
        name="Axes",
        description="How the vertices of the mesh lie",
        items=(
            ("AUTO", "Automatic", "As the object stands in the scene"),
            (Axes.Z_UP.value, "Z up", "Blender's own way, and that of glTF"),
            (Axes.Y_UP.value, "Y up", "As the import of OBJ leaves them"),
        ),
    )

    def act(self, context: bpy.types.Context) -> str:
        """Write them."""
        face, path = chosen_face(context), chosen_path(self)
        if path.suffix.lower() not in TARGET_SUFFIXES:
            raise MeshError(f"{printable_name(path)}: its ending must be .3dm or .3dma; choose another")
        targets = movestates_of(face, axes_of(face) if self.axes == "AUTO" else Axes(self.axes))
        save_morph_targets(targets, path)
        return f"{printable_name(path)} has {len(targets.states)} movestates of {face.name}"


CLASSES = (ImportMovestates, ExportMovestates)
