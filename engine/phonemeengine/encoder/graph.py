"""Builds the graphs of Whisper's encoder for ONNX Runtime from its weights.

The weights are a dict of float32 arrays with the names that CTranslate2 gives those of Whisper, without ``encoder/``
(``conv1/weight``, ``layer_0/self_attention/linear_0/weight`` ...). Both graphs take as many layers as they find
there, and the final layer norm where there is one. Pre-norm transformer with heads of 64 numbers (A. Radford et al.,
arXiv:2212.04356).
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array
from phonemeengine.encoder import onnx
from phonemeengine.encoder.weights import N_MELS

Weights = Mapping[str, Float32Array]

HEAD_SIZE = 64
BACK = 150
"""States, 20 ms each, that the live encoder keeps of the past."""
SLOTS = BACK + 2
"""States that its cache keeps of each layer, in a ring: state i lies at i modulo `SLOTS`."""
N_HALVES = 2
"""Frames of 10 ms in a state."""
EPSILON = 1e-5
MASKED = -1e9
LIMIT = 63
"""Quantised weights lie within ± this: on processors with AVX2 alone, sums of two products of 8 bits overflow."""
ACTIVATION_LIMIT, ACTIVATION_ZERO = 127, 128
"""Quantised inputs lie within ± this around that, in unsigned bytes."""
FINER = 2 * ACTIVATION_LIMIT
"""By how much the steps of the second rounding are smaller: what the first one leaves lies within ± half a step."""
LEAST_SCALE = 1e-12
_INTEGERS = {"count", "ahead"}


def layer_count(weights: Weights) -> int:
    """Return how many layers there are weights of."""
    return next(k for k in range(len(weights) + 1) if f"layer_{k}/ffn/linear_0/bias" not in weights)


def whole_graph(weights: Weights, bits: int, metadata: Mapping[str, str] | None = None) -> bytes:
    """Return the model that encodes an excerpt which is wholly known: absolute positions, no mask.

    Input ``mel``: float32, shape (1, 80, 2 n), n <= 1500. Output ``states``: float32, shape (1, n, n_channels).

    Parameters
    ----------
    weights : as the module says.
    bits : 32 for float32, 8 for matrices of bytes.
    metadata : texts by name, kept in the model.
    """
    graph = _Graph(bits, n_roundings=1)
    frames = _time_first(graph, "mel")
    edge = graph.constant(np.array([0, 1, 0, 0, 1, 0], np.int64))
    frames = _convolution(graph, weights, "conv1", graph.node("Pad", frames, edge), step=1)
    states = _convolution(graph, weights, "conv2", graph.node("Pad", frames, edge), step=2)
    positions = graph.constant(weights["position_encodings/encodings"][np.newaxis])
    states = graph.node("Add", states, graph.slice(positions, graph.integers(0), graph.length(states, 1), 1))
    for k in range(layer_count(weights)):
        states = _after_attention(graph, weights, k, states, _whole_attention(graph, weights, k, states))
    states = _final_norm(graph, weights, states)
    return graph.model({"mel": [1, N_MELS, "frames"]}, {"states": states}, metadata or {})


def live_graph(
    weights: Weights, bits: int, metadata: Mapping[str, str] | None = None, anchors: NDArray[np.float16] | None = None
) -> bytes:
    """Return the model that encodes sounds as they come, several side by side, each with a past of its own.

    State i of a layer attends to the states i - 150 to i of the layer below, in the first layer also to i + 1 where
    ``ahead`` is 1. Then the first layer answers one state later: of n new states the outputs are about those from one
    before the first, which for a new sound is none at all and to be thrown away.

    Inputs
    ------
    mel : float32, (batch, 80, 2 n + 3): the mel frames of n new states and the three before them; frame -2 first.
    count : int64, (batch,): states that came of each sound before.
    ahead : int64, (1,): 0 or 1, always the same for a sound.
    pending : float32, (batch, 1, n_channels): what the last call gave; anything for a new sound.
    keys_K, values_K : float32, (batch, n_heads, 64, 152) and (batch, n_heads, 152, 64): the ring of each layer K, in
        which the new ones are to be written at (c + k) modulo 152, k = 0 .. n - 1; c is ``count`` in the first layer
        and ``count`` - ``ahead`` in all others.

    Outputs
    -------
    states : float32, (batch, n, n_channels): after the last norm.
    next_pending : float32, as ``pending``.
    new_keys_K, new_values_K : float32, (batch, n_heads, 64, n) and (batch, n_heads, n, 64).
    head_weights, head_bias : float32, (n_channels, 2 x n_classes) and (2 x n_classes,): the head, always the same.
        States times the one plus the other are the logits of the first 10 ms of each, and of the second.
    anchors : float16, as given.

    Parameters
    ----------
    weights : besides those of the module, ``position_encodings/encodings`` (1, n_channels): the same for all
        positions; ``layer_K/self_attention/relative_bias`` (n_heads, 152): what is added to the score of a key j for
        the query i, at the column j - i + 150; and ``head/weight`` (2 x n_classes, n_channels) and ``head/bias``.
    bits, metadata : as of `whole_graph`.
    anchors : speech of many voices that is kept in the model, mel frames of shape (n, n_frames, 80); None for none.
    """
    graph = _Graph(bits, n_roundings=2)
    frames = _convolution(graph, weights, "conv1", _time_first(graph, "mel"), step=1)
    newest = _convolution(graph, weights, "conv2", frames, step=2)
    newest = graph.node("Add", newest, graph.constant(weights["position_encodings/encodings"]))
    n, known = graph.length(newest, 1), graph.node("Concat", "pending", newest, axis=1)
    outputs = {"next_pending": graph.slice(known, n, graph.node("Add", n, graph.integers(1)), 1)}
    one = graph.integers(1)
    start = graph.node("Sub", one, "ahead")
    end, none = graph.node("Add", start, n), graph.integers(0)
    states, ahead, count = graph.slice(known, start, end, 1), "ahead", "count"
    for k in range(layer_count(weights)):
        name = f"layer_{k}/self_attention"
        parts = _heads_of(graph, weights, name, _norm(graph, weights, f"{name}/layer_norm", states if k else known))
        if k == 0:
            parts = _of_first_layer(graph, parts, n, (start, end), one)
        if k < 2:  # all layers but the first look at the same places
            places = _places(graph, n, count, ahead)
            ahead, count = none, graph.node("Sub", "count", "ahead")
        bias = _relative_bias(graph, weights[f"{name}/relative_bias"], places)
        states = _after_attention(graph, weights, k, states, _attention(graph, parts, k, bias))
        outputs |= {f"new_keys_{k}": parts.keys, f"new_values_{k}": parts.values}
    outputs = {"states": _final_norm(graph, weights, states), **outputs}
    inputs = live_inputs(layer_count(weights), len(weights["conv2/bias"]))
    return graph.model(inputs, outputs, metadata or {}, _kept_of(weights, anchors))


def _kept_of(weights: Weights, anchors: NDArray[np.float16] | None) -> dict[str, NDArray[Any]]:
    """Return what is always the same: the head, and the anchors."""
    return {
        "head_weights": weights["head/weight"].T.astype(np.float32),
        "head_bias": weights["head/bias"].astype(np.float32),
        "anchors": np.zeros((0, 0, N_MELS), np.float16) if anchors is None else anchors,
    }


class _HeadInputs(NamedTuple):
    """Names of queries and values, (batch, n_heads, n, 64), and of keys, (batch, n_heads, 64, n)."""

    queries: str
    keys: str
    values: str


class _Graph:
    """Nodes and constants of a graph that is being made; each is known by the name of its result.

    Parameters
    ----------
    bits : 8 or 32, of the weights.
    n_roundings : of the inputs of 8-bit matrices: 1 to bytes, or 2, where what that leaves is rounded to bytes, too.
    """

    def __init__(self, bits: int, n_roundings: int) -> None:
        if bits not in {8, 32}:
            raise ValueError(f"the weights have 8 or 32 bits, got {bits}")
        self._bits, self._n_roundings = bits, n_roundings
        self._nodes: list[bytes] = []
        self._constants: list[bytes] = []

    def constant(self, array: NDArray[Any]) -> str:
        """Add an array that is the same in all calls."""
        name = f"c{len(self._constants)}"
        self._constants.append(onnx.tensor(name, array))
        return name

    def integers(self, *values: int) -> str:
        """Add constant int64 numbers, shape (n,)."""
        return self.constant(np.array(values, np.int64))

    def number(self, value: float) -> str:
        """Add a constant float32 number."""
        return self.constant(np.array(value, np.float32))

    def node(self, kind: str, *inputs: str, **attributes: Any) -> str:
        """Add a node with one result."""
        name = f"n{len(self._nodes)}"
        self._nodes.append(onnx.node(kind, inputs, [name], **attributes))
        return name

    def slice(self, array: str, start: str, end: str, axis: int) -> str:
        """Add a slice along one axis; start and end are of shape (1,)."""
        return self.node("Slice", array, start, end, self.integers(axis))

    def halves(self, array: str, axis: int) -> tuple[str, str]:
        """Add the two halves of an array along an axis."""
        names = f"n{len(self._nodes)}", f"n{len(self._nodes)}_second"
        self._nodes.append(onnx.node("Split", [array], names, axis=axis, num_outputs=2))
        return names

    def length(self, array: str, axis: int) -> str:
        """Add the length of an array along an axis, shape (1,)."""
        return self.node("Shape", array, start=axis, end=axis + 1)

    def linear(self, inputs: str, weight: Float32Array, bias: Float32Array) -> str:
        """Add the product with a matrix (n_out, n_in), plus a bias (n_out,)."""
        product = self._quantised(inputs, weight) if self._bits == 8 else self.product(inputs, weight)
        return self.node("Add", product, self.constant(bias.astype(np.float32)))

    def product(self, inputs: str, weight: Float32Array) -> str:
        """Add the product with a matrix (n_out, n_in) in float32."""
        return self.node("MatMul", inputs, self.constant(weight.T.astype(np.float32)))

    def _quantised(self, inputs: str, weight: Float32Array) -> str:
        # Each output of the matrix, and each row of the inputs, has a scale of its own. The latter makes the answer
        # independent of the rows beside it, so a sound may be shared with others.
        scales = np.maximum(np.abs(weight).max(axis=1) / LIMIT, LEAST_SCALE).astype(np.float32)
        quantised = np.round(weight / scales[:, np.newaxis]).astype(np.int8)
        most = self.node("ReduceMax", self.node("Abs", inputs), self.integers(-1), keepdims=1)
        most = self.node("Max", most, self.number(LEAST_SCALE))
        step, zero = self.number(1 / ACTIVATION_LIMIT), self.constant(np.array(ACTIVATION_ZERO, np.uint8))
        scaled = self.node("Div", inputs, most)
        as_bytes = self.node("QuantizeLinear", scaled, step, zero)
        if self._n_roundings == 2:
            # How a sound is cut changes the order of sums, and so the last digits of what is rounded here. Where one
            # turns a rounding, the second one makes up for it: the answer moves by 1/254 of what it would else.
            rest = self.node("Sub", scaled, self.node("DequantizeLinear", as_bytes, step, zero))
            fine = self.node("QuantizeLinear", rest, self.number(1 / (ACTIVATION_LIMIT * FINER)), zero)
            as_bytes = self.node("Concat", as_bytes, fine, axis=1)  # as more rows: the matrix is read once
        # one operator in place of a product, a conversion and two scales: at a state a time, operators cost as much
        # as the work
        factors = self.constant(quantised.T), step, self.constant(scales), zero
        product = self.node("MatMulIntegerToFloat", as_bytes, *factors, domain=onnx.CONTRIBUTED)
        if self._n_roundings == 2:
            product, fine = self.halves(product, 1)
            product = self.node("Add", product, self.node("Mul", fine, self.number(1 / FINER)))
        return self.node("Mul", product, most)

    def model(
        self,
        inputs: Mapping[str, Sequence[int | str]],
        outputs: Mapping[str, str],
        metadata: Mapping[str, str],
        kept: Mapping[str, NDArray[Any]] | None = None,
    ) -> bytes:
        """Return the model's file: inputs of these shapes, outputs that are these nodes, others that are arrays."""
        ends = [onnx.node("Identity", [found], [name]) for name, found in outputs.items()]
        kept = kept or {}
        ends += [onnx.node("Identity", [self.constant(array)], [name]) for name, array in kept.items()]
        kinds = {name: np.int64 if name in _INTEGERS else np.float32 for name in inputs}
        return onnx.model(
            [*self._nodes, *ends],
            self._constants,
            [onnx.port(name, kinds[name], shape) for name, shape in inputs.items()],
            [
                *(onnx.port(name, np.float32, None) for name in outputs),
                *(onnx.port(name, array.dtype, array.shape) for name, array in kept.items()),
            ],
            metadata,
        )


