"""What a few seconds of a stranger are worth."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.scores.corpus import LabelledUtterance
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.calibration.scores.scoring import Scores
from phonemeengine.encoder.live import build_live_encoder
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset
from phonemeengine.recognition.scores import UNFITTED
from phonemeengine.settings import ModelKind
from phonemetraining.config import TrainingConfig
from phonemetraining.model_card import model_card
from phonemetraining.pipeline import TrainingResult, Validation
from phonemetraining.teacher import Groups
from phonemetraining.validation import MOST_JUDGED, adapted_to_each, preset_of
from tests.corpora import put
from tests.fakes.encoder_weights import encoder_weights
from tests.models import tone_model
from tests.sounds import noise, vowel

FORMANTS = {Phoneme.A: (750, 1250, 2500), Phoneme.I: (300, 2200, 3000), Phoneme.U: (310, 800, 2300)}


def spoken(folder: Path, speaker: str, number: int, n_rounds: int) -> LabelledUtterance:
    """A recording of a voice that says vowels."""
    parts, labels, at = [], [], 0.0
    for k in range(4 * n_rounds):
        phoneme = (*FORMANTS, Phoneme.SILENCE)[k % 4]
        parts.append(vowel(FORMANTS[phoneme], 0.4, 200 + number) if phoneme in FORMANTS else noise(0.4, 1e-4))
        labels.append(Label(at, at + 0.4, phoneme.label, phoneme))
        at += 0.4
    put(folder, f"{speaker}{number}", np.concatenate(parts), tuple(labels))
    return LabelledUtterance(folder / f"{speaker}{number}.wav", tuple(labels), speaker, "made")


@pytest.mark.parametrize("lengths", [(1, 4, 1), (2, 2, 1)])
def test_one_recording_or_the_first_ones_that_are_as_long_are_learned_and_others_judge(tmp_path: Path, lengths):
    utterances = [spoken(tmp_path, "ann", k, n) for k, n in enumerate(lengths)]
    preset = load_preset("templates")
    read = [utterances[1]] if 4 in lengths else utterances[:2]
    others = [u for u in utterances if u not in read]
    learned = calibrate(preset, read).preset
    found = list(adapted_to_each(preset, utterances))
    assert [a.voice for a in found] == ["made/ann"] * len(others)
    for adapted, other in zip(found, others, strict=True):
        assert (adapted.before[1] == predict(other, preset).phonemes).all()
        assert (adapted.after[1] == predict(other, learned).phonemes).all()


def test_of_who_said_little_or_nothing_else_nothing_is_told_and_of_who_said_much_a_part(tmp_path: Path):
    preset = load_preset("templates")
    little = [spoken(tmp_path, "bob", k, 1) for k in range(3)]
    alone = [spoken(tmp_path, "cat", 0, 4)]
    much = [spoken(tmp_path, "dan", k, 4) for k in range(MOST_JUDGED + 3)]
    assert [a.voice for a in adapted_to_each(preset, [*little, *alone, *much])] == ["made/dan"] * MOST_JUDGED


@pytest.mark.long
def test_the_real_time_model_is_judged_as_it_recognises_live_sound(tmp_path: Path):
    utterances = [spoken(tmp_path, "eve", k, 4) for k in range(2)]
    model, encoder = load_preset("learned").model, build_live_encoder(encoder_weights(n_layers=1, n_channels=64))
    assert model is not None
    both = preset_of(model, encoder)
    (adapted,) = adapted_to_each(both, utterances)
    learned = calibrate(both, utterances[:1]).preset
    assert (adapted.before[1] == predict(utterances[1], both).phonemes).all()
    assert (adapted.after[1] == predict(utterances[1], learned).phonemes).all()
    assert (adapted.before[1] != predict(utterances[1], preset_of(model)).phonemes).any()


def test_the_card_tells_what_both_models_gain_by_a_sentence():
    figures = Scores(0.5, 0.6, 0.5, 0.7, 0.5, 0.9, 0.02, 10, 10, 1, 0.6)
    gained = {"people": (figures, replace(figures, macro_f1=0.9))}
    told = {ModelKind.REAL_TIME: Validation({}, {}, UNFITTED)}
    network = tone_model({700.0: Phoneme.A})
    result = TrainingResult(
        (),
        Groups(),
        TrainingConfig(),
        network,
        network,
        validations=told,
        adapted=dict.fromkeys((ModelKind.REAL_TIME, ModelKind.ENCODER), gained),
    )
    card = model_card("mine", result, 1)
    for kind in ("real-time", "encoder"):
        assert f"| {kind}, people, before | 1.0 | 0.600 |" in card
        assert f"| {kind}, people, after | 1.0 | 0.900 |" in card
