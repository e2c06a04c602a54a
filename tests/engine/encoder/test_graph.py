"""The graphs of the encoder, run by ONNX Runtime: held against the same written down with NumPy."""

import numpy as np
import onnxruntime
import pytest

from phonemeengine.encoder import onnx
from phonemeengine.encoder.graph import SLOTS, layer_count, live_graph, whole_graph
from tests.fakes.encoder_weights import encoder_weights, reference_logits, reference_states

WEIGHTS, WHOLE = encoder_weights(), encoder_weights(n_positions=1500)
N_HEADS = 2
CLOSE = {32: 2e-4, 8: 0.25}
"""Greatest difference of numbers with a spread of about 1."""


def mel_of(n_frames: int, seed: int = 3) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (80, n_frames)).astype(np.float32)


def session(content: bytes) -> onnxruntime.InferenceSession:
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])


def test_an_operator_is_written_as_onnx_has_it_and_named_as_its_output():
    # of NodeProto: input 1, output 2, name 3, op_type 4; ONNX Runtime before 1.22 opens no graph without names
    assert onnx.node("Add", ["a", "b"], ["c"]) == b'\n\x01a\n\x01b\x12\x01c\x1a\x01c"\x03Add'


class Stream:
    """What is kept of a sound between two calls."""

    def __init__(self, mel: np.ndarray, ahead: int) -> None:
        self.mel, self.ahead, self.count = mel, ahead, 0
        self.pending = np.full((1, 128), 7, np.float32)
        self.keys = [np.full((N_HEADS, 64, SLOTS), 9, np.float32) for _ in range(2)]
        self.values = [np.full((N_HEADS, SLOTS, 64), 9, np.float32) for _ in range(2)]
        self.logits: list[np.ndarray] = []


def step(model, streams: list[Stream], n: int) -> None:
    """Push n states of all streams."""
    feed = {
        "mel": np.stack([s.mel[:, 2 * s.count : 2 * (s.count + n) + 3] for s in streams]),
        "count": np.array([s.count for s in streams]),
        "ahead": np.array([streams[0].ahead]),
        "pending": np.stack([s.pending for s in streams]),
    }
    for k in range(2):
        feed |= {f"keys_{k}": np.stack([s.keys[k] for s in streams])}
        feed |= {f"values_{k}": np.stack([s.values[k] for s in streams])}
    names = [output.name for output in model.get_outputs()]
    found = dict(zip(names, model.run(None, feed), strict=True))
    for b, s in enumerate(streams):
        states = found["states"][b, s.ahead if s.count == 0 else 0 :]
        logits = states @ found["head_weights"] + found["head_bias"]
        s.logits.append(logits.reshape(-1, found["head_bias"].size // 2))
        s.pending = found["next_pending"][b]
        for k in range(2):
            kept = min(n, SLOTS)
            places = (s.count - (s.ahead if k else 0) + np.arange(n - kept, n)) % SLOTS
            s.keys[k][:, :, places] = found[f"new_keys_{k}"][b][:, :, n - kept :]
            s.values[k][:, places] = found[f"new_values_{k}"][b][:, n - kept :]
        s.count += n


@pytest.fixture(scope="module", params=[32, 8])
def live(request):
    return session(live_graph(WEIGHTS, request.param)), CLOSE[request.param]


@pytest.mark.parametrize("bits", [32, 8])
def test_a_whole_stretch_has_the_states_that_numpy_finds(bits):
    mel = mel_of(240)
    (found,) = session(whole_graph(WHOLE, bits)).run(None, {"mel": mel[np.newaxis]})
    np.testing.assert_allclose(found[0], reference_states(WHOLE, mel, None), atol=CLOSE[bits])


def test_there_is_no_final_norm_where_there_are_no_weights_of_one():
    weights = {name: array for name, array in WHOLE.items() if not name.startswith("layer_norm/")}
    (found,) = session(whole_graph(weights, 32)).run(None, {"mel": mel_of(60)[np.newaxis]})
    np.testing.assert_allclose(found[0], reference_states(weights, mel_of(60), None), atol=2e-4)
    assert layer_count(weights) == 2


def test_what_is_said_about_a_model_is_read_back():
    about = {"source": "x" * 300, "licence": "MIT – ©"}
    assert session(whole_graph(WHOLE, 8, about)).get_modelmeta().custom_metadata_map == about


@pytest.mark.parametrize("ahead", [0, 1])
@pytest.mark.parametrize("n", [1, 7, 400])
def test_live_states_are_those_that_numpy_finds_however_the_sound_is_cut(live, ahead, n):
    model, close = live
    n_states = 400  # twice as many as the cache holds, and more
    mel = mel_of(2 * n_states + 3)
    stream = Stream(mel, ahead)
    for first in range(0, n_states, n):
        step(model, [stream], min(n, n_states - first))
    expected = reference_logits(WEIGHTS, mel, ahead)[: 2 * (n_states - ahead)]
    np.testing.assert_allclose(np.concatenate(stream.logits), expected, atol=close)


def test_streams_that_began_at_different_times_are_answered_as_each_alone(live):
    model, _ = live
    streams, alone = ([Stream(mel_of(600, seed), 1) for seed in range(3)] for _ in range(2))
    for group in (streams, alone):
        for k, stream in enumerate(group):
            for _ in range(k):
                step(model, [stream], 80)  # 0, 80 and 160 states: a new one, and one whose ring is full
    for _ in range(5):
        step(model, streams, 3)
        for stream in alone:
            step(model, [stream], 3)
    for together, one in zip(streams, alone, strict=True):
        np.testing.assert_allclose(np.concatenate(together.logits), np.concatenate(one.logits), atol=2e-3)
