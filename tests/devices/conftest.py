"""What the tests in this folder share: virtual sound cards, and a minute that is recorded beside them."""

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.devices.programs import PATIENCE, SETTLED, pcm_noise, recorder
from tests.fakes.virtual_sound import VirtualSound
from tests.waiting import let_pass

MINUTE = 60.0


class Minute:
    """A minute of noise, recorded by two programs at the same time: as WAV and as FLAC."""

    def __init__(self, folder: Path) -> None:
        self.pcm = pcm_noise(folder / "noise.wav", MINUTE)
        self.takes = [folder / "take.wav", folder / "take.flac"]
        with VirtualSound() as card:
            self._programs = [recorder(folder, card, take) for take in self.takes]
            card.play_into_microphone(folder / "noise.wav").wait(MINUTE + PATIENCE)
            let_pass(SETTLED)
            self.codes = [program.end() for program in self._programs]
        self.said = [program.errors[-1] for program in self._programs]


@pytest.fixture(scope="session")
def minute(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Future[Minute]]:
    """A minute's recording on a card of its own; it begins here, and other tests do their work meanwhile."""
    with ThreadPoolExecutor(1) as thread:
        yield thread.submit(Minute, tmp_path_factory.mktemp("minute"))


@pytest.fixture
def card() -> Iterator[VirtualSound]:
    """A running virtual sound card of 44.1 kHz, for one test alone."""
    with VirtualSound() as sound:
        yield sound


@pytest.fixture
def takes(tmp_path: Path) -> Path:
    """A folder for recordings."""
    folder = tmp_path / "takes"
    folder.mkdir()
    return folder
