"""Bundlers of the web: a page that imports the shipped package, as vite and esbuild make it for production."""

import getpass
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import filelock
import pytest

from tests.web_ears import node

APP = Path(__file__).with_name("web_app")
PACKAGES = ("vite@6.4.6", "esbuild@0.25.9", "typescript@5.9.3")
BUNDLERS = ("vite", "esbuild")
ESBUILD = (
    "main.js",
    "--bundle",
    "--minify",
    "--target=es2020",
    "--format=esm",
    "--outdir=dist/assets",
    "--public-path=/assets",
    "--loader:.wasm=file",
    "--loader:.ear=file",
    "--asset-names=[name]",
)


def project(place: Path, package: Path) -> Path:
    """Make a project of the page in a folder, in which the shipped package is installed; gives it."""
    shutil.copytree(APP, place)
    (place / "package.json").write_text(json.dumps({"private": True, "type": "module"}), encoding="utf-8")
    tools = _installed()
    modules = place / "node_modules"
    modules.mkdir()
    for found in tools.iterdir():
        (modules / found.name).symlink_to(found)
    shutil.copytree(package, modules / "phoneme-ear")
    return place


def bundled(by: str, place: Path) -> tuple[Path, str]:
    """Have a bundler make the page ready for a web server; gives what it made, and its script there."""
    tool(place, by, *(("build",) if by == "vite" else ESBUILD))
    made = place / "dist"
    (script,) = [path for path in made.rglob("*.js") if "hear" in path.read_text(encoding="utf-8")]
    (made / "index.html").write_text(f'<script type="module" src="/assets/{script.name}"></script>', encoding="utf-8")
    return made, script.relative_to(made).as_posix()


def tool(place: Path, name: str, *words: str) -> None:
    """Run a tool of the project; what it complains about is a failure."""
    command = [str(place / "node_modules" / ".bin" / name), *words]
    done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "warn" not in (done.stdout + done.stderr).lower(), done.stdout + done.stderr


def _installed() -> Path:
    """Install the bundlers, unless that has been done; one process at a time, all others wait for it."""
    node()
    npm = shutil.which("npm")
    if npm is None and "CI" not in os.environ:
        pytest.skip("there is no npm")
    assert npm, "there is no npm; install it"
    place = Path(tempfile.gettempdir()) / f"phonemeanalyser-bundlers-{getpass.getuser()}" / "-".join(PACKAGES)
    place.mkdir(parents=True, exist_ok=True)
    with filelock.FileLock(place / "lock"):
        if not (place / "ready").exists():
            words = [npm, "install", "--prefix", str(place), "--no-audit", "--no-fund", "--prefer-offline", *PACKAGES]
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            if done.returncode and "CI" not in os.environ:
                pytest.skip(f"npm cannot fetch {', '.join(PACKAGES)}")
            assert done.returncode == 0, done.stderr
            (place / "ready").touch()
    return place / "node_modules"
