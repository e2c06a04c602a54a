"""What the real-time model learns of a voice: its head on its states, beside the small network."""

import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from phonemeengine.calibration.adaptation import WARPS, adapt_live_head
from phonemeengine.calibration.calibrate import calibrate
from phonemeengine.calibration.fine_tuning import example_of, sound_of, whisper_mels_of
from phonemeengine.calibration.scores.corpus import LabelledUtterance, frame_labels_of
from phonemeengine.calibration.scores.evaluation import predict
from phonemeengine.calibration.scores.scoring import scores_of
from phonemeengine.encoder.head import softmax
from phonemeengine.encoder.live import EncoderMix, LiveEncoder, LiveHead, build_live_encoder, open_live_encoder
from phonemeengine.labels.utterance import Label
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.files import load_preset, save_preset
from phonemeengine.presets.model_choice import for_files, for_live_use, states_in, with_real_time_model
from phonemeengine.presets.preset import Preset
from phonemeengine.settings import ModelKind
from phonemeengine.shipping.targets import format_ear
from tests.corpora import put
from tests.fakes.encoder_weights import encoder_weights
from tests.sounds import noise, vowel

P = Phoneme
FORMANTS = {P.A: (700, 1200), P.E: (450, 1900), P.I: (280, 2250), P.O: (450, 800), P.U: (310, 700), P.M: (250, 1000)}
READ = (P.SILENCE, P.A, P.SZ, P.I, P.M, P.U, P.E, P.O, P.SILENCE) * 2
ASKED = (P.SILENCE, P.U, P.M, P.O, P.SZ, P.E, P.A, P.SILENCE, P.I)
STRANGER, OTHERS = 1.12, ((110, 0.95), (220, 1.05), (130, 1.0))
"""The vocal tract of the voice that is learned; pitch and tract of those that the model knows."""


def said(phonemes: tuple[Phoneme, ...], f0: float, tract: float) -> tuple[np.ndarray, tuple[Label, ...]]:
    """What a voice of some pitch and vocal tract says, 0.25 s each, in a quiet room."""
    parts = []
    for k, phoneme in enumerate(phonemes):
        formants = tuple(tract * formant for formant in (*FORMANTS.get(phoneme, ()), 2800))
        loud = 0.1 if phoneme is P.SZ else 1e-4
        parts.append(vowel(formants, 0.25, f0) if phoneme in FORMANTS else noise(0.25, loud, seed=k))
    sound = np.concatenate(parts) + noise(0.25 * len(phonemes), 5e-4, seed=99)
    labels = [Label(0.25 * k, 0.25 * (k + 1), phoneme.label, phoneme) for k, phoneme in enumerate(phonemes)]
    return sound.astype(np.float32), tuple(labels)


def recording(
    folder: Path, name: str, phonemes: tuple[Phoneme, ...], f0: float, tract: float = STRANGER
) -> LabelledUtterance:
    sound, labels = said(phonemes, f0, tract)
    put(folder, name, sound, labels)
    return LabelledUtterance(folder / f"{name}.wav", labels, "ann", "made")


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> LabelledUtterance:
    return recording(tmp_path_factory.mktemp("read"), "read", READ, 150)


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> LabelledUtterance:
    """Another sentence of the same voice."""
    return recording(tmp_path_factory.mktemp("asked"), "asked", ASKED, 170)


def random_weights(seed: int = 1) -> dict[str, np.ndarray]:
    """An encoder that tells sounds apart, since its layer changes little of what the convolutions find."""
    drawn = encoder_weights(n_layers=1, n_channels=128, seed=seed)
    return {name: 0.1 * value if "linear_1" in name else value for name, value in drawn.items()}


@cache
def mels_of_others() -> np.ndarray:
    return np.stack([whisper_mels_of(said(READ, *voice)[0]) for voice in OTHERS])


@cache
def trained_weights() -> dict[str, np.ndarray]:
    """The same with a head that knows other voices, by least squares: +3 for what is said, else -3."""
    weights, truth = random_weights(), frame_labels_of(said(READ, 100, 1)[1]).phonemes
    states = [open_live_encoder(build_live_encoder(weights)).states_of(mels, 1) for mels in mels_of_others()]
    inputs = np.concatenate([np.c_[found, np.ones(len(found))] for found in states])
    wanted = 6 * np.tile(np.eye(26)[truth].reshape(-1, 52), (len(OTHERS), 1)) - 3
    solution = np.linalg.solve(inputs.T @ inputs + 5 * np.eye(129), inputs.T @ wanted).astype(np.float32)
    return weights | {"head/weight": solution[:-1].T, "head/bias": solution[-1]}


@cache
def encoder() -> LiveEncoder:
    return build_live_encoder(trained_weights(), EncoderMix(0.9), anchors=mels_of_others())


def preset_of(**changes) -> Preset:
    return replace(load_preset("learned"), **({"live_encoder": encoder(), "offline_model": None} | changes))


def learned(preset: Preset, utterance: LabelledUtterance) -> LiveHead:
    live, sound = with_real_time_model(preset), sound_of(utterance)
    return adapt_live_head(live, [example_of(sound, utterance.labels)], [states_in(live, whisper_mels_of(sound))])[0]


def answers(head: LiveHead, sound: np.ndarray) -> np.ndarray:
    return softmax(head.logits(states_in(with_real_time_model(preset_of()), whisper_mels_of(sound)))[:, :11])


