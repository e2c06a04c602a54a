"""What lies between a mouth and a file: microphones, automatic gain, overdrive, telephones and codecs."""

from collections.abc import Callable

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.libsndfile import through_codec
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.settings import SAMPLE_RATE

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
