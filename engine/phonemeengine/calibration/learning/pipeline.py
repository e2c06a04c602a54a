"""From folders of labelled speech to a model and the card that tells about it."""

import multiprocessing
import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from phonemeengine.calibration.learning.example_cache import read_examples, write_examples
from phonemeengine.calibration.learning.provenance import LabelSource, sources_of
from phonemeengine.calibration.learning.training import TrainingConfig, train
from phonemeengine.calibration.learning.validation import anchors_of, folds_of, predictions_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance, read_corpus
from phonemeengine.calibration.scores.evaluation import Predictions
from phonemeengine.calibration.scores.scoring import Answers, Scores, scores_of
from phonemeengine.errors import CorpusError
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model
from phonemeengine.settings import Channel

HESITATION = 0.2
"""How much more an unidentified sound must be the likeliest, in units of the logarithm of its probability: its frames
are many and of all sorts, and a mouth that stands still where somebody speaks is noticed."""
WARPS = (0.8, 1.0, 1.2)
"""Vocal tracts that a model listens with, see `phonemeengine.recognition.vtln`; adult voices span about that."""

OnProgress = Callable[[str, float], object]
"""Is told what goes on, and how much of it is done, 0..1."""


@dataclass(frozen=True)
class TrainingResult:
    """The outcome of a training.

    Attributes
    ----------
    model : trained on all speakers.
    sources : the speakers.
    held_out : for each speaker, how well a model did that was trained without it; empty without a validation.
    everyone : the same for all together; None without a validation.
    """

    model: Model
    sources: tuple[LabelSource, ...]
    held_out: dict[str, Scores]
    everyone: Scores | None


def train_and_validate(
    corpora: Sequence[Path], config: TrainingConfig, n_variations: int, n_folds: int, on_progress: OnProgress,
    channel: Channel = Channel.MIX,
) -> TrainingResult:  # fmt: skip
    """Train a model on folders in the corpus format, and validate it on speakers left out.

    Parameters
    ----------
    corpora : the folders.
    config : how to train.
    n_variations : of each recording, besides the recording itself.
    n_folds : groups of speakers, each of which is left out once; 0 for no validation.
    on_progress : is told of the progress.
    channel : what is heard of sounds that have several.

    Raises
    ------
    CorpusError : a folder is none, or there is too little speech for a batch.
    EngineError : a sound cannot be read.
    """
    utterances = [u for corpus in corpora for u in read_corpus(corpus, channel=channel)]
    sources = tuple(sources_of(corpora))
    if sum(source.minutes for source in sources) * 60 < config.batch_size * config.n_frames * 0.02:
        raise CorpusError(
            "there is too little speech to train with; give at least ten minutes of it, of many speakers"
        )
    weights = {source.name: source.weight for source in sources}
    with tempfile.TemporaryDirectory(prefix="examples-") as folder:
        n_done = 0

        def count(n: int) -> None:
            nonlocal n_done
            n_done += n
            on_progress("measuring", n_done / len(utterances))

        write_examples(Path(folder), utterances, n_variations, config.seed, count)
        groups = [[u for u in utterances if u.voice in names] for names in folds_of(list(weights), n_folds)]
        model, predictions = _train_all(Path(folder), weights, groups, config, on_progress)
    everyone = scores_of(prediction.answers for prediction in predictions) if predictions else None
    by_name: dict[str, list[Answers]] = {}
    for prediction in predictions:
        by_name.setdefault(prediction.utterance.voice, []).append(prediction.answers)
    return TrainingResult(model, sources, {name: scores_of(pairs) for name, pairs in by_name.items()}, everyone)


def _train_all(
    folder: Path,
    weights: dict[str, float],
    groups: list[list[LabelledUtterance]],
    config: TrainingConfig,
    on_progress: OnProgress,
) -> tuple[Model, list[Predictions]]:
    """Train on everybody, and without each group; as many trainings at a time as there are cores."""
    spawned = multiprocessing.get_context("spawn")
    done = spawned.Array("d", len(groups) + 1)
    with _single_threaded(), ProcessPoolExecutor(os.cpu_count(), spawned, _share, (done,)) as pool:
        jobs = [
            pool.submit(_train_without, k, folder, weights, left_out, config)
            for k, left_out in enumerate(([], *groups))
        ]
        while wait(jobs, timeout=0.5).not_done:
            on_progress("training", sum(done[:]) / len(jobs))
        results = [job.result() for job in jobs]
    return results[0][0], [prediction for _, predictions in results for prediction in predictions]


_done: Any = None
"""How far each training is, 0..1, shared by the processes."""


def _share(done: Any) -> None:
    global _done  # noqa: PLW0603 - a process is told once, at its beginning
    _done = done


def _train_without(
    number: int, folder: Path, weights: dict[str, float], left_out: list[LabelledUtterance], config: TrainingConfig
) -> tuple[Model, list[Predictions]]:
    """Train on all voices but those left out, and let the model recognise these."""
    strange = {utterance.voice for utterance in left_out}
    voices = [v for v in read_examples(folder, weights) if v.name not in strange]

    def count(step: int, n_steps: int, _loss: float) -> None:
        _done[number] = step / n_steps

    model = _hesitant(train(voices, config, count))
    model = replace(model, warps=WARPS, anchors=anchors_of(voices, config.seed)).rounded()
    return model, predictions_of(model, left_out)


def _hesitant(model: Model) -> Model:
    less = np.zeros(len(Phoneme), np.float32)
    less[Phoneme.UNIDENTIFIED] = HESITATION
    return replace(model, heads=tuple(replace(head, bias=head.bias - less) for head in model.heads))


@contextmanager
def _single_threaded() -> Iterator[None]:
    """Let processes that are started have one thread each for their matrices: there is one for every core."""
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
