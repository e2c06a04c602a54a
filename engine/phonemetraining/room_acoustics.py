"""Impulse responses of made-up rooms, by the image method.

J. Allen and D. Berkley, "Image method for efficiently simulating small-room acoustics", J. Acoust. Soc. Am. 65(4),
1979: each reflection is the sound of a mirror image of the mouth. After the first ones they are too many to count:
there noise decays as Eyring's formula says (C. Eyring, J. Acoust. Soc. Am. 1(2), 1930).
"""

import math
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.settings import SAMPLE_RATE

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
    """Return what the microphone hears of a click at the mouth, shape (n_samples,).

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
