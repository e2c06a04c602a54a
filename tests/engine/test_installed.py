"""Installed as a package, the engine works without Qt, sound card and checkout, and has types."""

import os
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from importlib.metadata import Distribution, distribution
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from phonemeengine import load_preset
from tests.conftest import ROOT
from tests.corpora import write_corpus

GAME = """
import sys
from phonemeengine import Phoneme, SoundReader, Analyser, __version__, analyse_blocks, load_preset, recognise_window

with SoundReader(sys.argv[1]) as reader:
    analyses = list(analyse_blocks(reader.blocks(44_100), load_preset("learned")))
spoken = {int(code) for analysis in analyses for code in analysis.phonemes}
assert spoken > {Phoneme.SILENCE, Phoneme.A, Phoneme.SZ}, spoken
for missing in ("PySide6", "sounddevice", "pyqtgraph", "engine", "presets", "tests", "tools"):
    try:
        __import__(missing)
    except ImportError:
        continue
    raise AssertionError(f"{missing} is here")
from importlib.metadata import version
assert version("phonemeanalyser") == __version__
import phonemeanalyser
print(sys.modules["phonemeengine"].__file__)
"""

USER = """
from phonemeengine import Analyser, Listener, calibrate, load_preset, read_recordings, recognise_window, score

preset = load_preset("learned")
with Listener(preset) as listener:
    reveal_type(listener)
    reveal_type(listener.poll().phoneme)
reveal_type(Analyser(preset).push)
reveal_type(recognise_window([0.0] * 2048, preset).intensity)
reveal_type(calibrate(preset, read_recordings("takes")).preset)
reveal_type(score(preset, read_recordings("corpus")).overall.scores.macro_f1)
Analyser("learned")
"""
REVEALED = [
    "phonemeengine.live.listener.Listener",
    "phonemeengine.phonemes.Phoneme",
    "def (samples: numpy._typing._array_like",
    "float",
    "phonemeengine.presets.preset.Preset",
    "float",
]


