"""The real-time model: its file, and what it makes of sounds that come in any pieces."""

import json
import sys
from dataclasses import replace

import numpy as np
import pytest

from phonemeengine.encoder.graph import SLOTS, live_graph, whole_graph
from phonemeengine.encoder.live import (
    LARGEST_FILE,
    MANY,
    EncoderMix,
    EncoderStream,
    LiveEncoder,
    OpenEncoder,
    build_live_encoder,
    load_live_encoder,
    open_live_encoder,
    save_live_encoder,
)
from phonemeengine.encoder.whisper import LEAST_PEAK, SILENT, RunningScale
from phonemeengine.errors import ModelError
from phonemeengine.presets.files import DEFAULT_PRESET, load_preset
from tests.fakes.encoder_weights import encoder_weights, reference_logits

WEIGHTS = encoder_weights(n_layers=2, n_channels=64)
EXACT = build_live_encoder(WEIGHTS, bits=32)
SMALL = build_live_encoder(WEIGHTS, EncoderMix(0.7, 0.35, (0.5,) * 26), about={"trained on": "noise"})
OTHER = build_live_encoder(encoder_weights(n_layers=2, n_channels=64, seed=7))
FEWER = WEIGHTS | {"head/weight": WEIGHTS["head/weight"][:50], "head/bias": np.zeros(50, np.float32)}
KNOWN = {"format": 1, "encoder_share": 0.5, "weakened": 0, "priors": [0.1] * 26}


def log_mels(n_frames: int, seed: int = 3) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-9, 1, (n_frames, 80)).astype(np.float32)


def answers(encoder: LiveEncoder, frames: np.ndarray, ahead: int, cuts: list[int]) -> np.ndarray:
    model = open_live_encoder(encoder)
    stream = EncoderStream(model, ahead)
    states = [model.encode([stream], [block])[0] for block in np.split(frames, cuts)]
    return model.head.logits(np.concatenate(states))


def test_a_model_that_is_saved_is_the_same_when_it_is_read(tmp_path):
    save_live_encoder(SMALL, tmp_path / "x.encoder.onnx")
    found = load_live_encoder(tmp_path / "x.encoder.onnx")
    assert found == SMALL != EXACT
    assert found.name == "x.encoder.onnx"
    assert open_live_encoder(found) is open_live_encoder(SMALL)
    assert open_live_encoder(found).mix == EncoderMix(0.7, 0.35, (0.5,) * 26)


@pytest.mark.parametrize("ahead", [0, 1])
@pytest.mark.parametrize("step", [3, 150, *(pytest.param(step, marks=pytest.mark.long) for step in (1, 2, 14))])
def test_the_shipped_one_finds_the_same_however_the_sound_is_cut(ahead, step):
    # With 8 bits, last digits turn roundings; what is rounded must be so fine that they do not matter.
    model = open_live_encoder(load_preset(DEFAULT_PRESET).live_encoder)
    frames = np.concatenate((model.anchors[0], model.anchors[1])).astype(np.float32)
    whole, pieces = EncoderStream(model, ahead), EncoderStream(model, ahead)
    states = [model.encode([pieces], [frames[k : k + step]])[0] for k in range(0, len(frames), step)]
    np.testing.assert_allclose(np.concatenate(states), model.encode([whole], [frames])[0], atol=2e-3)


@pytest.mark.parametrize("ahead", [0, 1])
@pytest.mark.parametrize("cuts", [[], [1, 2, 3, 10, 11, 200], list(range(1, 441))])
def test_it_says_what_numpy_finds_however_the_sound_is_cut(ahead, cuts):
    frames = log_mels(441)
    found = answers(EXACT, frames, ahead, cuts)
    mel = np.concatenate((np.full((2, 80), SILENT, np.float32), RunningScale().scale(frames)))
    assert len(found) == 440 - 2 * (1 + ahead) + 2  # a state needs the two frames after its first, or four
    np.testing.assert_allclose(found, reference_logits(WEIGHTS, mel.T, ahead)[: len(found)], atol=3e-4)


