"""The training of the learned recogniser: examples in, a model out; interrupted, it goes on where it was."""

import json
import multiprocessing
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, wait
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array, UInt8Array
from phonemeengine.calibration.fine_tuning import Optimiser
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.execution import end_with_parent, single_threaded
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, load_model, save_model
from phonemeengine.storage.files import atomic_write
from phonemetraining.augmentation import augment_spectra
from phonemetraining.examples import ARRAYS, SpeakerExamples, read_examples
from phonemetraining.trainable_network import TrainableNetwork, targets_of
from phonemetraining.validation import anchors_of


class Checkpoint:
    """A file with the state of a training.

    Parameters
    ----------
    path : where it lies; it need not be there yet.
    """

    def __init__(self, path: Path) -> None:
        self._path = path

    def keep(self, state: Sequence[Float32Array], generator: np.random.Generator, step: int) -> None:
        """Write the state; the older one stays until the new one is complete."""
        about = json.dumps({"step": step, "generator": generator.bit_generator.state}).encode()
        with atomic_write(self._path) as file:
            np.savez(file, allow_pickle=False, about=np.frombuffer(about, np.uint8), **_named(state))

    def restore(self, state: Sequence[Float32Array], generator: np.random.Generator) -> int:
        """Read the state into the arrays and the generator, if there is one; returns the number of steps done."""
        if not self._path.is_file():
            return 0
        with np.load(self._path, allow_pickle=False) as file:
            for name, array in _named(state).items():
                array[...] = file[name]
            about = json.loads(file["about"].tobytes())
        generator.bit_generator.state = about["generator"]
        return int(about["step"])


def _named(state: Sequence[Float32Array]) -> dict[str, Float32Array]:
    return {f"array_{k}": array for k, array in enumerate(state)}


RARE = 0.35
"""How much more the frames of a rare sound count: the power of its share; 1 would make all sounds count alike."""
BOTH_WAYS = (1, 2, 4, 8, 16, 16, 1, 2)
"""Dilations of the network that hears 0.5 s each way."""


AVERAGED = 300
"""Steps over which the average reaches back, about."""


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


class ExponentialAverage:
    """A slow average of arrays (B. Polyak and A. Juditsky, SIAM J. Control Optim. 30(4), 1992)."""

    def __init__(self, values: list[Float32Array]) -> None:
        self._values = values
        self.means = [v.copy() for v in values]
        self.n_done = 0

    def update(self) -> None:
        """Take in what the arrays are now."""
        self.n_done += 1
        share = np.float32(max(1 / AVERAGED, 10 / (self.n_done + 10)))
        for mean, value in zip(self.means, self._values, strict=True):
            np.add(mean, share * (value - mean), out=mean)

    def apply(self) -> None:
        """Write the averages into the arrays."""
        for mean, value in zip(self.means, self._values, strict=True):
            value[...] = mean


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


# Several trainings at a time, one a core, each without some speakers, who are then recognised.

HESITATION = 0.2
"""How much more an unidentified sound must be the likeliest, in units of the logarithm of its probability: its frames
are many and of all sorts, and a mouth that stands still where somebody speaks is noticed."""
WARPS = (0.8, 1.0, 1.2)
"""Vocal tracts that a model listens with, see `phonemeengine.recognition.learned`; adult voices span about that."""

Answer = TypeVar("Answer")


@dataclass(frozen=True)
class TrainingPart:
    """One training.

    Attributes
    ----------
    name : of its files: the model, and the state of a training that goes on.
    config : how.
    left_out : recordings of those speakers who do not take part.
    """

    name: str
    config: TrainingConfig
    left_out: tuple[LabelledUtterance, ...] = ()


def train_parts(
    parts: Sequence[TrainingPart],
    examples: Path,
    weights: dict[str, float],
    answers_of: Callable[[Model, Sequence[LabelledUtterance]], Answer],
    on_progress: Callable[[float], object],
) -> list[tuple[Model, Answer]]:
    """Return the model of each training and its answers in what was left out; as many at a time as there are cores.

    Parameters
    ----------
    parts : the trainings.
    examples : the folder with all examples; the models are written there too, and those that are there are taken.
    weights : of the speakers by their names.
    answers_of : lets a model recognise recordings, in a process of its own.
    on_progress : is told of the share that is done.
    """
    spawned = multiprocessing.get_context("spawn")
    done = spawned.Array("d", len(parts))
    with single_threaded(), ProcessPoolExecutor(os.cpu_count(), spawned, _share, (done,)) as pool:
        jobs = [pool.submit(_train_without, k, part, examples, weights, answers_of) for k, part in enumerate(parts)]
        while wait(jobs, timeout=0.5).not_done:
            on_progress(sum(done[:]) / len(jobs))
        return [job.result() for job in jobs]


_done: Any = None
"""How far each training is, 0..1, shared by the processes."""


def _share(done: Any) -> None:
    global _done  # noqa: PLW0603 - a process is told once, at its beginning
    end_with_parent()
    _done = done


def _train_without(
    number: int,
    part: TrainingPart,
    examples: Path,
    weights: dict[str, float],
    answers_of: Callable[[Model, Sequence[LabelledUtterance]], Answer],
) -> tuple[Model, Answer]:
    """Train on all voices but those left out, and let the model recognise these."""
    path, state = examples / f"{part.name}.npz", examples / f"{part.name}-state.npz"
    if not path.is_file():
        strange = {utterance.voice for utterance in part.left_out}
        voices = [v for v in read_examples(examples, weights) if v.name not in strange]

        def count(step: int, n_steps: int, _loss: float) -> None:
            _done[number] = step / n_steps

        model = _hesitant(train(voices, part.config, count, Checkpoint(state)))
        save_model(replace(model, warps=WARPS, anchors=anchors_of(voices, part.config.seed)), path)
        state.unlink(missing_ok=True)
    _done[number] = 1.0
    model = load_model(path)
    return model, answers_of(model, part.left_out)


def _hesitant(model: Model) -> Model:
    less = np.zeros(len(Phoneme), np.float32)
    less[Phoneme.UNIDENTIFIED] = HESITATION
    return replace(model, heads=tuple(replace(head, bias=head.bias - less) for head in model.heads))
