"""The example that polls a microphone, on a virtual one."""

import re
import subprocess
from pathlib import Path

import pytest
import soundfile

from tests.conftest import ROOT
from tests.devices.programs import PATIENCE, Program
from tests.fakes.virtual_sound import VirtualSound

POLL = ROOT / "examples" / "poll_microphone.py"
DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"


@pytest.mark.long
def test_what_is_said_into_the_microphone_is_printed(card: VirtualSound, tmp_path: Path) -> None:
    speech, rate = soundfile.read(DEMO)
    soundfile.write(tmp_path / "speech.wav", speech, rate)
    program = Program(tmp_path, card, POLL, PATIENCE)
    program.wait_for(lambda: program.out)
    playing: subprocess.Popen[bytes] = card.play_into_microphone(tmp_path / "speech.wav")
    program.wait_for(lambda: {"silence", "sz", "a", "u"} <= {line.split()[0] for line in program.out})
    playing.wait(PATIENCE)
    program.end()
    assert any(line.count("#") > 10 for line in program.out)


def test_it_ends_after_its_time_and_says_how_it_went(card: VirtualSound, tmp_path: Path) -> None:
    program = Program(tmp_path, card, POLL, 2)
    assert program.end(None) == 0
    assert re.search(r"; \d+\.\d\d s were lost$", program.out[-1])
