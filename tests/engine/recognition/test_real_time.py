"""Live sound by the real-time model and the small network together: when answers come, and what they are."""

import sys
from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.analyser import Analyser, Analysis, concatenate_analyses, push_together
from phonemeengine.dsp.framing import Framer
from phonemeengine.encoder.head import softmax
from phonemeengine.encoder.live import (
    EncoderMix,
    LiveEncoder,
    build_live_encoder,
    load_live_encoder,
    open_live_encoder,
    save_live_encoder,
)
from phonemeengine.encoder.whisper import SILENT, RunningScale, whisper_log_mels
from phonemeengine.errors import PresetError
from phonemeengine.labels.visemes import VisemeSet
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.document import preset_from_toml, preset_to_toml
from phonemeengine.presets.files import beyond_phoneme_data, load_preset, save_models, save_preset
from phonemeengine.presets.model_choice import (
    figures_ahead,
    for_files,
    for_live_use,
    frames_ahead,
    has_model,
    model_in_words,
    with_small_network,
)
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.learned import real_time_look_ahead
from phonemeengine.settings import HOP, AnalysisSettings, ModelKind
from tests.fakes.encoder_weights import encoder_weights, reference_logits
from tests.models import tone_model
from tests.sounds import silence, tone

WEIGHTS = encoder_weights(n_layers=1, n_channels=64)
NETWORK = tone_model({700.0: Phoneme.A, 2500.0: Phoneme.I}).rounded()
ENCODERS = {share: build_live_encoder(WEIGHTS, EncoderMix(encoder_share=share), bits=32) for share in (0.0, 0.6, 1.0)}
SOUND = np.concatenate([silence(0.2), tone(700, 0.31, 0.5), silence(0.1), tone(2500, 0.3, 0.5)])
N_FRAMES = -(-len(SOUND) // HOP)


def preset_of(share: float = 0.6, live_look_ahead: float = 0.05, **changes) -> Preset:
    settings = AnalysisSettings(statistics=False, live_look_ahead=live_look_ahead)
    of = {"model": NETWORK, "live_encoder": ENCODERS[share], "settings": settings, "name": "tones"}
    return Preset(recogniser="learned", **(of | changes))


def heard(preset: Preset, cuts: list[int] | None = None) -> Analysis:
    analyser = Analyser(preset, live=True)
    parts = [analyser.push(part) for part in np.split(SOUND, cuts or [])]
    return concatenate_analyses([*parts, analyser.finish()])


def scores_of(analysis: Analysis) -> np.ndarray:
    return np.stack([analysis.features[name] for name in analysis.features.names if name.startswith("p_")], axis=1)


@pytest.mark.parametrize(("allowed", "n_ahead"), [(0, 2), (0.01, 2), (0.03, 2), (0.04, 4), (0.05, 4)])
def test_each_frame_has_its_answer_as_late_as_the_preset_allows_but_20_ms_at_least(allowed, n_ahead):
    assert real_time_look_ahead(allowed) == n_ahead
    analyser = Analyser(preset_of(live_look_ahead=allowed), live=True)
    assert analyser.recogniser.look_ahead == n_ahead
    counts = [len(analyser.push(part)) for part in np.split(SOUND[: 40 * HOP], 40)]
    assert sum(counts) == 40 - 3 - n_ahead + 1  # a frame's window ends two hops and a half after its middle
    assert set(counts[10:]) == {1}
    assert len(heard(preset_of(live_look_ahead=allowed))) == N_FRAMES


@pytest.mark.parametrize("n", [137, HOP, 3000, len(SOUND)])
def test_live_windows_come_before_their_answers_however_the_sound_is_cut(n):
    framer = Framer()
    windows = np.concatenate([framer.cut_frames(SOUND), framer.finish()])
    analyser, n_whole = Analyser(preset_of(), live=True), (len(SOUND) - 2048 // 2 - HOP // 2) // HOP + 1
    pushed = [analyser.push(SOUND[k : k + n]) for k in range(0, len(SOUND), n)]
    assert sum(len(block.arrived) for block in pushed) == n_whole == sum(map(len, pushed)) + 4
    analyser.set_preset(replace(preset_of(), live_encoder=None))  # whose network is asked about what waits
    blocks = [*pushed, analyser.push(SOUND[:0]), analyser.finish()]
    np.testing.assert_array_equal(np.concatenate([block.arrived for block in blocks]), windows)
    assert not len(blocks[0].part(slice(1)).arrived)


def test_it_says_what_the_encoder_finds_in_the_windows():
    framer = Framer()
    windows = np.concatenate([framer.cut_frames(SOUND), framer.finish(), np.zeros((9, 2048), np.float32)])
    frames = np.concatenate((np.full((2, 80), SILENT), RunningScale().scale(whisper_log_mels(windows))))
    for ahead, allowed in enumerate((0.02, 0.05)):
        logits = reference_logits(WEIGHTS, frames.T.astype(np.float32), ahead)[:N_FRAMES]
        found = heard(preset_of(1.0, allowed))
        np.testing.assert_allclose(scores_of(found), softmax(logits[:, :11]), atol=1e-4)
        assert found.viseme_scores is not None
        np.testing.assert_allclose(found.viseme_scores, softmax(logits[:, 11:]), atol=1e-4)


def test_without_any_share_of_the_encoder_it_says_what_the_network_does_as_far_ahead():
    settings = AnalysisSettings(statistics=False, look_ahead=0.02, live_look_ahead=0.02)
    alone = heard(preset_of(settings=settings, live_model=ModelKind.REAL_TIME))
    np.testing.assert_allclose(scores_of(heard(preset_of(0.0, 0.02))), scores_of(alone), atol=1e-5)


@pytest.mark.parametrize("cuts", [[1, 500, 9000, 9001], list(range(0, len(SOUND), 300))])
def test_any_cutting_of_the_sound_gives_the_same_answers(cuts):
    np.testing.assert_allclose(scores_of(heard(preset_of(), cuts)), scores_of(heard(preset_of())), atol=1e-5)


def test_sounds_that_are_pushed_together_are_answered_as_each_alone():
    begun, late = (Analyser(preset_of(), live=True) for _ in range(2))
    pieces = np.split(SOUND, range(0, len(SOUND), 3 * HOP))
    first = [begun.push(piece) for piece in pieces[:7]]
    both = [push_together([(begun, piece), (late, piece)]) for piece in pieces[7:]]
    one = concatenate_analyses([*first, *(found for found, _ in both), begun.finish()])
    other = concatenate_analyses([*(found for _, found in both), late.finish()])
    np.testing.assert_allclose(scores_of(one), scores_of(heard(preset_of())), atol=1e-5)
    alone = Analyser(preset_of(), live=True)
    expected = concatenate_analyses([*(alone.push(piece) for piece in pieces[7:]), alone.finish()])
    np.testing.assert_allclose(scores_of(other), scores_of(expected), atol=1e-5)


def test_live_sound_is_recognised_with_it_and_files_are_not():
    live = for_live_use(preset_of())
    assert (live.model_kind, model_in_words(live)) == (ModelKind.ENCODER, "encoder, look-ahead 40 ms")
    assert for_live_use(live) == live
    assert for_files(preset_of()).model_kind is ModelKind.REAL_TIME
    assert for_files(preset_of(), ModelKind.ENCODER).model_kind is ModelKind.ENCODER
    assert for_live_use(preset_of(live_model=ModelKind.REAL_TIME)).model_kind is ModelKind.REAL_TIME
    with pytest.raises(PresetError, match="live_model is one of real-time, encoder, got whisper"):
        preset_of(live_model=ModelKind.WHISPER)


def test_it_tells_how_far_ahead_it_looks_and_how_right_it_is_then():
    measured = build_live_encoder(WEIGHTS, about={"by_look_ahead_ms": {"20": [0.71, 0.76]}})
    live = for_live_use(preset_of(live_encoder=measured, live_look_ahead=0.01))
    assert frames_ahead(live) == 2
    assert figures_ahead(live, 2) == (0.71, 0.76)
    assert figures_ahead(live, 4) is None
    assert figures_ahead(for_live_use(preset_of()), 2) is None
    assert frames_ahead(with_small_network(preset_of(live_look_ahead=0.03))) == 3


def test_sensitivities_act_on_both_together():
    none = scores_of(heard(preset_of()))
    more = scores_of(heard(preset_of(sensitivities={Phoneme.O: 2.0})))
    odds = [scores[:, Phoneme.O] / scores[:, Phoneme.A] for scores in (more, none)]
    np.testing.assert_allclose(odds[0] / odds[1], np.exp(2.0), rtol=1e-3)


@pytest.mark.parametrize(
    ("preset", "why"),
    [
        (preset_of(live_encoder=LiveEncoder(b"nothing", "x.onnx")), "x.onnx: this is not a real-time model"),
        (
            preset_of(model=replace(NETWORK, viseme_set=VisemeSet(("X",), dict.fromkeys(Phoneme, ("X",)), {}, {}))),
            "'tones' has visemes of its own, which the real-time model does not know",
        ),
    ],
)
def test_where_it_cannot_be_had_one_sentence_says_so_and_the_small_network_serves(preset, why):
    live = for_live_use(preset)
    assert live.model_kind is ModelKind.REAL_TIME
    (said,) = live.warnings
    assert why in said
    assert said.endswith("until then the small network recognises live sound")
    assert for_live_use(live).warnings == live.warnings
    assert len(heard(preset)) == N_FRAMES


def test_without_its_library_the_small_network_serves(monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    preset = preset_of(live_encoder=LiveEncoder(b"never opened", "x.onnx"))
    assert not has_model(preset, ModelKind.ENCODER)
    (said,) = for_live_use(preset).warnings
    assert "onnxruntime, which is not installed" in said


def test_it_is_saved_beside_its_preset(tmp_path):
    preset = preset_of(live_model=ModelKind.REAL_TIME)
    save_preset(preset, tmp_path / "mine.toml")
    assert (tmp_path / "mine.encoder.onnx").read_bytes() == ENCODERS[0.6].content
    assert load_preset(tmp_path / "mine.toml") == preset
    assert load_preset(tmp_path / "mine.toml") != preset_of(1.0, live_model=ModelKind.REAL_TIME)
    assert "the real-time model" in beyond_phoneme_data(preset)
    (tmp_path / "mine.encoder.onnx").unlink()
    without = load_preset(tmp_path / "mine.toml")
    assert without.live_encoder is None
    (said,) = without.warnings
    assert said.startswith("mine.encoder.onnx: there is no such file")


def test_one_that_ships_with_the_program_is_named_and_not_copied(tmp_path):
    own, shipped = tmp_path / "own", tmp_path / "shipped"
    own.mkdir()
    shipped.mkdir()
    save_live_encoder(ENCODERS[0.6], shipped / "usual.encoder.onnx")
    preset = preset_of(live_encoder=load_live_encoder(shipped / "usual.encoder.onnx"))
    names = save_models(preset, own / "mine.toml", shipped)
    assert names == {"model": "mine.npz", "live_encoder": "usual.encoder.onnx"}
    assert [path.name for path in own.iterdir()] == ["mine.npz"]
    assert preset_from_toml(preset_to_toml(preset, names), own, shipped) == preset
    save_live_encoder(ENCODERS[1.0], own / "usual.encoder.onnx")  # another one of that name would be found first
    names = save_models(preset, own / "mine.toml", shipped)
    assert names["live_encoder"] == "mine.encoder.onnx"
    assert preset_from_toml(preset_to_toml(preset, names), own, shipped) == preset


def test_what_the_window_and_listen_tell_of_its_figures_is_not_told_of_a_voice():
    measured = build_live_encoder(WEIGHTS, about={"by_look_ahead_ms": {"40": [0.71, 0.76]}})
    head = open_live_encoder(measured).head
    adapted = replace(NETWORK, live_head=replace(head, bias=head.bias + 1))
    assert figures_ahead(for_live_use(preset_of(live_encoder=measured)), 4) == (0.71, 0.76)
    assert figures_ahead(for_live_use(preset_of(live_encoder=measured, model=adapted)), 4) is None
