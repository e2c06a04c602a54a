"""A Whisper model as CTranslate2 keeps it, as wide as the base model's encoder, of one layer and random weights."""

from pathlib import Path

import numpy as np
from ctranslate2.specs import WhisperSpec

from phonemeengine.encoder.head import SHAPES, EncoderHead

WIDTH, HEADS, N_MELS, VOCABULARY = 512, 8, 80, 8


def write_whisper_model(folder: Path) -> Path:
    """Write `model.bin` and `config.json` into a folder."""
    weights = Weights()
    spec = WhisperSpec(1, HEADS, 1, HEADS)
    encoder, decoder = spec.encoder, spec.decoder
    for conv, n_in in ((encoder.conv1, N_MELS), (encoder.conv2, WIDTH)):
        conv.weight, conv.bias = weights.random(WIDTH, n_in, 3), weights.random(WIDTH)
    encoder.position_encodings.encodings = weights.random(1500, WIDTH)
    decoder.position_encodings.encodings = weights.random(16, WIDTH)
    decoder.embeddings.weight = weights.random(VOCABULARY, WIDTH)
    weights.fill_linear(decoder.projection, VOCABULARY, WIDTH)
    for part in (encoder, decoder):
        weights.fill_norm(part.layer_norm)
        weights.fill_attention(part.layer[0].self_attention, (3, 1))
        weights.fill_feed_forward(part.layer[0].ffn)
    weights.fill_attention(decoder.layer[0].attention, (1, 2, 1))
    spec.register_vocabulary([f"<{k}>" for k in range(VOCABULARY)])
    spec.validate()
    folder.mkdir(parents=True, exist_ok=True)
    spec.optimize("int8_float32")
    spec.save(str(folder))
    return folder


class Weights:
    """Draws the weights of a model's parts."""

    def __init__(self) -> None:
        self._chance = np.random.default_rng(1)

    def random(self, *shape: int) -> np.ndarray:
        return self._chance.normal(0, 0.05, shape).astype(np.float32)

    def fill_norm(self, norm) -> None:
        norm.gamma, norm.beta = np.ones(WIDTH, np.float32), np.zeros(WIDTH, np.float32)

    def fill_linear(self, linear, n_out: int, n_in: int) -> None:
        linear.weight, linear.bias = self.random(n_out, n_in), self.random(n_out)

    def fill_attention(self, attention, widths: tuple[int, ...]) -> None:
        self.fill_norm(attention.layer_norm)
        for linear, n in zip(attention.linear, widths, strict=True):
            self.fill_linear(linear, n * WIDTH, WIDTH)

    def fill_feed_forward(self, ffn) -> None:
        self.fill_norm(ffn.layer_norm)
        self.fill_linear(ffn.linear_0, 2 * WIDTH, WIDTH)
        self.fill_linear(ffn.linear_1, WIDTH, 2 * WIDTH)


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
