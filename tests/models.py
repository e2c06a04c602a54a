"""Small models whose answers are known, since they are built by hand."""

from collections.abc import Sequence

import numpy as np

from phonemeengine.dsp.mel import FLOOR, N_BANDS, log_mels
from phonemeengine.labels.visemes import Viseme
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.model import Model, OutputHead
from phonemeengine.recognition.network import TAPS, Layer
from phonemeengine.settings import SAMPLE_RATE, WINDOW

QUIET = np.float32(np.log10(FLOOR))
HEARD = -6.0
"""The logarithm of a band's power above which it counts as heard."""


def band_of(frequency: float) -> int:
    """Say in which mel band a tone is loudest."""
    wave = np.sin(2 * np.pi * frequency * np.arange(WINDOW) / SAMPLE_RATE)
    return int(log_mels(wave.astype(np.float32)[np.newaxis])[0].argmax())


def tone_model(tones: dict[float, Phoneme], n_heads: int = 6, visemes: dict[float, Viseme] | None = None) -> Model:
    """Give a model that names tones: each frequency a phoneme, silence where none of them sounds; and maybe a viseme.

    Head k answers for the frame k before the newest one, which the network finds by a second layer that hands on
    what was heard 0, 1, ... frames ago.
    """
    frequencies = list(tones)
    first = np.zeros((TAPS * N_BANDS, len(frequencies)), np.float32)
    for channel, frequency in enumerate(frequencies):
        first[(TAPS - 1) * N_BANDS + band_of(frequency), channel] = 1.0
    threshold = np.zeros(n_heads * len(tones), np.float32)
    threshold[: len(tones)] = -HEARD
    layers = [Layer(_wide(first, n_heads), threshold, 1)]
    n = len(frequencies)
    for k in range(1, n_heads):
        weights = np.zeros((TAPS * n_heads * n, n_heads * n), np.float32)
        for channel in range(n):
            weights[n_heads * n + (k - 1) * n + channel, k * n + channel] = 1.0  # the middle tap: one frame ago
        layers.append(Layer(weights, np.zeros(n_heads * n, np.float32), 1))
    heads = _heads([tones[f] for f in frequencies], len(Phoneme), n_heads)
    viseme_heads = _heads([visemes[f] for f in frequencies], len(Viseme), n_heads) if visemes else ()
    return Model(tuple(layers), heads, about={"name": "tones"}, viseme_heads=viseme_heads)


def _heads(classes: Sequence[int], n_classes: int, n_heads: int) -> tuple[OutputHead, ...]:
    """Give heads that name a class for each channel of their block, and the first one, silence, for none."""
    heads, n = [], len(classes)
    for k in range(n_heads):
        weights = np.zeros((n_heads * n, n_classes), np.float32)
        weights[k * n + np.arange(n), classes] = 10.0
        bias = np.zeros(n_classes, np.float32)
        bias[0] = 1.0
        heads.append(OutputHead(weights, bias))
    return tuple(heads)


def _wide(first: np.ndarray, n_heads: int) -> np.ndarray:
    """Put what is heard now into the first block of channels, and leave room for what was heard before."""
    wide = np.zeros((first.shape[0], n_heads * first.shape[1]), np.float32)
    wide[:, : first.shape[1]] = first
    return wide


def centred_model(
    width: int = 12, dilations: Sequence[int] = (1, 2, 4, 3), warps: tuple[float, ...] = (1.0,), seed: int = 1
) -> Model:
    """Give a centred model of random weights: nobody knows what it says, but it says it of every sound alike."""
    chance = np.random.default_rng(seed)
    inputs = [N_BANDS, *[width] * (len(dilations) - 1)]
    layers = [_random_layer(chance, n, width, dilation) for n, dilation in zip(inputs, dilations, strict=True)]
    heads, viseme_heads = ((_random_head(chance, width, n),) for n in (len(Phoneme), len(Viseme)))
    return Model(tuple(layers), heads, warps, viseme_heads=viseme_heads, centred=True).rounded()


def _random_layer(chance: np.random.Generator, n_in: int, n_out: int, dilation: int) -> Layer:
    weights = chance.normal(0, (2 / (TAPS * n_in)) ** 0.5, (TAPS * n_in, n_out)).astype(np.float32)
    return Layer(weights, chance.normal(0, 0.1, n_out).astype(np.float32), dilation)


def _random_head(chance: np.random.Generator, n_in: int, n_classes: int) -> OutputHead:
    weights = chance.normal(0, 0.5, (n_in, n_classes)).astype(np.float32)
    return OutputHead(weights, chance.normal(0, 0.5, n_classes).astype(np.float32))
