"""What a network learns from: the mel powers of a recording, with its labels."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.log_mel import FLOOR, mel_powers, warped_mel_bank
from phonemeengine.encoder.mel import whisper_log_mels
from phonemeengine.encoder.weights import N_MELS
from phonemeengine.labels.label import Label
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme

TOGETHER = 512
"""Frames that are measured at once."""

CERTAINTIES = {"core": 1.0, "affricate": 1.0, "diphthong": 0.7, "ambiguous": 0.6}
"""How much a frame counts by the certainty of its label; what is not listed counts for nothing."""
NOT_SAID = 255
"""The code of what no label says."""
N_SOFT_LABELS = len(Phoneme) + len(Viseme)
"""Numbers that a teacher gives for a frame: the probabilities of the phonemes, then those of the visemes."""


@dataclass(frozen=True)
class TrainingExample:
    """One variation of one recording.

    Attributes
    ----------
    log_powers : float16, shape (n_frames, 40): base-10 logarithms of the mel powers.
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    visemes : uint8, shape (n_frames,): codes of `Viseme`, or `NO_VISEME` where that is disputed.
    certainties : float16, shape (n_frames,): how much each label counts, 0..1.
    soft_labels : float16, shape (n_frames, 26): the teacher's probabilities of phonemes and visemes; zeros where
        there is no teacher.
    """

    log_powers: NDArray[np.float16]
    phonemes: UInt8Array
    visemes: UInt8Array
    certainties: NDArray[np.float16]
    soft_labels: NDArray[np.float16]

    def __len__(self) -> int:
        return len(self.phonemes)


def example_of(
    samples: Float32Array,
    labels: tuple[Label, ...],
    warp: float = 1.0,
    soft_labels: NDArray[np.float16] | None = None,
) -> TrainingExample:
    """Measure a sound (float32, shape (n,), 44.1 kHz) that is labelled, or that has a teacher's probabilities."""
    bank = _bank(warp)
    parts = [np.log10(mel_powers(block, bank) + np.float32(FLOOR)) for block in windows_of(samples)]
    powers = np.concatenate(parts) if parts else np.zeros((0, bank.shape[1]), np.float32)
    n = len(powers) if soft_labels is not None else 0
    unsaid = np.full(n, NOT_SAID, np.uint8)
    phonemes, visemes = unsaid, unsaid
    if labels:
        frames = frame_labels_of(labels)
        n = min(len(powers), len(frames.phonemes))
        phonemes, visemes = frames.phonemes[:n], frames.visemes[:n]
    soft = np.zeros((n, N_SOFT_LABELS), np.float16)
    if soft_labels is not None:
        soft[: len(soft_labels)] = soft_labels[:n]
    return TrainingExample(powers[:n].astype(np.float16), phonemes, visemes, certainties_of(labels, n), soft)


def whisper_mels_of(samples: Float32Array, warp: float = 1.0) -> Float32Array:
    """Return what `whisper_log_mels` finds in a sound (float32, shape (n,), 44.1 kHz), shape (n_frames, 80)."""
    parts = [whisper_log_mels(block, warp) for block in windows_of(samples)]
    return np.concatenate([np.zeros((0, N_MELS), np.float32), *parts])


def sound_of(utterance: LabelledUtterance) -> Float32Array:
    """Return the samples of a recording, float32, shape (n,), mono at 44.1 kHz.

    Raises
    ------
    AudioError : the sound cannot be read.
    """
    with utterance.opened() as reader:
        return reader.read_mono()


def certainties_of(labels: tuple[Label, ...], n: int) -> NDArray[np.float16]:
    """Return how much each of n frames counts, 0..1, shape (n,)."""
    times = (np.arange(n) + 0.5) * 0.01
    certainties = np.zeros(n, np.float16)
    for label in labels:
        certainties[(times >= label.start) & (times < label.end)] = CERTAINTIES.get(label.certainty, 0.0)
    return certainties


def windows_of(samples: Float32Array) -> Iterator[Float32Array]:
    """Cut a sound into windows, some at a time, shape (n, 2048)."""
    framer = Framer()
    for windows in (framer.cut_frames(samples), framer.finish()):
        for k in range(0, len(windows), TOGETHER):
            yield windows[k : k + TOGETHER]


@lru_cache(maxsize=64)
def _bank(warp: float) -> Float32Array:
    return warped_mel_bank(warp)
