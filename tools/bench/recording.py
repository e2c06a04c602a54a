"""The whole window at 60 frames a second while it records speech from a microphone."""

import json
import shutil
import tempfile
import time
from pathlib import Path

from tests.fakes.virtual_sound import VirtualSound
from tools.bench.desktop import live_for, shown_desktop, written_speech
from tools.bench.figures import Absolute, Figure, answer_of
from tools.bench.playing import Painted

WARM_UP, MEASURED = 3.0, 20.0
"""Seconds."""
STARTING = 15.0
"""Seconds of speech beyond that, since the window takes some time to open."""
LIMIT = 0.35
"""Most share of one core."""


def figures() -> list[Figure]:
    """Measure in a process of its own, with a sound server of its own."""
    if shutil.which("pulseaudio") is None:
        print("  left out: it needs a sound server of its own, PulseAudio")
        return []
    with tempfile.TemporaryDirectory() as folder, VirtualSound() as card:
        player = card.play_into_microphone(written_speech(Path(folder), STARTING + WARM_UP + MEASURED))
        answer = answer_of("recording", card.environment)
        player.kill()
        player.wait(5)
    share, n_lost = answer["share"], answer["lost"] + answer["dropped"]
    measured = f"{share:.1%} of a core, {answer['pictures']:.0f} fps"
    lost = f"{answer['lost']:g} s of sound, {answer['dropped']} frames"
    return [
        Figure("window recording at 60 fps", measured, "one busy core", share, LIMIT, absolute=Absolute.WORK),
        Figure("lost while recording", lost, "none", float(n_lost), limit=0.0),
    ]


def main() -> None:
    """Record, and print what it took as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        desktop = shown_desktop(Path(folder))
        session, painted = desktop.session, Painted()
        session.toggle_recording()
        live_for(WARM_UP)
        desktop.window.analysis.spectrum.graphics.viewport().installEventFilter(painted)
        n_before, recorded = session.history.n, session.microphone.recorded_seconds
        wall, processor = time.perf_counter(), time.process_time()
        live_for(MEASURED)
        processor, wall = time.process_time() - processor, time.perf_counter() - wall
        recorded = session.microphone.recorded_seconds - recorded
        assert recorded > 0.9 * MEASURED, f"only {recorded:.1f} s were recorded"
        assert session.history.n - n_before > 90 * MEASURED, "frames are missing"
        cost = {
            "share": processor / wall,
            "pictures": painted.n / wall,
            "lost": session.microphone.listener.lost_seconds,
            "dropped": session.microphone.listener.n_dropped,
        }
        desktop.close()
    print(json.dumps(cost))


if __name__ == "__main__":
    main()
