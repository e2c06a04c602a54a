"""Listens to the microphone and records it until SIGTERM; prints how it goes, and at the end what it heard."""

import json
import signal
import sys
import time
from pathlib import Path

from phonemeengine.audio.stream import InputChoice
from phonemeengine.live.listener import Listener
from phonemeengine.live.recorder import Recorder
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tests.waiting import let_pass

ending: list[int] = []
signal.signal(signal.SIGTERM, lambda number, _frame: ending.append(number))
tape = Recorder(lambda: Path(sys.argv[1]))
listener = Listener(load_preset(DEFAULT_PRESET), InputChoice(rate=int(sys.argv[2])), recorder=tape)
frames: list[tuple[int, list[int]]] = []
while not ending:
    status = listener.status
    frames += [(block.start, block.phonemes.tolist()) for block in listener.take_analyses()]
    print(
        json.dumps(
            {
                "time": time.monotonic(),
                "listening": status.listening,
                "words": status.words,
                "rate": listener.rate,
                "seconds": listener.seconds,
                "lost": listener.lost_seconds,
                "failure": tape.failure,
            }
        ),
        flush=True,
    )
    let_pass(0.02)
lost = listener.lost_seconds
listener.close()
frames += [(block.start, block.phonemes.tolist()) for block in listener.take_analyses()]
tape.close()
print(json.dumps({"frames": frames, "dropped": listener.n_dropped, "lost": lost}), flush=True)
