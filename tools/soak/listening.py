"""Listens to the microphone and records it, and prints how it goes each second, as JSON: run by the soak.

`python -m tools.soak.listening FOLDER SECONDS`
"""

import json
import resource
import sys
import time
from pathlib import Path

import numpy as np

from phonemeengine.analyser import Analysis
from phonemeengine.live.listener import Listener
from phonemeengine.live.recorder import Recorder
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset

TICK = 1 / 60
"""Seconds between two looks at what has arrived, as a window has it."""


class Watch:
    """Sees to it that the frames follow each other, and remembers how old they were when they were known."""

    def __init__(self, most: int) -> None:
        self.listener: Listener | None = None
        self.n_frames = self.n_missing = self._n_aged = 0
        self._ages = np.full(most, np.nan, np.float32)  # written to now, so that the memory is not taken later

    def age(self, analysis: Analysis) -> None:
        """Note the age of a block's newest frame; called as soon as it is known."""
        if self.listener is not None and self._n_aged < len(self._ages):
            self._ages[self._n_aged] = self.listener.age_of(analysis.start + len(analysis) - 1)
            self._n_aged += 1

    def count(self, blocks: list[Analysis]) -> None:
        """Count the frames that were taken, and those that are missing between them."""
        for block in blocks:
            self.n_missing += abs(block.start - self.n_frames)
            self.n_frames = block.start + len(block)

    @property
    def ages(self) -> tuple[float, float]:
        """Median and 99th percentile of the ages, seconds."""
        median, late = np.percentile(self._ages[: self._n_aged], (50, 99))
        return float(median), float(late)


def main() -> None:
    """Listen."""
    folder, seconds = Path(sys.argv[1]), float(sys.argv[2])
    tape = Recorder(folder / "soak.wav", with_phonemes=True)
    tape.journal, tape.rescue = folder / "journal", folder / "rescue"
    watch = Watch(round(110 * seconds))
    watch.listener = listener = Listener(
        load_preset(DEFAULT_PRESET), pitch=True, recorder=tape, on_analysis=watch.age
    )
    _attend(listener, watch, seconds)
    listener.close()
    tape.close()
    watch.count(listener.take_analyses())
    _say(_state_of(listener, watch) | {"recorded": tape.seconds, "failure": tape.failure, "ages": watch.ages})


def _attend(listener: Listener, watch: Watch, seconds: float) -> None:
    began = said = time.monotonic()
    while (now := time.monotonic()) - began < seconds:
        watch.count(listener.take_analyses())
        listener.poll()
        if now - said >= 1:
            said += 1
            _say(_state_of(listener, watch))
        time.sleep(TICK)


def _state_of(listener: Listener, watch: Watch) -> dict[str, object]:
    heard, now = listener.seconds, time.monotonic()
    return {
        "clock": now,
        "heard": heard,
        "megabytes": int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 1e6,
        "threads": len(list(Path("/proc/self/task").iterdir())),
        "files": len(list(Path("/proc/self/fd").iterdir())),
        "processor": time.process_time(),
        "latency": listener.latency.total,
        "lost": listener.lost_seconds,
        "dropped": listener.n_dropped,
        "frames": watch.n_frames,
        "missing": watch.n_missing,
    }


def _say(state: dict[str, object]) -> None:
    print(json.dumps(state), flush=True)


if __name__ == "__main__":
    main()
