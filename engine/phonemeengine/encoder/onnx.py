"""Networks for ONNX Runtime: opened, on the processor, and written as ONNX files. Alone imports onnxruntime.

The few messages of onnx.proto3 (https://github.com/onnx/onnx) that this takes are written here, so that who cuts a
network out of another one on his own machine needs no further library.
"""

from collections.abc import Iterable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from phonemeengine.errors import ModelError

LIBRARY = "onnxruntime"
ERRORS_ALONE = 3
"""The library's own level of what it writes to the standard error output."""


def has_runtime() -> bool:
    """Return whether the library is installed, without opening it."""
    return find_spec(LIBRARY) is not None


def open_session(model: Path | bytes, n_threads: int) -> Any:
    """Return an ``onnxruntime.InferenceSession``.

    Parameters
    ----------
    model : a file, or its content.
    n_threads : that work on a run.

    Raises
    ------
    ModelError : onnxruntime is not installed, or it cannot open the model; why, in its words.
    """
    try:
        import onnxruntime  # noqa: PLC0415 - it is an extra
    except ImportError as error:
        raise ModelError(
            "the speech encoder needs onnxruntime, which is not installed; install phonemeanalyser[encoder]"
        ) from error
    onnxruntime.disable_telemetry_events()  # of Windows; nothing about a sound leaves the program
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = n_threads
    options.log_severity_level = ERRORS_ALONE
    # threads that wait for the next operator sleep, instead of taking a core from other programs
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    source = model if isinstance(model, bytes) else str(model)
    try:
        return onnxruntime.InferenceSession(source, options, providers=["CPUExecutionProvider"])
    except Exception as error:  # the library raises its own, which have nothing but Exception in common
        raise ModelError(f"the network cannot be opened ({first_line(error)}); get it anew") from error


def first_line(error: Exception) -> str:
    """Return the first sentence of what a library says went wrong, for a place in ours."""
    words = (str(error).strip() or type(error).__name__).splitlines()[0]
    return words.removeprefix("Got: ").split(". ")[0][:160]


OPSET, IR_VERSION = 20, 9
"""Of ONNX: the first opset with Gelu; what ONNX Runtime reads from version 1.17 on."""
CONTRIBUTED = "com.microsoft"
"""The domain of the operators that ONNX Runtime has besides those of ONNX."""
TYPES = {"float32": 1, "uint8": 2, "int8": 3, "int64": 7, "float16": 10}
"""Codes of the types of numbers, as in ``TensorProto.DataType``."""


def tensor(name: str, values: NDArray[Any]) -> bytes:
    """Return a constant."""
    little = np.asarray(values, values.dtype.newbyteorder("<"), order="C").tobytes()
    sizes = [_field(1, size) for size in values.shape]
    return b"".join((*sizes, _field(2, TYPES[values.dtype.name]), _field(8, name), _field(9, little)))


def node(kind: str, inputs: Iterable[str], outputs: Sequence[str], domain: str = "", **attributes: Any) -> bytes:
    """Return an operator, named as its first output; attributes are floats, whole numbers, or sequences of those."""
    # ONNX Runtime names what it fuses by these names, and before 1.22 refuses a graph in which two are the same
    fields = [*(_field(1, name) for name in inputs), *(_field(2, name) for name in outputs)]
    fields += [_field(3, outputs[0]), _field(4, kind)]
    fields += [_field(5, _attribute(*each)) for each in attributes.items()]
    return b"".join((*fields, _field(7, domain) if domain else b""))


def port(name: str, dtype: DTypeLike, shape: Sequence[int | str] | None) -> bytes:
    """Return an input or output; sizes that may differ are names, and None leaves the shape open."""
    sizes = b"".join(_field(1, _field(1 if isinstance(size, int) else 2, size)) for size in shape or ())
    kind = _field(1, TYPES[np.dtype(dtype).name]) + (_field(2, sizes) if shape is not None else b"")
    return _field(1, name) + _field(2, _field(1, kind))


def model(
    nodes: Iterable[bytes],
    tensors: Iterable[bytes],
    inputs: Iterable[bytes],
    outputs: Iterable[bytes],
    metadata: Mapping[str, str],
) -> bytes:
    """Return the content of a file, with texts by name beside the graph."""
    parts = {1: nodes, 2: [b"encoder"], 5: tensors, 11: inputs, 12: outputs}
    graph = b"".join(_field(number, part) for number, group in parts.items() for part in group)
    opsets = (_field(2, OPSET), _field(1, CONTRIBUTED) + _field(2, 1))
    texts = (_field(1, name) + _field(2, text) for name, text in metadata.items())
    rest = [_field(8, opset) for opset in opsets] + [_field(14, text) for text in texts]
    return b"".join((_field(1, IR_VERSION), _field(7, graph), *rest))


def _attribute(name: str, value: Any) -> bytes:
    # Each kind of value has a field of its own; the last one tells which, as in ``AttributeProto.AttributeType``.
    if isinstance(value, float):
        return _field(1, name) + _tag(2, 5) + np.array(value, "<f4").tobytes() + _field(20, 1)
    if isinstance(value, int):
        return _field(1, name) + _field(3, value) + _field(20, 2)
    return b"".join((_field(1, name), *(_field(8, each) for each in value), _field(20, 7)))


def _field(number: int, value: int | str | bytes) -> bytes:
    """Return a field of a message of protobuf: a number, or bytes with their length before them."""
    if isinstance(value, int):
        return _tag(number, 0) + _varint(value)
    content = value.encode() if isinstance(value, str) else value
    return b"".join((_tag(number, 2), _varint(len(content)), content))


def _tag(number: int, wire_type: int) -> bytes:
    return _varint(number << 3 | wire_type)


def _varint(value: int) -> bytes:
    """Return a number, seven bits a byte, the lowest first; negative ones are of 64 bits."""
    value &= (1 << 64) - 1
    groups = bytearray()
    while value > 127:
        groups.append(value & 127 | 128)
        value >>= 7
    return bytes([*groups, value])
