"""What the tests of the player and of the listener share."""

from collections.abc import Iterator
from pathlib import Path

import pytest
import soundfile

from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.microphones import HandDrivenMicrophone, Hear, Hearing
from tests.fakes.players import SPEECH, Rig


@pytest.fixture
def path(tmp_path: Path) -> Path:
    soundfile.write(tmp_path / "speech.wav", SPEECH, SAMPLE_RATE, subtype="FLOAT")
    return tmp_path / "speech.wav"


@pytest.fixture
def rig(path: Path) -> Iterator[Rig]:
    rig = Rig(path)
    yield rig
    rig.player.close()


@pytest.fixture
def hear() -> Iterator[Hear]:
    made: list[Hearing] = []

    def make(*microphones: HandDrivenMicrophone | None, **options: object) -> Hearing:
        made.append(Hearing(*microphones, **options))
        return made[-1]

    yield make
    for hearing in made:
        hearing.openers.may_answer.set()
        hearing.listener.close()
