"""What a preset can be shipped for: files of this package, and what is made of them."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import phonemeengine
from phonemeengine.mouth.exports.glb import shipped_glb
from phonemeengine.shipping.npm import three_files
from phonemeengine.shipping.zig import compile_ear, shared_libraries

_HERE = Path(__file__).resolve().parent
_WASM = (
    "--target=wasm32-wasi",
    "-mexec-model=reactor",
    "-msimd128",
    "-fvisibility=hidden",
    '-DEAR_API=__attribute__((visibility("default")))',
    "-Wl,--export-dynamic,--export=malloc,--export=free,--strip-all",
)
"""For a module that asks its page for nothing, and gives all functions of `ear.h`."""

_LICENCE = next(folder for folder in (_HERE, _HERE.parents[2]) if (folder / "LICENSE").is_file()) / "LICENSE"
"""Of the program, and so of all that is shipped: beside this module where it is installed, as in a checkout."""
_WORKLET_PLACE = 'const WORKLET = "";'

DESCRIPTION = "Hears phonemes and visemes in speech, every 10 ms, and moves a mouth by them."

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
    """

    words: str
    sources: Mapping[str, str]
    makes: tuple[Callable[[], Files], ...] = ()
    preset: str = "preset.ear"
    licence: str = "LICENSE"

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
    """Return the ear as WebAssembly, and what makes a package of the folder."""
    package = {
        "name": "phoneme-ear",
        "version": phonemeengine.__version__,
        "description": DESCRIPTION,
        "license": "MIT",
        "type": "module",
        "exports": {
            ".": {"types": "./ear.d.ts", "default": "./ear.js"},
            "./ear-worklet.js": "./ear-worklet.js",
            "./ear.wasm": "./ear.wasm",
            "./preset.ear": "./preset.ear",
        },
        "types": "ear.d.ts",
        "files": ["ear.js", "ear.d.ts", "ear-worklet.js", "ear.wasm", "preset.ear", "LICENSE"],
    }
    return {"ear.js": _with_worklet(), "ear.wasm": compile_ear(_WASM, "ear.wasm"), "package.json": _json(package)}


def _with_worklet() -> bytes:
    """Return the module with the worklet in it, so that no bundler has to know of a second file."""
    module, worklet = ((_HERE / "web" / name).read_text(encoding="utf-8") for name in ("ear.js", "ear-worklet.js"))
    before, place, after = module.partition(_WORKLET_PLACE)
    assert place
    return f"{before}const WORKLET = {json.dumps(worklet)};{after}".encode()


def _demo_page() -> Files:
    """Return what the page draws: a head, and the library that draws it."""
    three = {f"demo/three/{name}": content for name, content in three_files().items()}
    return {"demo/head.glb": shipped_glb().content(), **three}


def _unity_package() -> Files:
    """Return the libraries where Unity looks for them, and what makes a package of the folder."""
    package = {
        "name": "com.phonemeanalyser.ear",
        "version": phonemeengine.__version__,
        "displayName": "Phoneme Ear",
        "description": DESCRIPTION,
        "unity": "2021.2",
        "license": "MIT",
    }
    places = {".dylib": "macOS", ".so": "x86_64", ".dll": "x86_64"}
    libraries = {
        f"Runtime/Plugins/{places[Path(name).suffix]}/{name}": content for name, content in shared_libraries().items()
    }
    return {"package.json": _json(package), **libraries}


def _json(document: object) -> bytes:
    return json.dumps(document, indent=2).encode() + b"\n"


TARGETS: Mapping[str, ShipTarget] = {
    "c": ShipTarget("C99, for programs of all kinds", {"c": ""}),
    "web": ShipTarget(
        "WebAssembly and an AudioWorklet, and a page with a talking head",
        {"web": "", "web_demo": "demo"},
        (_web_module, _demo_page),
    ),
    "web-module": ShipTarget("the same without the page, as an npm package", {"web": ""}, (_web_module,)),
    "unity": ShipTarget(
        "a package for Unity: C#, a talking face and a talking sprite",
        {"unity": "", "csharp": "Runtime"},
        (_unity_package,),
        "preset.bytes",
        "LICENSE.md",  # which Unity shows
    ),
    "godot": ShipTarget(
        "an add-on for Godot 4 with .NET, with the same two", {"godot": "", "csharp": ""}, (shared_libraries,)
    ),
}
"""What can be shipped for, by name."""
