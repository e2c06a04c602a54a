"""The runtime compiled by zig, a C compiler that builds for all systems and for WebAssembly."""

import hashlib
import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.errors import ExportError

COMPILE_TIMEOUT = 900.0
"""Seconds; its first call for a system compiles the C library, too."""
FAT_MAGIC, PAGE = 0xCAFEBABE, 1 << 14

_HERE = Path(__file__).resolve().parent
_SEEN = '-DEAR_API=__attribute__((visibility("default")))'
_ALWAYS = ("-std=c99", "-O3", "-fvisibility=hidden")
_LIBRARY = ("-shared", "-s", "-Ic", "c/ear.c", "gdextension/ear_godot.c")
_DECLARED = ("-isystem", "declared", "-nostdlib")
"""For systems whose headers and C library zig does not bring."""

MODULE = "ear.wasm"
_WASM = (
    "--target=wasm32-freestanding",
    "-msimd128",
    "-isystem",
    "declared",
    _SEEN,
    "-Wl,--no-entry,--export-dynamic,--export=malloc,--export=free,--strip-all",
    "c/ear.c",
    "declared/module.c",
)
"""For a module that asks its page for nothing, and gives all functions of ``ear.h``.

A whole C library would be compiled first, for most of a minute.
"""


def _android(processor: str) -> tuple[str, ...]:
    pages = "-Wl,-soname,libear.so,-z,max-page-size=16384,--no-as-needed"
    return (
        f"--target={processor}-linux-android",
        "-fPIC",
        _SEEN,
        *_DECLARED,
        *_LIBRARY,
        pages,
        "{libc.so}",
        "{libm.so}",
    )


def _linux(processor: str) -> tuple[str, ...]:
    return (f"--target={processor}-linux-gnu.2.17", "-fPIC", _SEEN, "-Wl,-soname,libear.so", *_LIBRARY)


def _macos(processor: str) -> tuple[str, ...]:
    return (f"--target={processor}-macos.11.0", "-Wl,-install_name,@rpath/libear.dylib", _SEEN, *_LIBRARY)


_IOS = ("--target=aarch64-ios.12.0", _SEEN, *_DECLARED, "-Ic", "-c")
LIBRARIES: Mapping[str, tuple[tuple[str, ...], ...]] = {
    "linux.x86_64/libear.so": (_linux("x86_64"),),
    "linux.arm64/libear.so": (_linux("aarch64"),),
    "windows.x86_64/ear.dll": (("--target=x86_64-windows-gnu", "-DEAR_API=__declspec(dllexport)", *_LIBRARY),),
    "macos/libear.dylib": (_macos("x86_64"), _macos("aarch64")),
    "android.arm64/libear.so": (_android("aarch64"),),
    "android.x86_64/libear.so": (_android("x86_64"),),
    "ios.arm64/libear.a": ((*_IOS, "c/ear.c"), (*_IOS, "gdextension/ear_godot.c")),
}
"""Options of zig for each library: once, once for each processor of macOS, or once for each source of an archive."""


def runtime_sources(folder: str) -> dict[str, bytes]:
    """Return the C that a program compiles itself, by path, in a folder of that name."""
    return {f"{folder}/{path.name}": path.read_bytes() for path in sorted((_HERE / "c").glob("ear*.[ch]"))}


def library(name: str) -> bytes:
    """Return one of `LIBRARIES`: as it came with the program, or compiled now.

    Raises
    ------
    ExportError : it did not come with the program, and there is no zig, or it fails.
    """
    return prebuilt(name) or _compile_library(name)


def module() -> bytes:
    """Return the runtime as WebAssembly, as `library` does."""
    return prebuilt(MODULE) or compile_ear(_WASM, MODULE)


def _compile_library(name: str) -> bytes:
    file = Path(name).name
    if file.endswith(".a"):
        return _archive([compile_ear(flags, "ear.o") for flags in LIBRARIES[name]], file)
    slices = [compile_ear(flags, file) for flags in LIBRARIES[name]]
    return slices[0] if len(slices) == 1 else _universal(slices)


PREBUILT = _HERE / "prebuilt"
"""What a wheel and a bundle bring compiled; a checkout has it after a release, and compiles with zig otherwise."""


