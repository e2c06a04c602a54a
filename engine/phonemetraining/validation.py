"""How well a model does on speakers that it was not trained on, before and after it knows a few seconds of them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import Predictions, predict
from phonemeengine.calibration.scores.scoring import Answers, scores_of
from phonemeengine.dsp.log_mel import N_BANDS
from phonemeengine.encoder.head import load_head
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.encoded import OVERLAP, STRETCH, EncodedRecogniser
from phonemeengine.recognition.learned import LearnedRecogniser
from phonemeengine.recognition.model import Model
from phonemeengine.recognition.scores import Sensitivity
from phonemeengine.recognition.smoothing import UNREPLACED
from phonemeengine.recognition.spec import LEARNED
from phonemeengine.settings import HOP, AnalysisSettings
from phonemetraining.examples import HEAD, SOFT_LABELS, SpeakerExamples, key_of, load_soft_labels

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


OTHER_LOOK_AHEADS = (0.0, 0.01, 0.02, 0.03, 0.04)
"""Seconds that are tried besides that of the settings, on every `SAMPLED`th recording."""
SAMPLED = 8
SETTINGS = AnalysisSettings(look_ahead=0.05, minimum_hold=0.01, hysteresis=0.1)
"""How a trained model is used, and so how it is validated."""
N_ANCHORS, N_FRAMES = 32, 150
"""Anchors, and frames of each."""


def folds_of(names: Sequence[str], n_folds: int) -> list[set[str]]:
    """Deal the speakers into groups, the kinds evenly: names that begin alike lie in different ones."""
    ordered = sorted(names)
    return [set(ordered[k::n_folds]) for k in range(n_folds)]


@dataclass(frozen=True)
class HeldOutGroup:
    """How a model did on speakers whom it had not heard.

    Attributes
    ----------
    heard : each of their recordings.
    adapted : some of them, before and after it knew a few seconds of their speakers; of a model for live sound.
    """

    heard: list["HeldOut"]
    adapted: list[Adapted]


@dataclass(frozen=True)
class HeldOut:
    """How a model recognised a recording of somebody whom it had not heard.

    Attributes
    ----------
    predictions : as a user's program gets them; confidences are the scores of what was named.
    answers : with other look-aheads, by these in seconds; of some recordings only.
    with_encoder : together with what the teacher heard, as files are heard with the ear ``whisper``; None without.
    """

    predictions: Predictions
    answers: dict[float, Answers]
    with_encoder: Predictions | None = None


def hear_held_out(model: Model, utterances: Sequence[LabelledUtterance], teacher: Path | None = None) -> HeldOutGroup:
    """Recognise recordings as a user's program does, some with other look-aheads, and some once it knows the voice.

    Parameters
    ----------
    model : a network that has not heard their speakers.
    utterances : the recordings.
    teacher : the folder with what heads that had not heard their speakers either say of them, as `teach` writes it.

    Raises
    ------
    AudioError : a sound cannot be read.
    """
    preset = preset_of(model)
    known = None
    if teacher is not None and model.centred:
        known = load_soft_labels(teacher / SOFT_LABELS), load_head(teacher / HEAD).priors
    found = []
    for k, utterance in enumerate(utterances):
        tried = () if model.centred or k % SAMPLED else OTHER_LOOK_AHEADS
        others = {s: replace(preset, settings=replace(SETTINGS, look_ahead=s)) for s in tried}
        answers = {seconds: predict(utterance, other).answers for seconds, other in others.items()}
        predictions = predict(utterance, preset)
        if answers:
            answers[SETTINGS.look_ahead] = predictions.answers
        with_encoder = None
        if known is not None:
            soft_labels, priors = known
            with_encoder = _with_encoder(utterance, preset, soft_labels[key_of(utterance)], priors)
        found.append(HeldOut(predictions, answers, with_encoder))
    return HeldOutGroup(found, [] if model.centred else list(adapted_to_each(preset, utterances)))


def _with_encoder(
    utterance: LabelledUtterance, preset: Preset, heard: NDArray[np.float16], priors: Float32Array
) -> Predictions:
    """Recognise a recording by the network together with what the teacher heard in it."""
    assert preset.model is not None
    shares, n_heard = heard.astype(np.float32), 0

    def hear(samples: Float32Array) -> Float32Array:
        nonlocal n_heard
        first, n_heard = max(0, n_heard - OVERLAP), n_heard + STRETCH
        return shares[first : first + -(-len(samples) // HOP)]

    network = LearnedRecogniser(preset.model, SETTINGS.look_ahead)
    return predict(utterance, preset, recogniser=EncodedRecogniser(network, hear, priors, Sensitivity({})))


def figures_by_look_ahead(held_out: Sequence[HeldOut]) -> dict[float, tuple[float, float]]:
    """Return macro F1 and the share of right mouth shapes by the look-ahead in seconds."""
    scores = {
        seconds: scores_of(heard.answers[seconds] for heard in held_out if heard.answers)
        for seconds in sorted({s for heard in held_out for s in heard.answers})
    }
    return {seconds: (s.macro_f1, s.viseme_accuracy) for seconds, s in scores.items()}


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
