"""How soon things happen on a virtual sound card: polling, playing, and a sound server that dies and comes back."""

import json
import shutil
import tempfile
import time
from pathlib import Path

import numpy as np

from tests.devices.programs import HERE, Program, listener, pcm_noise, recorder, seconds_of
from tests.devices.test_server_trouble import away, back
from tests.fakes.virtual_sound import VirtualSound
from tools.bench.figures import DEMO, Absolute, Figure

SECONDS = 3.0
"""Of noise that is played."""
POLL, LAG, LATE, SEEN, BACK, LACKING = 0.5e-3, 0.05, 0.015, 1.0, 3.0, 1.0
"""What each may take, seconds."""


def figures() -> list[Figure]:
    """Measure with sound servers of their own."""
    if shutil.which("pulseaudio") is None:
        print("  left out: it needs a sound server of its own, PulseAudio")
        return []
    with tempfile.TemporaryDirectory() as folder, VirtualSound() as card:
        pcm_noise(Path(folder) / "noise.wav", SECONDS)
        return [*_polled(Path(folder), card), *_played(Path(folder), card), *_troubled(Path(folder), card)]


def _polled(folder: Path, card: VirtualSound) -> list[Figure]:
    game = Program(folder, card, HERE / "poll_sound.py", DEMO)
    game.end(None)
    return [_figure("a poll", float(np.median(game.log[0]["waits"])), POLL)]


def _played(folder: Path, card: VirtualSound) -> list[Figure]:
    player = Program(folder, card, HERE / "play_on_card.py", folder / "noise.wav")
    player.end(None)
    seen = json.loads(player.out[-1])
    times, positions = np.array(seen["seen"]).T
    moving = (positions > 0.2) & (positions < SECONDS - 0.2)
    return [
        _figure("position while playing, unevenness", float(np.ptp((times - positions)[moving])), LAG),
        _figure("a frame after its middle was heard", float(np.median(seen["late"])), LATE),
    ]


def _troubled(folder: Path, card: VirtualSound) -> list[Figure]:
    lacking = _lacking(folder, card)
    program = listener(folder, card, folder / "take.wav")
    card.kill()
    seen = away(program, time.monotonic())
    card.restart()
    again = back(program, time.monotonic())
    program.end()
    return [
        _figure("lost by a recording that is killed", lacking, LACKING),
        _figure("a server that died is told", seen, SEEN),
        _figure("heard again after its restart", again, BACK),
    ]


def _lacking(folder: Path, card: VirtualSound) -> float:
    """Kill a recording, and give how much it lacks of the time that it ran."""
    take = folder / "killed.wav"
    program = recorder(folder, card, take)
    program.wait_for(lambda: seconds_of(take) > 0)
    began, first = time.monotonic(), seconds_of(take)
    time.sleep(SECONDS)
    program.process.kill()
    ran = time.monotonic() - began
    program.end(None)
    return ran - (seconds_of(take) - first)


def _figure(name: str, seconds: float, limit: float) -> Figure:
    return Figure(
        name, f"{1000 * seconds:.2f} ms", f"{1000 * limit:g} ms", seconds / limit, 1.0, absolute=Absolute.TIME
    )
