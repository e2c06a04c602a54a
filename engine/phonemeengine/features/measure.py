"""Measure all variables on a block of frames."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, ShortRepr
from phonemeengine.features.variables import Kind, Spectrum, Variable

FLOAT = np.dtype(np.float32)


@dataclass(frozen=True, repr=False)
class Features(ShortRepr):
    """What was measured on a block of frames.

    Attributes
    ----------
    names : the variables, one a column.
    values : float32, shape (n_frames, n_variables).
    """

    names: tuple[str, ...]
    values: Float32Array

    def __getitem__(self, name: str) -> Float32Array:
        """Return one variable's values, shape (n_frames,); KeyError for an unknown name."""
        try:
            return self.values[:, self.names.index(name)]
        except ValueError:
            raise KeyError(name) from None

    def part(self, frames: slice) -> "Features":
        """Return some of the frames of the block, as a block."""
        return Features(self.names, self.values[frames])

    def with_columns(self, names: tuple[str, ...], values: Float32Array) -> "Features":
        """Return the same with more columns, shape (n_frames, n_more)."""
        return Features(self.names + names, np.concatenate((self.values, values), axis=1))

    def frame(self, k: int) -> dict[str, float]:
        """Return the values of frame `k` by name."""
        return dict(zip(self.names, self.values[k].tolist(), strict=True))


class BandFeatures:
    """Measures variables on spectra, and on what denoising and normalising make of them.

    The maxima are written beside the bins of their spectrum, as if they were more bins. What happens to them after
    that keeps the order of amplitudes, so they stay the maxima, and all variables are one matrix product.

    Parameters
    ----------
    names : the columns of what is measured.
    variables : what to measure.
    centres : frequency of each bin or band, shape (n_bins,), Hz.
    """

    def __init__(self, names: tuple[str, ...], variables: Iterable[Variable], centres: Float64Array) -> None:
        # variables without a bin in reach, such as mel ones above the last band, measure 0: all their weights are
        reaches = {v: reach for v in variables if (reach := reach_of(v, centres)).stop > reach.start}
        maxima = [v for v in reaches if v.kind is Kind.MAX]
        self._n_bins, self._n_wide = len(centres), len(centres) + len(maxima)
        self._edges = np.array([(reaches[v].start, reaches[v].stop) for v in maxima], np.intp).ravel()
        self._weights = {source: np.zeros((self._n_wide, len(names)), FLOAT) for source in Spectrum}
        for v, reach in reaches.items():
            bins = self._n_bins + maxima.index(v) if v.kind is Kind.MAX else reach
            # a sum weighs its bins with 1, a mean with 1 / n, and a maximum is its own column behind the bins
            weight = 1 / (reach.stop - reach.start) if v.kind is Kind.MEAN else 1
            self._weights[v.source][bins, names.index(v.name)] = weight

    def allocate(self, n_frames: int) -> Float32Array:
        """Return room for spectra and their maxima: zeros, float32, shape (n_frames, n_bins + n_maxima)."""
        return np.zeros((n_frames, self._n_wide), FLOAT)

    def fill_maxima(self, wide: Float32Array) -> None:
        """Write the maxima beside the bins."""
        # `reduceat` gives a result for begin to end and one for end to the next begin; the latter mean nothing
        wide[:, self._n_bins :] = np.maximum.reduceat(wide, self._edges, axis=1)[:, ::2]

    def append_maxima(self, spectra: Float32Array) -> Float32Array:
        """Return spectra with their maxima beside the bins; float32, shape (n_frames, n_bins + n_maxima)."""
        wide = self.allocate(len(spectra))
        wide[:, : self._n_bins] = spectra
        self.fill_maxima(wide)
        return wide

    def weights(self, source: Spectrum) -> Float32Array:
        """Return what widened spectra are multiplied with to measure the variables of a source.

        Returns
        -------
        float32, shape (n_bins + n_maxima, n_names); the columns of all other variables are 0.
        """
        return self._weights[source]


def reach_of(variable: Variable, centres: Float64Array) -> slice:
    """Return the bins, or the mel bands, that a variable looks at; their centres are in Hz."""
    if variable.source is not Spectrum.MEL:
        reach = variable.bins(len(centres))
        return slice(reach.start, max(reach.start, reach.stop))
    # the next float above `high`, so that a band whose centre lies on it belongs to it
    first, last = np.searchsorted(centres, (variable.low, np.nextafter(variable.high, np.inf)))
    return slice(int(first), int(last))
