"""Closures of stops: a synthesizer reports a stop when it bursts, but lips and tongue close before that."""

import numpy as np

from phonemeengine.arrays import Int16Array
from phonemeengine.text.espeak import VOICE_RATE

STOPS = frozenset("pbtdkɡ")
LONGEST = 0.06
"""Seconds of a closure at most."""
QUIET = 0.25
"""Share of the loudest moment of the phone before, below which it is closed."""
_STEP = VOICE_RATE // 500
"""Samples that are looked at together (2 ms)."""


def closure_before(samples: Int16Array, phone: int, burst: int, symbol: str) -> int:
    """Return how many samples before its burst a stop closes: the quiet stretch there, at most half a phone.

    Parameters
    ----------
    samples : of the voice, at `VOICE_RATE`.
    phone : where the phone before begins, or the silence.
    burst : where the stop is reported.
    symbol : of IPA; what is no stop has no closure.
    """
    n_most = min((burst - phone) // 2, round(LONGEST * VOICE_RATE)) // _STEP
    if symbol not in STOPS or n_most < 1:
        return 0
    before = np.abs(samples[phone:burst].astype(np.int32))
    levels = before[len(before) - n_most * _STEP :].reshape(n_most, _STEP).max(axis=1)
    loud = np.flatnonzero(levels > QUIET * before.max())
    return (n_most - (int(loud[-1]) + 1 if len(loud) else 0)) * _STEP
