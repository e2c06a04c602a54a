"""How a voice says something: a running estimate of its activation and, less certain, of its pleasantness.

Both are relative to the speaker's own habits, which are learned meanwhile: how loud, how high, how lively and how
fast the voice is, and how bright its spectrum, each in the last second beside the last half minute. Level, pitch,
range, rate and spectral balance are the measures on which studies of vocal affect agree (R. Banse and K. Scherer,
"Acoustic profiles in vocal emotion expression", 1996; F. Eyben et al., "The Geneva minimalistic acoustic parameter
set", 2016); their weights are this program's choice. All levels are differences in decibels, so a louder recording of
the same speech gives the same answer. Nothing of the future is used, and memory is constant.
"""

import math
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.pitch import fundamental_of
from phonemeengine.settings import FRAME_PERIOD, HOP, WINDOW

SHORT, LONG = 0.7, 25.0
"""Seconds of voiced speech over which the present and the habits are averaged, as time constants."""
LEVEL_UNIT, PITCH_UNIT, RANGE_UNIT, RATE_UNIT, TILT_UNIT = 6.0, 4.0, 0.8, 0.5, 4.0
"""What counts as one step up: dB, semitones, natural logarithm of the range, octaves of the rate, dB of tilt."""
ACTIVATION = (0.5, 0.6, 0.2, 0.4, 0.4)
"""Weights of the steps of level, pitch, range, rate and tilt in activation."""
PLEASANTNESS = (-0.2, 0.4, 0.6, 0.0, -0.6)
"""Those in pleasantness."""
SILENCE = 3e-5
"""Amplitude below which a frame is silent: that of the last bit of 16."""
QUIET = 30.0
"""dB below the loudest of the last seconds from which on a frame is not taken for the speaker."""
LEAST_SPREADS = (0.2, 0.45)
"""Standard error of both where the speaker's habits are known well."""
LEARNED = 2.5
"""Seconds of voiced speech in which the uncertainty about the habits falls by a factor of e."""
RETURN = 1.5
"""Seconds without voice in which the estimate goes back to nothing by a factor of e, and becomes uncertain."""
BEAT = 1.0
"""dB by which the level rises over its mean of the last quarter second where a syllable begins."""

FeltFrames = Float32Array
"""Shape (n_frames, 4): activation and its standard error, pleasantness and its standard error; see `Feeling`."""


class Feeling(NamedTuple):
    """How a voice sounds at one time, beside the speaker's usual way.

    Attributes
    ----------
    activation : -1 relaxed .. 1 excited, 0 as usual.
    activation_spread : its standard error, 0..1; 1 where nothing is known.
    pleasantness : -1 unpleasant .. 1 pleasant, 0 as usual; far less certain.
    pleasantness_spread : its standard error.
    """

    activation: float = 0.0
    activation_spread: float = 1.0
    pleasantness: float = 0.0
    pleasantness_spread: float = 1.0


UNKNOWN = Feeling()
NO_FEELINGS: FeltFrames = np.zeros((0, len(UNKNOWN)), np.float32)


class _Habit:
    """The mean of a measure now and in the long run; both begin as the plain mean of what has come."""

    def __init__(self) -> None:
        self.now = self.usual = 0.0

    def add(self, value: float, seconds: float) -> None:
        """Take the next value, `seconds` of voice after the first."""
        self.now += (value - self.now) * _share(SHORT, seconds)
        self.usual += (value - self.usual) * _share(LONG, seconds)


def _share(constant: float, seconds: float) -> float:
    # one pole with this time constant; before as much voice has come, 1 / n, which makes a plain mean of n frames
    return max(FRAME_PERIOD / constant, FRAME_PERIOD / (seconds + FRAME_PERIOD))


