"""A Whisper model as CTranslate2 keeps it: the base model's encoder with random weights, and a piece of a decoder."""

import struct
from pathlib import Path

import numpy as np

from phonemeengine.encoder.head import SHAPES, EncoderHead
from phonemeengine.encoder.weights import OUTPUT, PREFIX, shapes_of


def write_whisper_model(folder: Path) -> Path:
    """Write `model.bin` into a folder."""
    chance = np.random.default_rng(1)
    variables = {"decoder/scale": np.array(1, np.int8)}
    for name, shape in shapes_of(OUTPUT).items():
        drawn = chance.standard_normal(shape, np.float32) * np.float32(0.05)
        variables[PREFIX + name] = (1 + drawn if name.endswith("gamma") else drawn).astype(np.float16)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "model.bin").write_bytes(content_of(variables, {"decoder/same": "decoder/scale"}))
    return folder


def content_of(variables: dict[str, np.ndarray], aliases: dict[str, str], kind: str = "WhisperSpec") -> bytes:
    """Return the file, as CTranslate2's documents say."""
    codes = {"float32": 0, "int8": 1, "float16": 4}
    parts = [struct.pack("<I", 6), _text(kind), struct.pack("<II", 3, len(variables))]
    for name, values in variables.items():
        sizes = struct.pack(f"<B{values.ndim}I", values.ndim, *values.shape)
        parts += [_text(name), sizes, struct.pack("<BI", codes[values.dtype.name], values.nbytes), values.tobytes()]
    parts.append(struct.pack("<I", len(aliases)))
    return b"".join([*parts, *(_text(name) for pair in aliases.items() for name in pair)])


def _text(words: str) -> bytes:
    encoded = words.encode() + b"\0"
    return struct.pack("<H", len(encoded)) + encoded


def encoder_head(n_components: int = 6, n_hidden: int = 9, seed: int = 1) -> EncoderHead:
    """Give a head of random weights."""
    chance = np.random.default_rng(seed)
    free = {
        "projection": (512, n_components),
        "hidden_weights": (5 * n_components, n_hidden),
        "hidden_bias": (n_hidden,),
        "weights": (n_hidden, 52),
    }
    arrays = {name: chance.normal(0, 0.3, free.get(name, sizes)).astype(np.float32) for name, sizes in SHAPES.items()}
    arrays["priors"] = np.full(26, 1 / 26, np.float32)
    return EncoderHead(**arrays).rounded()
