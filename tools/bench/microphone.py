"""From sound at a microphone to the phoneme in `phonemeanalyser listen`, and what listening costs.

A process plays sounds that begin out of silence into a virtual microphone, and stamps each when it is handed to the
sound server. First a bare `parec` records them, then `listen --format json` whose lines are stamped when the reader
of the pipe has them, then `parec` again. The reference, the server's own round trip, is the median of what `parec`
takes with blocks of 10 ms. What `listen` takes is held against that, onset by onset.

The two never listen at once: a server hands out blocks as short as the most impatient of its clients asks for, so a
`parec` beside it would make `listen` faster than it is. How much sound `listen` asks for at a time is its own choice
and counts against it.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.virtual_sound import VirtualSound
from tools.bench.desktop import written_speech
from tools.bench.figures import ROOT, Absolute, Figure, child_environment
from tools.bench.onsets import LEAST_GAP

N_ONSETS = 80
MOST_ONSETS = 1000
SPEECH_SECONDS = 24.0
MOST_MEDIAN, MOST_LATE = 45.0, 70.0
"""What `listen` may take beyond the round trip, ms: the median, and the 99th percentile."""
MOST_SHARE = 0.035
"""Of one core."""
SILENT = 0.9 * LEAST_GAP
"""Seconds of zeros before a sample that is an onset."""
WITHIN = 0.25
"""Seconds in which an onset must be recognised."""
LISTEN = (sys.executable, "-m", "phonemeanalyser", "listen", "--format", "json")


@dataclass(frozen=True)
class Measured:
    """What one run gave.

    Attributes
    ----------
    reference : seconds from each onset's handing over to its arrival at `parec`.
    trips : the same to the line of `listen`; None where it was not recognised.
    share : what `listen` takes of a core while there is speech.
    lost : what `listen` said of lost samples; mostly nothing.
    """

    reference: Sequence[float]
    trips: Sequence[float | None]
    share: float
    lost: str

    @property
    def beyond(self) -> list[float]:
        """What `listen` takes beyond the reference, ms."""
        own = float(np.median(self.reference))
        return [1000 * (trip - own) for trip in self.trips if trip is not None]


class Onsets:
    """Plays onsets into the microphone while it is entered; knows when each was handed over, and what it is."""

    def __init__(self, card: VirtualSound) -> None:
        self.handed: list[tuple[float, str]] = []
        self._card = card

    def __enter__(self) -> "Onsets":
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tools.bench.onsets", str(MOST_ONSETS)],
            env=self._card.environment | {"PULSE_SINK": "mic_in"},
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        threading.Thread(target=self._follow, daemon=True).start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._process.kill()
        self._process.wait(5)

    def next(self, n: int) -> list[tuple[float, str]]:
        """Wait for the next `n` onsets, and give them."""
        first = len(self.handed) + 1  # one that is under way may have begun before anyone listened
        while len(self.handed) < first + n:
            if self._process.poll() is not None:
                raise RuntimeError("the player has ended")
            time.sleep(0.05)
        time.sleep(WITHIN)
        return self.handed[first : first + n]

    def _follow(self) -> None:
        for line in self._process.stdout or ():
            self.handed.append(tuple(json.loads(line)))


class Lines:
    """Follows `listen` while it is entered, and stamps its lines as they arrive; knows in the end what was lost."""

    def __init__(self, card: VirtualSound) -> None:
        self.lost = ""
        self._arrived: list[tuple[float, str]] = []
        self._card = card

    def __enter__(self) -> "Lines":
        self._process = subprocess.Popen(
            LISTEN,
            env=child_environment(self._card.environment),
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        threading.Thread(target=self._follow, daemon=True).start()
        while not self._arrived:
            if self._process.poll() is not None:
                raise RuntimeError(self._process.communicate()[1])
            time.sleep(0.05)
        return self

    def __exit__(self, *_error: object) -> None:
        self._process.terminate()
        said = self._process.stderr.read() if self._process.stderr else ""
        self._process.wait(10)
        self.lost = "".join(line for line in said.splitlines() if "lost" in line)

    @property
    def processor(self) -> float:
        """Time of all its threads, seconds."""
        fields = Path(f"/proc/{self._process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def times_of(self, label: str) -> list[float]:
        """Say when the lines with a phoneme arrived."""
        return [when for when, name in self._arrived if name == label]

    def _follow(self) -> None:
        for line in self._process.stdout or ():
            self._arrived.append((time.monotonic(), json.loads(line)["phoneme"]))


class Reference:
    """A bare recording of the same microphone, which stamps onsets as they arrive, while it is entered."""

    def __init__(self, card: VirtualSound) -> None:
        self.onsets: list[float] = []
        self._card = card

    def __enter__(self) -> "Reference":
        self._process = subprocess.Popen(
            ["parec", "--raw", "--format=s16le", "--channels=1", f"--rate={SAMPLE_RATE}", "--latency-msec=10"],
            env=self._card.environment,
            stdout=subprocess.PIPE,
        )
        self._thread = threading.Thread(target=self._follow, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._process.kill()
        self._process.wait(5)
        self._thread.join(5)

    def _follow(self) -> None:
        assert self._process.stdout is not None
        n_silent = 0
        while data := os.read(self._process.stdout.fileno(), 65_536):
            now = time.monotonic()
            loud = np.flatnonzero(np.frombuffer(data, np.int16))
            if loud.size and n_silent + loud[0] > SILENT * SAMPLE_RATE:
                self.onsets.append(now)
            n = len(data) // 2
            n_silent = n - 1 - int(loud[-1]) if loud.size else n_silent + n


def figures() -> list[Figure]:
    """Measure with a sound server of its own."""
    if shutil.which("pulseaudio") is None:
        print("  left out: it needs a sound server of its own, PulseAudio")
        return []
    found = measured(N_ONSETS, SPEECH_SECONDS)
    n_missed = len(found.trips) - len(found.beyond)
    median, late = (float(np.percentile(found.beyond, p)) for p in (50, 99))
    trip = f"server's round trip {1000 * np.median(found.reference):.1f} ms"
    return [
        Figure(
            "sound to phoneme, median",
            f"{median:.1f} ms beyond",
            trip,
            median / MOST_MEDIAN,
            1.0,
            absolute=Absolute.TIME,
        ),
        Figure("sound to phoneme, p99", f"{late:.1f} ms beyond", trip, late / MOST_LATE, 1.0, absolute=Absolute.TIME),
        Figure("onsets missed by listen", f"{n_missed} of {len(found.trips)}", "none", float(n_missed), limit=0.0),
        Figure("samples lost by listen", found.lost or "none", "none", float(bool(found.lost)), limit=0.0),
        Figure(
            "listen",
            f"{found.share:.1%} of a core",
            f"{MOST_SHARE:.1%}",
            found.share / MOST_SHARE,
            1.0,
            absolute=Absolute.WORK,
        ),
    ]


def measured(n_onsets: int, seconds: float) -> Measured:
    """Play onsets for the latency, then speech for the processor time."""
    with VirtualSound() as card:
        with Onsets(card) as onsets:
            reference = _reference(card, onsets, n_onsets // 2)
            with Lines(card) as listening:
                trips = [_trip(at, listening.times_of(label)) for at, label in onsets.next(n_onsets)]
            reference += _reference(card, onsets, n_onsets // 2)
        with Lines(card) as working:
            share = _share(card, working, seconds)
    return Measured(reference, trips, share, listening.lost + working.lost)


def _reference(card: VirtualSound, onsets: Onsets, n: int) -> list[float]:
    with Reference(card) as reference:
        trips = [_trip(at, reference.onsets) for at, _ in onsets.next(n)]
    found = [trip for trip in trips if trip is not None]
    if len(found) < n:
        raise RuntimeError(f"the reference found only {len(found)} of {n} onsets")
    return found


def _trip(handed: float, arrivals: Sequence[float]) -> float | None:
    """Give the time to the first arrival after an onset; None where there is none before the next."""
    return next((when - handed for when in arrivals if 0 < when - handed < WITHIN), None)


def _share(card: VirtualSound, listening: Lines, seconds: float) -> float:
    """Give the share of a core that listening to speech takes."""
    with tempfile.TemporaryDirectory() as folder:
        player = card.play_into_microphone(written_speech(Path(folder), seconds + 10))
        time.sleep(2)
        wall, processor = time.monotonic(), listening.processor
        time.sleep(seconds)
        wall, processor = time.monotonic() - wall, listening.processor - processor
        player.kill()
        player.wait(5)
    return processor / wall
