"""The real-time model: how soon after a microphone is opened its first answer comes, and what memory it takes."""

import json
import threading
import time

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.stream import InputChoice
from phonemeengine.live.listener import Listener
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.presets.model_choice import has_model, with_real_time_model, with_small_network
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import HOP, SAMPLE_RATE, ModelKind
from tools.bench.figures import Absolute, Figure, answer_of, speech
from tools.bench.memory import resident_megabytes

FIRST_WITHIN, MOST_MB = 0.3, 150
"""Seconds to the first answer, and memory beyond that of the small network."""
SECONDS = 2.0
"""How long each listens before its memory is measured."""


def figures() -> list[Figure]:
    """Measure in a process of its own."""
    if not has_model(load_preset(DEFAULT_PRESET), ModelKind.ENCODER):
        print("  left out: the real-time model, which is not there")
        return []
    answer = answer_of("real_time")
    first, above = answer["first"], answer["above"]
    loaded = f"loaded before, in {answer['loading']:.2f} s"
    return [
        Figure(
            "real-time model, from opening a microphone to the first answer",
            f"{1000 * first:.0f} ms",
            f"{1000 * FIRST_WITHIN:.0f} ms; {loaded}",
            first / FIRST_WITHIN,
            1.0,
            absolute=Absolute.TIME,
        ),
        Figure("its memory", f"{above:.0f} MB", f"{MOST_MB} MB", above / MOST_MB, 1.0),
    ]


class PacedSpeech:
    """A microphone into which the demo sounds from the moment it is made, in blocks of 10 ms."""

    name, rate, n_channels = "the demo", SAMPLE_RATE, 1
    lost, quiet, delay, n_lost = False, 0.0, 0.0, 0

    def __init__(self) -> None:
        self._sound = speech(30.0).reshape(-1, 1)
        self._n_read = 0
        self.began = time.monotonic()

    def read(self, timeout: float) -> Float32Array:
        """Return the next block when its last sample has sounded; nothing where that takes too long."""
        missing = self.time_of(self._n_read + HOP) - time.monotonic()
        time.sleep(min(max(missing, 0.0), timeout))
        if missing > timeout:
            return self._sound[:0]
        self._n_read += HOP
        return self._sound[self._n_read - HOP : self._n_read]

    def time_of(self, sample: float) -> float:
        """Return when a sample sounds, on the clock of `time.monotonic`."""
        return self.began + sample / SAMPLE_RATE

    def close(self) -> None:
        """Let go of nothing."""


class SpeechListener(Listener):
    """Listens to the demo, and knows when that began."""

    began = 0.0

    def _open_input(self, choice: InputChoice) -> PacedSpeech:
        source = PacedSpeech()
        self.began = source.began
        return source


def main() -> None:
    """Listen with the small network, then with the real-time model, and print what was measured as JSON."""
    preset = load_preset(DEFAULT_PRESET)
    first_answer(with_small_network(preset))
    before, began = resident_megabytes(), time.monotonic()
    live = with_real_time_model(preset)
    loading = time.monotonic() - began
    first = first_answer(live)
    print(json.dumps({"first": first, "loading": loading, "above": resident_megabytes() - before}))


def first_answer(preset: Preset) -> float:
    """Listen for a while, and return the seconds from the opening of the microphone to the first answer."""
    answered: list[float] = []
    known = threading.Event()

    def note(_analysis: object) -> None:
        answered.append(time.monotonic())
        if answered[-1] - answered[0] > SECONDS:
            known.set()

    with SpeechListener(preset, on_analysis=note) as listener:
        if not known.wait(30.0):
            raise RuntimeError("no answers came")
        return answered[0] - listener.began


if __name__ == "__main__":
    main()
