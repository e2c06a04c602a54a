"""The add-on's zip, and what of the add-on needs no Blender; the rest is tested in Blender by `make test-blender`."""

import ast
import importlib
import sys
import tomllib
import zipfile
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

import phonemeengine
from phonemeengine.conversion.work import export
from phonemeengine.errors import MouthError
from phonemeengine.mouth.exports.exporter import ExportOptions
from phonemeengine.mouth.table import load_table, shipped_tables, table_of
from phonemeengine.presets.files import load_preset
from tests.conftest import ROOT
from tools.blender.addon.axes import Axes, to_file, to_mesh
from tools.blender.addon.mouth_tables import checked_toml, movements_on, sounds_of, with_movements
from tools.blender.addon.tracks import ANGLES, read_track
from tools.blender.build import OF_BLENDER, build, contents, imported_by, with_relative_imports, zip_of

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"
KEYS = ("JawOpen", "mouthFunnel", "Zunge")


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return contents()


def absolute_imports(text: str) -> set[str]:
    found = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add(str(node.module).split(".")[0])
    return found


def test_the_zip_is_the_same_each_time_and_has_its_manifest_on_top(files: dict[str, bytes], tmp_path: Path) -> None:
    path = build(tmp_path)
    assert path.read_bytes() == zip_of(files)
    with zipfile.ZipFile(BytesIO(path.read_bytes())) as archive:
        assert {"blender_manifest.toml", "__init__.py", "LICENSE", "tomli_w/LICENSE"} <= {*archive.namelist()}


def test_the_manifest_has_the_program_s_version_and_says_what_it_may_do(files: dict[str, bytes]) -> None:
    manifest = tomllib.loads(files["blender_manifest.toml"].decode())
    assert manifest["version"] == phonemeengine.__version__
    assert (manifest["schema_version"], manifest["type"], manifest["license"]) == ("1.0.0", "add-on", ["SPDX:MIT"])
    assert manifest["blender_version_min"] == "4.2.0"
    assert manifest["permissions"].keys() == {"files"}
    assert len(manifest["tagline"]) <= 64
    assert not manifest["tagline"].endswith(".")


def test_modules_in_the_zip_import_each_other_and_else_what_blender_has(files: dict[str, bytes]) -> None:
    modules = {place: content.decode() for place, content in files.items() if place.endswith(".py")}
    for place, text in modules.items():
        assert absolute_imports(text) <= {*sys.stdlib_module_names, *OF_BLENDER}, place
    assert "phonemeengine/mouth/files/threedm.py" in modules
    assert not any("soundfile" in text for text in modules.values())


def test_the_engine_in_the_zip_reads_without_the_installed_one(tmp_path: Path, files: dict[str, bytes]) -> None:
    folder = tmp_path / "lip_sync_addon"
    for place, content in files.items():
        if place != "__init__.py":
            (folder / place).parent.mkdir(parents=True, exist_ok=True)
            (folder / place).write_bytes(content)
    (folder / "__init__.py").touch()
    sys.path.insert(0, str(tmp_path))
    try:
        tables = importlib.import_module("lip_sync_addon.phonemeengine.mouth.table")
        assert Path(tables.__file__ or "").is_relative_to(folder)
        assert tables.load_table("arkit").movestates == load_table("arkit").movestates
    finally:
        sys.path.remove(str(tmp_path))
        for name in [name for name in sys.modules if name.startswith("lip_sync_addon")]:
            del sys.modules[name]


def test_an_import_of_what_blender_does_not_have_fails_the_build() -> None:
    with pytest.raises(ValueError, match=r"imports scipy\.fft, which Blender does not have"):
        imported_by("import numpy\nfrom scipy.fft import rfft\n")


def test_imports_become_relative_as_deep_as_the_module_lies() -> None:
    text = '"""from phonemeengine"""\nimport numpy\nimport tomli_w\nfrom phonemeengine.mouth import mesh\n'
    relative = (
        '"""from phonemeengine"""\nimport numpy\nfrom .. import tomli_w\nfrom ..phonemeengine.mouth import mesh\n'
    )
    assert with_relative_imports(text, 1) == relative


def test_vectors_that_are_turned_come_back() -> None:
    vectors = np.array([(1, 2, 3)], np.float32)
    assert to_mesh(vectors, Axes.Z_UP).tolist() == [[1, -3, 2]]
    assert (
        to_file(to_mesh(vectors, Axes.Z_UP), Axes.Z_UP).tolist()
        == to_file(vectors, Axes.Y_UP).tolist()
        == [[1, 2, 3]]
    )


@pytest.mark.parametrize("name", shipped_tables())
def test_a_table_for_a_face_moves_what_the_face_has_and_is_read_by_the_engine(name: str, tmp_path: Path) -> None:
    table = load_table(name)
    made = with_movements(table, movements_on(table, KEYS), KEYS)
    path = tmp_path / "face.toml"
    path.write_text(checked_toml(made), encoding="utf-8")
    loaded = load_table(path)
    assert loaded == made
    assert loaded.movestates == KEYS
    assert loaded.phones == table.phones
    assert {key for shape in loaded.shapes.values() for key in shape} <= {"JawOpen", "mouthFunnel"}


def test_capitals_of_a_shape_key_do_not_count() -> None:
    table = load_table("arkit")
    assert dict(movements_on(table, KEYS)["a"]) == {"JawOpen": table.shapes["a"]["jawOpen"]}
    assert dict(movements_on(table, ("jawopen", "jawOpen"))["a"]).keys() == {"jawOpen"}


def test_a_shape_that_moves_what_the_face_lacks_keeps_it() -> None:
    shapes = {shape: [("Mund", 80.0)] for shape in load_table("arkit").shapes}
    assert table_of(checked_toml(with_movements(load_table("arkit"), shapes, KEYS))).movestates == (*KEYS, "Mund")


@pytest.mark.parametrize(
    ("movements", "words"),
    [
        ([("", 50.0)], "shape a has a movement without a shape key"),
        ([("A", 1.0), ("A", 2.0)], "shape a moves 'A' twice"),
    ],
)
def test_a_movement_that_is_impossible_is_refused(movements: list[tuple[str, float]], words: str) -> None:
    with pytest.raises(MouthError, match=words):
        with_movements(load_table("arkit"), {"a": movements}, KEYS)


def test_a_shape_tells_its_sounds() -> None:
    assert sounds_of(load_table("arkit"), "f") == "labiodental"
    assert sounds_of(load_table("eleven"), "sz").startswith("sz")


def test_a_face_s_own_table_makes_curves_of_its_shape_keys(tmp_path: Path) -> None:
    table = tmp_path / "face.toml"
    base = load_table("arkit")
    table.write_text(checked_toml(with_movements(base, movements_on(base, KEYS), KEYS)), encoding="utf-8")
    curves = tmp_path / "demo.curves.json"
    export(DEMO, curves, "curves-json", load_preset("thesis"), ExportOptions(table=table))
    track = read_track(curves)
    assert track.movement.channels == ("JawOpen", "mouthFunnel", *ANGLES)
    assert track.columns_of({"Jaw": "JawOpen"}, 25)["Jaw"].max() > 0.3
    assert len(track.cues) > 10


def test_a_track_of_another_ending_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MouthError, match=r"a\.fbx: its ending must be \.json or \.csv; choose another file"):
        read_track(tmp_path / "a.fbx")
