"""The training of the learned recogniser: lessons in, a model out."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, UInt8Array
from phonemeengine.calibration.learning.augment_spectrum import augment_spectra
from phonemeengine.calibration.learning.example_cache import SpeakerExamples
from phonemeengine.calibration.learning.optimiser import ExponentialAverage, Optimiser
from phonemeengine.calibration.learning.trainable_network import TrainableNetwork
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model

RARE = 0.35
"""How much more the frames of a rare phoneme count: the power of its share; 1 would make all phonemes count alike."""


@dataclass(frozen=True)
class TrainingConfig:
    """How a network is trained.

    Attributes
    ----------
    width, dilations, dropout : of the network.
    n_epochs : times that everything is gone through.
    n_together, n_frames : size of a batch: so many stretches of so many frames.
    rate : the highest learning rate.
    seed : of all chance.
    """

    width: int = 112
    dilations: tuple[int, ...] = (1, 2, 4, 8, 16, 1, 2, 4)
    dropout: float = 0.1
    n_epochs: int = 16
    n_together: int = 24
    n_frames: int = 400
    rate: float = 2e-3
    seed: int = 1


def train(
    voices: Sequence[SpeakerExamples],
    course: TrainingConfig,
    progress: Callable[[int, int, float], object] = lambda *_: None,
) -> Model:
    """Train a model; `progress` is told the step, the number of steps and the loss."""
    generator = np.random.default_rng(course.seed)
    network = TrainableNetwork(course.width, course.dilations, course.dropout, generator)
    importance = _importance(voices)
    n_steps = course.n_epochs * sum(1 for _ in _batches(voices, course, np.random.default_rng(course.seed)))
    optimiser = Optimiser(network.values, n_steps, course.rate)
    average = ExponentialAverage([*network.values, *network.statistics])
    step = 0
    while step < n_steps:
        for log_powers, phonemes, certainties in _batches(voices, course, generator):
            heard = augment_spectra(np.power(np.float32(10), log_powers.astype(np.float32)), generator)
            loss = network.learn(heard, phonemes, importance[phonemes] * certainties)
            optimiser.step(network.gradients)
            average.update()
            step += 1
            progress(min(step, n_steps), n_steps, loss)
            if step == n_steps:
                break
    average.put()
    return network.finished()


Batch = tuple[NDArray[np.float16], UInt8Array, NDArray[np.float16]]


def _batches(
    voices: Sequence[SpeakerExamples], course: TrainingConfig, generator: np.random.Generator
) -> Iterator[Batch]:
    """Go through everything once: stretches of joined recordings of one voice, all voices mixed."""
    stretches = [s for voice in voices for s in _stretches(voice, course.n_frames, generator)]
    order = generator.permutation(len(stretches))
    for k in range(0, len(stretches) - course.n_together + 1, course.n_together):
        chosen = [stretches[i] for i in order[k : k + course.n_together]]
        yield tuple(np.stack(part) for part in zip(*chosen, strict=True))  # type: ignore[misc]


def _stretches(voice: SpeakerExamples, n_frames: int, generator: np.random.Generator) -> Iterator[Batch]:
    n_times = int(voice.weight) + (generator.random() < voice.weight % 1)
    for _ in range(n_times):
        order = generator.permutation(len(voice.recordings))
        drawn = [voice.recordings[i][generator.integers(len(voice.recordings[i]))] for i in order]
        arrays = [
            np.concatenate([getattr(lesson, name) for lesson in drawn])
            for name in ("log_powers", "phonemes", "certainties")
        ]
        first = int(generator.integers(0, n_frames // 2))
        for k in range(first, len(arrays[0]) - n_frames + 1, n_frames):
            yield tuple(array[k : k + n_frames] for array in arrays)  # type: ignore[misc]


def _importance(voices: Sequence[SpeakerExamples]) -> Float32Array:
    """Return how much a frame of each phoneme counts; what lies between the phonemes counts a little less."""
    counts = np.ones(len(Phoneme))
    for voice in voices:
        for recording in voice.recordings:
            counts += np.bincount(recording[0].phonemes, minlength=len(Phoneme))
    weights = (counts / counts.sum()) ** -RARE
    weights[Phoneme.UNIDENTIFIED] *= 0.8
    return np.asarray(weights / weights.mean(), np.float32)
