"""All lessons in files: they are too many for the memory of a small machine, and several trainings share them."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from phonemeengine.calibration.learning.training_examples import TrainingExample, examples_of
from phonemeengine.calibration.scores.corpus import Utterance
from phonemeengine.dsp.log_mel import N_BANDS

OpenSounds = tuple[tuple[TrainingExample, ...], ...]


@dataclass(frozen=True)
class SpeakerExamples:
    """All lessons of one speaker.

    Attributes
    ----------
    name : who, as corpus/speaker.
    recordings : for each recording its variations; the first one is the recording as it is.
    weight : how often it is gone through in an epoch; below 1, only that share of it.
    """

    name: str
    recordings: OpenSounds
    weight: float = 1.0


@dataclass(frozen=True)
class _Entry:
    """Where the variations of a recording lie."""

    voice: str
    lengths: tuple[int, ...]


def write_examples(
    folder: Path, utterances: Sequence[Utterance], n_variations: int, seed: int,
    progress: Callable[[int], object] = lambda _n: None,
) -> None:  # fmt: skip
    """Make all lessons and write them into a folder; `progress` is told of each recording.

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
        for utterance, lessons in zip(utterances, examples_of(utterances, n_variations, seed), strict=True):
            for lesson in lessons:
                powers.write(lesson.log_powers.tobytes())
                phonemes.write(lesson.phonemes.tobytes())
                certainties.write(lesson.certainties.tobytes())
            entries.append(_Entry(utterance.voice, tuple(len(lesson) for lesson in lessons)))
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
        lessons = []
        for n in entry["lengths"]:
            part = slice(first, first + n)
            lessons.append(TrainingExample(powers[part], phonemes[part], certainties[part]))
            first += n
        recordings.setdefault(entry["voice"], []).append(tuple(lessons))
    return [SpeakerExamples(name, tuple(sounds), weights.get(name, 1.0)) for name, sounds in recordings.items()]