class FeelingEstimator:
    """Follows a voice, and tells frame by frame how it sounds; the answer does not depend on how the sound is cut."""

    def __init__(self) -> None:
        self._voiced = 0.0
        self._level, self._pitch, self._tilt = _Habit(), _Habit(), _Habit()
        self._swing, self._beats = _Habit(), _Habit()
        self._loudest = -math.inf
        self._fast = self._slow = 0.0
        self._risen = False
        self._steps = (0.0,) * len(ACTIVATION)
        self._fresh = 0.0

    def follow(self, windows: Float32Array) -> FeltFrames:
        """Return how the voice sounds in the next frames.

        Parameters
        ----------
        windows : the samples of consecutive frames, float32, shape (n_frames, 2048), as `FrameBlock` has them.
        """
        if not len(windows):
            return NO_FEELINGS
        levels, tilts = _levels_and_tilts(windows)
        rows = zip(levels.tolist(), tilts.tolist(), fundamental_of(windows, SILENCE).tolist(), strict=True)
        return np.array([self._follow(*row) for row in rows], np.float32)

    def _follow(self, level: float, tilt: float, f0: float) -> Feeling:
        # it falls by 30 dB in 25 s, so that a shout does not make quiet speech background for good
        self._loudest = max(level, self._loudest - QUIET * FRAME_PERIOD / LONG)
        if f0 > 0 and level > self._loudest - QUIET:
            self._learn(level, tilt, 12 * math.log2(f0))  # semitones, since only differences are used
        else:
            self._fresh *= math.exp(-FRAME_PERIOD / RETURN)
            self._risen = False
        if not self._voiced:
            return UNKNOWN
        # nearer to nothing, and less certain, the less voice has come in all and the longer none has come
        habit = math.exp(-self._voiced / LEARNED)
        known = self._fresh * (1 - habit)
        values = (_weighed(weights, self._steps) * known for weights in (ACTIVATION, PLEASANTNESS))
        spreads = (1 - (1 - least) * known for least in LEAST_SPREADS)
        one, other = zip(values, spreads, strict=True)
        return Feeling(*one, *other)

    def _learn(self, level: float, tilt: float, pitch: float) -> None:
        seconds = self._voiced
        self._fresh += (1 - self._fresh) * FRAME_PERIOD / 0.2
        for habit, value in ((self._level, level), (self._pitch, pitch), (self._tilt, tilt)):
            habit.add(value, seconds)
        # the mean distance from the pitch of the moment is the range, which one octave error moves little
        self._swing.add(abs(pitch - self._pitch.now), seconds)
        if not seconds:
            self._fast = self._slow = level
        self._fast += (level - self._fast) * FRAME_PERIOD / 0.03
        self._slow += (level - self._slow) * FRAME_PERIOD / 0.25
        # a syllable begins where the level of 30 ms rises over that of 250 ms; it falls below before the next one
        rises = self._fast > self._slow + BEAT
        self._beats.add(float(rises and not self._risen), seconds)
        self._risen = rises or (self._risen and self._fast > self._slow)
        self._voiced += FRAME_PERIOD
        self._steps = (
            (self._level.now - self._level.usual) / LEVEL_UNIT,
            (self._pitch.now - self._pitch.usual) / PITCH_UNIT,
            # half a semitone and a beat in a second are added, so that a monotonous or slow voice divides by no zero
            math.log((self._swing.now + 0.5) / (self._swing.usual + 0.5)) / RANGE_UNIT,
            math.log2((self._beats.now + 0.01) / (self._beats.usual + 0.01)) / RATE_UNIT / 2,
            (self._tilt.now - self._tilt.usual) / TILT_UNIT,
        )


def _weighed(weights: tuple[float, ...], steps: tuple[float, ...]) -> float:
    return math.tanh(sum(weight * step for weight, step in zip(weights, steps, strict=True)))


def _levels_and_tilts(windows: Float32Array) -> tuple[Float64Array, Float64Array]:
    """Return the level of frames, dB, and their tilt: the level of the differences of samples beside it, dB."""
    middle = windows[:, (WINDOW - 2 * HOP) // 2 :][:, : 2 * HOP]
    power = np.einsum("ij,ij->i", middle, middle).astype(np.float64)
    rises = np.diff(middle, axis=1)  # a high pass of 6 dB an octave: the more is left, the brighter the sound
    slope = np.einsum("ij,ij->i", rises, rises).astype(np.float64)
    faintest = np.finfo(np.float32).tiny
    level = 10 * np.log10(power / middle.shape[1] + faintest)
    return level, 10 * np.log10((slope + faintest) / (power + faintest))
