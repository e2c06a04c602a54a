"""A mel filter bank: triangular filters, equally spaced and overlapping by half on the HTK mel scale.

``mel = 2595 log10(1 + f / 700)`` (S. Young et al., The HTK Book, section 5.4). Each triangle has height 1 and
its value is the weighted mean of the amplitudes under it, so that a flat spectrum stays flat.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array, Float64Array


def mel_of(frequency: ArrayLike) -> Float64Array:
    """Convert hertz to mel (HTK)."""
    return np.asarray(2595 * np.log10(1 + np.asarray(frequency, float) / 700))


def frequency_of(mel: ArrayLike) -> Float64Array:
    """Convert mel (HTK) to hertz."""
    return np.asarray(700 * (10 ** (np.asarray(mel, float) / 2595) - 1))


def mel_edges(n_bands: int, highest: float, lowest: float = 0.0) -> Float64Array:
    """Return the corners of the triangles in Hz, shape (n_bands + 2,): band b spans edges b..b+2, peak b+1."""
    return frequency_of(np.linspace(float(mel_of(lowest)), float(mel_of(highest)), n_bands + 2))


def triangular_bank(edges: Float64Array, n_bins: int, bin_width: float) -> Float32Array:
    """Return the weights of triangular filters, shape (n_bins, n_edges - 2); each column sums to 1.

    Filter b spans edges b..b+2 (Hz, rising); one narrower than a bin takes the bin nearest to its peak.
    """
    low, peak, high = edges[:-2], edges[1:-1], edges[2:]
    frequencies = np.arange(n_bins)[:, np.newaxis] * bin_width
    # the smaller of the rising and the falling line, cut off at 0, is the triangle
    weights = np.maximum(0, np.minimum((frequencies - low) / (peak - low), (high - frequencies) / (high - peak)))
    empty = np.flatnonzero(weights.sum(axis=0) == 0)
    weights[np.round(peak[empty] / bin_width).astype(int), empty] = 1
    return np.asarray(weights / weights.sum(axis=0), np.float32)


@lru_cache(maxsize=32)
def mel_bank(n_bands: int, n_bins: int, bin_width: float) -> Float32Array:
    """Return the weights of filters from 0 Hz to the last bin, shape (n_bins, n_bands), read-only."""
    bank = triangular_bank(mel_edges(n_bands, n_bins * bin_width), n_bins, bin_width)
    bank.flags.writeable = False
    return bank


def mel_spectra_of(spectra: Float32Array, n_bands: int, bin_width: float) -> Float32Array:
    """See amplitude spectra through the bank: (n_frames, n_bins) -> (n_frames, n_bands), float32, 0..1."""
    return np.asarray(spectra @ mel_bank(n_bands, spectra.shape[1], bin_width), np.float32)


def spread_mel(mel: Float32Array, n_bins: int, bin_width: float) -> Float32Array:
    """Draw mel spectra on the linear axis: (n_frames, n_bands) -> (n_frames, n_bins), a step for each band.

    Every bin shows the band whose peak is nearest in mel.
    """
    n_bands = mel.shape[1]
    spacing = float(mel_of(n_bins * bin_width)) / (n_bands + 1)
    nearest = np.round(mel_of(np.arange(n_bins) * bin_width) / spacing).astype(int) - 1
    return mel[:, np.clip(nearest, 0, n_bands - 1)]
