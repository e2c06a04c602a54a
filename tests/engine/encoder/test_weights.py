"""The weights of Whisper's encoder are read from CTranslate2's file, or one sentence says why not."""

import numpy as np
import pytest

from phonemeengine.encoder.weights import OUTPUT, read_weights, shapes_of
from tests.fakes.whisper_model import content_of

BIAS = "encoder/layer_0/ffn/linear_1/bias"


@pytest.fixture(scope="module")
def content(whisper_folder) -> bytes:
    return (whisper_folder / "model.bin").read_bytes()


@pytest.mark.parametrize(("layer", "last"), [(0, "layer_0"), (4, "layer_4"), (5, "layer_5"), (OUTPUT, "layer_norm")])
def test_there_are_the_convolutions_and_the_layers_up_to_one(content, layer, last):
    weights = read_weights(content, layer)
    assert max(name.partition("/")[0] for name in weights if name.startswith("layer")) == last
    assert {name: array.shape for name, array in weights.items()} == shapes_of(layer)
    assert {array.dtype for array in weights.values()} == {np.dtype(np.float32)}


def test_numbers_of_both_sizes_and_other_names_are_read():
    zeros = {f"encoder/{name}": np.zeros(shape, np.float16) for name, shape in shapes_of(0).items()}
    ramp = np.arange(512, dtype=np.float32)
    del zeros[BIAS]
    content = content_of(zeros | {"encoder/ramp": ramp}, {BIAS: "encoder/ramp"})
    np.testing.assert_array_equal(read_weights(content, 0)[BIAS.removeprefix("encoder/")], ramp)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        (None, "encoder/layer_0/ffn/linear_1/bias is missing"),
        (np.zeros(384, np.float16), r"linear_1/bias has the shape \(384,\), that of Whisper base \(512,\)"),
        (np.zeros(512, np.int8), "linear_1/bias is neither float16 nor float32"),
    ],
)
def test_what_is_not_as_in_whisper_base_is_named(changed, words):
    variables = {f"encoder/{name}": np.zeros(shape, np.float16) for name, shape in shapes_of(0).items()}
    del variables[BIAS]
    with pytest.raises(ValueError, match=words):
        read_weights(content_of(variables | ({} if changed is None else {BIAS: changed}), {}), 0)


@pytest.mark.parametrize("kept", [0, 3, 20, 70, 1000, 5_000_000])
def test_a_file_that_ends_too_early_is_refused(content, kept):
    with pytest.raises(ValueError, match="it ends too early"):
        read_weights(content[:kept])


@pytest.mark.parametrize("other", [b"nonsense, and more of it", content_of({}, {}, "TransformerSpec")])
def test_another_file_is_refused(other):
    with pytest.raises(ValueError, match=r"it is no Whisper model of CTranslate2|it ends too early"):
        read_weights(other)


def test_another_name_of_nothing_is_damage():
    with pytest.raises(ValueError, match="it is damaged"):
        read_weights(content_of({}, {"encoder/a": "encoder/b"}))