def _time_first(graph: _Graph, mel: str) -> str:
    """Turn (batch, 80, n) into (batch, n, 80), so that a frame is a row."""
    return graph.node("Transpose", mel, perm=[0, 2, 1])


def _convolution(graph: _Graph, weights: Weights, name: str, frames: str, step: int) -> str:
    """Add a convolution over three rows, without padding, and its activation."""
    # the three rows of each answer side by side times one matrix: it can be quantised as all others are
    weight = weights[f"{name}/weight"]
    n_out, n_in, n_taps = weight.shape
    n, axis, stride = graph.length(frames, 1), graph.integers(1), graph.integers(step)
    taps = []
    for k in range(n_taps):
        end = graph.node("Sub", n, graph.integers(n_taps - 1 - k))
        taps.append(graph.node("Slice", frames, graph.integers(k), end, axis, stride))
    matrix = weight.transpose(0, 2, 1).reshape(n_out, n_taps * n_in)
    beside = graph.node("Concat", *taps, axis=2)
    if step == 1:  # the mel bands themselves stay as exact as they are: it is the smallest matrix
        found = graph.node("Add", graph.product(beside, matrix), graph.constant(weights[f"{name}/bias"]))
    else:
        found = graph.linear(beside, matrix, weights[f"{name}/bias"])
    return graph.node("Gelu", found)


