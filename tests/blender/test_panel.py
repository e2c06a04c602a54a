"""The panels and menus draw operators and properties that Blender knows; a layout that is handed in looks at them."""

from types import SimpleNamespace
from typing import Any

import bpy
import pytest

ICONS = {item.identifier for item in bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items}


class Layout:
    """Stands in for that of Blender, which draws in a window alone, and lists what is drawn."""

    def __init__(self, drawn: list[str]) -> None:
        self.drawn = drawn

    def label(self, text: str = "", icon: str = "NONE") -> None:
        assert icon in ICONS
        self.drawn.append(text)

    def operator(self, idname: str, text: str = "", icon: str = "NONE") -> SimpleNamespace:
        assert icon in ICONS
        group, name = idname.split(".")
        getattr(getattr(bpy.ops, group), name).get_rna_type()
        self.drawn.append(idname)
        return SimpleNamespace()

    def operator_menu_enum(self, idname: str, enum: str, text: str = "") -> None:
        group, name = idname.split(".")
        assert getattr(getattr(bpy.ops, group), name).get_rna_type().properties[enum].enum_items
        self.drawn.append(idname)

    def prop(self, data: Any, name: str, text: str | None = None) -> None:
        self.drawn.append(data.bl_rna.properties[name].name)

    def prop_search(
        self, data: Any, name: str, among: Any, names: str, text: str | None = None, icon: str = "NONE"
    ) -> None:
        assert icon in ICONS
        assert names in among.bl_rna.properties
        self.drawn.append(getattr(data, name))

    def template_list(self, kind: str, name: str, data: Any, items: str, active_data: Any, active: str) -> None:
        assert {items, active} <= {*data.bl_rna.properties.keys()}
        for item in getattr(data, items):
            getattr(bpy.types, kind).draw_item(None, None, self, data, item, 0, active_data, active)

    def part(self, **_looks: Any) -> "Layout":
        return self

    row = column = split = part


def drawn(panel: str) -> list[str]:
    """Return what a panel shows for the chosen object."""
    kind, layout = getattr(bpy.types, panel), Layout([])
    assert kind.poll(bpy.context)
    kind.draw(SimpleNamespace(layout=layout), bpy.context)
    return layout.drawn


def test_the_face_panel_offers_what_the_add_on_does(mouth: Any) -> None:
    operators = ("import_movestates", "export_movestates", "speak_sound", "import_curves")
    assert drawn("LIPSYNC_PT_face") == ["Cube", *(f"lip_sync.{name}" for name in operators)]


def test_the_table_panel_shows_shapes_with_their_sounds_and_keys(mouth: Any) -> None:
    buttons = ["lip_sync.new_table", "lip_sync.load_table", "lip_sync.save_table"]
    assert drawn("LIPSYNC_PT_table") == buttons
    bpy.ops.lip_sync.new_table(table="arkit")
    mouth.data.lip_sync.active = 7
    shown = drawn("LIPSYNC_PT_table")
    assert shown[:3] == buttons
    assert shown[shown.index("f") + 1] == "labiodental"
    assert shown[-4:] == ["JawOpen", "Percent", "lip_sync.remove_movement", "lip_sync.add_movement"]


@pytest.mark.parametrize("menu", ["TOPBAR_MT_file_import", "TOPBAR_MT_file_export"])
def test_the_file_menus_have_movestates(menu: str) -> None:
    entries = [draw for draw in getattr(bpy.types, menu)._dyn_ui_initialize() if "phonemeanalyser" in draw.__module__]
    layout = Layout([])
    for draw in entries:
        draw(SimpleNamespace(layout=layout), bpy.context)
    assert any("movestates" in name for name in layout.drawn)


def test_without_a_mesh_there_is_no_panel() -> None:
    assert not bpy.types.LIPSYNC_PT_face.poll(bpy.context)


def test_the_add_on_can_be_switched_off_and_on() -> None:
    for _ in range(2):
        bpy.ops.preferences.addon_disable(module="bl_ext.user_default.phonemeanalyser")
        assert not hasattr(bpy.types, "LIPSYNC_PT_face")
        bpy.ops.preferences.addon_enable(module="bl_ext.user_default.phonemeanalyser")
        assert hasattr(bpy.types, "LIPSYNC_PT_face")
