"""The outline of a long waveform: its lowest and highest sample in every stretch, at any scale, at once."""

import threading
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array

FINEST = 256
"""Samples of the finest stretch that is remembered."""
FACTOR = 16
"""How many stretches make one of the next coarser level."""


class Peaks(NamedTuple):
    """The lowest and the highest sample of stretches, float32, each of shape (n,); NaN where there is no sound."""

    low: Float32Array
    high: Float32Array


class WaveformPeaks:
    """Takes a sound as it comes, and tells its outline, also to other threads; an hour takes 5 MB."""

    def __init__(self) -> None:
        self.n_samples = 0
        self._growing = threading.Lock()
        self._rest = np.zeros(0, np.float32)
        self._parts: list[Peaks] = []
        self._joined: list[Peaks] | None = None

    def push(self, samples: Float32Array) -> None:
        """Take the next samples, shape (n,)."""
        with self._growing:
            self.n_samples += len(samples)
            sound = np.concatenate((self._rest, samples))
            whole = len(sound) // FINEST * FINEST
            self._rest = sound[whole:].copy()
            if whole:
                stretches = sound[:whole].reshape(-1, FINEST)
                self._parts.append(Peaks(stretches.min(axis=1), stretches.max(axis=1)))
            self._joined = None

    def between(self, first: float, last: float, n_columns: int) -> Peaks:
        """Return the outline from one sample to another in so many columns, each at least as wide as `FINEST`.

        Columns are rounded outwards to remembered stretches: no peak is lost.
        """
        # A pyramid of minima and maxima: a column reads a few stretches of the level that is just finer than itself,
        # so a view of ten hours costs as much as one of a second.
        edges = np.linspace(first, last, n_columns + 1)
        level, width = self._level_for((last - first) / n_columns)
        begins = np.floor(edges[:-1] / width).astype(int)
        ends = np.maximum(np.ceil(edges[1:] / width).astype(int), begins + 1)
        n = len(level.low) - 1
        inside = (begins < n) & (ends > 0)
        begins, ends = np.clip(begins, 0, max(n - 1, 0)), np.clip(ends, 1, max(n, 1))
        if n < 1:
            nothing = np.full(n_columns, np.nan, np.float32)
            return Peaks(nothing, nothing)
        low, high = (
            _reduced(values, begins, ends, act) for values, act in ((level.low, np.minimum), (level.high, np.maximum))
        )
        return Peaks(np.where(inside, low, np.float32(np.nan)), np.where(inside, high, np.float32(np.nan)))

    def _level_for(self, samples_per_column: float) -> tuple[Peaks, int]:
        """Return the coarsest level whose stretches are no wider than a column, and their samples.

        Its last value stands there twice, so that a stretch may end at the end.
        """
        with self._growing:
            levels = self._all_levels()
        k = 0
        while k + 1 < len(levels) and FINEST * FACTOR ** (k + 1) <= samples_per_column:
            k += 1
        return levels[k], FINEST * FACTOR**k

    def _all_levels(self) -> list[Peaks]:
        if self._joined is None:
            parts = list(self._parts)
            if len(self._rest):
                parts.append(Peaks(self._rest.min(keepdims=True), self._rest.max(keepdims=True)))
            nothing = np.zeros(0, np.float32)
            finest = Peaks(*(np.concatenate([nothing, *(p[k] for p in parts)]) for k in (0, 1)))
            levels = [finest]
            while len(levels[-1].low) > FACTOR:
                levels.append(_coarser(levels[-1]))
            self._joined = [Peaks(*(np.append(values, values[-1:]) for values in level)) for level in levels]
        return self._joined


def _coarser(level: Peaks) -> Peaks:
    starts = np.arange(0, len(level.low), FACTOR)
    return Peaks(np.minimum.reduceat(level.low, starts), np.maximum.reduceat(level.high, starts))


def _reduced(values: Float32Array, begins: np.ndarray, ends: np.ndarray, act: np.ufunc) -> Float32Array:
    """Reduce stretches that may overlap, shape (n_columns,)."""
    # `reduceat` takes pairs of begin and end; every second result is that of a gap between columns
    places = np.stack((begins, np.minimum(ends, len(values) - 1)), axis=1).ravel()
    return np.asarray(act.reduceat(values, places)[::2], np.float32)
