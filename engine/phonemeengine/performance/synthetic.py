"""A synthetic performer: a model of a face that speaks, for demonstration and tests, where no person was recorded.

It is a dominance model (M. Cohen, D. Massaro, Modeling coarticulation in synthetic visual speech, 1993): each sound
pulls each channel towards a target, the more strongly the nearer it is, and the face is their weighted mean. Targets
and strengths vary from sound to sound by a tenth, and a slow noise lies over all channels, so that no two takes are
alike. What is made so is named synthetic wherever it is shown. No mouth table has to do with it: who compares a table
of these performances with the rules compares two things that know nothing of each other.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float64Array
from phonemeengine.labels.articulation import ARTICULATIONS, letters_of
from phonemeengine.mouth.animation import Animation
from phonemeengine.mouth.blendshape_names import ARKIT, both_sides
from phonemeengine.performance.recording import SILENCE, PerformedPhone

RATE = 60.0
"""Frames a second."""
VARIATION = 0.1
"""Standard deviation of targets and strengths from sound to sound, a share of them."""
NOISE, NOISE_CUTOFF = 0.006, 4.0
"""Standard deviation of the noise, and the frequency (Hz) above which it fades out."""
ASYMMETRY = {"Left": 1.06, "Right": 0.94}
"""How much more or less a side moves than the other."""
HEAD_SWAY, SWAY_CUTOFF = np.array([2.2, 1.4, 1.0]), 0.4
"""Standard deviation of the head's yaw, pitch and roll, degrees, and how fast they change at most, Hz."""
NOD, NOD_LENGTH = -2.5, 0.16
"""How far the head nods at a stressed syllable, degrees; and how long, seconds."""
BLINK_LENGTH, BLINK_EVERY = 0.09, (2.0, 5.0)
"""Seconds."""


@dataclass(frozen=True)
class Pull:
    """What a class of sounds does to a face.

    Attributes
    ----------
    strength : how strongly it pulls the channels that it names, beside a vowel's 1.
    rate : how fast its pull fades with the distance from its middle, 1/s.
    targets : weight by channel; a name without a side stands for both.
    """

    strength: float
    rate: float
    targets: dict[str, float]


REST = Pull(1.6, 14.0, {"jawOpen": 0.02})
"""What silence does."""
SOFTNESS = 0.02
"""Distances are no less than this, seconds: no face turns round at once."""
WEAK = 0.25
"""How strongly a sound pulls the channels that it does not name to 0."""
CONSONANTS = {
    # The first class that a sound belongs to counts.
    "labiovelar": Pull(3.0, 22.0, {"jawOpen": 0.11, "mouthPucker": 0.66, "mouthFunnel": 0.24}),
    "dental": Pull(2.0, 26.0, {"jawOpen": 0.15, "tongueOut": 0.24, "mouthLowerDown": 0.16}),
    "labiodental": Pull(
        7.0, 32.0, {"jawOpen": 0.08, "mouthRollLower": 0.52, "mouthUpperUp": 0.17, "mouthShrugUpper": 0.12}
    ),
    "bilabial": Pull(
        11.0,
        34.0,
        {"jawOpen": 0.05, "mouthClose": 0.06, "mouthPress": 0.38, "mouthRollLower": 0.2, "mouthRollUpper": 0.19},
    ),
    "postalveolar": Pull(
        2.6, 22.0, {"jawOpen": 0.07, "mouthFunnel": 0.5, "mouthPucker": 0.17, "mouthLowerDown": 0.2}
    ),
    "lateral": Pull(1.3, 24.0, {"jawOpen": 0.21, "mouthLowerDown": 0.22, "tongueOut": 0.05}),
    "rhotic": Pull(1.7, 21.0, {"jawOpen": 0.13, "mouthFunnel": 0.33, "mouthPucker": 0.21}),
    "palatal": Pull(1.2, 21.0, {"jawOpen": 0.1, "mouthSmile": 0.24, "mouthStretch": 0.17}),
    "sibilant": Pull(
        1.9, 26.0, {"jawOpen": 0.06, "mouthStretch": 0.24, "mouthLowerDown": 0.19, "mouthUpperUp": 0.09}
    ),
    "alveolar": Pull(1.2, 27.0, {"jawOpen": 0.13, "mouthLowerDown": 0.13, "mouthUpperUp": 0.06}),
    "velar": Pull(0.7, 21.0, {"jawOpen": 0.19, "mouthLowerDown": 0.1}),
    "consonant": Pull(0.4, 19.0, {"jawOpen": 0.22}),
}
HEIGHTS = {
    "open vowel": {"jawOpen": 0.64, "mouthLowerDown": 0.36, "mouthUpperUp": 0.15, "mouthShrugLower": 0.05},
    "close vowel": {"jawOpen": 0.15, "mouthLowerDown": 0.15, "mouthUpperUp": 0.06},
    "vowel": {"jawOpen": 0.38, "mouthLowerDown": 0.26, "mouthUpperUp": 0.11},
}
"""What vowels do to jaw and lips; the first class counts."""
ROUNDINGS = {
    "rounded vowel": {"mouthPucker": 0.57, "mouthFunnel": 0.36},
    "front vowel": {"mouthSmile": 0.19, "mouthStretch": 0.25, "mouthDimple": 0.08},
}
"""What is added to that; the first class counts."""
VOWEL_RATE = 18.0
FOLLOWERS = {
    "cheekSquint": ("mouthSmile", 0.35),
    "noseSneer": ("mouthUpperUp", 0.3),
    "eyeSquint": ("mouthSmile", 0.12),
}
"""Channels that move with another one, by a share of it."""


