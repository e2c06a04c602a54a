"""The same speech as others might have said it elsewhere: other tempo, pitch, tract, room, sounds and recorder.

A recorder is a chain of microphone, automatic gain, overdrive, telephone and codec.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.libsndfile import through_codec
from phonemeengine.audio.resampling import change_speed, resample_whole
from phonemeengine.calibration.scores.added_noise import BACKGROUNDS
from phonemeengine.settings import SAMPLE_RATE

# Impulse responses of made-up rooms, by the image method.
#
# J. Allen and D. Berkley, "Image method for efficiently simulating small-room acoustics", J. Acoust. Soc. Am. 65(4),
# 1979: each reflection is the sound of a mirror image of the mouth. After the first ones they are too many to count:
# there noise decays as Eyring's formula says (C. Eyring, J. Acoust. Soc. Am. 1(2), 1930).

SPEED_OF_SOUND = 343.0
"""Metres a second."""
EYRING = 24 * math.log(10) / SPEED_OF_SOUND
"""Seconds a metre: T60 = EYRING x volume / (surface x -ln(1 - absorption))."""
EARLY = 0.05
"""Seconds after the direct sound in which reflections are counted one by one."""
CROSSOVER = 2000.0
"""Above it walls and air swallow more, hertz."""


@dataclass(frozen=True)
class Room:
    """A room with hard edges, a mouth and a microphone.

    Attributes
    ----------
    size : length, width and height, metres.
    mouth, microphone : where they are, metres from one corner.
    decays : times in which the sound falls by 60 dB, below and above 2 kHz, seconds.
    """

    size: tuple[float, float, float]
    mouth: tuple[float, float, float]
    microphone: tuple[float, float, float]
    decays: tuple[float, float]

    @property
    def distance(self) -> float:
        """From the mouth to the microphone, metres."""
        return math.dist(self.mouth, self.microphone)


@dataclass(frozen=True)
class _RoomKind:
    """A kind of room: ranges of length and width, of height, of the decay, and of the microphone's distance."""

    sides: tuple[float, float]
    height: tuple[float, float]
    decay: tuple[float, float]
    distance: tuple[float, float]


KINDS = {
    "vocal booth": _RoomKind((1.2, 2.5), (2.0, 2.4), (0.08, 0.2), (0.1, 0.4)),
    "headset": _RoomKind((2.5, 6.0), (2.3, 3.0), (0.25, 0.7), (0.03, 0.1)),
    "desk": _RoomKind((2.5, 6.0), (2.3, 3.0), (0.25, 0.7), (0.4, 0.9)),
    "far from the microphone": _RoomKind((3.0, 8.0), (2.4, 3.5), (0.3, 0.9), (1.0, 3.0)),
    "hall": _RoomKind((8.0, 20.0), (4.0, 8.0), (0.8, 1.8), (0.3, 1.5)),
}


def draw_room(generator: np.random.Generator) -> Room:
    """Draw a room in which people speak to a computer."""
    kind = list(KINDS.values())[generator.integers(len(KINDS))]
    size = np.array([*generator.uniform(*kind.sides, 2), generator.uniform(*kind.height)])
    distance = min(generator.uniform(*kind.distance), 0.4 * float(size.min()))
    way = generator.standard_normal(3)
    way *= distance / np.linalg.norm(way)
    margin = np.abs(way) + 0.1 * size
    mouth = generator.uniform(margin, size - margin) if (2 * margin < size).all() else size / 2 - way / 2
    decay = generator.uniform(*kind.decay)
    x, y, z = size.tolist()
    return Room((x, y, z), tuple(mouth), tuple(mouth + way), (decay, decay * generator.uniform(0.5, 1)))


def impulse_response(room: Room, generator: np.random.Generator) -> Float32Array:
    """Return what the microphone records of a click at the mouth, shape (n_samples,).

    It begins with the direct sound, which has the height 1: neither times nor levels of the speech change.
    """
    from scipy.fft import irfft, rfft, rfftfreq  # noqa: PLC0415 - it costs half a second at the start

    n = int((EARLY + max(room.decays)) * SAMPLE_RATE)
    low, high = (rfft(_band(room, decay, n, generator)) for decay in room.decays)
    share = 1 / (1 + (rfftfreq(n, 1 / SAMPLE_RATE) / CROSSOVER) ** 2)
    response: Float32Array = irfft(share * low + (1 - share) * high, n).astype(np.float32)
    return response


