"""What all tests share."""

import gc
import os
import shutil
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

from tests.homes import environment_of, home_of_this_run

os.environ |= home_of_this_run()  # before anything looks for what the user keeps
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")  # tests need no display
os.environ.setdefault("OMP_NUM_THREADS", "1")  # where others work too, threads of PyTorch wait for each other busily
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # else each worker, and each program that tests start, compiles all

import numpy as np
import pytest
import soundfile
from hypothesis import settings

from phonemeengine.audio import stream
from phonemeengine.encoder.model_folder import FOLDER_VARIABLE, PACKAGES
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.plug_ins import Shelf, install_example
from tests.fakes.portaudio import FakePortAudio
from tests.fakes.whisper_model import write_whisper_model
from tests.sounds import noise, silence, vowel
from tests.waiting import Clock

sys.dont_write_bytecode = False  # of this process itself

# A shell's background jobs ignore Ctrl-C and the terminal's end, and so would the programs that tests start.
for number, handler in (("SIGINT", signal.default_int_handler), ("SIGHUP", signal.SIG_DFL)):
    if hasattr(signal, number) and signal.getsignal(signal.Signals[number]) is signal.SIG_IGN:
        signal.signal(signal.Signals[number], handler)

settings.register_profile("project", deadline=None, max_examples=40)  # a busy machine is no failure
settings.load_profile("project")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """One worker more than there are cores: tests of sound cards mostly wait."""
    return (os.cpu_count() or 1) + 1


def pytest_unconfigure() -> None:
    """Remove the home of this run; in a worker it is not this process's."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        shutil.rmtree(os.environ["HOME"], ignore_errors=True)


gc.disable()  # while tests are collected, all of which stay


def pytest_collection_finish() -> None:
    """Have no later collection of garbage look through modules and tests, which stay: it takes half a second."""
    gc.collect()
    gc.freeze()
    gc.enable()


collect_ignore = ["blender"]  # those run in Blender, by `make test-blender`
ROOT = Path(__file__).resolve().parents[1]
CORPUS = ROOT / "tests" / "data" / "corpus"
SCORER = ROOT / "tests" / "reference" / "score.py"
"""Scores a corpus as a program of its own, which shares no line with the engine."""

SPEECH = np.concatenate(
    (
        silence(0.1),
        vowel((700, 1200, 2500), 0.25),
        noise(0.15, 0.2),
        vowel((310, 800, 2300), 0.25, f0=210),
        silence(0.1013),
    )
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let long tests take what they take; those of sound cards come first, since they wait while others compute."""
    items.sort(key=lambda item: "devices" not in item.path.parts)
    for item in items:
        if item.get_closest_marker("long"):
            item.add_marker(pytest.mark.timeout(0))


@pytest.fixture(scope="session")
def corpus() -> Path:
    """The labelled development corpus: 91 utterances of 8 speakers."""
    return CORPUS


@pytest.fixture(scope="session")
def example_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder into which the example of a plug-in is installed with pip."""
    return install_example(tmp_path_factory.mktemp("site"))


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A home for one test, in which the program looks for Whisper's model, without the packages that bring it."""
    for name, value in environment_of(tmp_path / "home").items():
        monkeypatch.setenv(name, value)
    monkeypatch.delenv(FOLDER_VARIABLE)
    for package in PACKAGES:
        monkeypatch.setitem(sys.modules, package, None)
    return tmp_path / "home"


@pytest.fixture(scope="session")
def whisper_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a small model that the encoder's library runs."""
    return write_whisper_model(tmp_path_factory.mktemp("whisper"))


@pytest.fixture
def whisper(whisper_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Have the program find that model."""
    monkeypatch.setenv(FOLDER_VARIABLE, str(whisper_folder))
    return whisper_folder


@pytest.fixture
def shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Shelf:
    """Where a test puts packages that Python shall find."""
    return Shelf(tmp_path, monkeypatch)


@pytest.fixture
def loudness(example_site: Path, shelf: Shelf) -> Path:
    """The example of a plug-in, found by this process; the folder where it is installed."""
    shelf.use(example_site, "phonemeanalyser_loudness")
    return example_site


@pytest.fixture
def brightness(example_site: Path, shelf: Shelf) -> Path:
    """The example of a plug-in that learns, found by this process; the folder where it is installed."""
    shelf.use(example_site, "phonemeanalyser_brightness")
    return example_site


@pytest.fixture
def clock() -> Clock:
    """A clock that the test moves."""
    return Clock()


@pytest.fixture
def portaudio(monkeypatch: pytest.MonkeyPatch) -> Iterator[FakePortAudio]:
    """The sound system, with devices that the test plugs in."""
    fake = FakePortAudio()
    monkeypatch.setitem(sys.modules, "sounddevice", fake)
    yield fake
    for opened in tuple(stream._open):
        opened.close()


@pytest.fixture
def no_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine without OpenGL: the package that opens one finds no library."""

    def refuse(**_options: object) -> None:
        raise ImportError("libEGL.so.1 not loaded\nand more")

    door = SimpleNamespace(default_backend=lambda: refuse, get_backend_by_name=lambda _name: refuse)
    monkeypatch.setitem(sys.modules, "glcontext", door)


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    """Speech-like sound of 0.85 s in a file."""
    path = tmp_path / "speech.wav"
    soundfile.write(path, SPEECH, SAMPLE_RATE, subtype="FLOAT")
    return path


@pytest.fixture
def stereo(tmp_path: Path) -> Path:
    """The same on the left, and silence on the right."""
    path = tmp_path / "stereo.wav"
    soundfile.write(path, np.stack((SPEECH, 0 * SPEECH), axis=1), SAMPLE_RATE, subtype="FLOAT")
    return path