def run(*words: object, folder: Path, code: int = 0) -> str:
    """Run a program away from the checkout, as a user does; what it prints before it ends with that code."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "MYPY"))}
    done = subprocess.run(
        [str(word) for word in words], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done.stdout


def build(target: str, out: Path, source: Path = ROOT) -> Path:
    """Build a wheel or a source distribution; its file."""
    done = subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(out)],
        cwd=source,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    (built,) = out.iterdir()
    return built


def requirements_of(wheel: Path) -> list[Distribution]:
    """The packages on this machine that a wheel needs, and those that they need, without extras."""
    with zipfile.ZipFile(wheel) as files:
        (metadata,) = (name for name in files.namelist() if name.endswith(".dist-info/METADATA"))
        lines = files.read(metadata).decode().splitlines()
    waiting = [line.removeprefix("Requires-Dist: ") for line in lines if line.startswith("Requires-Dist: ")]
    found: dict[str, Distribution] = {}
    while waiting:
        requirement = Requirement(waiting.pop())
        name = canonicalize_name(requirement.name)
        if name not in found and (requirement.marker is None or requirement.marker.evaluate({"extra": ""})):
            found[name] = distribution(name)
            assert requirement.specifier.contains(found[name].version, prereleases=True)
            waiting += found[name].requires or []
    return list(found.values())


def lend(source: Path, target: Path) -> None:
    """Have a file or folder appear elsewhere; it is copied where the system allows no links."""
    try:
        target.symlink_to(source)
    except OSError:
        (shutil.copytree if source.is_dir() else shutil.copy)(source, target)


def fresh_python(folder: Path, wheel: Path) -> Path:
    """Make an environment that has a wheel, and of this machine's packages what that needs; its Python."""
    venv.create(folder, symlinks=os.name != "nt")
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    site = Path(run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", folder=folder).strip())
    for package in requirements_of(wheel):
        for top in sorted(
            {file.parts[0] for file in package.files or () if file.parts[0] not in {"..", "__pycache__"}}
        ):
            lend(Path(str(package.locate_file(top))), site / top)
    pip = (sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--disable-pip-version-check")
    run(*pip, "--no-index", "--no-deps", wheel, folder=folder)
    return python


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build("wheel", tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return fresh_python(tmp_path_factory.mktemp("fresh"), wheel)


def names_in(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as files:
        return set(files.namelist())


def test_three_packages_are_installed_and_nothing_else(wheel: Path) -> None:
    names = names_in(wheel)
    assert {name.split("/")[0].split("-")[0] for name in names} == {
        "phonemeengine",
        "phonemetraining",
        "phonemeanalyser",
    }
    typed = {
        "phonemeengine/py.typed",
        "phonemeengine/__init__.pyi",
        "phonemetraining/py.typed",
        "phonemeanalyser/py.typed",
    }
    assert typed <= names
    shipped = {f"phonemeengine/presets/factory/{path.name}" for path in (ROOT / "presets").iterdir()}
    assert "phonemeengine/presets/factory/learned.npz" in shipped <= names
    sources = {
        path for path in (ROOT / "engine" / "phonemeengine" / "shipping").rglob("*.*") if path.suffix != ".pyc"
    }
    shipped = {path.relative_to(ROOT / "engine").as_posix() for path in sources if path.is_file()}
    assert "phonemeengine/shipping/web/ear.js" in shipped <= names


@pytest.mark.long
def test_a_wheel_from_the_source_distribution_is_the_same(wheel: Path, tmp_path: Path) -> None:
    with tarfile.open(build("sdist", tmp_path / "sdist")) as files:
        files.extractall(tmp_path, filter="data")
    (unpacked,) = tmp_path.glob("phonemeanalyser-*")
    assert names_in(build("wheel", tmp_path / "again", unpacked)) == names_in(wheel)


def test_a_game_recognises_with_what_is_installed(installed: Path, tmp_path: Path) -> None:
    home = run(installed, "-c", GAME, ROOT / "phonemeanalyser" / "demo" / "demo.flac", folder=tmp_path)
    assert installed.parents[1] in Path(home.strip()).parents


def test_what_is_installed_writes_the_page_of_a_report(installed: Path, tmp_path: Path) -> None:
    write_corpus(tmp_path, load_preset("thesis"), ["c/s"])
    run(installed, "-m", "phonemeanalyser", "score", tmp_path, "-o", "report.html", folder=tmp_path)
    assert (tmp_path / "report.html").read_text().endswith("</html>\n")


@pytest.mark.long  # as `make test` installs the checkout for all tests
def test_a_checkout_that_is_installed_for_editing_finds_the_presets(tmp_path: Path) -> None:
    python = fresh_python(tmp_path / "fresh", build("wheel:editable", tmp_path / "built"))
    program = "import phonemeanalyser, phonemeengine as e; print(e.__file__, e.load_preset('learned').name)"
    assert run(python, "-c", program, folder=tmp_path).split() == [
        str(ROOT / "engine" / "phonemeengine" / "__init__.py"),
        "Learned",
    ]


@pytest.mark.long
def test_a_user_s_type_checker_sees_the_types(installed: Path, tmp_path: Path) -> None:
    (tmp_path / "user.py").write_text(USER)
    mypy = (sys.executable, "-m", "mypy", "--strict", "--python-executable", installed, "user.py")
    said = run(*mypy, folder=tmp_path, code=1)
    seen = [line.split('Revealed type is "')[1] for line in said.splitlines() if "Revealed type" in line]
    assert len(seen) == len(REVEALED), said
    assert [full.startswith(wanted) for full, wanted in zip(seen, REVEALED, strict=True)] == [True] * len(seen), seen
    assert 'Argument 1 to "Analyser" has incompatible type "str"; expected "Preset"' in said
    assert "Found 1 error in 1 file" in said, said