def test_an_adapted_head_errs_less_in_another_sentence_of_the_voice(read, asked):
    own, adapted = open_live_encoder(encoder()).head, learned(preset_of(), read)
    sound, truth = sound_of(asked), frame_labels_of(asked.labels).phonemes
    before, after = (answers(head, sound)[: len(truth)] for head in (own, adapted))
    losses = [-np.log(shares[np.arange(len(truth)), truth]).mean() for shares in (before, after)]
    right = [(shares.argmax(axis=1) == truth).mean() for shares in (before, after)]
    assert losses[1] < 0.75 * losses[0]
    assert right[1] > right[0] + 0.05
    assert adapted.origin == own.origin


def test_anchors_hold_what_is_said_of_others(read):
    own, held = open_live_encoder(encoder()).head, learned(preset_of(), read)
    free = learned(preset_of(live_encoder=build_live_encoder(trained_weights())), read)
    expected, *moved = (answers(head, said(ASKED, 190, 1.0)[0]) for head in (own, held, free))
    by_anchors, without = (np.sum(expected * np.log(expected / shares), axis=1).mean() for shares in moved)
    assert by_anchors < without / 2


def test_a_childs_voice_is_recognised_by_bands_of_higher_frequencies(tmp_path):
    read, asked = (recording(tmp_path, name, what, 300, 1.7) for name, what in (("r", READ), ("a", ASKED)))
    quiet = recording(tmp_path, "q", (P.SILENCE,) * 16, 300)  # tells nothing of a vocal tract
    preset = preset_of()
    outcome = calibrate(preset, [read, quiet], held_out=[asked])
    model = outcome.preset.model
    assert outcome.gains
    assert model is not None
    assert model.live_head is not None
    assert model.live_head.warp in WARPS[1:]
    assert model.warps == (model.live_head.warp,)
    for found, figures in ((preset, outcome.before), (outcome.preset, outcome.after)):
        assert scores_of([predict(asked, for_live_use(found)).answers]) == figures


def test_both_models_learn_and_what_recognises_live_sound_is_judged(read, asked):
    preset = preset_of()
    outcome = calibrate(preset, [read], held_out=[asked])
    model = outcome.preset.model
    assert outcome.gains
    assert model is not None
    assert model.live_head is not None
    assert model.live_head.warp == 1
    assert preset.model is not None
    assert not np.array_equal(model.heads[0].bias, preset.model.heads[0].bias)
    for found, figures in ((preset, outcome.before), (outcome.preset, outcome.after)):
        assert scores_of([predict(asked, for_live_use(found)).answers]) == figures
    assert outcome.after.macro_f1 > outcome.before.macro_f1
    assert outcome.warning == ""
    assert outcome.preset.live_encoder == preset.live_encoder


def test_where_the_small_network_is_chosen_it_is_judged_and_both_learn(read, asked):
    preset = preset_of(live_model=ModelKind.REAL_TIME)
    outcome = calibrate(preset, [read], held_out=[asked])
    assert outcome.before == scores_of([predict(asked, preset).answers])
    assert outcome.after == scores_of([predict(asked, outcome.preset).answers])
    assert outcome.preset.model is not None
    assert outcome.preset.model.live_head is not None


def test_who_asked_for_the_real_time_model_is_judged_by_it_as_far_ahead_as_he_asked(read, asked):
    preset = for_files(preset_of(), ModelKind.ENCODER)
    outcome = calibrate(preset, [read], held_out=[asked])
    assert outcome.before == scores_of([predict(asked, preset).answers])
    assert outcome.after == scores_of([predict(asked, outcome.preset).answers])


def test_without_its_library_the_small_network_learns_alone_and_one_sentence_says_so(read, asked, monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    open_live_encoder.cache_clear()
    outcome = calibrate(preset_of(), [read], held_out=[asked])
    alone = calibrate(preset_of(live_encoder=None), [read], held_out=[asked])
    assert outcome.preset.model == alone.preset.model
    assert outcome.after == alone.after
    assert "onnxruntime, which is not installed" in outcome.warning
    assert outcome.warning.endswith(
        "; until then the small network recognises live sound, and it alone learned the voice."
    )
    assert alone.warning == ""


def test_the_head_is_kept_with_the_model_of_the_preset(read, asked, tmp_path):
    adapted = replace(preset_of(), model=replace(preset_of().model, live_head=learned(preset_of(), read)).rounded())
    save_preset(adapted, tmp_path / "ann.toml")
    save_preset(preset_of(), tmp_path / "all.toml")
    again = load_preset(tmp_path / "ann.toml")
    assert again == adapted != preset_of()
    sizes = [(tmp_path / name).stat().st_size for name in ("ann.npz", "all.npz")]
    assert sizes[0] - sizes[1] < 2 * 128 * 52 + 1000
    found = predict(asked, for_live_use(again)).phonemes
    np.testing.assert_array_equal(found, predict(asked, for_live_use(adapted)).phonemes)
    assert (found != predict(asked, for_live_use(preset_of())).phonemes).any()


def test_a_head_of_another_real_time_model_is_not_used_and_one_sentence_says_so(read):
    adapted = replace(preset_of().model, live_head=learned(preset_of(), read))
    other = build_live_encoder(random_weights(5))
    live = for_live_use(preset_of(model=adapted, live_encoder=other))
    assert live.model_kind is ModelKind.ENCODER
    assert live.warnings == (
        "the new model: the preset was calibrated with another real-time model; calibrate it again",
    )
    assert for_live_use(preset_of(model=adapted)).warnings == ()


def test_programs_without_python_get_the_small_network_as_if_there_were_no_other(read):
    model = replace(preset_of().model, live_head=learned(preset_of(), read))
    assert format_ear(preset_of(model=model)) == format_ear(preset_of(live_encoder=None))
