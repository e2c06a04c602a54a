"""Starts and stops a listener many times; prints after each what the process holds: memory, threads, open files."""

import json
import sys
import threading
import time
from pathlib import Path

from phonemeengine.live.listener import Listener
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tests.waiting import let_pass

preset = load_preset(DEFAULT_PRESET)
for _ in range(int(sys.argv[1])):
    deadline = time.monotonic() + 120
    listener = Listener(preset)
    while not listener.status.listening and time.monotonic() < deadline:
        let_pass(0.002)
    heard = listener.status.listening
    listener.close()
    held = dict(line.split(":", 1) for line in Path("/proc/self/status").read_text().splitlines())
    print(
        json.dumps(
            {
                "heard": heard,
                "memory_kb": int(held["VmRSS"].split()[0]),
                "threads": int(held["Threads"]),
                "python_threads": threading.active_count(),
                "files": len(list(Path("/proc/self/fd").iterdir())),
            }
        ),
        flush=True,
    )
