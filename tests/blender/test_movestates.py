"""Movestates become shape keys and come back, on meshes as Blender's importers leave them."""

from pathlib import Path

import bpy
import numpy as np
import pytest

from phonemeengine.mouth.files.io import load_morph_targets, save_morph_targets
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import MorphTargets, load_head, morph_targets_of
from phonemeengine.mouth.movestate import movestate_of
from tests.blender.conftest import positions_of

CUBE = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float32)
"""The corners of Blender's cube, in the coordinates of files."""


@pytest.fixture(params=[".3dm", ".3dma"])
def head_file(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    head, path = load_head(), tmp_path / f"head{request.param}"
    save_morph_targets(morph_targets_of(head.mesh, head.states), path)
    return path


def write(path: Path, points: np.ndarray, name: str, moved: int, offset: tuple[float, float, float]) -> str:
    """Write a file of one movestate that moves one vertex."""
    offsets = np.zeros_like(points)
    offsets[moved] = offset
    save_morph_targets(morph_targets_of(mesh_of(points), [movestate_of(name, offsets)]), path)
    return str(path)


def same(one: MorphTargets, other: MorphTargets) -> bool:
    return [s.name for s in one.states] == [s.name for s in other.states] and all(
        np.array_equal(a.numbers, b.numbers) and np.allclose(a.offsets, b.offsets, atol=2e-6)
        for a, b in zip(one.states, other.states, strict=True)
    )


def head_as_obj(path: Path) -> None:
    mesh = load_head().mesh
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.positions.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (mesh.triangles + 1).tolist()]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def test_the_head_s_movestates_are_those_that_gltf_brings(head: bpy.types.Object, head_file: Path) -> None:
    blocks = head.data.shape_keys.key_blocks
    brought = {key.name: positions_of(key.data) for key in blocks}
    head.shape_key_clear()
    bpy.ops.lip_sync.import_movestates(filepath=str(head_file))
    blocks = head.data.shape_keys.key_blocks
    assert {key.name for key in blocks} == brought.keys()
    for key in blocks:
        np.testing.assert_allclose(positions_of(key.data), brought[key.name], atol=1.1e-4)  # what is left out
        assert key.value == (0 if key.name != "Basis" else key.value)


def test_movestates_of_a_head_that_gltf_brought_come_back(head: bpy.types.Object, head_file: Path) -> None:
    again = head_file.with_name(f"again{head_file.suffix}")
    head.shape_key_clear()
    bpy.ops.lip_sync.import_movestates(filepath=str(head_file))
    bpy.ops.lip_sync.export_movestates(filepath=str(again))
    assert same(load_morph_targets(again), load_morph_targets(head_file))


def test_movestates_of_a_head_that_obj_brought_come_back(head_file: Path, tmp_path: Path) -> None:
    head_as_obj(tmp_path / "head.obj")
    bpy.ops.wm.obj_import(filepath=str(tmp_path / "head.obj"))
    bpy.context.view_layer.update()
    again = tmp_path / f"again{head_file.suffix}"
    bpy.ops.lip_sync.import_movestates(filepath=str(head_file))
    bpy.ops.lip_sync.export_movestates(filepath=str(again))
    assert same(load_morph_targets(again), load_morph_targets(head_file))


def test_up_in_a_file_is_up_in_blender(cube: bpy.types.Object, tmp_path: Path) -> None:
    corner = np.flatnonzero((CUBE == (1, 1, 1)).all(axis=1))[0]
    bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "up.3dm", CUBE, "up", corner, (0, 0.5, 0.25)))
    rest, up = (positions_of(cube.data.shape_keys.key_blocks[name].data) for name in ("Basis", "up"))
    (moved,) = np.flatnonzero((rest != up).any(axis=1))
    assert rest[moved].tolist() == [1, -1, 1]  # right, towards the viewer, above
    assert (up - rest)[moved].tolist() == [0, -0.25, 0.5]


