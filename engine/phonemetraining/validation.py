"""How well a model does on speakers that it was not trained on, before and after it knows a few seconds of them."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.calibration.scores.scoring import Answers, scores_of
from phonemeengine.encoder.live import LOOK_AHEADS, LiveEncoder
from phonemeengine.execution import end_with_parent
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import OVERLAP, STRETCH, EncodedRecogniser, LearnedRecogniser
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.scores import Sensitivity
from phonemeengine.recognition.searched import searched
from phonemeengine.recognition.segments import UNREPLACED
from phonemeengine.recognition.spec import LEARNED
from phonemeengine.settings import FRAME_PERIOD, HOP, AnalysisSettings, ModelKind
from phonemetraining.processes import in_processes

LEAST_READ, MOST_READ = 5.0, 10.0
"""Seconds that are learned: of one recording, or of the first ones that are as long together."""
MOST_JUDGED = 12
"""Further recordings of each speaker that are recognised before and after."""


class Adapted(NamedTuple):
    """What was answered in a recording of a speaker, before and after others of his were learned."""

    voice: str
    before: Answers
    after: Answers


def adapted_to_each(preset: Preset, utterances: Sequence[LabelledUtterance]) -> Iterator[Adapted]:
    """Have a preset learn some seconds of each speaker, as `calibrate` does, and recognise others of his recordings.

    Speakers of whom there is too little are left out.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    by_voice: dict[str, list[LabelledUtterance]] = {}
    for utterance in utterances:
        by_voice.setdefault(utterance.voice, []).append(utterance)
    for voice, said in by_voice.items():
        read = _some_seconds_of(said)
        others = [utterance for utterance in said if utterance not in read][:MOST_JUDGED]
        if not read or not others:
            continue
        learned = calibrate(preset, read).preset
        for other in others:
            yield Adapted(voice, predict(other, preset).answers, predict(other, learned).answers)


def _some_seconds_of(utterances: Sequence[LabelledUtterance]) -> list[LabelledUtterance]:
    for utterance in utterances:
        if LEAST_READ <= _seconds(utterance) <= MOST_READ:
            return [utterance]
    found: list[LabelledUtterance] = []
    for utterance in utterances:
        found.append(utterance)
        if sum(map(_seconds, found)) >= LEAST_READ:
            return found if sum(map(_seconds, found)) <= MOST_READ else []
    return []


def _seconds(utterance: LabelledUtterance) -> float:
    return utterance.labels[-1].end if utterance.labels else 0.0


LOOK_AHEADS_TRIED = {
    ModelKind.REAL_TIME: (0.0, 0.01, 0.02, 0.03, 0.04, 0.05),
    ModelKind.ENCODER: tuple(n * FRAME_PERIOD for n in LOOK_AHEADS),
}
"""Seconds that are tried with each model for live sound, on every `SAMPLED`th recording."""
SAMPLED = 8
SETTINGS = AnalysisSettings(look_ahead=0.05, minimum_hold=0.01, hysteresis=0.1)
"""How a trained model is used, and so how it is validated."""


def recognise_all(
    utterances: Sequence[LabelledUtterance],
    model: Model,
    on_progress: Callable[[float], object],
    encoder: LiveEncoder | None = None,
) -> list[Predictions]:
    """Recognise recordings as a user's program does; as many at a time as there are cores.

    Parameters
    ----------
    utterances : the recordings.
    model : a small network.
    on_progress : called with the share that is done.
    encoder : the real-time model that recognises with it; None for none.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    found = []
    for k, predictions in enumerate(in_processes(_predict, (utterances,), _use, (model, encoder)), 1):
        found.append(predictions)
        on_progress(k / len(utterances))
    return found


_preset: Preset


def _use(model: Model, encoder: LiveEncoder | None) -> None:
    global _preset  # noqa: PLW0603 - a process gets it once, as it begins
    end_with_parent()
    _preset = preset_of(model, encoder)


def _predict(utterance: LabelledUtterance) -> Predictions:
    return predict(utterance, _preset)


def with_head(
    utterance: LabelledUtterance, preset: Preset, soft_labels: NDArray[np.float16], priors: Float32Array
) -> Predictions:
    """Recognise a recording by the network for files together with what the teacher said of it.

    Parameters
    ----------
    utterance : the recording.
    preset : of the network.
    soft_labels : probabilities by a head that did not learn from the speaker, shape (n_frames, 26).
    priors : of the head.
    """
    assert preset.model is not None
    shares, n_taken = soft_labels.astype(np.float32), 0

    def states(samples: Float32Array) -> Float32Array:
        nonlocal n_taken
        first, n_taken = max(0, n_taken - OVERLAP), n_taken + STRETCH
        return shares[first : first + -(-len(samples) // HOP)]

    network = LearnedRecogniser(preset.model, SETTINGS.look_ahead)
    both = EncodedRecogniser(network, states, priors, Sensitivity({}))
    return predict(utterance, preset, recogniser=searched(both, preset.search))


def recognise_by_look_ahead(
    utterances: Sequence[LabelledUtterance], preset: Preset
) -> dict[float, tuple[float, float]]:
    """Return macro F1 and the share of right mouth shapes by the look-ahead, seconds, on every 8th recording."""
    found = {}
    for seconds in LOOK_AHEADS_TRIED[preset.model_kind]:
        other = replace(preset, settings=replace(SETTINGS, look_ahead=seconds))
        scores = scores_of(predict(utterance, other).answers for utterance in utterances[::SAMPLED])
        found[seconds] = (scores.macro_f1, scores.viseme_accuracy)
    return found


def preset_of(model: Model, encoder: LiveEncoder | None = None) -> Preset:
    """Return the preset by which a trained model is used, maybe together with a real-time model."""
    preset = Preset(recogniser=LEARNED.name, model=model, settings=SETTINGS, successors=UNREPLACED)
    return preset if encoder is None else replace(preset, live_encoder=encoder, model_kind=ModelKind.ENCODER)
