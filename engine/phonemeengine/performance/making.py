"""Making a corpus with the synthetic performer: sounds of a voice, what is said in them, and a face that says it."""

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import tomli_w

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.wav import WavEncoder
from phonemeengine.errors import EngineError, PerformanceError
from phonemeengine.files import atomic_write, printable_name, reason_of
from phonemeengine.labels.utterance import Utterance, shifted
from phonemeengine.labels.utterance_files import format_utterance
from phonemeengine.mouth.exports.livelink import lines_of
from phonemeengine.performance.corpus import ABOUT, FORMAT
from phonemeengine.performance.recording import SILENCE, phones_of
from phonemeengine.performance.synthetic import perform
from phonemeengine.progress import Progress, no_progress, report_progress
from phonemeengine.settings import SAMPLE_RATE

LEAD = 0.25
"""Seconds of silence before a sentence."""
Speak = Callable[[str], tuple[Float32Array, Utterance]]
"""Says a text: gives samples, mono at 44.1 kHz, and what is said in them, as `speak` does."""


@dataclass(frozen=True)
class MadeCorpus:
    """A corpus that was made: how many recordings, and how long they are together, seconds."""

    n_recordings: int
    duration: float


def make_corpus(
    folder: str | os.PathLike[str], sentences: Iterable[str], speak: Speak, *, seconds: float, seed: int = 0,
    progress: Progress = no_progress,
) -> MadeCorpus:  # fmt: skip
    """Have the synthetic performer read sentences, until they are so long or have come to their end.

    Parameters
    ----------
    folder : is made; it must hold nothing.
    speak : the voice.
    seconds : of all recordings together.
    seed : another one gives other takes.

    Raises
    ------
    PerformanceError : there is something in the folder, or it cannot be written.
    EngineError : the voice refuses a sentence.
    Cancelled : it was not wanted any more; the recordings that are there are whole.
    """
    folder = Path(folder)
    name = printable_name(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise PerformanceError(f"{name}: there are files in this folder already; name a new one")
        about = tomli_w.dumps({"format": FORMAT, "name": folder.resolve().name, "synthetic": True})
        (folder / ABOUT).write_text(about, encoding="utf-8")
        made = MadeCorpus(0, 0.0)
        for number, sentence in enumerate(sentences, 1):
            report_progress(progress, min(made.duration / seconds, 1.0))
            if made.duration >= seconds:
                break
            samples, utterance = _with_lead(*speak(sentence))
            _write_recording(folder / f"synthetic{number:04d}", samples, utterance, (seed, number))
            made = MadeCorpus(number, made.duration + utterance.duration)
    except EngineError:
        raise
    except (OSError, ValueError) as error:
        raise PerformanceError(f"{name}: it cannot be written ({reason_of(error)}); name another folder") from error
    return made


def _with_lead(samples: Float32Array, utterance: Utterance) -> tuple[Float32Array, Utterance]:
    """Return a sound and what is said in it behind some silence."""
    n = round(LEAD * SAMPLE_RATE)
    words = tuple(shifted(word, n / SAMPLE_RATE) for word in utterance.words)
    later = replace(utterance, words=words, duration=utterance.duration + n / SAMPLE_RATE)
    return np.concatenate([np.zeros(n, np.float32), samples]), later


def _write_recording(path: Path, samples: Float32Array, utterance: Utterance, seed: tuple[int, int]) -> None:
    """Write a recording's sound, labels and face; the endings are added to the path."""
    with atomic_write(path.with_suffix(".wav")) as file:
        encoder = WavEncoder(file, SAMPLE_RATE, 1)
        encoder.write(samples[:, None])
        encoder.close()
    face = perform(phones_of(utterance), seed)
    for suffix, content in ((".TextGrid", format_utterance(utterance, SILENCE)), (".csv", "".join(lines_of(face)))):
        with atomic_write(path.with_suffix(suffix)) as file:
            file.write(content.encode())
