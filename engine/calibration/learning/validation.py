"""How well a model does on speakers that it was not trained on."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from engine.calibration.learning.lesson_book import Voice
from engine.calibration.learning.lessons import CERTAINTIES, Lesson
from engine.calibration.scores.corpus import FrameLabels
from engine.calibration.scores.scoring import Codes
from engine.dsp.log_mel import FLOOR, N_BANDS
from engine.recognition.learned import network_of
from engine.recognition.model import Model
from engine.recognition.statistics import UNREPLACED, Statistics

CERTAIN = CERTAINTIES["core"]
N_ANCHORS, N_FRAMES = 32, 150
"""Anchors, and frames of each."""


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


def anchors_of(voices: Sequence[Voice], seed: int) -> NDArray[np.float32]:
    """Draw stretches of the speech, shape (n, n_frames, 40): of voices that count more, more often."""
    generator = np.random.default_rng(seed)
    long = [[r[0] for r in voice.recordings if len(r[0]) >= N_FRAMES] for voice in voices]
    weights = np.array([voice.weight * bool(some) for voice, some in zip(voices, long, strict=True)])
    if not weights.any():
        return np.zeros((0, N_FRAMES, N_BANDS), np.float32)
    found = []
    for k in generator.choice(len(voices), N_ANCHORS, p=weights / weights.sum()):
        lesson = long[k][generator.integers(len(long[k]))]
        first = int(generator.integers(len(lesson) - N_FRAMES + 1))
        found.append(np.asarray(lesson.log_powers[first : first + N_FRAMES], np.float32))
    return np.stack(found)


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
