"""Centred models, which hear as far ahead as back: when they answer, what for, and how they are kept."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.analyser import Analyser, Analysis
from phonemeengine.dsp.mel import N_BANDS, silent_log_mels
from phonemeengine.errors import ModelError
from phonemeengine.phonemes import Phoneme
from phonemeengine.presets.preset import Preset
from phonemeengine.recognition.model import MOST_FRAMES_AROUND, load_model, save_model
from phonemeengine.recognition.network import CentredNetwork, Layer
from phonemeengine.settings import HOP, WINDOW, AnalysisSettings
from tests.models import centred_model, tone_model
from tests.sounds import silence, tone

MODEL = centred_model()
REACH = sum(layer.dilation for layer in MODEL.layers)
SOUND = np.concatenate([silence(0.1), tone(700, 0.3, 0.5), silence(0.1), tone(2500, 0.2, 0.5), tone(300, 0.1, 0.2)])
N_FRAMES = -(-len(SOUND) // HOP)
HEARD = np.random.default_rng(3).normal(-5, 2, (60, N_BANDS)).astype(np.float32)


def preset_of(model=MODEL, look_ahead: float = 0.0) -> Preset:
    plain = AnalysisSettings(statistics=False, look_ahead=look_ahead)
    return Preset(recogniser="learned", model=model, settings=plain)


def heard(preset: Preset, cuts: list[int] | None = None, sound: np.ndarray = SOUND) -> list[Analysis]:
    analyser = Analyser(preset)
    return [*(analyser.push(part) for part in np.split(sound, sorted(cuts or []))), analyser.finish()]


def scores_of(analyses: list[Analysis]) -> np.ndarray:
    return np.concatenate([a.features.values for a in analyses])


def by_definition(layers: tuple[Layer, ...], frames: np.ndarray) -> np.ndarray:
    """What a centred network is: zeros around what each layer hears, silence around what the first one does."""
    hidden = frames
    for k, layer in enumerate(layers):
        d, n = layer.dilation, len(hidden)
        around = np.full((d, hidden.shape[1]), 0 if k else silent_log_mels()[0], np.float32)
        padded = np.concatenate([around, hidden, around])
        taps = np.concatenate([padded[start : start + n] for start in (0, d, 2 * d)], axis=1)
        found = np.maximum(taps @ layer.weights + layer.bias, 0)
        hidden = found + hidden if k else found
    return hidden


def test_each_layer_looks_at_the_frame_itself_and_at_those_a_dilation_before_and_after():
    found = CentredNetwork(MODEL.layers, silent_log_mels()).forward(HEARD)
    assert len(found) == len(HEARD) - REACH
    np.testing.assert_allclose(found, by_definition(MODEL.layers, HEARD)[:-REACH], rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize("n", [1, 2, 7, 33])
def test_a_centred_network_gives_the_same_however_many_frames_come_at_once(n):
    network = CentredNetwork(MODEL.layers, silent_log_mels())
    found = np.concatenate([network.forward(HEARD[k : k + n]) for k in range(0, len(HEARD), n)])
    whole = CentredNetwork(MODEL.layers, silent_log_mels()).forward(HEARD)
    np.testing.assert_allclose(found, whole, rtol=1e-4, atol=1e-4)


@settings(deadline=None, max_examples=25)
@given(cuts=st.lists(st.integers(0, len(SOUND)), max_size=40), warped=st.booleans())
def test_the_answers_do_not_depend_on_how_the_sound_was_cut(cuts, warped):
    preset = preset_of(centred_model(warps=(0.8, 1.0, 1.2) if warped else (1.0,)))
    whole, parts = heard(preset), heard(preset, cuts)
    assert sum(map(len, whole)) == sum(map(len, parts)) == N_FRAMES
    np.testing.assert_allclose(scores_of(parts), scores_of(whole), rtol=1e-3, atol=1e-4)
    assert [a.start for a in parts if len(a)] == list(np.cumsum([0, *(len(a) for a in parts if len(a))]))[:-1]


@pytest.mark.parametrize("look_ahead", [0.0, 0.03, 0.05])
def test_it_waits_for_what_it_hears_ahead_whatever_the_preset_says(look_ahead):
    analyser = Analyser(preset_of(look_ahead=look_ahead))
    assert analyser.recogniser.look_ahead == REACH
    first = next(k for k in range(100) if len(analyser.push(SOUND[k * HOP : (k + 1) * HOP])))
    assert first == WINDOW // 2 // HOP + REACH


def test_a_frame_is_named_by_what_lies_as_far_before_it_as_after():
    frame = np.zeros((1, N_BANDS), np.float32)
    quiet = silent_log_mels(80)
    loud = np.concatenate([quiet[:40], frame, quiet[41:]])
    found = [CentredNetwork(MODEL.layers, silent_log_mels()).forward(frames) for frames in (quiet, loud)]
    changed = np.flatnonzero(np.any(found[0] != found[1], axis=1))
    assert (changed[0], changed[-1]) == (40 - REACH, 40 + REACH)


def test_a_sound_shorter_than_what_is_heard_ahead_still_has_all_its_frames():
    short = tone(700, 0.05, 0.5)
    assert len(short) // HOP < REACH
    assert sum(map(len, heard(preset_of(), sound=short))) == -(-len(short) // HOP)
    assert sum(map(len, heard(preset_of(), sound=short[:0]))) == 0


def test_a_centred_model_comes_back_from_its_file_as_it_was(tmp_path):
    save_model(MODEL, tmp_path / "m.npz")
    back = load_model(tmp_path / "m.npz")
    assert back == MODEL
    assert back.centred
    assert back != replace(MODEL, centred=False)


def test_only_a_centred_model_needs_a_program_that_knows_them(tmp_path):
    for model, version in ((MODEL, 3), (replace(MODEL, centred=False), 2), (tone_model({700.0: Phoneme.A}), 1)):
        save_model(model, tmp_path / "m.npz")
        with np.load(tmp_path / "m.npz") as file:
            assert int(file["format"]) == version
        assert load_model(tmp_path / "m.npz").centred == model.centred


@pytest.mark.parametrize(
    "model",
    [replace(MODEL, heads=MODEL.heads * 2, viseme_heads=()), centred_model(dilations=(1, MOST_FRAMES_AROUND))],
)
def test_a_centred_model_that_hears_too_far_or_by_two_heads_is_refused(tmp_path, model):
    save_model(model, tmp_path / "m.npz")
    with pytest.raises(ModelError, match=r"m\.npz: a centred model has one head and uses 100 frames around"):
        load_model(tmp_path / "m.npz")
