"""When a voice begins in what a microphone hears, and whether it has ended."""

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array

PERIOD = 0.01
QUIET_FRAMES, LOUD_FRAMES = 8, 5
"""How many of 10 ms must be quiet before a sound, and loud in a row where it begins."""


def onset_in(sound: Float32Array, rate: int, threshold: float) -> float | None:
    """Return when a voice begins, seconds: where, after quiet, it stays as loud as a threshold (RMS); None if never.

    Parameters
    ----------
    sound : float32, shape (n,), ±1.
    rate : Hz.
    threshold : an amplitude.
    """
    quiet = run = 0
    for k, is_loud in enumerate(_loud(sound, rate, threshold).tolist()):
        run = run + 1 if is_loud else 0
        if quiet >= QUIET_FRAMES and run >= LOUD_FRAMES:
            return (k + 1 - run) * PERIOD
        if not is_loud:
            quiet = quiet + 1
        elif quiet < QUIET_FRAMES:
            quiet = 0
    return None


def quiet_at_end(sound: Float32Array, rate: int, threshold: float) -> float:
    """Say for how long it has been quieter than a threshold, seconds; the parameters are those of `onset_in`."""
    loud = np.flatnonzero(_loud(sound, rate, threshold))
    return len(sound) / rate - (int(loud[-1]) + 1) * PERIOD if len(loud) else len(sound) / rate


def _loud(sound: Float32Array, rate: int, threshold: float) -> BoolArray:
    frame = max(1, round(PERIOD * rate))
    n = len(sound) // frame
    levels = np.sqrt(np.mean(sound[: n * frame].reshape(n, frame) ** 2, axis=1)) if n else np.zeros(0)
    return np.asarray(levels >= threshold)