def test_a_sound_is_recognised_alike_wherever_in_a_stream_it_comes():
    frames = log_mels(120)
    plain = answers(EXACT, np.concatenate((np.full((400, 80), -10, np.float32), frames)), 1, [])
    for more in (38, 250, 1000):  # states of silence that come before, beyond the 150 that it remembers
        silence = np.full((400 + 2 * more, 80), -10, np.float32)
        later = answers(EXACT, np.concatenate((silence, frames)), 1, [])
        np.testing.assert_allclose(later[2 * more + 400 :], plain[400:], atol=2e-5)


@pytest.mark.parametrize("ahead", [0, 1])
def test_a_microphone_that_was_open_for_days_is_answered_as_in_its_first_minute(ahead):
    model, frames = open_live_encoder(EXACT), np.concatenate((np.full((400, 80), -10, np.float32), log_mels(120)))
    plain = answers(EXACT, frames, ahead, [400])
    for days in (1, 100):
        stream = EncoderStream(model, ahead)
        before = model.encode([stream], [frames[:400]])[0]
        stream.count += days * 24 * 3600 * 50 // SLOTS * SLOTS  # a state each 20 ms; its rings go round as before
        found = model.head.logits(np.concatenate((before, model.encode([stream], [frames[400:]])[0])))
        np.testing.assert_allclose(found, plain, atol=2e-5)


@pytest.mark.parametrize("lengths", [(160, 175, 190, 205), (MANY + 1) * (120,)])
def test_many_sounds_together_are_answered_as_each_alone(lengths):
    model, everybody = open_live_encoder(SMALL), tuple(range(len(lengths)))
    sounds = [log_mels(n, k) for k, n in enumerate(lengths)]
    streams = [EncoderStream(model, 1) for _ in sounds]
    found: list[list[np.ndarray]] = [[] for _ in sounds]
    # all, some that lie among them, one alone, others; each with as much sound as it has not had yet
    for who, n in ((everybody, 20), (everybody[1:], 31), ((2,), 10), ((0, 3), 40), (everybody, 400)):
        parts = [sounds[k][:n] for k in who]
        for k, answer in zip(who, model.encode([streams[k] for k in who], parts), strict=True):
            found[k].append(answer)
            sounds[k] = sounds[k][n:]
    for k, parts in enumerate(found):
        np.testing.assert_allclose(
            model.head.logits(np.concatenate(parts)), answers(SMALL, log_mels(lengths[k], k), 1, []), atol=5e-4
        )


def test_sounds_that_take_turns_in_halves_keep_the_memory_that_each_half_shares():
    model = open_live_encoder(SMALL)
    streams = [EncoderStream(model, 0) for _ in range(6)]
    for half in (streams[:3], streams[3:]):
        model.encode(half, [log_mels(5)] * 3)
    shared = [stream.rings[0].base for stream in streams]
    for half in (streams[:3], streams[4:]):  # one of them has nothing new
        model.encode(half, [log_mels(5)] * len(half))
    assert all(stream.rings[0].base is base for stream, base in zip(streams, shared, strict=True))


def test_sounds_that_ended_leave_no_memory_behind():
    model = open_live_encoder(SMALL)
    streams = [EncoderStream(model, 0) for _ in range(3)]
    model.encode(streams, [log_mels(5)] * 3)
    lonely = streams.pop()
    streams.clear()
    model.encode([EncoderStream(model, 0) for _ in range(2)], [log_mels(5)] * 2)
    assert lonely.rings[0].base is None  # of the three that were together, the memory of two is free


def test_the_floor_follows_the_loudest_band_and_falls_slowly():
    frames = np.full((201, 80), -10, np.float32)
    frames[1, 3] = 1.0
    scaled = RunningScale().scale(frames)
    assert scaled[0, 0] == SILENT == (LEAST_PEAK - 8 + 4) / 4
    np.testing.assert_allclose(scaled[1, [0, 3]], [(1 - 8 + 4) / 4, 5 / 4])
    np.testing.assert_allclose(scaled[101, 0], (1 - 0.2 - 8 + 4) / 4, rtol=1e-6)
    parts = RunningScale()
    np.testing.assert_array_equal(
        np.concatenate([parts.scale(part) for part in np.split(frames, [1, 2, 50])]), scaled
    )


