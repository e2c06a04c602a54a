"""Sounds without speech, made here: what a network should call silence however loud it is.

``python -m tools.voices.no_speech OUT_DIR`` writes them as one speaker of a corpus: music, the desk of a person who
streams, struck tones, coloured noise and digital silence, in equal parts, at levels from loud to faint.
"""

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np

from phonemeengine.calibration.scores.added_noise import desk, music
from tools.voices.classes import PLAIN, table_of
from tools.voices.labels import Segment
from tools.voices.writing import SAMPLE_RATE, Speaker, Utterance, UtteranceWriter, replace_speaker

ABOUT = Speaker("made", "no_speech", "", "", "no speech", "MIT (made by this project)", "", "")
SECONDS, N_EACH = 8.0, 18
LEVELS = (-60.0, -12.0)
"""Root mean square, dB below full scale."""


def main() -> None:
    """Write the recordings, and say how much there is."""
    parser = argparse.ArgumentParser(prog="python -m tools.voices.no_speech", description=__doc__)
    parser.add_argument("out", type=Path, metavar="OUT_DIR", help="folder for the corpus")
    out = parser.parse_args().out
    writer = UtteranceWriter(out, ABOUT, table_of(*PLAIN))
    generator = np.random.default_rng(1)
    for make in (music, desk, tones, noise, nothing):
        for _ in range(N_EACH):
            writer.write(recording_of(make, generator))
    replace_speaker(out, ABOUT, writer.rows)
    print(f"{len(writer.rows)} recordings, {writer.seconds / 60:.1f} min")


Make = Callable[[int, np.random.Generator], np.ndarray]


def recording_of(make: Make, generator: np.random.Generator) -> Utterance:
    """Return a recording of some kind of sound at a drawn level, with its one label."""
    sound = make(round(SECONDS * SAMPLE_RATE), generator) * 10 ** (generator.uniform(*LEVELS) / 20)
    return Utterance(sound, SAMPLE_RATE, [Segment(0.0, SECONDS, "pau")], "")


def tones(n: int, generator: np.random.Generator) -> np.ndarray:
    """Return a chord of pure tones that is struck again and again, shape (n,), with a root mean square of 1."""
    times = np.arange(n) / SAMPLE_RATE
    period, fall = generator.uniform(0.2, 2), generator.uniform(0, 8)
    frequencies = 110 * 2 ** generator.uniform(0, 3, size=generator.integers(1, 5))
    sound = np.sin(2 * np.pi * frequencies[:, np.newaxis] * times).sum(axis=0) * np.exp(-fall * (times % period))
    return np.asarray(sound / np.sqrt(np.mean(sound**2)))


def noise(n: int, generator: np.random.Generator) -> np.ndarray:
    """Return noise whose power follows a drawn power of the frequency, shape (n,), with a root mean square of 1."""
    spectrum = np.fft.rfft(generator.standard_normal(n))
    spectrum[1:] *= np.arange(1, len(spectrum)) ** -generator.uniform(0, 1)
    sound = np.fft.irfft(spectrum, n)
    return np.asarray(sound / np.sqrt(np.mean(sound**2)))


def nothing(n: int, _generator: np.random.Generator) -> np.ndarray:
    """Return digital silence, shape (n,)."""
    return np.zeros(n)


if __name__ == "__main__":
    main()
