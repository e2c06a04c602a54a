"""What all tests share."""

import signal
from pathlib import Path

import pytest
from hypothesis import settings

from tests.plug_ins import Shelf, install_example

# A shell's background jobs ignore Ctrl-C and the terminal's end, and so would the programs that tests start.
for number, handler in (("SIGINT", signal.default_int_handler), ("SIGHUP", signal.SIG_DFL)):
    if hasattr(signal, number) and signal.getsignal(signal.Signals[number]) is signal.SIG_IGN:
        signal.signal(signal.Signals[number], handler)

settings.register_profile("house", deadline=None)  # a busy machine is no failure
settings.load_profile("house")

ROOT = Path(__file__).resolve().parents[1]
CORPUS = ROOT.parent / "shared" / "corpus"


@pytest.fixture(scope="session")
def corpus() -> Path:
    """The labelled development corpus, which only the founders' machines have."""
    if not (CORPUS / "manifest.csv").exists():
        pytest.skip("the development corpus is not on this machine")
    return CORPUS


@pytest.fixture(scope="session")
def example_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder into which the example of a plug-in is installed with pip."""
    return install_example(tmp_path_factory.mktemp("site"))


@pytest.fixture
def shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Shelf:
    """Where a test puts packages that Python shall find."""
    return Shelf(tmp_path, monkeypatch)


@pytest.fixture
def loudness(example_site: Path, shelf: Shelf) -> Path:
    """The example of a plug-in, found by this process; the folder where it is installed."""
    shelf.use(example_site, "phonemeanalyser_loudness")
    return example_site
