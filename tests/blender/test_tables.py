"""Mouth tables in the panel: made for a face, edited, saved as the engine reads them, and loaded again."""

from pathlib import Path
from typing import Any

import bpy
import pytest

from phonemeengine.mouth.table import TABLES, load_table


def shapes_of(face: Any) -> dict[str, dict[str, float]]:
    """Return what the panel shows."""
    return {shape.name: {m.key: m.percent for m in shape.movements} for shape in face.data.lip_sync.shapes}


def test_a_new_table_moves_what_the_face_has(mouth: Any) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    like = load_table("arkit")
    assert shapes_of(mouth).keys() == like.shapes.keys()
    assert shapes_of(mouth)["o"] == {
        "JawOpen": like.shapes["o"]["jawOpen"],
        "mouthFunnel": like.shapes["o"]["mouthFunnel"],
    }


def test_a_table_that_is_edited_and_saved_is_read_by_the_engine(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    table = mouth.data.lip_sync
    table.active = [shape.name for shape in table.shapes].index("a")
    bpy.ops.lip_sync.add_movement()
    movement = table.shapes[table.active].movements[-1]
    movement.key, movement.percent = "Bart", -20
    bpy.ops.lip_sync.save_table(filepath=str(tmp_path / "face.toml"))
    saved, like = load_table(tmp_path / "face.toml"), load_table("arkit")
    assert saved.movestates == ("JawOpen", "mouthClose", "mouthFunnel", "Bart")
    assert saved.shapes["a"] == {"JawOpen": like.shapes["a"]["jawOpen"], "Bart": -20}
    assert (saved.phonemes, saved.phones, saved.times) == (like.phonemes, like.phones, like.times)


def test_a_table_that_is_loaded_is_shown_whole(mouth: Any) -> None:
    bpy.ops.lip_sync.load_table(filepath=str(TABLES / "vrm.toml"))
    assert shapes_of(mouth) == {name: dict(moved) for name, moved in load_table("vrm").shapes.items()}


def test_a_shape_key_is_removed_from_a_shape(mouth: Any) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    table = mouth.data.lip_sync
    table.active = [shape.name for shape in table.shapes].index("o")
    first = table.shapes[table.active].movements[0].key
    bpy.ops.lip_sync.remove_movement(index=0)
    assert first not in shapes_of(mouth)["o"]


def test_a_table_stays_in_the_file_of_blender(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    before, name = shapes_of(mouth), mouth.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    mouth.data.lip_sync.shapes.clear()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    assert shapes_of(bpy.data.objects[name]) == before


@pytest.mark.parametrize(
    ("key", "percent", "words"),
    [("", 10, "shape silence has a movement without a shape key"), ("Bart", 10, "shape silence moves 'Bart' twice")],
)
def test_an_impossible_table_is_not_saved(mouth: Any, tmp_path: Path, key: str, percent: float, words: str) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    for _ in range(2):
        bpy.ops.lip_sync.add_movement()
        mouth.data.lip_sync.shapes[0].movements[-1].key = key
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.lip_sync.save_table(filepath=str(tmp_path / "a.toml"))
    assert not (tmp_path / "a.toml").exists()


def test_a_file_that_is_no_table_is_refused_and_the_panel_stays(mouth: Any, tmp_path: Path) -> None:
    bpy.ops.lip_sync.new_table(table="arkit")
    before = shapes_of(mouth)
    (tmp_path / "a.toml").write_text("format = 3\n", encoding="utf-8")
    with pytest.raises(RuntimeError, match=r"a\.toml: a mouth table begins with format"):
        bpy.ops.lip_sync.load_table(filepath=str(tmp_path / "a.toml"))
    assert shapes_of(mouth) == before


def test_without_a_table_there_is_nothing_to_save(mouth: Any, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Cube has no mouth table; make one in the panel, or load one"):
        bpy.ops.lip_sync.save_table(filepath=str(tmp_path / "a.toml"))
