"""What the tests of the player share."""

from collections.abc import Iterator
from pathlib import Path

import pytest
import soundfile

from engine.settings import SAMPLE_RATE
from tests.players import SPEECH, Rig


@pytest.fixture
def path(tmp_path: Path) -> Path:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "speech.wav"


@pytest.fixture
def rig(path: Path) -> Iterator[Rig]:
    rig = Rig(path)
    yield rig
    rig.player.close()
