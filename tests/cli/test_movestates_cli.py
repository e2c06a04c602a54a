"""``phonemeanalyser movestates``, as an animator types it."""

from pathlib import Path

import numpy as np
import pytest
from pygltflib import GLTF2

from phonemeanalyser.cli.main import main
from phonemeengine.mouth.files.gltf_writing import format_glb
from phonemeengine.mouth.files.io import load_morph_mesh, load_morph_targets, save_morph_targets
from phonemeengine.mouth.mesh import mesh_of
from phonemeengine.mouth.morph_mesh import load_head, morph_targets_of
from tests.meshes import CORNERS, GLTF_TEXT, TRIANGLES, format_obj, morph_mesh_of_cube, moved_by
from tests.tables import Capsys

SMILE, OPEN = moved_by((1, 3), (0.5, 0, 0.25)), moved_by((2,), (0, -1, 0))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A cube at rest, smiling, and open, as a modelling program exports them."""
    for name, offsets in (("base", 0), ("smile", SMILE), ("open", OPEN)):
        (tmp_path / f"{name}.obj").write_bytes(format_obj(mesh_of(CORNERS + offsets, TRIANGLES)))
    return tmp_path


def run(folder: Path, *words: str, capsys: Capsys) -> tuple[int, str, str]:
    """Run the command with names of files in a folder; gives its exit code, and what it printed."""
    code = main(["movestates", *(str(folder / word) if "." in word else word for word in words)])
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_targets_become_movestates_of_their_files_names(folder: Path, capsys: Capsys):
    code, out, _ = run(folder, "export", "base.obj", "smile.obj", "open.obj", "-o", "face.3dm", capsys=capsys)
    assert code == 0
    assert out.startswith("face.3dm: 2 movestates, 3 vertices move, ")
    smile, opened = load_morph_targets(folder / "face.3dm").states
    assert (smile.name, smile.numbers.tolist()) == ("smile", [1, 3])
    np.testing.assert_allclose(smile.offsets, SMILE[[1, 3]])
    assert (opened.name, opened.numbers.tolist()) == ("open", [2])


def test_the_morph_targets_of_a_gltf_count_as_targets(folder: Path, capsys: Capsys):
    (folder / "cube.gltf").write_bytes(GLTF_TEXT)
    assert run(folder, "export", "cube.gltf", "-o", "face.3dma", capsys=capsys)[0] == 0
    assert [state.name for state in load_morph_targets(folder / "face.3dma").states] == ["lid up", "wide"]
    (folder / "more.glb").write_bytes(format_glb(morph_mesh_of_cube()))
    assert run(folder, "export", "base.obj", "open.obj", "more.glb", "-o", "all.3dm", capsys=capsys)[0] == 0
    assert [state.name for state in load_morph_targets(folder / "all.3dm").states] == [
        "open",
        "lid up",
        "größer",
        "still",
    ]


def test_the_programs_own_head_becomes_a_glb_that_others_read(folder: Path, capsys: Capsys):
    code, out, _ = run(folder, "convert", "woman", "face.glb", capsys=capsys)
    assert code == 0
    assert out.startswith("face.glb: 58 movestates, ")
    gltf, head = GLTF2().load(str(folder / "face.glb")), load_head()
    assert gltf is not None
    (primitive,) = gltf.meshes[0].primitives

    def points(accessor: int) -> np.ndarray:
        form = gltf.accessors[accessor]
        assert (form.componentType, form.type) == (5126, "VEC3")
        begin = gltf.bufferViews[form.bufferView].byteOffset
        return np.frombuffer(gltf.binary_blob(), "<f4", 3 * form.count, begin).reshape(-1, 3)

    np.testing.assert_array_equal(points(primitive.attributes.POSITION), head.mesh.positions)
    assert gltf.accessors[primitive.indices].count == 3 * len(head.mesh.triangles)
    assert gltf.meshes[0].extras["targetNames"] == [state.name for state in head.states]
    for state, target in zip(head.states, primitive.targets, strict=True):
        offsets = points(target["POSITION"])
        np.testing.assert_array_equal(offsets[state.numbers], state.offsets)
        assert np.count_nonzero(offsets.any(axis=1)) == len(state)


def test_movestates_of_the_programs_own_head_go_through_the_thesis_format(folder: Path, capsys: Capsys):
    assert run(folder, "convert", "woman", "face.3dm", capsys=capsys)[0] == 0
    code, out, _ = run(folder, "convert", "face.3dm", "again.glb", "--mesh", "woman", capsys=capsys)
    assert code == 0
    assert "renumbered" not in out
    assert [s.name for s in load_morph_targets(folder / "again.glb").states] == [s.name for s in load_head().states]


def test_info_tells_what_a_file_holds(folder: Path, capsys: Capsys):
    run(folder, "export", "base.obj", "smile.obj", "open.obj", "-o", "face.3dm", capsys=capsys)
    _, out, _ = run(folder, "info", "face.3dm", capsys=capsys)
    assert out.splitlines()[1:] == [
        "movestate  vertices  farthest",
        "smile             2    0.5590",
        "open              1    1.0000",
    ]
    _, out, _ = run(folder, "info", "base.obj", capsys=capsys)
    assert out == "base.obj: 8 vertices, 12 triangles, 1 material\n"


def test_converting_round_and_back_keeps_every_byte(folder: Path, capsys: Capsys):
    run(folder, "export", "base.obj", "smile.obj", "open.obj", "-o", "face.3dm", capsys=capsys)
    for source, target in (("face.3dm", "face.3dma"), ("face.3dma", "face.glb"), ("face.glb", "again.3dm")):
        assert run(folder, "convert", source, target, capsys=capsys)[0] == 0
    assert (folder / "again.3dm").read_bytes() == (folder / "face.3dm").read_bytes()


def test_converting_to_glb_with_the_mesh_shows_the_mesh(folder: Path, capsys: Capsys):
    run(folder, "export", "base.obj", "smile.obj", "-o", "face.3dm", capsys=capsys)
    assert run(folder, "convert", "face.3dm", "face.glb", "--mesh", "base.obj", capsys=capsys)[0] == 0
    morph_mesh = load_morph_mesh(folder / "face.glb")
    np.testing.assert_array_equal(morph_mesh.mesh.positions, CORNERS)
    assert len(morph_mesh.mesh.triangles) == 12


def test_a_mesh_in_another_order_gets_its_own_numbers(folder: Path, capsys: Capsys):
    run(folder, "export", "base.obj", "smile.obj", "-o", "face.3dm", capsys=capsys)
    (folder / "turned.obj").write_bytes(format_obj(mesh_of(CORNERS[::-1])))
    code, out, _ = run(folder, "convert", "face.3dm", "new.3dm", "--mesh", "turned.obj", capsys=capsys)
    assert code == 0
    assert "face.3dm: the vertices are renumbered as turned.obj has them" in out
    assert load_morph_targets(folder / "new.3dm").states[0].numbers.tolist() == [4, 6]


REFUSED = {
    "no targets": (("export", "base.obj", "-o", "a.3dm"), "base.obj: there are no morph targets in it"),
    "another mesh": (("export", "base.obj", "small.obj", "-o", "a.3dm"), "small.obj: it has 7 vertices, and"),
    "the base again": (("export", "base.obj", "same.obj", "-o", "a.3dm"), "same.obj: no vertex moves"),
    "twice": (("export", "base.obj", "smile.obj", "smile.obj", "-o", "a.3dm"), "two movestates are called 'smile'"),
    "garbage": (("info", "garbage.3dm"), "garbage.3dm: a .3dm file begins with"),
    "missing": (("info", "missing.glb"), "missing.glb: there is no such file; check its name and folder"),
    "a mesh alone": (("convert", "base.obj", "a.3dm"), "this is a mesh without morph targets"),
    "elsewhere": (("convert", "good.3dm", "b.3dm", "--mesh", "far.obj"), "2 of the 2 vertices that move are not in"),
    "no place": (("convert", "good.3dm", "none/b.3dm"), "b.3dm: cannot be written (No such file or directory)"),
}


@pytest.mark.parametrize(("words", "said"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_done_is_said_in_one_sentence(words: tuple[str, ...], said: str, folder: Path, capsys: Capsys):
    (folder / "small.obj").write_bytes(format_obj(mesh_of(CORNERS[:7])))
    (folder / "far.obj").write_bytes(format_obj(mesh_of(CORNERS + 9)))
    (folder / "same.obj").write_bytes((folder / "base.obj").read_bytes())
    (folder / "garbage.3dm").write_bytes(bytes(range(256)))
    smile = load_morph_mesh(folder / "smile.obj").mesh.positions - CORNERS
    morph_mesh = morph_mesh_of_cube()
    save_morph_targets(morph_targets_of(morph_mesh.mesh, morph_mesh.states[1:2]), folder / "good.3dm")
    assert smile.any()
    code, out, err = run(folder, *words, capsys=capsys)
    assert (code, out) == (1, "")
    assert err.startswith("phonemeanalyser: ")
    assert said in err
    assert err.count("\n") == 1
    assert not (folder / "a.3dm").exists()
