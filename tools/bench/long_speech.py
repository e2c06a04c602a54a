"""Ten minutes of speech on a virtual sound card: how far the mouth's time strays from what is playing."""

import json
import shutil
import subprocess
import threading
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import count

import numpy as np
from scipy.signal import correlate

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.live.player import Player
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from phonemeengine.settings import SAMPLE_RATE
from phonemeengine.speech.spooled import SpooledSpeech
from phonemeengine.speech.voice import SpokenSentence, Voice
from tests.fakes.virtual_sound import VirtualSound
from tools.bench.figures import Absolute, Figure, answer_of

MINUTES = 10
HALF_A_MINUTE = 30.0
WARM_UP = 5.0
"""Seconds that are not looked at."""
LOOK = 0.005
DRIFT = 0.01
"""Seconds by which the medians of the first and the last half minute may differ."""
PROBE, REACH = 1.0, 0.5
"""Seconds of speech that are found again, and how far from where they should be."""
CHUNK = 441
"""Samples that are recorded at once."""
RECORDER = ("parec", "--raw", "--format=s16le", f"--rate={SAMPLE_RATE}", "--channels=1", "--latency-msec=20")


def figures() -> list[Figure]:
    """Measure in a process of its own, on a virtual sound card."""
    if shutil.which("pulseaudio") is None:
        print("  left out: it needs a sound server of its own, PulseAudio")
        return []
    with VirtualSound() as card:
        answer = answer_of("long_speech", card.environment)
    drift = abs(answer["last"] - answer["first"])
    measured = f"{1000 * answer['first']:.1f} and {1000 * answer['last']:.1f} ms"
    name = f"mouth against sound, first and last half of {MINUTES} minutes"
    return [Figure(name, measured, f"{1000 * DRIFT:g} ms apart", drift / DRIFT, 1.0, absolute=Absolute.TIME)]


def main() -> None:
    """Let a voice speak, record what plays, and print the medians of both ends as JSON."""
    speech, recording, seen = _Speech(), _Recording(), []
    recording.start()
    player = Player(SpooledSpeech(speech.kept(Voice("en-us").speak(_text()))), load_preset(DEFAULT_PRESET))
    player.play()
    while player.position < 60 * MINUTES + WARM_UP:
        player.take_analyses()
        seen.append((time.monotonic(), player.position))
        time.sleep(LOOK)
    player.close()
    recording.stop()
    times, positions = np.array(seen).T
    moving = positions > 0
    heard = _Heard(speech.samples(), recording, times[moving], positions[moving])
    end = 60.0 * MINUTES
    first, last = heard.median(WARM_UP, WARM_UP + HALF_A_MINUTE), heard.median(end - HALF_A_MINUTE, end)
    print(json.dumps({"first": first, "last": last}))


def _text() -> str:
    """Return enough sentences, none twice, so that each is found again where it was said."""
    return " ".join(
        f"This is the sentence with the number {k}, said on the evening of day {7 * k}." for k in range(400)
    )


@dataclass
class _Speech:
    """Keeps what a voice says."""

    parts: list[Float32Array] = field(default_factory=list)

    def kept(self, sentences: Iterable[SpokenSentence]) -> Iterator[SpokenSentence]:
        for sentence in sentences:
            self.parts.append(sentence.samples)
            yield sentence

    def samples(self) -> Float32Array:
        return np.concatenate(self.parts)


class _Recording:
    """What a sound card plays, and when each part of it came."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._times: list[float] = []
        self._thread = threading.Thread(target=self._read, daemon=True)

    def start(self) -> None:
        self._recorder = subprocess.Popen([*RECORDER, "-d", "speaker.monitor"], stdout=subprocess.PIPE)
        self._thread.start()

    def stop(self) -> None:
        self._recorder.terminate()
        self._thread.join()

    @property
    def samples(self) -> Float64Array:
        return np.frombuffer(b"".join(self._parts), "<i2") / 32768

    @property
    def times(self) -> Float64Array:
        """When the last sample of each chunk came."""
        return np.array(self._times)

    def _read(self) -> None:
        assert self._recorder.stdout is not None
        for _ in count():
            part = self._recorder.stdout.read(2 * CHUNK)
            if len(part) < 2 * CHUNK:
                return
            self._parts.append(part)
            self._times.append(time.monotonic())


class _Heard:
    """Compares where the player says that it is with what comes out."""

    def __init__(
        self, spoken: Float32Array, recording: _Recording, times: Float64Array, positions: Float64Array
    ) -> None:
        self._spoken, self._recorded, self._came = spoken, recording.samples, recording.times
        self._times, self._positions = times, positions

    def median(self, start: float, end: float) -> float:
        """Return the median, over some seconds of speech, of its time on the clock of the mouth less its own."""
        errors = []
        for second in np.arange(start, end - PROBE, PROBE):
            at = self._found(second)
            errors.append(float(np.interp(at, self._times, self._positions)) - second)
        return float(np.median(errors))

    def _found(self, second: float) -> float:
        """Return when a second of speech came out of the sound card."""
        first = round(second * SAMPLE_RATE)
        probe = self._spoken[first : first + round(PROBE * SAMPLE_RATE)]
        expected = np.interp(second, self._positions, self._times)
        begin = max(0, round((np.searchsorted(self._came, expected) * CHUNK) - REACH * SAMPLE_RATE))
        heard = self._recorded[begin : begin + len(probe) + round(2 * REACH * SAMPLE_RATE)]
        sample = begin + int(np.argmax(correlate(heard, probe, "valid")))
        return float(np.interp(sample, CHUNK * np.arange(1, len(self._came) + 1), self._came))


if __name__ == "__main__":
    main()
