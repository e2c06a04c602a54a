"""How well a model does on speakers that it was not trained on."""

from collections.abc import Iterable, Sequence

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.learning.example_cache import SpeakerExamples
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.smoothing import UNREPLACED
from phonemeengine.recognition.spec import LEARNED
from phonemeengine.settings import AnalysisSettings

SETTINGS = AnalysisSettings(look_ahead=0.05, minimum_hold=0.01, hysteresis=0.1)
"""How a trained model is used, and so how it is validated."""
N_ANCHORS, N_FRAMES = 32, 150
"""Anchors, and frames of each."""


def folds_of(names: Sequence[str], n_folds: int) -> list[set[str]]:
    """Deal the speakers into groups, the kinds evenly: names that begin alike lie in different ones."""
    ordered = sorted(names)
    return [set(ordered[k::n_folds]) for k in range(n_folds)]


def predictions_of(model: Model, utterances: Iterable[LabelledUtterance]) -> list[Predictions]:
    """Recognise recordings as a user's program does.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    preset = preset_of(model)
    return [predict(utterance, preset) for utterance in utterances]


def preset_of(model: Model) -> Preset:
    """Return the preset by which a trained model is used."""
    return Preset(recogniser=LEARNED.name, model=model, settings=SETTINGS, successors=UNREPLACED)


def anchors_of(voices: Sequence[SpeakerExamples], seed: int) -> Float32Array:
    """Draw stretches of the speech, shape (n, n_frames, 40): of voices that count more, more often."""
    generator = np.random.default_rng(seed)
    long = [[r[0] for r in voice.recordings if len(r[0]) >= N_FRAMES] for voice in voices]
    weights = np.array([voice.weight * bool(some) for voice, some in zip(voices, long, strict=True)])
    if not weights.any():
        return np.zeros((0, N_FRAMES, N_BANDS), np.float32)
    found = []
    for k in generator.choice(len(voices), N_ANCHORS, p=weights / weights.sum()):
        example = long[k][generator.integers(len(long[k]))]
        first = int(generator.integers(len(example) - N_FRAMES + 1))
        found.append(np.asarray(example.log_powers[first : first + N_FRAMES], np.float32))
    return np.stack(found)
