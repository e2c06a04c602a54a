"""The latency measured by clicks that are played and heard."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from phonemeengine.live.loopback import EVERY
from tests.fakes.virtual_sound import VirtualSound

DRIVER = Path(__file__).with_name("measure_loopback.py")


def measured(sound: VirtualSound) -> Any:
    done = subprocess.run(
        [sys.executable, str(DRIVER)], env=sound.environment, capture_output=True, text=True, timeout=240, check=True
    )
    return json.loads(done.stdout)


def test_clicks_from_the_loudspeaker_are_heard_and_timed() -> None:
    with VirtualSound(loopback=True) as sound:
        found = measured(sound)
    assert 4 <= found["n_detected"] <= found["n_played"] == 8
    assert 0.005 < found["round_trip"] < EVERY
    assert 0 <= found["capture"] < found["round_trip"]


def test_a_microphone_that_hears_no_clicks_is_told_in_one_sentence() -> None:
    with VirtualSound() as sound:
        found = measured(sound)
    assert found == "only 0 of 8 clicks were recorded; turn the loudspeaker up, or move the microphone"
