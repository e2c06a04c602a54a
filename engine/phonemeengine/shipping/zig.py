"""The door to zig, a C compiler that builds for all systems and for WebAssembly."""

import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.errors import ExportError

TIMEOUT = 900.0
"""Seconds; its first call for a system compiles the C library, too."""
FAT_MAGIC, PAGE = 0xCAFEBABE, 1 << 14


_EAR = Path(__file__).resolve().with_name("c") / "ear.c"
_SHARED = ("-shared", "-s", "-fvisibility=hidden")
_SEEN = '-DEAR_API=__attribute__((visibility("default")))'
_SYSTEMS = {
    "libear.so": (("--target=x86_64-linux-gnu.2.17", "-fPIC", _SEEN),),
    "ear.dll": (("--target=x86_64-windows-gnu", "-DEAR_API=__declspec(dllexport)"),),
    "libear.dylib": tuple(
        (f"--target={processor}-macos.11.0", "-Wl,-install_name,@rpath/libear.dylib", _SEEN)
        for processor in ("x86_64", "aarch64")
    ),
}
"""What zig is told, once for each processor."""


def shared_libraries() -> dict[str, bytes]:
    """Return the ear as a shared library for Linux, Windows and macOS, by file name.

    Raises
    ------
    ExportError : there is no zig, or it fails.
    """
    made = {name: [compile_ear((*_SHARED, *flags), name) for flags in tried] for name, tried in _SYSTEMS.items()}
    return {name: slices[0] if len(slices) == 1 else _universal(slices) for name, slices in made.items()}


def compile_ear(flags: tuple[str, ...], name: str) -> bytes:
    """Return what zig makes of `ear.c`, which may tell the name of its file.

    Raises
    ------
    ExportError : there is no zig, or it fails.
    """
    with tempfile.TemporaryDirectory() as folder:
        command = [*_zig(), "cc", "-std=c99", "-O3", *flags, str(_EAR), "-o", name]
        try:
            done = subprocess.run(  # noqa: S603 - our own words
                command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=TIMEOUT, check=False
            )
        except (OSError, subprocess.SubprocessError) as error:
            raise ExportError(f"the compiler zig does not run ({error}); install it again") from error
        made = Path(folder) / name
        if done.returncode or not made.exists():
            why = next((line for line in done.stderr.splitlines() if "error" in line), "no reason given")
            raise ExportError(f"the compiler zig cannot compile the ear ({why:.200}); install a newer one")
        return made.read_bytes()


def _universal(slices: Sequence[bytes]) -> bytes:
    """Join libraries for several processors into one file, as macOS has them; see ``mach-o/fat.h``."""
    header, body, at = struct.pack(">II", FAT_MAGIC, len(slices)), b"", PAGE
    for content in slices:
        processor = struct.unpack_from("<II", content, 4)
        header += struct.pack(">IIIII", *processor, at + len(body), len(content), PAGE.bit_length() - 1)
        body += content + bytes(-len(content) % PAGE)
    return header.ljust(PAGE, b"\0") + body


def _zig() -> list[str]:
    """Return the words that begin a call of zig: the one of the system, or that of the package ziglang."""
    if found := shutil.which("zig"):
        return [found]
    if find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang"]
    raise ExportError(
        "this target is compiled by zig, which is not installed; install zig, or pip install "
        "'phonemeanalyser[ship]', or ship the target c"
    )
