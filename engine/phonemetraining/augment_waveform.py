"""The same speech as others might have said it elsewhere: other tempo, pitch, tract, room, sounds and recorder.

A recorder is a chain of microphone, automatic gain, overdrive, telephone and codec.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.libsndfile import through_codec
from phonemeengine.audio.resampling import change_speed, resample_whole
from phonemeengine.calibration.background_sounds import BACKGROUNDS
from phonemeengine.settings import SAMPLE_RATE
from phonemetraining.room_acoustics import draw_room, impulse_response

TELEPHONE_RATE = 8000
TELEPHONE_BAND = (300.0, 3400.0)
"""Hertz (ITU-T G.712)."""
MU = 255
"""Of the compression of telephones (ITU-T G.711)."""
GAIN_TIME = 0.4
"""Seconds over which an automatic gain follows the level."""
CODECS = (("MP3", "MPEG_LAYER_III", 44_100, 0.9), ("OGG", "VORBIS", 44_100, 0.999), ("OGG", "OPUS", 16_000, 0.98))
"""Container, codec, sample rate and the most compression, 0..1, that is used: down to 40, 60 and 10 kbit/s."""

Chain = Callable[[Float32Array, np.random.Generator], Float32Array]


def microphone(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Return what a drawn microphone makes of a sound: less bass, more presence, an end of the treble."""
    bass, presence, treble = generator.uniform(30, 200), generator.uniform(2000, 6000), generator.uniform(5000, 16000)
    height = 10 ** (generator.uniform(0, 8) / 20) - 1

    def response(frequencies: Float64Array) -> Float64Array:
        octaves = np.log2(np.maximum(frequencies, 1) / presence)
        low = frequencies**2 / (frequencies**2 + bass**2)
        return np.asarray(low * (1 + height * np.exp(-2 * octaves**2)) / (1 + (frequencies / treble) ** 4))

    return _filtered(samples, response)


def automatic_gain(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Return a sound whose level is evened out by a drawn share, as voice chats do."""
    from scipy.ndimage import uniform_filter1d  # noqa: PLC0415 - it costs time at the start

    power = uniform_filter1d(samples.astype(np.float64) ** 2, int(GAIN_TIME * SAMPLE_RATE), mode="nearest")
    loud = max(float(power.max()), 1e-12)
    gain = np.minimum((loud / np.maximum(power, 1e-12)) ** (generator.uniform(0.2, 0.7) / 2), 30)
    return np.asarray(samples * gain, np.float32)


def overdrive(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Return a sound whose loudest peaks, 1 to 10 dB of them, are cut off."""
    most = float(np.abs(samples).max(initial=0.0)) * 10 ** (-generator.uniform(1, 10) / 20)
    return np.clip(samples, -most, most)


def telephone(samples: Float32Array, _generator: np.random.Generator) -> Float32Array:
    """Return a sound that went through a telephone: 300 to 3400 Hz, 8 bit with mu-law."""
    first, last = TELEPHONE_BAND
    band = _filtered(samples, lambda f: ((f > first) & (f < last)).astype(float))
    narrow = resample_whole(band, SAMPLE_RATE, TELEPHONE_RATE)
    loudest = max(float(np.abs(narrow).max(initial=0.0)), 1e-9)
    compressed = np.sign(narrow) * np.log1p(MU * np.abs(narrow) / loudest) / np.log1p(MU)
    steps = np.round(compressed * 127) / 127
    expanded = loudest * np.sign(steps) * np.expm1(np.abs(steps) * np.log1p(MU)) / MU
    return _fitted(resample_whole(expanded.astype(np.float32), TELEPHONE_RATE, SAMPLE_RATE), len(samples))


def codec(samples: Float32Array, generator: np.random.Generator) -> Float32Array:
    """Return a sound that was compressed by a drawn codec of libsndfile and unpacked again; times stay."""
    container, kind, rate, most = CODECS[generator.integers(len(CODECS))]
    sound = np.clip(resample_whole(samples, SAMPLE_RATE, rate), -1, 1)
    unpacked = through_codec(sound, rate, container, kind, generator.uniform(0.5, most))
    return _fitted(resample_whole(unpacked, rate, SAMPLE_RATE), len(samples))


def _filtered(samples: Float32Array, response: Callable[[Float64Array], Float64Array]) -> Float32Array:
    """Filter a sound without any delay; `response` gives the factors at frequencies in hertz."""
    from scipy.fft import irfft, next_fast_len, rfft, rfftfreq  # noqa: PLC0415 - it costs half a second at the start

    n = next_fast_len(len(samples) + SAMPLE_RATE // 10, real=True)
    spectrum = rfft(samples, n) * response(rfftfreq(n, 1 / SAMPLE_RATE)).astype(np.float32)
    return np.asarray(irfft(spectrum, n)[: len(samples)], np.float32)


def _fitted(samples: Float32Array, n: int) -> Float32Array:
    return np.pad(samples[:n], (0, max(0, n - len(samples))))


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
    warp : of the mel bank, see `phonemeengine.dsp.log_mel.warped_mel_bank`.
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
