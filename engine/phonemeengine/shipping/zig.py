"""The door to zig, a C compiler that builds for all systems and for WebAssembly."""

import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from phonemeengine.errors import ExportError

TIMEOUT = 900.0
"""Seconds; its first call for a system compiles the C library, too."""


def compile_ear(source: Path, flags: tuple[str, ...]) -> bytes:
    """Return what zig makes of a C file.

    Raises
    ------
    ExportError : there is no zig, or it fails.
    """
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "made"
        command = [*_zig(), "cc", "-std=c99", "-O3", *flags, str(source), "-o", str(made)]
        try:
            done = subprocess.run(  # noqa: S603 - our own words
                command, capture_output=True, text=True, errors="replace", timeout=TIMEOUT, check=False
            )
        except (OSError, subprocess.SubprocessError) as error:
            raise ExportError(f"the compiler zig does not run ({error}); install it again") from error
        if done.returncode or not made.exists():
            why = next((line for line in done.stderr.splitlines() if "error" in line), "no reason given")
            raise ExportError(f"the compiler zig cannot compile the ear ({why:.200}); install a newer one")
        return made.read_bytes()


def _zig() -> list[str]:
    """Return the words that begin a call of zig: the one of the system, or that of the package ziglang."""
    if found := shutil.which("zig"):
        return [found]
    if find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang"]
    raise ExportError(
        "this target is compiled by zig, which is not installed; install it with pip install "
        "'phonemeanalyser[ship]', or ship the target c"
    )
