"""Several trainings at a time, one a core, each without some speakers, who are then recognised."""

import multiprocessing
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, wait
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.execution import end_with_parent, single_threaded
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, load_model, save_model
from phonemetraining.examples import read_examples
from phonemetraining.training import Checkpoint, TrainingConfig, train
from phonemetraining.validation import anchors_of

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
        jobs = [
            pool.submit(_train_without, k, part, examples, weights, answers_of) for k, part in enumerate(parts)
        ]  # fmt: skip
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
    number: int, part: TrainingPart, examples: Path, weights: dict[str, float],
    answers_of: Callable[[Model, Sequence[LabelledUtterance]], Answer],
) -> tuple[Model, Answer]:  # fmt: skip
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
