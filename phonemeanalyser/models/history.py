"""What was found lately: the columns that scroll by, and the extremes since Clear."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.analyser import Analysis
from engine.dsp.mel import spread_mel
from engine.features.measure import Features
from engine.settings import BIN_WIDTH, FRAME_PERIOD, WINDOW

CAPACITY = 6000
"""Frames that are remembered: one minute."""
MOST_BINS = WINDOW // 2


class History:
    """The last minute, frame by frame, and the extremes of every variable since Clear.

    Column c (counted from Clear) lies at index ``c % CAPACITY`` of the arrays.

    Attributes
    ----------
    n : columns since Clear.
    n_bins : bins of the newest spectrum; the rest of a column is 0.
    spectra : float16, shape (CAPACITY, 1024).
    frames : int64, shape (CAPACITY,): the column's frame in the file.
    phonemes, recognised : uint8, shape (CAPACITY,): with and without the statistics.
    intensities : float32, shape (CAPACITY,).
    """

    def __init__(self) -> None:
        self.n = 0
        self.n_bins = MOST_BINS // 4
        self.spectra = np.zeros((CAPACITY, MOST_BINS), np.float16)
        self.frames = np.zeros(CAPACITY, np.int64)
        self.phonemes = np.zeros(CAPACITY, np.uint8)
        self.recognised = np.zeros(CAPACITY, np.uint8)
        self.intensities = np.zeros(CAPACITY, np.float32)
        self.newest: Analysis | None = None
        self._names: tuple[str, ...] = ()
        self._values = np.zeros((CAPACITY, 0), np.float32)
        self._forget_extremes()

    def clear(self) -> None:
        """Forget everything."""
        self.n = 0
        self.newest = None
        self._forget_extremes()

    def take_back(self, n: int) -> None:
        """Forget the newest `n` columns, which are about to be appended anew, and all extremes."""
        self.n -= n
        self._forget_extremes()

    def newest_run(self, most: int) -> tuple[int, int]:
        """Give the frames first..last-1 of the file that the newest columns hold in a row, `most` at the most."""
        if self.n == 0:
            return 0, 0
        frames = self.frames[self.indices(self.n - most, self.n)]
        breaks = np.flatnonzero(np.diff(frames) != 1)
        return int(frames[breaks[-1] + 1 if len(breaks) else 0]), int(frames[-1]) + 1

    def append(self, analysis: Analysis) -> None:
        """Take in a block of frames, at most CAPACITY."""
        if analysis.features.names != self._names:
            self._rename(analysis.features.names)
        shown = shown_spectra(analysis)
        at = (self.n + np.arange(len(analysis))) % CAPACITY
        self.n_bins = shown.shape[1]
        self.spectra[at, : self.n_bins] = shown
        self.spectra[at, self.n_bins :] = 0
        self.frames[at] = analysis.start + np.arange(len(analysis))
        self.phonemes[at] = analysis.phonemes
        self.recognised[at] = analysis.recognised
        self.intensities[at] = analysis.intensities
        self._values[at] = analysis.features.values
        self._widen_extremes(analysis.features.values)
        self.newest = analysis
        self.n += len(analysis)

    @property
    def names(self) -> tuple[str, ...]:
        """The measured variables."""
        return self._names

    def indices(self, first: int, last: int) -> NDArray[np.intp]:
        """Give the indices of columns first..last-1, as far as they are still remembered."""
        first = max(first, 0, self.n - CAPACITY)
        return np.arange(first, max(first, min(last, self.n))) % CAPACITY

    def features(self, indices: NDArray[np.intp]) -> Features:
        """Give the variables at these indices."""
        return Features(self._names, self._values[indices])

    def extremes(self, name: str) -> tuple[float, float, float] | None:
        """Give maximum, mean and minimum of a variable since Clear, or None before the first frame."""
        if name not in self._names:
            return None
        k = self._names.index(name)
        if not self._n_measured[k]:
            return None
        return float(self._highest[k]), float(self._sum[k] / self._n_measured[k]), float(self._lowest[k])

    def phoneme_lasted(self) -> float:
        """Return how long the newest phoneme has been shown, seconds; at most what is remembered."""
        codes = self.phonemes[self.indices(0, self.n)]
        others = np.flatnonzero(codes != codes[-1:])
        return (len(codes) - 1 - int(others[-1]) if len(others) else len(codes)) * FRAME_PERIOD

    def changes_per_s(self, seconds: float) -> float | None:
        """Give how often the phoneme changed in a second, over the newest seconds; None before there are any."""
        codes = self.phonemes[self.indices(self.n - round(seconds / FRAME_PERIOD), self.n)]
        if len(codes) < 2:
            return None
        return float(np.count_nonzero(codes[1:] != codes[:-1]) / (len(codes) * FRAME_PERIOD))

    def _rename(self, names: tuple[str, ...]) -> None:
        """Take up other variables; those that stay keep their values and extremes."""
        before = self._measured
        stayed = [(names.index(name), k) for k, name in enumerate(self._names) if name in names]
        self._names, self._values = names, np.zeros((CAPACITY, len(names)), np.float32)
        self._forget_extremes()
        for old, new in zip(before, self._measured, strict=True):
            for k_new, k_old in stayed:
                new[..., k_new] = old[..., k_old]

    @property
    def _measured(self) -> tuple[NDArray[Any], ...]:
        """Everything whose last axis is the variable."""
        return self._values, self._highest, self._lowest, self._sum, self._n_measured

    def _forget_extremes(self) -> None:
        n = len(self._names)
        self._n_measured = np.zeros(n, np.int64)
        self._highest = np.full(n, -np.inf)
        self._lowest = np.full(n, np.inf)
        self._sum = np.zeros(n)

    def _widen_extremes(self, values: NDArray[np.float32]) -> None:
        np.maximum(self._highest, values.max(axis=0), out=self._highest)
        np.minimum(self._lowest, values.min(axis=0), out=self._lowest)
        self._sum += values.sum(axis=0)
        self._n_measured += len(values)


def shown_spectra(analysis: Analysis) -> NDArray[np.float32]:
    """Give the spectra as they are drawn: through the mel bank while it is on, on the linear axis."""
    if analysis.mel is None:
        return analysis.spectra
    return spread_mel(analysis.mel, analysis.spectra.shape[1], BIN_WIDTH)
