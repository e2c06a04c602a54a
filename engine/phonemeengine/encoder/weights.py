"""The weights of Whisper's encoder, read from `model.bin` as CTranslate2 keeps it. NumPy alone."""

import struct

import numpy as np

from phonemeengine.arrays import Float32Array

# CTranslate2's format (https://github.com/OpenNMT/CTranslate2, python/ctranslate2/specs/model_spec.py): version of
# the format, name and revision of the kind of model, number of variables; of each its name, sizes, type of number,
# and the numbers; then other names of variables that are equal to one of them. All is little-endian.
VERSION, PREFIX = 6, "encoder/"
TYPES = {0: "<f4", 4: "<f2"}
N_MELS, N_STATES, N_INNER, N_POSITIONS, N_LAYERS = 80, 512, 2048, 1500, 6
"""Sizes of Whisper base; the last number is that of its layers."""
OUTPUT = N_LAYERS
"""Stands in the place of a layer's number for the encoder's output: the last layer and its norm."""
Weights = dict[str, Float32Array]
"""By name, such as ``layer_0/ffn/linear_0/weight``; those of a linear map have the shape (outputs, inputs)."""


def read_weights(content: bytes, layer: int = OUTPUT) -> Weights:
    """Return the weights that the encoder's states after a layer need, float32.

    Parameters
    ----------
    content : of `model.bin`.
    layer : 0..5, or `OUTPUT`.

    Raises
    ------
    ValueError : it is no Whisper base, is damaged, or has no floating-point weights; why, in words.
    """
    found, weights = _variables(content), dict[str, Float32Array]()
    for name, shape in shapes_of(layer).items():
        if name not in found:
            raise ValueError(f"{PREFIX}{name} is missing")
        sizes, code, values = found[name]
        if sizes != shape:
            raise ValueError(f"{PREFIX}{name} has the shape {sizes}, that of Whisper base {shape}")
        if code not in TYPES:
            raise ValueError(f"{PREFIX}{name} is neither float16 nor float32")
        weights[name] = np.frombuffer(values, TYPES[code]).reshape(shape).astype(np.float32)
    return weights


def shapes_of(layer: int) -> dict[str, tuple[int, ...]]:
    """Return the names and shapes of what the encoder's states after a layer need."""
    shapes: dict[str, tuple[int, ...]] = {"position_encodings/encodings": (N_POSITIONS, N_STATES)}
    for name, n_in in (("conv1", N_MELS), ("conv2", N_STATES)):
        shapes |= {f"{name}/weight": (N_STATES, n_in, 3), f"{name}/bias": (N_STATES,)}
    linears = {
        "self_attention": ((3 * N_STATES, N_STATES), (N_STATES, N_STATES)),
        "ffn": ((N_INNER, N_STATES), (N_STATES, N_INNER)),
    }
    norms = [] if layer < OUTPUT else ["layer_norm"]
    for k in range(min(layer + 1, N_LAYERS)):
        for part, sizes in linears.items():
            norms.append(f"layer_{k}/{part}/layer_norm")
            for i, size in enumerate(sizes):
                shapes |= {
                    f"layer_{k}/{part}/linear_{i}/{name}": size[:n] for name, n in (("weight", 2), ("bias", 1))
                }
    return shapes | {f"{norm}/{name}": (N_STATES,) for norm in norms for name in ("gamma", "beta")}


_Variable = tuple[tuple[int, ...], int, memoryview]
"""Its sizes, the code of its type, its numbers."""


def _variables(content: bytes) -> dict[str, _Variable]:
    """Return the variables of the encoder, by name without `PREFIX`, and those of the decoder."""
    reader, found = _Unpacker(content), dict[str, _Variable]()
    try:
        version, kind = reader.take("I"), reader.take_name()
        if (version, kind) != (VERSION, "WhisperSpec"):
            raise ValueError(f"it is no Whisper model of CTranslate2 in version {VERSION} of the format")
        reader.take("I")  # the revision of the kind
        for _ in range(reader.take("I")):
            name, shape = reader.take_name(), tuple(reader.take("I") for _ in range(reader.take("B")))
            found[name] = shape, reader.take("B"), reader.take_bytes(reader.take("I"))
        for _ in range(reader.take("I")):
            name, same = reader.take_name(), reader.take_name()
            found[name] = found[same]
    except (UnicodeDecodeError, KeyError) as error:
        raise ValueError("it is damaged") from error
    return {name.removeprefix(PREFIX): variable for name, variable in found.items()}


class _Unpacker:
    """Takes one after the other what stands in a file."""

    def __init__(self, content: bytes) -> None:
        self._content, self._place = memoryview(content), 0

    def take(self, form: str) -> int:
        """Take a whole number of a form that `struct` knows."""
        return int(struct.unpack(f"<{form}", self.take_bytes(struct.calcsize(f"<{form}")))[0])

    def take_bytes(self, n: int) -> memoryview:
        """Take n bytes."""
        self._place += n
        if self._place > len(self._content):
            raise ValueError("it ends too early")
        return self._content[self._place - n : self._place]

    def take_name(self) -> str:
        """Take a name, which stands behind its length."""
        return str(self.take_bytes(self.take("H")), "utf-8").rstrip("\0")
