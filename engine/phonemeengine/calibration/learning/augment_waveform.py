"""The same speech as others might have said it elsewhere: other tempo, pitch, tract, room, sounds and recorder."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.audio.resampling import change_speed
from phonemeengine.calibration.background_sounds import BACKGROUNDS
from phonemeengine.calibration.learning.recording_chain import (
    Chain,
    automatic_gain,
    codec,
    microphone,
    overdrive,
    telephone,
)
from phonemeengine.calibration.learning.room_acoustics import draw_room, impulse_response

RANGE = (0.84, 1.2)
"""How much faster and higher a voice is made, and how much shorter its vocal tract; adult voices span about that."""
IN_A_ROOM, IN_NOISE = 0.4, 0.2
"""Shares of the variations that are said in a made-up room, and over music or the noise of a desk."""
SNRS = (3.0, 30.0)
"""Level of the speech above those sounds, dB."""
CHAINS: tuple[tuple[float, Chain], ...] = (
    (0.25, microphone), (0.06, automatic_gain), (0.05, overdrive), (0.1, codec), (0.05, telephone),
)  # fmt: skip
"""Shares of the variations that go through each, in the order in which they follow each other."""


@dataclass(frozen=True)
class Augmentation:
    """How a recording is varied.

    Attributes
    ----------
    rate : so many times faster and higher, formants too.
    warp : of the mel bank, see `phonemeengine.dsp.log_mel.bank_of`.
    reverberates : whether it is said in a room.
    background : whether there are other sounds.
    chain : what it is recorded through.
    """

    rate: float = 1.0
    warp: float = 1.0
    reverberates: bool = False
    background: bool = False
    chain: tuple[Chain, ...] = ()


def draw_augmentation(generator: np.random.Generator) -> Augmentation:
    """Draw a variation: in the end the formants lie anywhere in the range, whatever became of the pitch."""
    low, high = np.log(RANGE)
    rate = float(np.exp(generator.uniform(low, high))) if generator.random() < 0.7 else 1.0
    tract = float(np.exp(generator.uniform(low, high)))
    warp = float(np.clip(rate / tract, 0.8, 1.25)) if generator.random() < 0.6 else 1.0
    chain = tuple(step for share, step in CHAINS if generator.random() < share)
    return Augmentation(rate, warp, generator.random() < IN_A_ROOM, generator.random() < IN_NOISE, chain)


def augment(samples: Float32Array, variation: Augmentation, generator: np.random.Generator) -> Float32Array:
    """Vary a recording, float32, shape (n,), 44.1 kHz; it gets shorter by the rate."""
    if variation.rate != 1:
        samples = change_speed(samples, variation.rate)
    if not len(samples):
        return samples
    if variation.reverberates:
        samples = _in_a_room(samples, generator)
    if variation.background:
        samples = _over_background(samples, generator)
    for step in variation.chain:
        samples = step(samples, generator)
    return samples


def _in_a_room(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    from scipy.fft import irfft, next_fast_len, rfft  # noqa: PLC0415 - it costs half a second at the start

    response = impulse_response(draw_room(generator), generator)
    n = next_fast_len(len(samples) + len(response), real=True)
    reverberant: Float32Array = irfft(rfft(samples, n) * rfft(response, n), n)[: len(samples)].astype(np.float32)
    return reverberant


def _over_background(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    sound = BACKGROUNDS[generator.integers(len(BACKGROUNDS))](len(samples), generator)
    level = np.sqrt(np.mean(samples.astype(np.float64) ** 2)) * 10 ** (-generator.uniform(*SNRS) / 20)
    return samples + np.float32(level) * sound