def prebuilt(name: str, folder: Path = PREBUILT) -> bytes | None:
    """Return a part that came compiled; None where there is none, or sources or options have changed since."""
    made_of, part = folder / "SOURCES", folder / _part(name)
    if not (part.is_file() and made_of.is_file() and made_of.read_text(encoding="ascii") == _sources()):
        return None
    return part.read_bytes()


def prebuild(folder: Path) -> None:
    """Compile all parts anew into a folder.

    Raises
    ------
    ExportError : there is no zig, or it fails.
    """
    parts = {name: _compile_library(name) for name in LIBRARIES} | {MODULE: compile_ear(_WASM, MODULE)}
    for name, content in parts.items():
        (folder / _part(name)).write_bytes(content)
    (folder / "SOURCES").write_text(_sources(), encoding="ascii")


def _part(name: str) -> str:
    return f"{name.replace('/', '-')}.bin"  # a name that packers do not take for a library


def _sources() -> str:
    """Return a checksum of all that compiled parts are made of."""
    digest = hashlib.sha256(repr((_ALWAYS, LIBRARIES, _WASM)).encode())
    for path in sorted(
        path for folder in ("c", "gdextension", "declared") for path in (_HERE / folder).glob("*.[ch]")
    ):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def compile_ear(flags: Sequence[str], name: str) -> bytes:
    """Return what zig makes of the runtime, which may tell the name of its file.

    An option in braces stands for an empty library of that name, for which the runtime asks when it is loaded.

    Raises
    ------
    ExportError : there is no zig, or it fails.
    """
    with tempfile.TemporaryDirectory() as place:
        made = Path(place) / name
        words = [
            _named_only(made.with_name(word[1:-1]), flags[0]) if word.startswith("{") else word for word in flags
        ]
        return _zig(made, "cc", *_ALWAYS, *words, "-o", str(made))


def _named_only(made: Path, system: str) -> str:
    """Return the path of a library that is empty: the system has a whole one of that name."""
    made.with_name("none.c").touch()
    words = f"-Wl,-soname,{made.name}", str(made.with_name("none.c"))
    _zig(made, "cc", system, "-shared", "-nostdlib", *words, "-o", str(made))
    return str(made)


def _archive(objects: Sequence[bytes], name: str) -> bytes:
    """Return objects as a static library, which programs for iOS are linked with."""
    with tempfile.TemporaryDirectory() as place:
        paths = [Path(place) / f"ear{k}.o" for k in range(len(objects))]
        for path, content in zip(paths, objects, strict=True):
            path.write_bytes(content)
        made = Path(place) / name
        return _zig(made, "ar", "--format=darwin", "rcsD", str(made), *map(str, paths))


def _universal(slices: Sequence[bytes]) -> bytes:
    """Join libraries for several processors into one file, as macOS has them; see ``mach-o/fat.h``."""
    header, body, at = struct.pack(">II", FAT_MAGIC, len(slices)), b"", PAGE
    for content in slices:
        processor = struct.unpack_from("<II", content, 4)
        header += struct.pack(">IIIII", *processor, at + len(body), len(content), PAGE.bit_length() - 1)
        body += content + bytes(-len(content) % PAGE)
    return header.ljust(PAGE, b"\0") + body


def _zig(made: Path, *words: str) -> bytes:
    """Call zig among the sources, the one of the system or that of the package ziglang; return what it makes."""
    if found := shutil.which("zig"):
        program = [found]
    elif find_spec("ziglang"):
        program = [sys.executable, "-m", "ziglang"]
    else:
        raise ExportError(
            "this target is compiled by zig, which is not installed; install zig, or pip install "
            "'phonemeanalyser[ship]', or ship the target c"
        )
    try:
        done = subprocess.run(  # noqa: S603 - our own words
            [*program, *words],
            cwd=_HERE,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=COMPILE_TIMEOUT,
            check=False,
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise ExportError(f"the compiler zig does not run ({error}); install it again") from error
    if done.returncode or not made.exists():
        why = next((line for line in done.stderr.splitlines() if "error" in line), "no reason given")
        raise ExportError(f"the compiler zig cannot compile the runtime ({why:.200}); install a newer one")
    return made.read_bytes()
