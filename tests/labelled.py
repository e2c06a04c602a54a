"""Labelled recordings whose every sound is made, so that what is said in them is known."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import soundfile

from phonemeengine.arrays import UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import labels_of_segments, segments_of
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE
from tests.sounds import Sound, noise, silence, vowel

FORMANTS = {
    Phoneme.A: (750.0, 1250.0, 2500.0),
    Phoneme.E: (480.0, 1900.0, 2500.0),
    Phoneme.I: (280.0, 2250.0, 3000.0),
    Phoneme.O: (480.0, 850.0, 2400.0),
    Phoneme.U: (310.0, 700.0, 2300.0),
}
SAID = (Phoneme.SILENCE, Phoneme.A, Phoneme.SZ, Phoneme.I, Phoneme.O, Phoneme.SILENCE, Phoneme.U, Phoneme.E)


def said(phoneme: Phoneme, seconds: float, pitch: float = 120.0, level: float = 0.4, seed: int = 0) -> Sound:
    """One sound: a vowel, a hiss for s, or a very faint noise."""
    if phoneme in FORMANTS:
        return vowel(FORMANTS[phoneme], seconds, pitch, level) + noise(seconds, 0.002, seed)
    if phoneme is Phoneme.SZ:
        return noise(seconds, level / 4, seed)
    return silence(seconds) + noise(seconds, 0.0005, seed)


def recording(
    path: Path,
    phonemes: Sequence[Phoneme] = SAID,
    seconds: float = 0.3,
    *,
    speaker: str = "ada",
    pitch: float = 120.0,
    level: float = 0.4,
) -> LabelledUtterance:
    """Write a recording in which these are said one after the other, and give it with its labels."""
    sounds = [said(p, seconds, pitch, level, k) for k, p in enumerate(phonemes)]
    soundfile.write(path, np.concatenate(sounds), SAMPLE_RATE, subtype="FLOAT")
    labels = tuple(Label(k * seconds, (k + 1) * seconds, p.label, p) for k, p in enumerate(phonemes))
    return LabelledUtterance(path, labels, speaker, "made")


def recordings(folder: Path) -> tuple[LabelledUtterance, ...]:
    """Write four recordings of two speakers."""
    return tuple(
        recording(
            folder / f"{k}.wav",
            [*SAID[k:], *SAID[:k]],
            speaker=("ada", "bob")[k % 2],
            pitch=110.0 + 25 * k,
            level=0.3 + 0.1 * k,
        )
        for k in range(4)
    )


OF_THE_SCORER = {
    "ten_acc": "accuracy",
    "ten_f1": "macro_f1",
    "vowel5": "vowel_accuracy",
    "mouth_acc": "viseme_accuracy",
    "mouth_f1": "viseme_f1",
    "silence_recall": "silence_recall",
    "false_silence": "false_silence",
}
"""What the figures of the corpus scorer are called here, those that are shares."""


def labels_of(phonemes: UInt8Array, duration: float | None = None) -> tuple[Label, ...]:
    """Join equal frames of 10 ms into labels without gaps.

    Parameters
    ----------
    phonemes : codes of `Phoneme`, shape (n_frames,).
    duration : length of the sound, seconds, where the last label ends; that of the frames where it is None.
    """
    seconds = len(phonemes) * FRAME_PERIOD if duration is None else duration
    return labels_of_segments(segments_of([(phonemes, np.zeros(len(phonemes), np.float32))], seconds))
