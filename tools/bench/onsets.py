"""Plays sounds that begin out of silence, and tells when each beginning was handed to the sound server.

`python -m tools.bench.onsets N` plays N of them on the default output, and prints for each a line of JSON: the time
by `time.monotonic`, and the phoneme that it is.
"""

import json
import sys
import threading
import time
from typing import Any

import numpy as np

from phonemeengine.audio.stream import CardStream
from phonemeengine.settings import SAMPLE_RATE
from tests.sounds import Sound, vowel

LENGTH = 0.2
"""Seconds of each sound."""
LEAST_GAP, MOST_GAP = 0.25, 0.55
"""Seconds of silence between two."""
SOUNDS = (vowel((280, 2250, 2900), LENGTH), vowel((730, 1090, 2440), LENGTH))
LABELS = ("i", "a")
"""What the default preset calls them, from their first frames on."""
LATENCY = 0.04
"""What is asked of the card, seconds."""
BEFORE = 0.5
"""Seconds of silence before the first."""


def sequence(n: int) -> tuple[Sound, list[int]]:
    """Give `n` onsets at irregular intervals as one sound, and their first samples."""
    gaps = np.random.default_rng(n).uniform(LEAST_GAP, MOST_GAP, n)
    parts, places, at = [np.zeros(round(BEFORE * SAMPLE_RATE), np.float32)], [], round(BEFORE * SAMPLE_RATE)
    for k, gap in enumerate(gaps):
        silent = np.zeros(round(gap * SAMPLE_RATE), np.float32)
        parts += [SOUNDS[k % len(SOUNDS)], silent]
        places.append(at)
        at += len(parts[-2]) + len(silent)
    return np.concatenate(parts), places


class Playing:
    """Fills the card's blocks, and notes when an onset was among what it gave."""

    def __init__(self, sound: Sound, places: list[int]) -> None:
        self.times: list[float] = []
        self.done = threading.Event()
        self._sound = sound
        self._places = places
        self._at = 0

    def fill(self, out: Any, n: int, _times: Any, _status: Any) -> None:
        """Fill the next block."""
        part = self._sound[self._at : self._at + n]
        out[:] = 0
        out[: len(part), 0] = part
        self._at += n
        if len(self.times) < len(self._places) and self._places[len(self.times)] < self._at:
            self.times.append(time.monotonic())
        if self._at >= len(self._sound):
            self.done.set()


def main() -> None:
    """Play, and print each time as it is known."""
    playing = Playing(*sequence(int(sys.argv[1])))
    stream = CardStream("output", None, SAMPLE_RATE, 1, LATENCY, playing.fill)
    n_said = 0
    while not playing.done.wait(0.1):
        for k in range(n_said, len(playing.times)):
            print(json.dumps([playing.times[k], LABELS[k % len(LABELS)]]), flush=True)
        n_said = len(playing.times)
    stream.close()


if __name__ == "__main__":
    main()
