"""A server that all tests of this room may ask, and what is said in their recordings."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import soundfile

from phonemeanalyser.server.access import ServerLimits
from phonemeanalyser.server.repertoire import Repertoire
from phonemeanalyser.server.service import ServerSettings
from phonemeengine.presets.files import DEFAULT_PRESET
from tests.conftest import CORPUS
from tests.server.servers import served
from tests.sounds import Sound

RECORDING = CORPUS / "espeak_de" / "de" / "de_00.flac"
TEXT = "Meine Mama mag Musik, und mein Papa backt am Samstag Pizza."
FAST = ServerLimits(max_speed=1000)
"""Tests do not wait for a sound to be over."""
REPERTOIRE = Repertoire.of_files([DEFAULT_PRESET], [], FAST)
"""What a server offers that is told no more."""


@pytest.fixture(scope="session")
def server() -> Iterator[str]:
    """The address of a server with the default preset."""
    with served(ServerSettings(port=0, limits=FAST)) as address:
        yield address


@pytest.fixture(scope="session")
def recording() -> Sound:
    """A recording of the corpus, float32 at 44.1 kHz."""
    samples, rate = soundfile.read(RECORDING, dtype="float32")
    assert rate == 44_100
    return np.asarray(samples, np.float32)


@pytest.fixture
def token_file(tmp_path: Path) -> Path:
    path = tmp_path / "token.txt"
    path.write_text("0123456789abcdef-secret\n")
    path.chmod(0o600)
    return path
