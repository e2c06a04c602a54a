"""Folders of recordings of a tone and of a face whose jaw opens steadily."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.labels.textgrid import format_tiers
from phonemeengine.labels.utterance import Phone, Syllable, Utterance, Word
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.settings import SAMPLE_RATE
from tests.engine.performance.faces import ramp

DURATION = 1.0
PHONES = [(0.2, 0.3, "m"), (0.3, 0.5, "aː"), (0.5, 0.6, "m"), (0.6, 0.8, "i")]
SYLLABLES = [(0.2, 0.5, "ˈmaː"), (0.5, 0.8, "mi")]
TONE = 200.0
"""Hz, of the first vowel; all else is silent."""


def tone(duration: float = DURATION) -> Float32Array:
    """Give a tone of amplitude 0.5 while the first vowel is said."""
    times = np.arange(round(duration * SAMPLE_RATE)) / SAMPLE_RATE
    heard = (times >= 0.3) & (times < 0.5)
    return (0.5 * np.sin(2 * np.pi * TONE * times) * heard).astype(np.float32)


def write_sound(path: Path, samples: Float32Array) -> None:
    with path.open("wb") as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 1)
        encoder.write(samples[:, None])
        encoder.close()


def write_recording(folder: Path, name: str = "mami", *, syllables: bool = True) -> None:
    """Write a recording of the word "mami", whose jaw opens from 0 to 1 within a second."""
    tiers = {"words": [(0.2, 0.8, "mami")], "phones": PHONES} | ({"syllables": SYLLABLES} if syllables else {})
    (folder / f"{name}.TextGrid").write_text(format_tiers(tiers, DURATION), encoding="utf-8")
    (folder / f"{name}.csv").write_text("".join(lines_of(ramp(61))), encoding="utf-8")
    write_sound(folder / f"{name}.wav", tone())


def saying() -> Callable[[str], tuple[Float32Array, Utterance]]:
    """Give a voice that says "ma" for each word of a text, 0.2 s each."""

    def speak(text: str) -> tuple[Float32Array, Utterance]:
        words = tuple(_ma(k, word) for k, word in enumerate(text.split()))
        return np.zeros(round((len(words) * 0.2 + 0.3) * SAMPLE_RATE), np.float32), Utterance(
            words, len(words) * 0.2 + 0.3
        )

    return speak


def _ma(k: int, text: str) -> Word:
    start = 0.1 + 0.2 * k
    phones = (Phone(start, start + 0.08, "m", Phoneme.M), Phone(start + 0.08, start + 0.2, "a", Phoneme.A))
    return Word(text, (Syllable(phones, 1),))
