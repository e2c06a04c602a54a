"""The outline of a long waveform: its lowest and highest sample in every section, at any scale, at once."""

import threading
from typing import NamedTuple

import numpy as np

from phonemeengine.arrays import Float32Array

FINEST = 256
"""Samples of the finest section that is remembered."""
FACTOR = 16
"""How many sections make one of the next coarser level."""


class Peaks(NamedTuple):
    """The lowest and the highest sample of sections, float32, each of shape (n,); NaN where there is no sound."""

    low: Float32Array
    high: Float32Array


class WaveformPeaks:
    """Collects the outline of a sound block by block; other threads may read it meanwhile. An hour takes 5 MB.

    Parameters
    ----------
    finest : samples of the finest section that is remembered; with 1 the outline is exact, for short sounds.
    """

    def __init__(self, finest: int = FINEST) -> None:
        self.finest = finest
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
            whole = len(sound) // self.finest * self.finest
            self._rest = sound[whole:].copy()
            if whole:
                stretches = sound[:whole].reshape(-1, self.finest)
                self._parts.append(Peaks(stretches.min(axis=1), stretches.max(axis=1)))
            self._joined = None

    def between(self, first: float, last: float, n_columns: int) -> Peaks:
        """Return the outline from one sample to another in `n_columns` columns, each at least as wide as `finest`.

        Columns are rounded outwards to remembered sections: no peak is lost.
        """
        # A pyramid of minima and maxima: a column reads a few sections of the level that is just finer than itself,
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
        """Return the coarsest level whose sections are no wider than a column, and their samples.

        Its last value stands there twice, so that a section may end at the end.
        """
        with self._growing:
            levels = self._all_levels()
        k = 0
        while k + 1 < len(levels) and self.finest * FACTOR ** (k + 1) <= samples_per_column:
            k += 1
        return levels[k], self.finest * FACTOR**k

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


def zero_crossing_near(samples: Float32Array, place: float, reach: float) -> float | None:
    """Return where a sound crosses zero nearest to a place, in samples between two of them; None within no reach.

    Parameters
    ----------
    samples : amplitudes, shape (n,).
    place, reach : in samples.
    """
    first = max(0, int(place - reach))
    near = samples[first : max(first, int(place + reach) + 2)].astype(np.float64)
    at = np.flatnonzero((near[:-1] < 0) != (near[1:] < 0))
    crossings = first + at + near[at] / (near[at] - near[at + 1])
    found = crossings[np.abs(crossings - place) <= reach]
    return float(found[np.argmin(np.abs(found - place))]) if len(found) else None


def _coarser(level: Peaks) -> Peaks:
    starts = np.arange(0, len(level.low), FACTOR)
    return Peaks(np.minimum.reduceat(level.low, starts), np.maximum.reduceat(level.high, starts))


def _reduced(values: Float32Array, begins: np.ndarray, ends: np.ndarray, act: np.ufunc) -> Float32Array:
    """Reduce sections that may overlap, shape (n_columns,)."""
    # `reduceat` takes pairs of begin and end; every second result is that of a gap between columns
    places = np.stack((begins, np.minimum(ends, len(values) - 1)), axis=1).ravel()
    return np.asarray(act.reduceat(values, places)[::2], np.float32)
