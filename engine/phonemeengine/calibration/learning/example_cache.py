"""All examples in files: they are too many for the memory of a small machine, and several trainings share them."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from phonemeengine.calibration.learning.training_examples import TrainingExample, examples_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.dsp.log_mel import N_BANDS

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
    progress: Callable[[int], object] = lambda _n: None,
) -> None:  # fmt: skip
    """Make all examples and write them into a folder; `progress` is told of each recording.

    Raises
    ------
    EngineError : a sound cannot be read.
    """
    entries = []
    with (
        (folder / "powers").open("wb") as powers,
        (folder / "phonemes").open("wb") as phonemes,
        (folder / "certainties").open("wb") as certainties,
    ):
        for utterance, examples in zip(utterances, examples_of(utterances, n_variations, seed), strict=True):
            for example in examples:
                powers.write(example.log_powers.tobytes())
                phonemes.write(example.phonemes.tobytes())
                certainties.write(example.certainties.tobytes())
            entries.append(_Entry(utterance.voice, tuple(len(example) for example in examples)))
            progress(1)
    (folder / "index.json").write_text(json.dumps([asdict(entry) for entry in entries]))


def read_examples(folder: Path, weights: dict[str, float]) -> list[SpeakerExamples]:
    """Read the voices from a folder; their arrays stay on the disk. `weights` tells the weight of each by name."""
    powers = np.memmap(folder / "powers", np.float16, "r").reshape(-1, N_BANDS)
    phonemes = np.memmap(folder / "phonemes", np.uint8, "r")
    certainties = np.memmap(folder / "certainties", np.float16, "r")
    recordings: dict[str, list[tuple[TrainingExample, ...]]] = {}
    first = 0
    for entry in json.loads((folder / "index.json").read_text()):
        examples = []
        for n in entry["lengths"]:
            part = slice(first, first + n)
            examples.append(TrainingExample(powers[part], phonemes[part], certainties[part]))
            first += n
        recordings.setdefault(entry["voice"], []).append(tuple(examples))
    return [SpeakerExamples(name, tuple(sounds), weights.get(name, 1.0)) for name, sounds in recordings.items()]
