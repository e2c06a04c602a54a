"""How well a model does on speakers that it was not trained on."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from engine.calibration.corpus import FrameLabels
from engine.calibration.learning.lesson_book import Voice
from engine.calibration.learning.lessons import CERTAINTIES, Lesson
from engine.calibration.scoring import Codes
from engine.dsp.log_mel import FLOOR, N_BANDS
from engine.phonemes import Phoneme
from engine.recognition.learned import network_of
from engine.recognition.model import Model
from engine.recognition.statistics import UNREPLACED, Statistics

CERTAIN = CERTAINTIES["core"]
N_HEARD, N_FRAMES, N_ANCHORS = 600, 60, 120
"""Recordings that are looked through for anchors, frames of each, and anchors of each phoneme."""


def folds_of(names: Sequence[str], n_folds: int) -> list[set[str]]:
    """Deal the speakers into groups, the kinds evenly: names that begin alike lie in different ones."""
    ordered = sorted(names)
    return [set(ordered[k::n_folds]) for k in range(n_folds)]


def answers_of(model: Model, voices: Iterable[Voice], hold: float) -> list[tuple[str, FrameLabels, Codes]]:
    """Recognise all recordings as they are; gives name of the speaker, labels and codes of each."""
    return [
        (voice.name, _labels_of(recording[0]), _codes_of(model, recording[0], hold))
        for voice in voices
        for recording in voice.recordings
        if len(recording[0])
    ]


def anchors_of(model: Model, voices: Sequence[Voice], seed: int) -> NDArray[np.float32]:
    """Give what the network finds in frames of all voices, as many of each phoneme, shape (n, n_channels)."""
    generator = np.random.default_rng(seed)
    recordings = [recording[0] for voice in voices for recording in voice.recordings]
    chosen = [recordings[k] for k in generator.permutation(len(recordings))[:N_HEARD]]
    n_ahead = len(model.heads) - 1
    found, phonemes = [], []
    for lesson in chosen:
        hidden = hidden_of(model, lesson)[n_ahead:]
        certain = np.flatnonzero(lesson.certainties == CERTAIN)
        at = generator.permutation(certain)[:N_FRAMES]
        found.append(hidden[at])
        phonemes.append(lesson.phonemes[at])
    codes = np.concatenate(phonemes)
    kept = np.concatenate([np.flatnonzero(codes == p)[:N_ANCHORS] for p in Phoneme])
    anchors: NDArray[np.float32] = np.concatenate(found)[kept]
    return anchors


def hidden_of(model: Model, lesson: Lesson) -> NDArray[np.float32]:
    """Run the network over a lesson, and as many frames of silence after it as the model looks ahead."""
    after = np.full((len(model.heads) - 1, N_BANDS), np.log10(FLOOR), np.float32)
    return network_of(model).push(np.concatenate((lesson.log_powers.astype(np.float32), after)))


def _labels_of(lesson: Lesson) -> FrameLabels:
    return FrameLabels(np.asarray(lesson.phonemes), lesson.certainties == CERTAIN)


def _codes_of(model: Model, lesson: Lesson, hold: float) -> Codes:
    head = model.heads[-1]
    scores = hidden_of(model, lesson)[len(model.heads) - 1 :] @ head.weights + head.bias
    return Statistics(hold, UNREPLACED).push(scores.argmax(axis=1).astype(np.uint8))
