"""All examples in files: they are too many for the memory of a small machine, and several trainings share them."""

import json
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from phonemeengine.calibration.learning.soft_labels import N_HEARD, SoftLabels
from phonemeengine.calibration.learning.training_examples import TrainingExample, examples_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.files import atomic_write

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
    folder: Path, utterances: Sequence[LabelledUtterance], n_variations: int, seed: int,
    soft_labels: SoftLabels | None = None, progress: Callable[[int], object] = lambda _n: None,
) -> None:  # fmt: skip
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
