"""A package for Unity: its manifest, where its libraries lie, and the `.meta` files by which Unity knows them."""

import hashlib
import json
import tomllib
from collections.abc import Mapping
from pathlib import PurePosixPath

import phonemeengine
from phonemeengine.mouth.face_mapping import SHAPE_NAMES
from phonemeengine.shipping.compiling import runtime_sources

Files = dict[str, bytes]

UNITY_NAME = "com.phonemeanalyser.ear"
PLACES = {
    "linux.x86_64/libear.so": "Runtime/Plugins/x86_64/libear.so",
    "windows.x86_64/ear.dll": "Runtime/Plugins/x86_64/ear.dll",
    "macos/libear.dylib": "Runtime/Plugins/macOS/libear.dylib",
}
"""Of the libraries that the package brings; other systems compile the source."""
_SOURCE_FOLDER = "Runtime/Plugins/Source"
"""Of the C that Unity compiles itself, where a program has no libraries that it could load."""


def package_files(shared: Files, description: str) -> Files:
    """Return libraries where Unity looks for them, the source for other systems, and what makes a package of it.

    Parameters
    ----------
    shared : the libraries of `PLACES`, by name.
    description : what the package says that it does.
    """
    package = {
        "name": UNITY_NAME,
        "version": phonemeengine.__version__,
        "displayName": "Phoneme Ear",
        "description": description,
        "unity": "2021.2",
        "license": "MIT",
        "author": {"name": "PhonemeAnalyser"},
        "keywords": ["lip sync", "phoneme", "viseme", "blend shape"],
        "samples": [
            {
                "displayName": "Talk at Run Time",
                "description": "A head that is made while the game runs speaks by the microphone.",
                "path": "Samples~/TalkAtRunTime",
            }
        ],
    }
    libraries = {PLACES[name]: content for name, content in shared.items()}
    version = phonemeengine.__version__
    changes = f"# Changelog\n\n## [{version}]\n\nMade by PhonemeAnalyser {version}.\n"
    return {
        "package.json": json.dumps(package, indent=2).encode() + b"\n",
        "CHANGELOG.md": changes.encode(),
        "Editor/shape_names.txt": _shape_names(),
        **libraries,
        **runtime_sources(_SOURCE_FOLDER),
    }


def _shape_names() -> bytes:
    """Return what programs call the blend shapes of ARKit, a line for each: those of one part."""
    names = tomllib.loads(SHAPE_NAMES.read_text(encoding="utf-8"))["arkit"]
    lines = (f"{ours}={' '.join(one for one in known if isinstance(one, str))}" for ours, known in names.items())
    return ("\n".join(lines) + "\n").encode()


_META_IMPORTERS = {
    ".cs": "MonoImporter",
    ".asmdef": "AssemblyDefinitionImporter",
    ".json": "PackageManifestImporter",
    ".md": "TextScriptImporter",
    ".txt": "TextScriptImporter",
    ".bytes": "TextScriptImporter",
    "": "DefaultImporter",
}
_PLUGIN_PLATFORMS: Mapping[str, Mapping[str, Mapping[str, str]]] = {
    ".so": {"Editor": {"CPU": "x86_64", "OS": "Linux"}, "Linux64": {"CPU": "x86_64"}},
    ".dll": {"Editor": {"CPU": "x86_64", "OS": "Windows"}, "Win64": {"CPU": "x86_64"}},
    ".dylib": {"Editor": {"CPU": "AnyCPU", "OS": "OSX"}, "OSXUniversal": {"CPU": "AnyCPU"}},
    ".c": {"Android": {}, "WebGL": {}, "iOS": {}},
    ".h": {"Android": {}, "WebGL": {}, "iOS": {}},
}
"""What the importer of a library switches on, by its ending; all other platforms are off."""


def metas(files: Files) -> Files:
    """Return the files with which Unity knows each file and folder again: their ids never change.

    Folders that end in a tilde are hidden from Unity, so they and their files have none.
    """
    seen = [path for path in map(PurePosixPath, files) if not any(part.endswith("~") for part in path.parts)]
    folders = {folder for path in seen for folder in path.parents if folder.parts}
    return {f"{path}.meta": _meta(path, path in folders).encode() for path in sorted({*seen, *folders})}


def _meta(path: PurePosixPath, is_folder: bool) -> str:
    identity = hashlib.md5(f"{UNITY_NAME}/{path}".encode(), usedforsecurity=False).hexdigest()
    start = f"fileFormatVersion: 2\nguid: {identity}\n"
    end = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"
    if is_folder:
        return f"{start}folderAsset: yes\nDefaultImporter:\n  externalObjects: {{}}\n{end}"
    if path.suffix not in _PLUGIN_PLATFORMS:
        return f"{start}{_META_IMPORTERS[path.suffix]}:\n  externalObjects: {{}}\n{end}"
    platforms = _PLUGIN_PLATFORMS[path.suffix]
    off = "".join(f"        Exclude {name}: {int(name not in platforms)}\n" for name in _ALL_PLATFORMS)
    on = "".join(_platform(name, settings) for name, settings in platforms.items())
    return (
        f"{start}PluginImporter:\n  externalObjects: {{}}\n  serializedVersion: 2\n  iconMap: {{}}\n"
        "  executionOrder: {}\n  defineConstraints: []\n  isPreloaded: 0\n  isOverridable: 0\n"
        "  isExplicitlyReferenced: 0\n  validateReferences: 1\n  platformData:\n"
        "  - first:\n      : Any\n    second:\n      enabled: 0\n"
        f"      settings:\n{off}"
        "  - first:\n      Any: \n    second:\n      enabled: 0\n      settings: {}\n"
        f"{on}{end}"
    )


_GROUPS = {"Linux64": "Standalone", "Win64": "Standalone", "OSXUniversal": "Standalone", "iOS": "iPhone"}
_ALL_PLATFORMS = ("Android", "Editor", "Linux64", "OSXUniversal", "WebGL", "Win", "Win64", "iOS")


def _platform(name: str, settings: Mapping[str, str]) -> str:
    lines = "".join(f"        {key}: {value}\n" for key, value in settings.items())
    return (
        f"  - first:\n      {_GROUPS.get(name, name)}: {name}\n    second:\n      enabled: 1\n"
        f"      settings:{chr(10) + lines if lines else ' {}' + chr(10)}"
    )