def test_its_file_holds_its_head_and_anchors_as_they_are():
    anchors = np.stack([log_mels(60, seed) for seed in (5, 6)]).astype(np.float16)
    model = open_live_encoder(build_live_encoder(WEIGHTS, anchors=anchors.astype(np.float32)))
    np.testing.assert_array_equal(model.anchors, anchors)
    np.testing.assert_array_equal(model.head.weights, WEIGHTS["head/weight"].T)
    np.testing.assert_array_equal(model.head.bias, WEIGHTS["head/bias"])
    assert model.anchor_states(1).shape == (2, 30, 64)
    np.testing.assert_array_equal(model.anchor_states(1)[1], model.states_of(anchors[1].astype(np.float32), 1))
    assert open_live_encoder(SMALL).anchor_states(0).shape == (0, 0, 64)


@pytest.mark.parametrize("ahead", [0, 1])
@pytest.mark.parametrize("n", [0, 1, 7, 600])
def test_the_states_of_a_whole_sound_are_those_of_one_that_silence_follows(ahead, n):
    found = open_live_encoder(EXACT).states_of(log_mels(n), ahead)
    frames = np.concatenate((log_mels(n), np.full((9, 80), -10, np.float32)))
    assert found.shape == ((n + 1) // 2, 64)
    logits = open_live_encoder(EXACT).head.logits(found)[:n]
    np.testing.assert_allclose(logits, answers(EXACT, frames, ahead, [])[:n], atol=3e-4)


def test_a_head_fits_no_other_model():
    model, other = open_live_encoder(SMALL), open_live_encoder(OTHER)
    adapted = replace(model.head, bias=model.head.bias + 1)
    assert model.fitting(adapted) is adapted
    assert other.fitting(adapted) is other.head
    assert model.fitting(None) is model.head
    assert open_live_encoder(EXACT).fitting(adapted) is adapted  # the same weights in 32 bits
    wrong = replace(adapted, weights=adapted.weights[1:])
    assert model.fitting(wrong) is model.head


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"no model",
        SMALL.content[: len(SMALL.content) // 2],
        live_graph(WEIGHTS, 8),
        live_graph(WEIGHTS, 8, {"phonemeanalyser": "{}"}),
        live_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN | {"priors": [0.0] * 26})}),
        live_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN | {"encoder_share": "much"})}),
        live_graph(FEWER, 8, {"phonemeanalyser": json.dumps(KNOWN)}),
        whole_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN)}),
        live_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN)}, np.zeros((1, 10, 40), np.float16)),
        live_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN)}, np.full((1, 10, 80), np.nan, np.float16)),
    ],
    ids=[
        "empty",
        "text",
        "half",
        "untold",
        "no numbers",
        "priors",
        "share",
        "outputs",
        "another graph",
        "anchors",
        "no anchors",
    ],
)
def test_a_damaged_or_foreign_file_is_refused_in_a_sentence(content):
    with pytest.raises(
        ModelError, match=r"^x\.onnx: this is not a real-time model, or it is damaged; download it again$"
    ):
        open_live_encoder(LiveEncoder(content, "x.onnx"))


def test_a_newer_or_larger_one_is_refused(tmp_path):
    newer = live_graph(WEIGHTS, 8, {"phonemeanalyser": json.dumps(KNOWN | {"format": 2})})
    with pytest.raises(ModelError, match="newer version; update the program"):
        OpenEncoder(newer)
    (tmp_path / "x.onnx").write_bytes(bytes(LARGEST_FILE + 1))
    with pytest.raises(ModelError, match=r"x\.onnx: a real-time model has at most 12 MB, this has 12\.1 MB"):
        load_live_encoder(tmp_path / "x.onnx")
    with pytest.raises(ModelError, match=r"at most 12 MB, this has 13\.0; use 8 bits"):
        save_live_encoder(LiveEncoder(bytes(13 << 20), "y"), tmp_path / "y.onnx")
    with pytest.raises(ModelError, match=r"z\.onnx: there is no such file"):
        load_live_encoder(tmp_path / "z.onnx")


def test_without_its_library_it_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    with pytest.raises(
        ModelError, match=r"x: .*onnxruntime, which is not installed; install phonemeanalyser\[encoder\]"
    ):
        open_live_encoder(LiveEncoder(b"never opened", "x"))
