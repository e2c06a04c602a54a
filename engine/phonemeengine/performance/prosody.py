"""How loud and how high each phone is spoken."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.framing import Framer
from phonemeengine.dsp.pitch import fundamental_of
from phonemeengine.performance.recording import PerformedPhone
from phonemeengine.settings import HOP, SAMPLE_RATE

QUIETEST = -100.0
"""What is quieter counts as so loud, dB."""
_AT_ONCE = 32 * HOP
"""Samples whose pitch is measured at once: so few that no other core is called to help, which would cost more."""


def measured(phones: Sequence[PerformedPhone], samples: Float32Array) -> tuple[PerformedPhone, ...]:
    """Return phones with their energy and pitch.

    Parameters
    ----------
    phones : in order of time.
    samples : float32, shape (n,), of the sound in which they are spoken, mono at 44.1 kHz, ±1.
    """
    squares = np.concatenate([[0.0], np.cumsum(samples.astype(np.float64) ** 2)])
    pitches = _pitches_of(samples)
    return tuple(replace(phone, energy=_level(squares, phone), pitch=_pitch(pitches, phone)) for phone in phones)


def _level(squares: Float64Array, phone: PerformedPhone) -> float:
    """Return the mean level of a phone, dB; `squares` are the sums of all squares before each sample."""
    first, last = (min(round(time * SAMPLE_RATE), len(squares) - 1) for time in (phone.start, phone.end))
    power = (squares[last] - squares[first]) / max(last - first, 1)
    return max(10 * float(np.log10(max(power, 1e-30))), QUIETEST)


def _pitch(pitches: Float32Array, phone: PerformedPhone) -> float:
    """Return the median pitch of a phone's frames, Hz; 0 where fewer than half of them are voiced."""
    frames = pitches[int(phone.start * SAMPLE_RATE / HOP) : max(1, round(phone.end * SAMPLE_RATE / HOP))]
    return float(np.median(frames)) if len(frames) else 0.0


def _pitches_of(samples: Float32Array) -> Float32Array:
    framer = Framer()
    blocks = [framer.cut_frames(samples[k : k + _AT_ONCE]) for k in range(0, len(samples), _AT_ONCE)]
    found = [fundamental_of(block) for block in (*blocks, framer.finish()) if len(block)]
    return np.concatenate([np.zeros(0, np.float32), *found])
