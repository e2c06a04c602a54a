"""Programs that tests run beside themselves on a virtual sound card, and the exact search in what was heard.

PortAudio takes its sound server from the environment when a process begins, so each test needs processes of its own.
"""

import json
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import soundfile
from numpy.typing import NDArray

from phonemeengine.audio.files import SoundReader
from phonemeengine.errors import AudioError
from tests.fakes.virtual_sound import VirtualSound
from tests.sounds import noise
from tests.waiting import let_pass

HERE = Path(__file__).parent
PATIENCE = 120.0
"""Seconds that only a hang takes."""
UNSEEN = 0.02
"""Sound that a device may lose without being counted, since it loses whole blocks, seconds."""
SETTLED = 5.0
"""Seconds after which everything that was lost is counted: the meter wants two whole seconds."""
SIGNATURE = 64
"""Samples of noise that occur only once."""

Samples = NDArray[np.int64]


class Program:
    """A Python program on a virtual sound card; what it prints lies in two files."""

    def __init__(self, folder: Path, sound: VirtualSound, *words: object) -> None:
        name = f"{time.monotonic_ns()}"
        self._out, self._errors = folder / f"{name}.out", folder / f"{name}.err"
        with self._out.open("wb") as out, self._errors.open("wb") as errors:
            self.process = subprocess.Popen(
                [sys.executable, *map(str, words)], env=sound.environment, stdout=out, stderr=errors
            )

    @property
    def out(self) -> list[str]:
        """What it has printed, by lines; one that is being written is left out."""
        return self._out.read_text().split("\n")[:-1]

    @property
    def errors(self) -> list[str]:
        """What it has said on standard error, by lines."""
        return self._errors.read_text().splitlines()

    @property
    def log(self) -> list[dict[str, Any]]:
        """What it has printed, as JSON."""
        return [json.loads(line) for line in self.out]

    def wait_for(self, true: Callable[[], object]) -> None:
        """Wait until something is so."""
        deadline = time.monotonic() + PATIENCE
        while not true():
            assert self.process.poll() is None, self.errors
            assert time.monotonic() < deadline, (self.out[-1:], self.errors)
            let_pass(0.02)

    def end(self, number: int | None = signal.SIGTERM) -> int:
        """Send a signal, unless it is None, and give the exit code."""
        if number is not None:
            self.process.send_signal(number)
        return self.process.wait(PATIENCE)


def listener(folder: Path, sound: VirtualSound, take: Path, rate: int = 0) -> Program:
    """Listen and record in a process of its own; returns when sound comes in."""
    program = Program(folder, sound, HERE / "listen_on_card.py", take, rate)
    program.wait_for(lambda: any(line.get("listening") for line in program.log))
    return program


def recorder(folder: Path, sound: VirtualSound, *words: object) -> Program:
    """Run `phonemeanalyser record`; returns when it has begun."""
    program = Program(folder, sound, "-m", "phonemeanalyser", "record", *words)
    program.wait_for(lambda: any("listening to" in line for line in program.errors))
    return program


@dataclass(frozen=True)
class Followed:
    """What was heard of a noise: seconds that were skipped in it, and seconds that are missing at its end."""

    skipped: float
    rest: float

    @property
    def missing(self) -> float:
        """All that is missing, seconds."""
        return self.skipped + self.rest


def followed(pcm: Samples, heard: Samples) -> Followed:
    """Follow a noise through what was heard; fails unless that is the noise, in its order, and nothing besides.

    A busy machine loses blocks, which are missing then, and plays silence where it comes late.
    """
    (sounding,) = np.nonzero(heard)
    at = int(sounding[0]) if len(sounding) else len(heard)
    n_skipped = k = 0
    while at < len(heard) - SIGNATURE and k < len(pcm):
        goes_on = n_alike(heard[at:], pcm[k:]) >= min(SIGNATURE // 4, len(pcm) - k)
        again = k if goes_on else place_of(heard[at : at + SIGNATURE], pcm)
        assert again >= k, "the noise goes back"
        n_skipped += again - k
        n = n_alike(heard[at:], pcm[again:])
        at, k = at + n, again + n
        (sounding,) = np.nonzero(heard[at:])
        at = at + int(sounding[0]) if len(sounding) else len(heard)
    assert k < len(pcm) or at == len(heard), "something follows the noise"
    return Followed(n_skipped / 44_100, (len(pcm) - k) / 44_100)


def n_alike(one: Samples, other: Samples) -> int:
    """Count the samples that are the same from the beginning on."""
    n = min(len(one), len(other))
    different = np.flatnonzero(one[:n] != other[:n])
    return int(different[0]) if len(different) else n


def counted_in(sentence: str) -> float:
    """Give the seconds that `record` says were lost, in the last sentence that it says."""
    said = re.search(r"(nothing|([0-9.]+) s)( more)?( were)? lost( on the way)?$", sentence)
    assert said is not None, sentence
    return float(said[2] or 0)


def pcm_noise(path: Path, seconds: float, seed: int = 0) -> Samples:
    """Write noise of 16 bits, and give its samples."""
    pcm = np.clip(np.round(noise(seconds, 0.1, seed) * 32768), -32768, 32767).astype(np.int16)
    pcm[0] = pcm[-1] = 1000  # so that its ends are seen
    soundfile.write(path, pcm, 44_100, subtype="PCM_16")
    return pcm.astype(np.int64)


def samples_of(path: Path) -> Samples:
    """The first channel of a recording, in steps of 16 bits; fails where a sample lies between two steps."""
    samples, _ = soundfile.read(path, dtype="float64", always_2d=True)
    steps = samples[:, 0] * 32768
    assert np.array_equal(steps, np.round(steps))
    return steps.astype(np.int64)


def seconds_of(path: Path) -> float:
    """The length of a recording, which may still be growing and have nothing in it yet."""
    try:
        with SoundReader(path) as reader:
            return reader.duration
    except AudioError:
        return 0.0


def place_of(part: Samples, whole: Samples) -> int:
    """Say where the beginning of a noise lies in a recording; the only place."""
    signature = part[:SIGNATURE]
    candidates = np.flatnonzero(whole[: len(whole) - SIGNATURE + 1] == signature[0])
    places = [k for k in candidates if np.array_equal(whole[k : k + SIGNATURE], signature)]
    assert len(places) == 1, f"found {len(places)} times"
    return int(places[0])
