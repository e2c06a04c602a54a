"""Mel filter banks, logarithms of the powers in their bands, and the cepstra of those.

The filters are triangles, equally spaced and overlapping by half on the HTK mel scale:
``mel = 2595 log10(1 + f / 700)`` (S. Young et al., The HTK Book, section 5.4). Each triangle has height 1 and
its value is the weighted mean of the amplitudes under it, so that a flat spectrum stays flat.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.dsp.spectrum import rfft
from phonemeengine.settings import SAMPLE_RATE, WINDOW


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


SHORT = 1024
"""Samples of the short window (23.2 ms), the middle of a frame: 46.4 ms would blur the burst of a p."""

N_BANDS = 40
LOWEST, HIGHEST = 60.0, 8000.0
"""Where the first band begins and the last one ends, Hz; much speech holds nothing above."""

FLOOR = 1e-11
"""Added to every power, so that digital silence has a logarithm; a full-scale sine has the power 1."""

_MIDDLE = slice((WINDOW - SHORT) // 2, (WINDOW + SHORT) // 2)


def log_mels(windows: Float32Array, warps: tuple[float, ...] = (1.0,)) -> Float32Array:
    """Return the base-10 logarithms of the powers in 40 mel bands, about -11 to 0; see `mel_powers`.

    With several `warps` (see `warped_mel_bank`) the bands of each lie beside those of the one before: shape
    (n_frames, n_warps x 40).
    """
    # Added and not clamped: the logarithm stays smooth near the floor, so a faint hiss moves it little.
    powers = mel_powers(windows, _banks(warps))
    powers += np.float32(FLOOR)
    logarithms: Float32Array = np.log10(powers, out=powers)
    return logarithms


def silent_log_mels(*shape: int) -> Float32Array:
    """Return what digital silence reads in all 40 bands, shape (*shape, 40)."""
    return np.full((*shape, N_BANDS), np.log10(FLOOR), np.float32)


def mel_powers(windows: Float32Array, bank: Float32Array) -> Float32Array:
    """Return the powers in mel bands.

    Parameters
    ----------
    windows : float32, shape (n_frames, 2048), full scale ±1.
    bank : the bands, as from `warped_mel_bank`, shape (n_bins, n_bands).

    Returns
    -------
    float32, shape (n_frames, n_bands); a full-scale sine has the power 1.
    """
    bins = rfft()(windows[:, _MIDDLE] * short_window(), axis=1)[:, : len(bank)]
    powers = bins.real * bins.real
    powers += bins.imag * bins.imag
    mels: Float32Array = powers.dot(bank)
    return mels


@lru_cache(maxsize=1)
def short_window() -> Float32Array:
    """Return the Hann window, shape (1024,), scaled so that a full-scale sine on a bin reads 1."""
    # Periodic (n and not n - 1 below the line), so that a sine on a bin reaches just its two neighbours. A sine of
    # amplitude 1 gives a bin of half the sum of the window, hence 2 / sum.
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(SHORT) / SHORT)
    return np.asarray(window * 2 / window.sum(), np.float32)


def warped_mel_bank(warp: float = 1.0) -> Float32Array:
    """Return the weights of the mel filters, shape (n_bins, 40); each column sums to 1.

    With a `warp`, what lies at a frequency f is looked for at f x warp, as if the speaker's vocal tract were shorter
    (above 1) or longer; the upper end stays (piecewise linear, as in L. Lee and R. Rose, "A frequency warping
    approach to speaker normalization", IEEE Trans. Speech and Audio Processing 6(1), 1998).
    """
    edges = mel_edges(N_BANDS, HIGHEST, LOWEST)
    # Straight up to the knee with the slope `warp`, and from there to the fixed upper end, so that the same bins are
    # used whatever the warp. The knee moves down for warps above 1, else the second slope would be negative.
    knee = 0.8 * HIGHEST / max(warp, 1)
    slope = (HIGHEST - warp * knee) / (HIGHEST - knee)
    edges = np.where(edges <= knee, edges * warp, warp * knee + (edges - knee) * slope)
    bin_width = SAMPLE_RATE / SHORT
    return triangular_bank(edges, int(HIGHEST / bin_width) + 2, bin_width)


@lru_cache(maxsize=8)
def _banks(warps: tuple[float, ...]) -> Float32Array:
    return np.concatenate([warped_mel_bank(warp) for warp in warps], axis=1)


# Mel cepstra: the coarse shape of a spectrum, as few numbers.

N_CEPSTRA = 12
"""Coefficients 1..12; the zeroth, the loudness, is left out."""


def cepstra_of(log_mels: Float32Array) -> Float32Array:
    """Return the cosine transform of logarithms of mel powers, without its zeroth coefficient.

    A louder sound has the same cepstra (S. Davis and P. Mermelstein, IEEE Trans. ASSP 28(4), 1980).

    Parameters
    ----------
    log_mels : float32, shape (n_frames, 40).

    Returns
    -------
    float32, shape (n_frames, 12).
    """
    cepstra: Float32Array = log_mels.dot(cepstral_cosines())
    return cepstra


@lru_cache(maxsize=1)
def cepstral_cosines() -> Float32Array:
    """Return the orthonormal cosines of the transform (DCT-II), shape (n_bands, n_cepstra)."""
    # Half a band further, since the DCT-II is even about the edge of the first band; neighbouring mel bands are
    # nearly decorrelated by it, which lets distances treat the coefficients as independent.
    bands = np.arange(N_BANDS)[:, np.newaxis] + 0.5
    return np.asarray(
        np.sqrt(2 / N_BANDS) * np.cos(np.pi / N_BANDS * bands * np.arange(1, N_CEPSTRA + 1)), np.float32
    )