def _norm(graph: _Graph, weights: Weights, name: str, states: str) -> str:
    scale, bias = (graph.constant(weights[f"{name}/{part}"]) for part in ("gamma", "beta"))
    return graph.node("LayerNormalization", states, scale, bias, axis=-1, epsilon=EPSILON)


def _final_norm(graph: _Graph, weights: Weights, states: str) -> str:
    return _norm(graph, weights, "layer_norm", states) if "layer_norm/gamma" in weights else states


def _heads_of(graph: _Graph, weights: Weights, name: str, normed: str) -> _HeadInputs:
    """Add queries, keys and values of normed states; queries are scaled by 1 / 8, so that scores are."""
    weight, bias = weights[f"{name}/linear_0/weight"].copy(), weights[f"{name}/linear_0/bias"].copy()
    n_channels = weight.shape[1]
    weight[:n_channels] *= HEAD_SIZE**-0.5
    bias[:n_channels] *= HEAD_SIZE**-0.5
    shape = graph.integers(0, 0, 3, n_channels // HEAD_SIZE, HEAD_SIZE)
    split = graph.node("Reshape", graph.linear(normed, weight, bias), shape)
    parts = [graph.node("Gather", split, graph.constant(np.array(k, np.int64)), axis=2) for k in range(3)]
    queries, values = (graph.node("Transpose", parts[k], perm=[0, 2, 1, 3]) for k in (0, 2))
    return _HeadInputs(queries, graph.node("Transpose", parts[1], perm=[0, 2, 3, 1]), values)


def _of_first_layer(graph: _Graph, parts: _HeadInputs, n: str, asked: tuple[str, str], one: str) -> _HeadInputs:
    """Return the queries of the states from the pending one on, and the keys and values of the new ones."""
    after = graph.node("Add", n, one)
    queries = graph.slice(parts.queries, *asked, 2)
    return _HeadInputs(queries, graph.slice(parts.keys, one, after, 3), graph.slice(parts.values, one, after, 2))


def _whole_attention(graph: _Graph, weights: Weights, layer: int, states: str) -> str:
    """Add attention to all states of an excerpt, shape (batch, n, n_channels)."""
    # ONNX Runtime's own operator never writes down the scores of all queries and keys, which takes a seventh off.
    name = f"layer_{layer}/self_attention"
    both = _linear(graph, weights, f"{name}/linear_0", _norm(graph, weights, f"{name}/layer_norm", states))
    n = len(weights[f"{name}/linear_1/bias"])
    parts = [graph.slice(both, graph.integers(k * n), graph.integers((k + 1) * n), 2) for k in range(3)]
    return graph.node("MultiHeadAttention", *parts, domain=onnx.CONTRIBUTED, num_heads=n // HEAD_SIZE)


def _attention(graph: _Graph, parts: _HeadInputs, layer: int, bias: str) -> str:
    """Add attention to what the ring of a layer holds and to what is new, shape (batch, n, n_channels)."""
    # Two products each, so that the ring is never copied to be laid beside what is new.
    old = graph.node("MatMul", parts.queries, f"keys_{layer}")
    new = graph.node("MatMul", parts.queries, parts.keys)
    scores = graph.node("Add", graph.node("Concat", old, new, axis=3), bias)
    shares = graph.node("Softmax", scores, axis=-1)
    zero, slots, end = graph.integers(0), graph.integers(SLOTS), graph.length(shares, 3)
    found = graph.node("MatMul", graph.slice(shares, zero, slots, 3), f"values_{layer}")
    found = graph.node("Add", found, graph.node("MatMul", graph.slice(shares, slots, end, 3), parts.values))
    beside = graph.node("Transpose", found, perm=[0, 2, 1, 3])
    return graph.node("Reshape", beside, graph.integers(0, 0, -1))


def _places(graph: _Graph, n: str, count: str, ahead: str) -> str:
    """Add the column of the relative bias for each query and key, int64, shape (batch, n, 152 + n).

    Keys that are not seen, since they are too far away, do not exist yet or no longer, have the column 152.
    """
    # Relative to the first new state a key lies at -152 .. -1, or is new. What a slot of the ring holds follows from
    # the number of states that came: the latest whose number is that slot's, modulo 152.
    one, zero, columns = graph.integers(1), graph.integers(0), graph.integers(SLOTS)
    slots = graph.constant(np.arange(SLOTS, dtype=np.int64)[np.newaxis])
    came = graph.node("Unsqueeze", count, one)
    old = graph.node("Sub", graph.node("Mod", graph.node("Sub", slots, came), columns), columns)
    squeezed = [graph.node("Squeeze", number) for number in (zero, n, one)]
    new = graph.node("Range", *squeezed)
    beside = graph.node("Expand", new, graph.node("Concat", graph.length(came, 0), n, axis=0))
    keys = graph.node("Concat", old, beside, axis=1)
    exists = graph.node("GreaterOrEqual", keys, graph.node("Neg", came))
    queries = graph.node("Sub", graph.node("Unsqueeze", new, one), ahead)
    offset = graph.node("Sub", graph.node("Unsqueeze", keys, one), queries)
    column = graph.node("Add", offset, graph.integers(BACK))
    last = graph.node("Add", ahead, graph.integers(BACK))
    near = graph.node("And", graph.node("GreaterOrEqual", column, zero), graph.node("LessOrEqual", column, last))
    return graph.node("Where", graph.node("And", near, graph.node("Unsqueeze", exists, one)), column, columns)


def _relative_bias(graph: _Graph, bias: Float32Array, places: str) -> str:
    """Add what is added to the scores, shape (batch, n_heads, n, 152 + n)."""
    hidden = np.full((len(bias), 1), MASKED, np.float32)
    table = graph.constant(np.concatenate((bias, hidden), axis=1).T)
    return graph.node("Transpose", graph.node("Gather", table, places, axis=0), perm=[0, 3, 1, 2])


def _after_attention(graph: _Graph, weights: Weights, layer: int, states: str, found: str) -> str:
    """Add what attention found to the states, and then what the two linear maps make of them."""
    name = f"layer_{layer}"
    states = graph.node("Add", states, _linear(graph, weights, f"{name}/self_attention/linear_1", found))
    hidden = _linear(graph, weights, f"{name}/ffn/linear_0", _norm(graph, weights, f"{name}/ffn/layer_norm", states))
    return graph.node("Add", states, _linear(graph, weights, f"{name}/ffn/linear_1", graph.node("Gelu", hidden)))


def _linear(graph: _Graph, weights: Weights, name: str, inputs: str) -> str:
    return graph.linear(inputs, weights[f"{name}/weight"], weights[f"{name}/bias"])


def live_inputs(n_layers: int, n_channels: int) -> dict[str, list[int | str]]:
    """Return the names and shapes of the inputs of a live graph."""
    inputs: dict[str, list[int | str]] = {
        "mel": ["batch", N_MELS, "frames"],
        "count": ["batch"],
        "ahead": [1],
        "pending": ["batch", 1, n_channels],
    }
    heads: list[int | str] = ["batch", n_channels // HEAD_SIZE]
    for k in range(n_layers):
        inputs |= {f"keys_{k}": [*heads, HEAD_SIZE, SLOTS], f"values_{k}": [*heads, SLOTS, HEAD_SIZE]}
    return inputs