def test_a_file_of_another_mesh_is_refused_and_everything_stays(mouth: bpy.types.Object, tmp_path: Path) -> None:
    other = write(tmp_path / "other.3dm", CUBE * 3, "smile", 2, (0, 1, 0))
    before = {key.name: positions_of(key.data) for key in mouth.data.shape_keys.key_blocks}
    with pytest.raises(RuntimeError) as refused:
        bpy.ops.lip_sync.import_movestates(filepath=other)
    assert "other.3dm: 1 of the 1 vertices that move are not in the mesh within 0.0001: 2; choose" in str(
        refused.value
    )
    after = {key.name: positions_of(key.data) for key in mouth.data.shape_keys.key_blocks}
    assert before.keys() == after.keys()
    assert all(np.array_equal(before[name], after[name]) for name in before)


def test_a_mesh_without_shape_keys_has_none_after_a_refusal(cube: bpy.types.Object, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="not in the mesh"):
        bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "a.3dm", CUBE * 3, "a", 2, (0, 1, 0)))
    assert cube.data.shape_keys is None


def test_a_movestate_that_is_there_already_moves_anew(cube: bpy.types.Object, tmp_path: Path) -> None:
    for height in (0.5, 0.75):
        bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "a.3dm", CUBE, "up", 0, (0, height, 0)))
    blocks = cube.data.shape_keys.key_blocks
    assert [key.name for key in blocks] == ["Basis", "up"]
    assert np.abs(positions_of(blocks["up"].data) - positions_of(blocks["Basis"].data)).max() == 0.75


@pytest.mark.parametrize(
    ("name", "words"), [("x" * 64, "at most 63 bytes"), ("Basis", "called like the shape at rest")]
)
def test_a_name_that_no_shape_key_can_have_is_refused(
    cube: bpy.types.Object, tmp_path: Path, name: str, words: str
) -> None:
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "a.3dm", CUBE, name, 0, (0, 1, 0)))
    assert cube.data.shape_keys is None


def test_a_vertex_group_holds_a_shape_key_back(mouth: bpy.types.Object, tmp_path: Path) -> None:
    keys = mouth.data.shape_keys.key_blocks
    keys["Bart"].data[0].co.z += 1
    keys["Bart"].data[1].co.z += 1
    mouth.vertex_groups.new(name="half").add([0], 0.5, "REPLACE")
    keys["Bart"].vertex_group = "half"
    bpy.ops.lip_sync.export_movestates(filepath=str(tmp_path / "a.3dm"))
    beard = next(state for state in load_morph_targets(tmp_path / "a.3dm").states if state.name == "Bart")
    assert (beard.numbers.tolist(), beard.offsets.tolist()) == ([0], [[0, 0.5, 0]])


def test_a_mesh_without_shape_keys_has_nothing_to_export(cube: bpy.types.Object, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="Cube has no shape keys; add some, or import them"):
        bpy.ops.lip_sync.export_movestates(filepath=str(tmp_path / "a.3dm"))
    assert not (tmp_path / "a.3dm").exists()


def test_without_a_mesh_there_is_one_sentence(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="no mesh is chosen; click on the face"):
        bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "a.3dm", CUBE, "a", 0, (0, 1, 0)))


def test_a_face_that_is_being_edited_is_refused(cube: bpy.types.Object, tmp_path: Path) -> None:
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="Cube is being edited; go back to object mode"):
        bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "a.3dm", CUBE, "a", 0, (0, 1, 0)))
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_mesh_whose_vertices_an_importer_split_moves_in_all_copies(cube: bpy.types.Object, tmp_path: Path) -> None:
    bpy.ops.export_scene.gltf(filepath=str(tmp_path / "cube.glb"))
    bpy.ops.import_scene.gltf(filepath=str(tmp_path / "cube.glb"))
    split = bpy.context.object
    assert len(split.data.vertices) == 24
    bpy.ops.lip_sync.import_movestates(filepath=write(tmp_path / "up.3dm", CUBE, "up", 7, (0, 0.5, 0)))
    rest, up = (positions_of(split.data.shape_keys.key_blocks[name].data) for name in ("Basis", "up"))
    moved = (rest != up).any(axis=1)
    np.testing.assert_array_equal(rest[moved], [(1, -1, 1)] * 3)
    np.testing.assert_array_equal((up - rest)[moved], [(0, 0, 0.5)] * 3)


def test_another_ending_is_refused(mouth: bpy.types.Object, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match=r"a\.glb: its ending must be \.3dm or \.3dma; choose another"):
        bpy.ops.lip_sync.export_movestates(filepath=str(tmp_path / "a.glb"))
    assert not (tmp_path / "a.glb").exists()
