"""The same speech as others might have said it elsewhere: other tempo, pitch, vocal tract and room."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.resampling import change_speed
from phonemeengine.settings import SAMPLE_RATE

RANGE = (0.84, 1.2)
"""How much faster and higher a voice is made, and how much shorter its vocal tract; adult voices span about that."""
DECAYS = (0.12, 0.7)
"""Reverberation times of rooms, seconds to -60 dB."""
DIRECT = (-2.0, 14.0)
"""Level of the direct sound above the reverberation, dB."""
DARKENING = (1, 6)
"""Samples over which the reverberation is blurred: walls swallow high frequencies."""


@dataclass(frozen=True)
class Augmentation:
    """How a recording is varied.

    Attributes
    ----------
    rate : so many times faster and higher, formants too.
    warp : of the mel bank, see `phonemeengine.dsp.log_mel.bank_of`.
    reverberates : whether it is said in a room.
    """

    rate: float = 1.0
    warp: float = 1.0
    reverberates: bool = False


def draw_augmentation(generator: np.random.Generator) -> Augmentation:
    """Draw a variation: in the end the formants lie anywhere in the range, whatever became of the pitch."""
    low, high = np.log(RANGE)
    rate = float(np.exp(generator.uniform(low, high))) if generator.random() < 0.7 else 1.0
    tract = float(np.exp(generator.uniform(low, high)))
    warp = float(np.clip(rate / tract, 0.8, 1.25)) if generator.random() < 0.6 else 1.0
    return Augmentation(rate, warp, generator.random() < 0.4)


def augment(samples: Float32Array, variation: Augmentation, generator: np.random.Generator) -> Float32Array:
    """Vary a recording, float32, shape (n,), 44.1 kHz; it gets shorter by the rate."""
    if variation.rate != 1:
        samples = change_speed(samples, variation.rate)
    return _in_a_room(samples, generator) if variation.reverberates else samples


def _in_a_room(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Add the reverberation of a made-up room: noise that decays, after the direct sound."""
    from scipy.fft import irfft, next_fast_len, rfft  # noqa: PLC0415 - it costs half a second at the start

    decay = generator.uniform(*DECAYS)
    times = np.arange(int(decay * SAMPLE_RATE)) / SAMPLE_RATE
    response = generator.standard_normal(len(times)) * 10 ** (-3 * times / decay)
    blur = int(generator.uniform(*DARKENING))
    response = np.convolve(response, np.ones(blur) / blur, "same")
    response[: int(generator.uniform(0.001, 0.012) * SAMPLE_RATE)] = 0
    response *= 10 ** (-generator.uniform(*DIRECT) / 20) / np.sqrt(np.sum(response**2))
    response[0] += 1
    n = next_fast_len(len(samples) + len(response))
    reverberant: Float32Array = irfft(rfft(samples, n) * rfft(response, n), n)[: len(samples)].astype(np.float32)
    return reverberant
