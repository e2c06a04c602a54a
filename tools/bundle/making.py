"""How the program without Python is made.

The wheel of this checkout goes into a fresh environment, PyInstaller makes a folder of that, and the folder becomes
one archive: .tar.xz on Linux, .zip elsewhere. On Windows, ``installer.iss`` makes an installer of it.
"""

import os
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
EXTRAS = "desktop,preview,server,speech"
DESKTOP_FILES = ("phonemeanalyser.desktop", "phonemeanalyser-mime.xml", "integrate.sh")
"""What tells a Linux desktop of the program, once ``integrate.sh`` was run."""


def make_bundle(out: Path) -> tuple[Path, Path]:
    """Make the program into a folder; returns the program's own folder, and the archive of it."""
    out.mkdir(parents=True, exist_ok=True)
    python = _environment(out)
    version = _answer(python, "-c", "import phonemeengine; print(phonemeengine.__version__)")
    folder = _program(python, out, version)
    return folder, pack(folder, out / f"PhonemeAnalyser-{version}-{_system()}", int(_commit_time()))


def _environment(out: Path) -> Path:
    """Make an environment that holds what users install, and PyInstaller; returns its Python."""
    folder = out / "environment"
    venv.create(folder, with_pip=True, clear=True)
    python = folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    install = [
        python,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "-c",
        ROOT / "constraints.txt",
    ]
    subprocess.run([*install, f"{ROOT}[{EXTRAS}]", "pyinstaller"], check=True)
    return python


def _program(python: Path, out: Path, version: str) -> Path:
    """Have PyInstaller make the folder of the program; returns it."""
    icon = out / "phonemeanalyser.png"
    write_icon(icon)
    settings = {
        "BUNDLE_ICON": str(icon),
        "BUNDLE_VERSION": version,
        "PYTHONPATH": "",  # nothing but what is installed there
        "PYTHONHASHSEED": "1",  # so that two builds have the same bytes
        "SOURCE_DATE_EPOCH": _commit_time(),
    }
    subprocess.run(
        [
            python,
            "-m",
            "PyInstaller",
            "--noconfirm",
            "--log-level",
            "WARN",
            "--distpath",
            out,
            "--workpath",
            out / "work",
            HERE / "phonemeanalyser.spec",
        ],
        check=True,
        cwd=out,
        env={**os.environ, **settings},
    )
    folder = out / "PhonemeAnalyser"
    if sys.platform == "darwin":
        return out / "PhonemeAnalyser.app"
    if sys.platform == "linux":
        for name in DESKTOP_FILES:
            shutil.copy2(HERE / name, folder)
        shutil.copy2(icon, folder)
    return folder


def pack(folder: Path, name: Path, epoch: int) -> Path:
    """Pack the folder, its files in order and all with the same time; returns the archive."""
    files = sorted(folder.rglob("*"))
    if sys.platform == "linux":
        archive = name.with_name(f"{name.name}.tar.xz")
        with tarfile.open(archive, "w:xz") as packed:
            for file in files:
                member = packed.gettarinfo(file, str(file.relative_to(folder.parent)))
                member.mtime, member.uid, member.gid, member.uname, member.gname = epoch, 0, 0, "", ""
                if member.isreg():
                    with file.open("rb") as content:
                        packed.addfile(member, content)
                else:
                    packed.addfile(member)
        return archive
    archive = name.with_name(f"{name.name}.zip")
    if sys.platform == "darwin":  # links and rights of an .app outlive only its own tool
        subprocess.run(["ditto", "-c", "-k", "--keepParent", folder, archive], check=True)
        return archive
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for file in files:
            packed.write(file, file.relative_to(folder.parent))
    return archive


def _commit_time() -> str:
    """Return when the last commit was made, in seconds since 1970."""
    return _answer("git", "-C", ROOT, "log", "-1", "--format=%ct")


def _answer(*command: str | Path) -> str:
    """Return what a command prints."""
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def _system() -> str:
    system = {"linux": "linux", "win32": "windows", "darwin": "macos"}[sys.platform]
    return f"{system}-{os.uname().machine if hasattr(os, 'uname') else 'x86_64'}"


SIZE = 512


def write_icon(out: Path) -> None:
    """Write the icon as a PNG of `SIZE` x `SIZE` pixels."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from PySide6.QtGui import QGuiApplication, QIcon

    from phonemeanalyser.desktop.app import ICON

    app = QGuiApplication.instance() or QGuiApplication([])
    assert QIcon(str(ICON)).pixmap(SIZE, SIZE).save(str(out)), out
    del app