def perform(phones: Sequence[PerformedPhone], seed: Sequence[int]) -> Animation:
    """Return how the performer's face says phones: all blend shapes of ARKit, and the head.

    Parameters
    ----------
    phones : in order of time, the first from 0.
    seed : whole numbers from 0; others give another take.
    """
    chance = np.random.default_rng([*seed])
    times = np.arange(int(phones[-1].end * RATE + 1e-6) + 1) / RATE
    weights = _pulled(phones, times, chance)
    stresses = [phone.middle for phone in phones if phone.stress == 1 and _is_vowel(phone.name)]
    _add_upper_face(weights, times, stresses, chance)
    noise = _slow_noise(len(times), len(ARKIT), NOISE_CUTOFF, chance)
    head = _slow_noise(len(times), 3, SWAY_CUTOFF, chance) * HEAD_SWAY
    for time in stresses:
        head[:, 1] += NOD * chance.uniform(0.2, 1.4) * _bump(times, time, NOD_LENGTH)
    moved = np.clip(weights + NOISE * noise, 0, 1).astype(np.float32)
    return Animation(RATE, ARKIT, moved, head.astype(np.float32))


def _pulled(phones: Sequence[PerformedPhone], times: Float64Array, chance: np.random.Generator) -> Float64Array:
    """Return the weighted mean of all targets at each time, shape (n_times, n_channels)."""
    pulls = [(time, pull) for phone in phones for time, pull in _pulls_of(phone)]
    middles, rates = np.array([time for time, _ in pulls]), np.array([pull.rate for _, pull in pulls])
    shape = (len(pulls), len(ARKIT))
    named = np.array([_weights_of(pull) for _, pull in pulls])
    strengths = np.array([pull.strength for _, pull in pulls])[:, None]
    strengths = np.where((named > 0) | (strengths == REST.strength), strengths, WEAK)
    strengths = strengths * np.exp(VARIATION * chance.standard_normal(shape))
    targets = named * np.clip(1 + VARIATION * chance.standard_normal(shape), 0.5, 1.5)
    near = np.exp(-rates * np.hypot(times[:, None] - middles, SOFTNESS))
    pulled: Float64Array = (near @ (strengths * targets)) / (near @ strengths)
    return pulled


def _pulls_of(phone: PerformedPhone) -> list[tuple[float, Pull]]:
    """Return what a phone does, and when: each part of a diphthong, and silence all the while."""
    if phone.name == SILENCE:
        n = max(1, round(phone.duration / 0.1))
        return [(phone.start + (k + 0.5) / n * phone.duration, REST) for k in range(n)]
    letters = letters_of(phone.name) or ("ə",)
    part = phone.duration / len(letters)
    return [(phone.start + (k + 0.5) * part, _pull_of(letter)) for k, letter in enumerate(letters)]


def _pull_of(letter: str) -> Pull:
    if not _is_vowel(letter):
        return next(pull for name, pull in CONSONANTS.items() if letter in ARTICULATIONS[name])
    height = next(targets for name, targets in HEIGHTS.items() if letter in ARTICULATIONS[name])
    rounding = next((targets for name, targets in ROUNDINGS.items() if letter in ARTICULATIONS[name]), {})
    return Pull(1.0, VOWEL_RATE, height | rounding)


def _is_vowel(name: str) -> bool:
    return any(letter in ARTICULATIONS["vowel"] for letter in letters_of(name))


def _weights_of(pull: Pull) -> Float64Array:
    """Return the targets of all channels, the ones of the sides not quite alike."""
    weights = np.zeros(len(ARKIT))
    for name, weight in pull.targets.items():
        for side in (name,) if name in ARKIT else both_sides(name):
            factor = next((factor for end, factor in ASYMMETRY.items() if side.endswith(end)), 1.0)
            weights[ARKIT.index(side)] = weight * factor
    return weights


def _add_upper_face(
    weights: Float64Array, times: Float64Array, stresses: Sequence[float], chance: np.random.Generator
) -> None:
    """Add blinks, brows that rise at some stresses, and what follows the mouth."""
    for name, (leader, share) in FOLLOWERS.items():
        for follower, led in zip(both_sides(name), both_sides(leader), strict=True):
            weights[:, ARKIT.index(follower)] += share * weights[:, ARKIT.index(led)]
    for time in stresses:
        if chance.random() < 0.35:
            height = chance.uniform(0.1, 0.45)
            for name, share in (("browInnerUp", 1.0), ("browOuterUpLeft", 0.8), ("browOuterUpRight", 0.7)):
                weights[:, ARKIT.index(name)] += share * height * _bump(times, time, 0.18)
    time = chance.uniform(0.3, BLINK_EVERY[1])
    while time < times[-1]:
        for side in both_sides("eyeBlink"):
            weights[:, ARKIT.index(side)] += _bump(times, time, BLINK_LENGTH)
        time += chance.uniform(*BLINK_EVERY)


def _bump(times: Float64Array, middle: float, length: float) -> Float64Array:
    """Return a Gaussian about a time, 1 there, of a standard deviation in seconds."""
    return np.exp(-(((times - middle) / length) ** 2) / 2)


def _slow_noise(n: int, n_channels: int, cutoff: float, chance: np.random.Generator) -> Float64Array:
    """Return noise of unit variance, shape (n, n_channels), that fades out above a frequency, Hz.

    It is white noise under a Gaussian window in time.
    """
    sigma = RATE / (2 * np.pi * cutoff)
    reach = int(4 * sigma) + 1
    window = np.exp(-((np.arange(-reach, reach + 1) / sigma) ** 2) / 2)
    white = chance.standard_normal((n + 2 * reach, n_channels))
    smooth = [np.convolve(column, window / np.linalg.norm(window), "valid") for column in white.T]
    return np.stack(smooth, axis=1)
