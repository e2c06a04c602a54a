"""Makes all files of a release: ``make release``, or ``python -m tools.release -o FOLDER``.

The checkout must have no changes, and times inside the files are those of its last commit. What takes seconds is made
twice, and must have the same bytes.
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

from phonemeengine.shipping.compiling import PREBUILT, prebuild
from tools.blender.build import build
from tools.bundle.making import make_bundle

ROOT = Path(__file__).resolve().parents[2]


def main(argv: Sequence[str] | None = None) -> int:
    """Make them; returns 0, or 1 where there are changes or two makings differ."""
    parser = argparse.ArgumentParser(prog="python -m tools.release", description=__doc__)
    parser.add_argument("-o", "--out", type=Path, default=ROOT / "build" / "release", help="folder (build/release)")
    out = parser.parse_args(argv).out.resolve()
    if _answer("git", "status", "--porcelain"):
        print("This checkout has changes; commit them, so that others can make the same release.", file=sys.stderr)
        return 1
    os.environ["SOURCE_DATE_EPOCH"] = _answer("git", "log", "-1", "--format=%ct")
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    PREBUILT.mkdir(exist_ok=True)  # git ignores it, and wheel and bundle hold it
    differing = made_twice(prebuild, PREBUILT)
    differing += [name for make in (package, web_module, add_on) for name in made_twice(make, out)]
    shutil.copy2(make_bundle(out.parent / "bundle")[1], out)
    write_checksums(out)
    print((out / "SHA256SUMS").read_text(), end="")
    for name in differing:
        print(f"{name}: two makings differ", file=sys.stderr)
    return 1 if differing else 0


def package(out: Path) -> None:
    """Make wheel and source."""
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", out], cwd=ROOT, check=True)


def web_module(out: Path) -> None:
    """Make the package for npm, with the preset *Learned*."""
    with tempfile.TemporaryDirectory() as folder:
        shipped = Path(folder) / "web"
        command = [sys.executable, "-m", "phonemeanalyser", "ship", "learned", "--target", "web-module"]
        subprocess.run([*command, "-o", shipped], cwd=ROOT, check=True)
        subprocess.run([_npm(), "pack", "--silent", "--pack-destination", out], cwd=shipped, check=True)


def add_on(out: Path) -> None:
    """Make the add-on for Blender."""
    build(out)


def made_twice(make: Callable[[Path], None], out: Path) -> list[str]:
    """Make files into a folder, and once more elsewhere; returns the names of those whose bytes differ."""
    with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
        make(Path(first))
        make(Path(second))
        names = sorted(path.name for path in Path(first).iterdir())
        differing = [
            name for name in names if (Path(first) / name).read_bytes() != (Path(second) / name).read_bytes()
        ]
        for name in names:
            shutil.copy2(Path(first) / name, out)
    return differing


def write_checksums(folder: Path) -> None:
    """Write SHA256SUMS, which ``sha256sum --check`` reads."""
    files = sorted(path for path in folder.iterdir() if path.name != "SHA256SUMS")
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files]
    (folder / "SHA256SUMS").write_text("".join(lines))


def _npm() -> str:
    found = shutil.which("npm")
    if found is None:
        raise SystemExit("The web module is packed by npm, which is not installed; install Node.js with npm.")
    return found


def _answer(*command: str) -> str:
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


if __name__ == "__main__":
    sys.exit(main())
