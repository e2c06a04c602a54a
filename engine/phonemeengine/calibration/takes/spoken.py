"""A sentence that a speaker read, kept beside their takes: sound and labels, which no manifest names.

Reading the project as a corpus gives the takes alone. What was read to learn from, and what was held out to judge
by, lie in folders of their own.
"""

from pathlib import Path

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array
from phonemeengine.audio.recording import write_flac
from phonemeengine.calibration.alignment import SPOKEN, aligned
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.sentences import Sentence
from phonemeengine.calibration.takes.take import folder_for
from phonemeengine.errors import TakeError
from phonemeengine.labels.files import read_labels
from phonemeengine.labels.table import format_table, write_text
from phonemeengine.storage.files import free_path, printable_name, reason_of

# When a voice begins in the microphone's signal, and whether it has ended.

PERIOD = 0.01
QUIET_FRAMES, LOUD_FRAMES = 8, 5
"""How many of 10 ms must be quiet before a sound, and loud in a row where it begins."""


def onset_in(sound: Float32Array, rate: int, threshold: float) -> float | None:
    """Return when a voice begins, seconds: where, after quiet, it stays as loud as a threshold (RMS); None if never.

    Parameters
    ----------
    sound : float32, shape (n,), ±1.
    rate : Hz.
    threshold : an amplitude.
    """
    quiet = run = 0
    for k, is_loud in enumerate(_loud(sound, rate, threshold).tolist()):
        run = run + 1 if is_loud else 0
        if quiet >= QUIET_FRAMES and run >= LOUD_FRAMES:
            return (k + 1 - run) * PERIOD
        if not is_loud:
            quiet = quiet + 1
        elif quiet < QUIET_FRAMES:
            quiet = 0
    return None


def quiet_at_end(sound: Float32Array, rate: int, threshold: float) -> float:
    """Say for how long it has been quieter than a threshold, seconds; the parameters are those of `onset_in`."""
    loud = np.flatnonzero(_loud(sound, rate, threshold))
    return len(sound) / rate - (int(loud[-1]) + 1) * PERIOD if len(loud) else len(sound) / rate


def _loud(sound: Float32Array, rate: int, threshold: float) -> BoolArray:
    frame = max(1, round(PERIOD * rate))
    n = len(sound) // frame
    levels = np.sqrt(np.mean(sound[: n * frame].reshape(n, frame) ** 2, axis=1)) if n else np.zeros(0)
    return np.asarray(levels >= threshold)


HELD_OUT = "held-out"
"""The folder of sentences from which nothing is learned, in a project of takes; that of the others is `SPOKEN`."""


def keep_sentence(
    folder: Path,
    samples: Float32Array,
    rate: int,
    mono: Float32Array,
    sentence: Sentence,
    speaker: str,
    *,
    teaches: bool,
) -> LabelledUtterance:
    """Label a sentence by its known text, and keep it in a project of takes.

    Parameters
    ----------
    folder : of the project.
    samples, rate : as it was recorded, shape (n, n_channels), and Hz.
    mono : the same as one channel at 44.1 kHz, shape (m,).
    sentence : what was to be read.
    speaker : who read it.
    teaches : whether it is learned from; else it is to judge by.

    Raises
    ------
    TakeError : something else was read, or the folder cannot be written; nothing is kept.
    RecordingError, CorpusError : the disk refuses.
    """
    labels = aligned(mono, sentence)
    part = SPOKEN if teaches else HELD_OUT
    place = folder / part / folder_for(speaker)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise TakeError(
            f"{printable_name(place)}: this folder cannot be made ({reason_of(error)}); choose another for the takes"
        ) from error
    path = free_path(place / f"{sentence.language.lower()}-1.flac")
    write_flac(path, samples, rate)
    write_text(format_table(labels), path.with_suffix(".csv"))
    return LabelledUtterance(path, read_labels(path.with_suffix(".csv")), speaker, part)  # as others will read it
