"""Measure all variables on a block of frames."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from engine.features.variables import Kind, Spectrum, Variable

Block = NDArray[np.float32]


@dataclass(frozen=True)
class Features:
    """What was measured on a block of frames.

    Attributes
    ----------
    names : the variables, one a column.
    values : float32, shape (n_frames, n_variables).
    """

    names: tuple[str, ...]
    values: Block

    def __getitem__(self, name: str) -> Block:
        """Give one variable's values, shape (n_frames,); KeyError for an unknown name."""
        try:
            return self.values[:, self.names.index(name)]
        except ValueError:
            raise KeyError(name) from None

    def frame(self, k: int) -> dict[str, float]:
        """Give the values of frame `k` by name."""
        return dict(zip(self.names, self.values[k].tolist(), strict=True))


def zero_crossings_of(frames: Block) -> Block:
    """Count the sign changes inside each raw frame; zero counts as positive. Shape (n_frames,)."""
    negative = frames < 0
    changes = np.packbits(negative[:, 1:] != negative[:, :-1], axis=1)
    counts: Block = np.add.reduce(np.bitwise_count(changes), axis=1, dtype=np.float32)
    return counts


def peak_levels_of(frames: Block) -> Block:
    """Give the largest absolute sample of each frame, shape (n_frames,)."""
    levels: Block = np.maximum(np.maximum.reduce(frames, axis=1), -np.minimum.reduce(frames, axis=1))
    return levels


class BandMeter:
    """Measures band variables on the spectra of one front end.

    Sums and means are one matrix product per source, maxima a slice each.

    Parameters
    ----------
    variables : what to measure.
    source : only variables that look at this spectrum are measured.
    centres : frequency of each bin or band, shape (n_bins,), Hz.
    """

    def __init__(self, variables: tuple[Variable, ...], source: Spectrum, centres: NDArray[np.float64]) -> None:
        mine = [(k, v, _reach(v, centres)) for k, v in enumerate(variables) if v.source is source]
        linear = [(k, v, reach) for k, v, reach in mine if v.kind is not Kind.MAX]
        self._columns = [k for k, _, _ in linear]
        self._weights = np.zeros((len(centres), len(linear)), np.float32)
        for column, (_, variable, reach) in enumerate(linear):
            n = reach.stop - reach.start
            self._weights[reach, column] = 1 / n if variable.kind is Kind.MEAN and n else 1
        self._maxima = [(k, reach) for k, v, reach in mine if v.kind is Kind.MAX and reach.stop > reach.start]

    def measure(self, spectra: Block, out: Block) -> None:
        """Write the measured columns of `out`, shape (n_frames, n_variables)."""
        if self._columns:
            out[:, self._columns] = spectra @ self._weights
        for column, reach in self._maxima:
            np.max(spectra[:, reach], axis=1, out=out[:, column])


def _reach(variable: Variable, centres: NDArray[np.float64]) -> slice:
    if variable.source is not Spectrum.MEL:
        reach = variable.bins(len(centres))
        return slice(reach.start, max(reach.start, reach.stop))
    first, last = np.searchsorted(centres, (variable.low, np.nextafter(variable.high, np.inf)))
    return slice(int(first), int(last))
