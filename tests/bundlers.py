"""Bundlers of the web: a page that imports the shipped package, as each of them makes it for production."""

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
MORE_PACKAGES = (
    *("webpack@5.113.0", "webpack-cli@7.3.1", "parcel@2.16.4", "esbuild@0.25.9"),
    *("react@19.3.1", "react-dom@19.3.1", "three@0.187.0", "@pixiv/three-vrm-core@3.5.5"),
)
"""Of tests in a browser."""
ESBUILD = ("main.js", "--bundle", "--minify", "--format=esm", "--outdir=dist/assets")
WORDS = {
    "vite": ("vite", "build"),
    "esbuild": ("esbuild", *ESBUILD),
    "webpack": (
        "webpack",
        "build",
        "--mode=production",
        "--entry=./main.js",
        "--output-path=dist/assets",
        "--no-performance",
    ),
    "parcel": ("parcel", "build", "index.html", "--dist-dir=dist", "--no-cache", "--no-source-maps"),
}
"""What each is told, none of which is about the package."""


def project(place: Path, package: Path, tools: tuple[str, ...] = PACKAGES) -> Path:
    """Make a project of the page in a folder, in which the shipped package is installed; gives it."""
    shutil.copytree(APP, place)
    (place / "package.json").write_text(json.dumps({"private": True, "type": "module"}), encoding="utf-8")
    modules = place / "node_modules"
    modules.mkdir()
    for found in installed(tools).iterdir():
        (modules / found.name).symlink_to(found)
    shutil.copytree(package, modules / "phoneme-ear")
    return place


def bundled(by: str, place: Path) -> tuple[Path, str]:
    """Have a bundler make the page ready for a web server; gives what it made, and its script there."""
    tool(place, *WORDS[by])
    made = place / "dist"
    (script,) = [path for path in made.rglob("*.js") if "OfflineAudioContext" in path.read_text(encoding="utf-8")]
    name = script.relative_to(made).as_posix()
    if not (made / "index.html").exists():
        (made / "index.html").write_text(f'<script type="module" src="/{name}"></script>', encoding="utf-8")
    return made, name


def tool(place: Path, name: str, *words: str) -> None:
    """Run a tool of the project; what it complains about is a failure, but for the size of the preset."""
    command = [str(place / "node_modules" / ".bin" / name), *words]
    done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = (done.stdout + done.stderr).lower().splitlines()
    assert [line for line in lines if "warn" in line and "size" not in line] == []


def installed(packages: tuple[str, ...]) -> Path:
    """Install packages, unless that has been done; one process at a time, all others wait for it."""
    node()
    npm = shutil.which("npm")
    if npm is None and "CI" not in os.environ:
        pytest.skip("there is no npm")
    assert npm, "there is no npm; install it"
    place = (
        Path(tempfile.gettempdir())
        / f"phonemeanalyser-bundlers-{getpass.getuser()}"
        / "-".join(packages).replace("/", "-")
    )
    place.mkdir(parents=True, exist_ok=True)
    with filelock.FileLock(place / "lock"):
        if not (place / "ready").exists():
            words = [npm, "install", "--prefix", str(place), "--no-audit", "--no-fund", "--prefer-offline", *packages]
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            if done.returncode and "CI" not in os.environ:
                pytest.skip(f"npm cannot fetch {', '.join(packages)}")
            assert done.returncode == 0, done.stderr
            (place / "ready").touch()
    return place / "node_modules"
