"""What all tests share."""

import os
import signal
from pathlib import Path

import numpy as np
import pytest
import soundfile
from hypothesis import settings

from phonemeengine.encoder import model_folder
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.plug_ins import Shelf, install_example
from tests.fakes.whisper_model import write_whisper_model
from tests.sounds import noise, silence, vowel

# A shell's background jobs ignore Ctrl-C and the terminal's end, and so would the programs that tests start.
for number, handler in (("SIGINT", signal.default_int_handler), ("SIGHUP", signal.SIG_DFL)):
    if hasattr(signal, number) and signal.getsignal(signal.Signals[number]) is signal.SIG_IGN:
        signal.signal(signal.Signals[number], handler)

settings.register_profile("house", deadline=None)  # a busy machine is no failure
settings.load_profile("house")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers() -> int:
    """One worker more than there are cores: tests of sound cards mostly wait."""
    return (os.cpu_count() or 1) + 1


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


@pytest.fixture(scope="session")
def corpus() -> Path:
    """The labelled development corpus: 91 utterances of 8 speakers."""
    return CORPUS


@pytest.fixture(scope="session")
def example_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder into which the example of a plug-in is installed with pip."""
    return install_example(tmp_path_factory.mktemp("site"))


@pytest.fixture(autouse=True)
def _no_whisper(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever this machine has, tests find no model of the speech encoder but those that they make."""
    monkeypatch.delenv(model_folder.FOLDER_VARIABLE, raising=False)
    monkeypatch.setattr(model_folder, "data_folder", lambda: tmp_path_factory.getbasetemp() / "no data")
    monkeypatch.setattr(model_folder, "PACKAGES", ("no_such_package_1", "no_such_package_2"))


@pytest.fixture(scope="session")
def whisper_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a small model that the encoder's library runs."""
    return write_whisper_model(tmp_path_factory.mktemp("whisper"))


@pytest.fixture
def whisper(whisper_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Have the program find that model."""
    monkeypatch.setenv(model_folder.FOLDER_VARIABLE, str(whisper_folder))
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
