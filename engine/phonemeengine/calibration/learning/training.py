"""The training of the learned recogniser: examples in, a model out."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.learning.augment_spectrum import augment_spectra
from phonemeengine.calibration.learning.checkpoint import Checkpoint
from phonemeengine.calibration.learning.example_cache import ARRAYS, SpeakerExamples
from phonemeengine.calibration.learning.optimiser import ExponentialAverage, Optimiser
from phonemeengine.calibration.learning.targets import targets_of
from phonemeengine.calibration.learning.trainable_network import TrainableNetwork
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model
from phonemeengine.visemes import Viseme

RARE = 0.35
"""How much more the frames of a rare sound count: the power of its share; 1 would make all sounds count alike."""
BOTH_WAYS = (1, 2, 4, 8, 16, 16, 1, 2)
"""Dilations of the network that hears 0.5 s each way."""


@dataclass(frozen=True)
class TrainingConfig:
    """How a network is trained.

    Attributes
    ----------
    width, dilations, dropout : of the network.
    centred : whether it hears as far ahead as back.
    n_epochs : times that everything is gone through.
    batch_size, n_frames : size of a batch: so many stretches of so many frames.
    rate : the highest learning rate.
    seed : of all chance.
    """

    width: int = 112
    dilations: tuple[int, ...] = (1, 2, 4, 8, 16, 1, 2, 4)
    dropout: float = 0.1
    centred: bool = False
    n_epochs: int = 10
    batch_size: int = 8
    n_frames: int = 400
    rate: float = 4e-3
    seed: int = 1


def train(
    voices: Sequence[SpeakerExamples],
    config: TrainingConfig,
    progress: Callable[[int, int, float], object] = lambda *_: None,
    checkpoint: Checkpoint | None = None,
) -> Model:
    """Train a model.

    Parameters
    ----------
    voices : what to learn from.
    config : how.
    progress : is told the step, the number of steps and the loss.
    checkpoint : keeps the state after each epoch; a training that was interrupted goes on from there, and ends
        with the same model.
    """
    generator = np.random.default_rng(config.seed)
    network = TrainableNetwork(config.width, config.dilations, config.dropout, generator, centred=config.centred)
    importance, viseme_importance = _importance(voices)
    n_steps = config.n_epochs * sum(1 for _ in _batches(voices, config, np.random.default_rng(config.seed)))
    optimiser = Optimiser(network.values, n_steps, config.rate, network.hidden)
    average = ExponentialAverage([*network.values, *network.statistics])
    state = [*network.values, *network.statistics, *optimiser.moments, *average.means]
    step = 0 if checkpoint is None else checkpoint.restore(state, generator)
    optimiser.n_done = average.n_done = step
    while step < n_steps:
        for log_powers, codes, visemes, certainties, heard in _batches(voices, config, generator):
            augmented = augment_spectra(np.power(np.float32(10), log_powers.astype(np.float32)), generator)
            counts, soft = certainties.astype(np.float32), heard.astype(np.float32)
            phoneme_targets = targets_of(codes, soft[..., : len(Phoneme)], importance, counts)
            viseme_targets = targets_of(visemes, soft[..., len(Phoneme) :], viseme_importance, counts)
            loss = network.learn(augmented, phoneme_targets, viseme_targets)
            optimiser.step(network.gradients)
            average.update()
            step += 1
            progress(min(step, n_steps), n_steps, loss)
            if step == n_steps:
                break
        if checkpoint is not None:
            checkpoint.keep(state, generator, step)
    average.apply()
    return network.finished()


Batch = tuple[NDArray[np.float16], UInt8Array, UInt8Array, NDArray[np.float16], NDArray[np.float16]]


def _batches(
    voices: Sequence[SpeakerExamples], config: TrainingConfig, generator: np.random.Generator
) -> Iterator[Batch]:
    """Go through everything once: stretches of joined recordings of one voice, all voices mixed."""
    segments = [s for voice in voices for s in _segments(voice, config.n_frames, generator)]
    order = generator.permutation(len(segments))
    for k in range(0, len(segments) - config.batch_size + 1, config.batch_size):
        chosen = [segments[i] for i in order[k : k + config.batch_size]]
        yield tuple(np.stack(part) for part in zip(*chosen, strict=True))  # type: ignore[misc]


def _segments(voice: SpeakerExamples, n_frames: int, generator: np.random.Generator) -> Iterator[Batch]:
    n_times = int(voice.weight) + (generator.random() < voice.weight % 1)
    for _ in range(n_times):
        order = generator.permutation(len(voice.recordings))
        drawn = [voice.recordings[i][generator.integers(len(voice.recordings[i]))] for i in order]
        arrays = [np.concatenate([getattr(example, name) for example in drawn]) for name in ARRAYS]
        first = int(generator.integers(0, n_frames // 2))
        for k in range(first, len(arrays[0]) - n_frames + 1, n_frames):
            yield tuple(array[k : k + n_frames] for array in arrays)  # type: ignore[misc]


def _importance(voices: Sequence[SpeakerExamples]) -> tuple[Float32Array, Float32Array]:
    """Return how much a frame of each phoneme, and of each viseme, counts."""
    counts, visemes = np.ones(len(Phoneme)), np.ones(len(Viseme))
    for voice in voices:
        for recording in voice.recordings:
            counts += np.bincount(recording[0].phonemes, minlength=len(Phoneme))[: len(Phoneme)]
            visemes += np.bincount(recording[0].visemes, minlength=len(Viseme))[: len(Viseme)]
    weights = _rarities(counts)
    weights[Phoneme.UNIDENTIFIED] *= 0.8  # what lies between the phonemes counts a little less
    return weights, _rarities(visemes)


def _rarities(counts: Float64Array) -> Float32Array:
    weights = (counts / counts.sum()) ** -RARE
    return np.asarray(weights / weights.mean(), np.float32)
