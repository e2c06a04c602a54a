"""A sound without end whose every sample is known, and is another at every moment."""

import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import soundfile
from numpy.typing import NDArray

import phonemeanalyser
from phonemeengine.audio.files import SoundReader
from phonemeengine.settings import SAMPLE_RATE
from tests.fakes.recorders import samples_of_16_bits
from tests.fakes.virtual_sound import VirtualSound

DEMO = Path(phonemeanalyser.__file__).parent / "demo" / "demo.flac"
MINUTE = 60 * SAMPLE_RATE
AHEAD = 1000
"""What the player keeps ready, ms: the sound must not break off where the machine is busy."""

Samples = NDArray[np.int16]


class KnownSound:
    """Speech again and again, so that the phonemes change, over a faint noise that tells where a sample stands."""

    def __init__(self) -> None:
        with SoundReader(DEMO) as reader:
            speech = np.concatenate(list(reader.blocks(SAMPLE_RATE)))
        self._speech = np.round(30_000 * speech).astype(np.int16)

    def samples(self, first: int, n: int) -> Samples:
        """Give samples first..first+n-1."""
        noise = np.round(8 * samples_of_16_bits(first, n)[:, 0]).astype(np.int16)
        return self._speech[np.arange(first, first + n) % len(self._speech)] + noise


class KnownPlayer:
    """Plays the known sound into the virtual microphone while it is entered."""

    def __init__(self, sound: KnownSound, card: VirtualSound) -> None:
        self._sound = sound
        self._card = card

    def __enter__(self) -> "KnownPlayer":
        self._process = subprocess.Popen(
            [
                "pacat",
                "--playback",
                "-d",
                "mic_in",
                "--raw",
                "--format=s16le",
                "--channels=1",
                f"--rate={SAMPLE_RATE}",
                f"--latency-msec={AHEAD}",
            ],
            env=self._card.environment,
            stdin=subprocess.PIPE,
        )
        self._thread = threading.Thread(target=self._feed, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._process.kill()
        self._process.wait(5)
        self._thread.join(5)

    def _feed(self) -> None:
        assert self._process.stdin is not None
        first = 0
        try:
            while True:
                self._process.stdin.write(self._sound.samples(first, SAMPLE_RATE).tobytes())
                first += SAMPLE_RATE
        except (BrokenPipeError, ValueError):
            pass  # it was ended


def heard_exactly(path: Path, sound: KnownSound) -> int:
    """Count the samples of the known sound at the end of a recording that begins with silence; 0 if one differs."""
    start = _silence_before(path, sound)
    if start is None:
        return 0
    n = 0
    for block in _minutes(path, start):
        if not np.array_equal(block, sound.samples(n, len(block)) / 32768):
            return 0
        n += len(block)
    return n


def _silence_before(path: Path, sound: KnownSound) -> int | None:
    began = int(np.flatnonzero(sound.samples(0, SAMPLE_RATE))[0])
    n = 0
    for block in _minutes(path, 0):
        if (found := np.flatnonzero(block)).size:
            return n + int(found[0]) - began
        n += len(block)
    return None


def _minutes(path: Path, first: int) -> Iterator[NDArray[np.float32]]:
    with soundfile.SoundFile(path) as file:
        file.seek(first)
        while len(block := file.read(MINUTE, dtype="float32")):
            yield block
