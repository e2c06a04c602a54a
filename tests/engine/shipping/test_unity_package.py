"""The folder for Unity keeps the rules of a package: all that a script can check."""

import json
import re
from pathlib import Path

import pytest

import phonemeengine
from phonemeengine.shipping.targets import TARGETS, Files
from phonemeengine.shipping.unity_package import PLACES, UNITY_NAME, metas, package_files

SOURCES = Path(phonemeengine.__file__).parent / "shipping"


@pytest.fixture(scope="module")
def files() -> Files:
    """The package; what zig makes of the libraries is of no account here."""
    found = {"preset.bytes": b"EAR", "LICENSE.md": b"MIT"}
    for source, place in TARGETS["unity"].sources.items():
        for path in (path for path in (SOURCES / source).rglob("*") if path.is_file()):
            found[(Path(place) / path.relative_to(SOURCES / source)).as_posix()] = path.read_bytes()
    found |= package_files(dict.fromkeys(PLACES, b"library"), "Recognises.")
    return found | metas(found)


def test_every_file_and_folder_that_unity_sees_has_an_id_of_its_own_that_stays(files: Files) -> None:
    assets = {name for name in files if not name.endswith(".meta") and "~/" not in name}
    folders = {parent.as_posix() for name in assets for parent in Path(name).parents if parent.parts}
    described = {name.removesuffix(".meta") for name in files if name.endswith(".meta")}
    assert described == assets | folders
    ids = {
        name: re.findall(r"^guid: ([0-9a-f]{32})$", files[f"{name}.meta"].decode(), re.MULTILINE)
        for name in described
    }
    assert all(len(found) == 1 for found in ids.values())
    assert len({found[0] for found in ids.values()}) == len(described)
    assert ids["Runtime/TalkingFace.cs"] == ["bb4ce449703d0ced3045fcb465b65b3a"]  # scenes refer to it


def test_the_manifest_says_what_unity_asks_for_and_its_samples_are_there(files: Files) -> None:
    package = json.loads(files["package.json"])
    assert package["name"] == UNITY_NAME
    assert re.fullmatch(r"[a-z0-9-]+(\.[a-z0-9-]+){2,}", UNITY_NAME)
    assert re.fullmatch(r"\d+\.\d+\.\d+(-[\w.]+)?", package["version"])
    assert re.fullmatch(r"20\d\d\.\d", package["unity"])
    assert package["author"]["name"]
    assert all(package[key] for key in ("displayName", "description", "license", "keywords"))
    for sample in package["samples"]:
        assert sample.keys() == {"displayName", "description", "path"}
        assert any(name.startswith(f"{sample['path']}/") for name in files)
    assert {"README.md", "CHANGELOG.md", "LICENSE.md"} <= files.keys()
    assert f"[{package['version']}]" in files["CHANGELOG.md"].decode()
    assert any(name.startswith("Documentation~/") and name.endswith(".md") for name in files)


def test_assemblies_are_named_as_their_files_and_the_editor_s_stays_in_the_editor(files: Files) -> None:
    assemblies = {Path(name): json.loads(content) for name, content in files.items() if name.endswith(".asmdef")}
    assert {path.stem for path in assemblies} == {found["name"] for found in assemblies.values()}
    for path, found in assemblies.items():
        assert (found.get("includePlatforms") == ["Editor"]) == (path.parts[0] == "Editor")
        assert {*found.get("references", [])} <= {"PhonemeEar", "Unity.Timeline"}
    in_editor = [name for name, content in files.items() if name.endswith(".cs") and b"using UnityEditor" in content]
    assert in_editor
    assert all(name.startswith("Editor/") for name in in_editor)


def test_a_component_or_asset_lies_in_a_file_of_its_name(files: Files) -> None:
    kinds = r"class (\w+) : (?:EarListener|MonoBehaviour|PlayableAsset|TrackAsset|EditorWindow)"
    found = {name: re.findall(kinds, content.decode()) for name, content in files.items() if name.endswith(".cs")}
    assert sum(map(len, found.values())) == 7
    assert all(names in ([], [Path(path).stem]) for path, names in found.items())


PLATFORMS = {
    "libear.so": {"Editor", "Linux64"},
    "ear.dll": {"Editor", "Win64"},
    "libear.dylib": {"Editor", "OSXUniversal"},
    "ear.c": {"Android", "WebGL", "iOS"},
    "ear.h": {"Android", "WebGL", "iOS"},
    "ear_kernels.h": {"Android", "WebGL", "iOS"},
}


def test_each_library_is_imported_for_its_systems_alone(files: Files) -> None:
    metas_of = {
        Path(name).name.removesuffix(".meta"): content.decode()
        for name, content in files.items()
        if name.endswith(".meta") and b"PluginImporter" in content
    }
    assert metas_of.keys() == PLATFORMS.keys()
    for name, text in metas_of.items():
        on = re.findall(r"- first:\n      \w+: (\w+)\n    second:\n      enabled: 1\n", text)
        assert {*on} == PLATFORMS[name]
        assert {*re.findall(r"Exclude (\w+): 0", text)} == PLATFORMS[name]
    editors = [
        re.findall(r"Editor: Editor\n.*\n.*\n.*\n        CPU: \w+\n        OS: (\w+)", text)
        for text in metas_of.values()
    ]
    assert sorted(filter(None, editors)) == [["Linux"], ["OSX"], ["Windows"]]
