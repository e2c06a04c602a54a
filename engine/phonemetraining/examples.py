"""The examples of all recordings, each varied several times, made and kept in files.

They are too many for the memory of a small machine, and several trainings share them.
"""

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.training_examples import N_HEARD, TrainingExample, example_of, sound_of
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.errors import CorpusError, EngineError
from phonemeengine.execution import end_with_parent
from phonemeengine.labels.label import Label
from phonemeengine.storage.files import atomic_write, reason_of
from phonemetraining.augmentation import Augmentation, augment, draw_augmentation

# Soft labels: what a teacher that knows many more voices heard in recordings, kept on disk.

SOFT_LABELS, HEAD = "heard.npz", "head.npz"
"""Files of what the teacher heard, and of a head that heard all."""

SoftLabels = Mapping[str, NDArray[np.float16]]
"""By the key of the recording: shape (n_frames, 26), frames of 10 ms."""


def key_of(utterance: LabelledUtterance) -> str:
    """Return the name of a recording among the soft labels: corpus/speaker/file, without the file's ending."""
    return f"{utterance.voice}/{utterance.path.stem}"


def save_soft_labels(soft_labels: SoftLabels, path: Path) -> None:
    """Write soft labels into an ``.npz``."""
    np.savez(path, allow_pickle=False, **soft_labels)


def load_soft_labels(path: Path) -> dict[str, NDArray[np.float16]]:
    """Read soft labels.

    Raises
    ------
    CorpusError : the file cannot be read, or holds other arrays.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            found = {name: file[name] for name in file.files}
    except (OSError, ValueError, EOFError) as error:
        reason = reason_of(error) if isinstance(error, OSError) else "it is damaged"
        raise CorpusError(
            f"{path.name}: the soft labels cannot be read ({reason}); let the teacher hear again"
        ) from error
    if any(a.ndim != 2 or a.shape[1] != N_HEARD or a.dtype != np.float16 for a in found.values()):
        raise CorpusError(f"{path.name}: these are no soft labels of this version; let the teacher hear again")
    return found


ARRAYS: dict[str, tuple[type[np.generic], tuple[int, ...]]] = {
    "log_powers": (np.float16, (N_BANDS,)),
    "phonemes": (np.uint8, ()),
    "visemes": (np.uint8, ()),
    "certainties": (np.float16, ()),
    "heard": (np.float16, (N_HEARD,)),
}
"""The arrays of an example, each in a file of its own: kind, and shape of a frame."""
INDEX = "index.json"
Variations = tuple[tuple[TrainingExample, ...], ...]


@dataclass(frozen=True)
class SpeakerExamples:
    """All examples of one speaker.

    Attributes
    ----------
    name : who, as corpus/speaker.
    recordings : for each recording its variations; the first one is the recording as it is.
    weight : how often it is gone through in an epoch; below 1, only that share of it.
    """

    name: str
    recordings: Variations
    weight: float = 1.0


@dataclass(frozen=True)
class _Entry:
    """Where the variations of a recording lie."""

    voice: str
    lengths: tuple[int, ...]


def write_examples(
    folder: Path,
    utterances: Sequence[LabelledUtterance],
    n_variations: int,
    seed: int,
    soft_labels: SoftLabels | None = None,
    progress: Callable[[int], object] = lambda _n: None,
) -> None:
    """Make all examples and write them into a folder, last of all its index; `progress` is told of each recording.

    Raises
    ------
    EngineError : a sound cannot be read.
    """
    entries = []
    with ExitStack() as stack:
        files = {name: stack.enter_context((folder / name).open("wb")) for name in ARRAYS}
        made = examples_of(utterances, n_variations, seed, soft_labels)
        for utterance, examples in zip(utterances, made, strict=True):
            for example in examples:
                for name, file in files.items():
                    file.write(getattr(example, name).tobytes())
            entries.append(_Entry(utterance.voice, tuple(len(example) for example in examples)))
            progress(1)
    with atomic_write(folder / INDEX) as index:
        index.write(json.dumps([asdict(entry) for entry in entries]).encode())


def read_examples(folder: Path, weights: dict[str, float]) -> list[SpeakerExamples]:
    """Read the voices from a folder; their arrays stay on the disk. `weights` tells the weight of each by name."""
    arrays: dict[str, NDArray[Any]] = {
        name: np.memmap(folder / name, kind, "r").reshape(-1, *shape) for name, (kind, shape) in ARRAYS.items()
    }
    recordings: dict[str, list[tuple[TrainingExample, ...]]] = {}
    first = 0
    for entry in json.loads((folder / INDEX).read_text()):
        examples = []
        for n in entry["lengths"]:
            part = slice(first, first + n)
            examples.append(TrainingExample(**{name: array[part] for name, array in arrays.items()}))
            first += n
        recordings.setdefault(entry["voice"], []).append(tuple(examples))
    return [SpeakerExamples(name, tuple(sounds), weights.get(name, 1.0)) for name, sounds in recordings.items()]


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


def _examples(
    task: tuple[LabelledUtterance, int, int, NDArray[np.float16] | None],
) -> tuple[TrainingExample, ...] | EngineError:
    """Make the examples of one utterance; an error travels back as a value, since it must survive the way."""
    utterance, n_variations, seed, heard = task
    generator = np.random.default_rng([seed, *utterance.path.name.encode()])
    try:
        samples = sound_of(utterance)
    except EngineError as error:
        return EngineError(str(error))
    variations = [Augmentation(), *(draw_augmentation(generator) for _ in range(n_variations))]
    return tuple(_augmented_example(samples, utterance.labels, v, generator, heard) for v in variations)


def _augmented_example(
    samples: Float32Array,
    labels: tuple[Label, ...],
    variation: Augmentation,
    generator: np.random.Generator,
    heard: NDArray[np.float16] | None,
) -> TrainingExample:
    moved = tuple(
        replace(label, start=label.start / variation.rate, end=label.end / variation.rate) for label in labels
    )
    if heard is not None:
        frames = (np.arange(int(len(heard) / variation.rate)) + 0.5) * variation.rate
        heard = heard[np.minimum(frames.astype(int), len(heard) - 1)]
    return example_of(augment(samples, variation, generator), moved, round(variation.warp, 2), heard)
