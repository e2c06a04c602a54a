"""What a network is trained on: mel powers of recordings, several variations of each, with their labels."""

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.calibration.learning.augment_waveform import Augmentation, augment, draw_augmentation
from phonemeengine.calibration.learning.soft_labels import N_HEARD, SoftLabels, key_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.log_mel import FLOOR, mel_powers, warped_mel_bank
from phonemeengine.errors import EngineError
from phonemeengine.labels.label import Label
from phonemeengine.processes import end_with_parent

TOGETHER = 512
"""Frames that are measured at once."""

CERTAINTIES = {"core": 1.0, "affricate": 1.0, "diphthong": 0.7, "ambiguous": 0.6}
"""How much a frame counts by the certainty of its label; what is not listed counts for nothing."""
NOT_SAID = 255
"""The code of what no label says."""


@dataclass(frozen=True)
class TrainingExample:
    """One variation of one recording.

    Attributes
    ----------
    log_powers : float16, shape (n_frames, 40): base-10 logarithms of the mel powers.
    phonemes : uint8, shape (n_frames,): codes of `Phoneme`.
    visemes : uint8, shape (n_frames,): codes of `Viseme`, or `NO_VISEME` where that is disputed.
    certainties : float16, shape (n_frames,): how much each label counts, 0..1.
    heard : float16, shape (n_frames, 26): the teacher's probabilities of phonemes and visemes, see
        `phonemeengine.calibration.learning.soft_labels`; zeros where there is no teacher.
    """

    log_powers: NDArray[np.float16]
    phonemes: UInt8Array
    visemes: UInt8Array
    certainties: NDArray[np.float16]
    heard: NDArray[np.float16]

    def __len__(self) -> int:
        return len(self.phonemes)


def examples_of(
    utterances: Sequence[LabelledUtterance], n_variations: int, seed: int, soft_labels: SoftLabels | None = None
) -> Iterator[tuple[TrainingExample, ...]]:
    """Make the examples of all utterances: each as it is, and `n_variations` others; in as many processes as cores.

    Raises
    ------
    EngineError : a sound cannot be read.
    """
    with ProcessPoolExecutor(os.cpu_count(), initializer=end_with_parent) as pool:
        known = soft_labels or {}
        tasks = ((utterance, n_variations, seed, known.get(key_of(utterance))) for utterance in utterances)
        for made in pool.map(_examples, tasks, chunksize=8):
            if isinstance(made, EngineError):
                pool.shutdown(wait=False, cancel_futures=True)
                raise made
            yield made


def example_of_recording(utterance: LabelledUtterance) -> TrainingExample:
    """Measure a labelled recording as it is.

    Raises
    ------
    AudioError : the sound cannot be read.
    """
    return example_of(_sound_of(utterance), utterance.labels)


def example_of(
    samples: Float32Array, labels: tuple[Label, ...], warp: float = 1.0, heard: NDArray[np.float16] | None = None
) -> TrainingExample:
    """Measure a sound (float32, shape (n,), 44.1 kHz) that is labelled, or of which a teacher tells what it heard."""
    bank = _bank(warp)
    parts = [np.log10(mel_powers(block, bank) + np.float32(FLOOR)) for block in _windows_of(samples)]
    powers = np.concatenate(parts) if parts else np.zeros((0, bank.shape[1]), np.float32)
    n = len(powers) if heard is not None else 0
    unsaid = np.full(n, NOT_SAID, np.uint8)
    phonemes, visemes = unsaid, unsaid
    if labels:
        frames = frame_labels_of(labels)
        n = min(len(powers), len(frames.phonemes))
        phonemes, visemes = frames.phonemes[:n], frames.visemes[:n]
    soft = np.zeros((n, N_HEARD), np.float16)
    if heard is not None:
        soft[: len(heard)] = heard[:n]
    return TrainingExample(powers[:n].astype(np.float16), phonemes, visemes, certainties_of(labels, n), soft)


def _examples(
    task: tuple[LabelledUtterance, int, int, NDArray[np.float16] | None],
) -> tuple[TrainingExample, ...] | EngineError:
    """Make the examples of one utterance; an error travels back as a value, since it must survive the way."""
    utterance, n_variations, seed, heard = task
    generator = np.random.default_rng([seed, *utterance.path.name.encode()])
    try:
        samples = _sound_of(utterance)
    except EngineError as error:
        return EngineError(str(error))
    variations = [Augmentation(), *(draw_augmentation(generator) for _ in range(n_variations))]
    return tuple(_augmented_example(samples, utterance.labels, v, generator, heard) for v in variations)


def _sound_of(utterance: LabelledUtterance) -> Float32Array:
    with utterance.opened() as reader:
        return reader.read_mono()


def _augmented_example(
    samples: Float32Array, labels: tuple[Label, ...], variation: Augmentation, generator: np.random.Generator,
    heard: NDArray[np.float16] | None,
) -> TrainingExample:  # fmt: skip
    moved = tuple(
        replace(label, start=label.start / variation.rate, end=label.end / variation.rate) for label in labels
    )
    if heard is not None:
        frames = (np.arange(int(len(heard) / variation.rate)) + 0.5) * variation.rate
        heard = heard[np.minimum(frames.astype(int), len(heard) - 1)]
    return example_of(augment(samples, variation, generator), moved, round(variation.warp, 2), heard)


def certainties_of(labels: tuple[Label, ...], n: int) -> NDArray[np.float16]:
    """Return how much each of n frames counts, 0..1, shape (n,)."""
    times = (np.arange(n) + 0.5) * 0.01
    certainties = np.zeros(n, np.float16)
    for label in labels:
        certainties[(times >= label.start) & (times < label.end)] = CERTAINTIES.get(label.certainty, 0.0)
    return certainties


def _windows_of(samples: Float32Array) -> Iterator[Float32Array]:
    framer = Framer()
    for windows in (framer.cut_frames(samples), framer.finish()):
        for k in range(0, len(windows), TOGETHER):
            yield windows[k : k + TOGETHER]


@lru_cache(maxsize=64)
def _bank(warp: float) -> Float32Array:
    return warped_mel_bank(warp)