def _band(room: Room, decay: float, n: int, generator: np.random.Generator) -> Float64Array:
    """Return the impulse response of walls that reflect all frequencies alike, shape (n,)."""
    response = _reflections(room, decay, n)
    first = min(int(min(EARLY, decay) * SAMPLE_RATE), n)
    before = response[first // 2 : first]
    times = np.arange(n - first) / SAMPLE_RATE
    tail = generator.standard_normal(n - first) * 10 ** (-3 * times / decay)
    middle = 10 ** (3 * (first / 4 / SAMPLE_RATE) / decay)  # how much louder the middle of `before` is than its end
    level = math.sqrt(float(np.mean(before**2))) / middle if len(before) else 0.0
    response[first:] = level * tail
    return response


def _reflections(room: Room, decay: float, n: int) -> Float64Array:
    """Return the direct sound, at 0 and of the height 1, and the first reflections, as pulses."""
    size = np.array(room.size)
    volume, surface = float(size.prod()), 2 * float(size[0] * size[1] + size[1] * size[2] + size[2] * size[0])
    reflection = math.exp(-EYRING * volume / (surface * decay) / 2)
    reach = min(EARLY, decay) * SPEED_OF_SOUND + room.distance
    squares, bounces = [], []
    for length, mouth, microphone in zip(room.size, room.mouth, room.microphone, strict=True):
        order = math.ceil(reach / (2 * length))
        shifts = 2 * length * np.arange(-order, order + 1)
        numbers = 2 * np.abs(np.arange(-order, order + 1))
        squares.append(np.concatenate([(shifts + mouth - microphone) ** 2, (shifts - mouth - microphone) ** 2]))
        bounces.append(np.concatenate([numbers, np.abs(2 * np.arange(-order, order + 1) - 1)]))
    ways = np.sqrt(np.add.outer(np.add.outer(squares[0], squares[1]), squares[2]).ravel())
    counts = np.add.outer(np.add.outer(bounces[0], bounces[1]), bounces[2]).ravel()
    near = ways < reach
    places = ((ways[near] - room.distance) / SPEED_OF_SOUND * SAMPLE_RATE + 0.5).astype(int)
    heights = room.distance / ways[near] * reflection ** counts[near]
    return np.asarray(np.bincount(np.minimum(places, n - 1), heights, n)[:n], float)


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
HIGH, HIGH_RANGES = 0.2, ((1.05, 1.6), (1.2, 1.7))
"""Share of the variations that become a child's or a cartoon voice, how much faster and higher these are, and how
much shorter their vocal tract: that of a small child is about two thirds as long as a man's."""
IN_A_ROOM, IN_NOISE = 0.4, 0.2
"""Shares of the variations that are said in a made-up room, and over music or the noise of a desk."""
SNRS = (3.0, 30.0)
"""Level of the speech above those sounds, dB."""
CHAINS: tuple[tuple[float, Chain], ...] = (
    (0.25, microphone),
    (0.06, automatic_gain),
    (0.05, overdrive),
    (0.1, codec),
    (0.05, telephone),
)
"""Shares of the variations that go through each, in the order in which they follow each other."""


@dataclass(frozen=True)
class Augmentation:
    """How a recording is varied.

    Attributes
    ----------
    rate : factor by which it is faster and higher, formants too.
    warp : of the mel bank, see `phonemeengine.dsp.mel.warped_mel_bank`.
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
    high = generator.random() < HIGH
    rates, tracts = np.log(HIGH_RANGES if high else (RANGE, RANGE))
    rate = float(np.exp(generator.uniform(*rates))) if high or generator.random() < 0.7 else 1.0
    tract = float(np.exp(generator.uniform(*tracts)))
    warp = float(np.clip(rate / tract, 0.8, 1.25)) if high or generator.random() < 0.6 else 1.0
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
