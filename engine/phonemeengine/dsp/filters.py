"""The filters: on waveforms (pre-emphasis) and on amplitude spectra (all others).

Every function takes and gives float32 blocks of shape (n_frames, n_bins) and leaves its input as it is; denoise and
normalise take a single spectrum of shape (n_bins,) as well.
"""

import math

import numpy as np

from phonemeengine.arrays import Float32Array
from phonemeengine.errors import SettingsError

# Close above the smallest normal float32 (1.2e-38): a silent spectrum divided by it stays 0, without a branch, a
# division by zero or slow subnormal numbers.
TINY: Float32Array = np.array(1e-37, np.float32)


def pre_emphasis(waves: Float32Array, a: float) -> Float32Array:
    """Raise high frequencies: ``x[n] - a x[n-1]``, with x[-1] = x[0] so that a constant gives no edge."""
    # The gain is 1 - a at 0 Hz and 1 + a at half the rate: it counters the fall of voiced speech of about 6 dB an
    # octave.
    out = waves.copy()
    out[:, 1:] -= np.float32(a) * waves[:, :-1]
    out[:, 0] -= np.float32(a) * waves[:, 0]
    return out


class FrequencyShaper:
    """Scales, blurs over frequency and applies the ramps of the pass filters, in one go.

    All are linear in the spectrum, so together they are one weight for a bin and one for each neighbour.
    At blur strength 0 nothing is blurred, at 1 every bin is the mean of three; the border repeats, so a flat
    spectrum stays flat.

    Parameters
    ----------
    strength : of the blur, 0..1.
    gains : of the ramps, shape (n_bins,).
    scale : what each bin is multiplied with before all else, shape (n_bins,); nothing where it is not given.

    Attributes
    ----------
    centre : weight of each bin, float32, shape (1, n_bins).
    below, above : of its neighbours, float32, shape (n_bins - 1,): of bin k for bin k + 1, and of k + 1 for k.
    blurs : whether those count.
    """

    def __init__(self, strength: float, gains: Float32Array, scale: Float32Array | None = None) -> None:
        scale = np.ones_like(gains) if scale is None else scale
        # The kernel is (s/3, 1 - 2s/3, s/3). Scales belong to the bin that is read, gains to the bin that is written,
        # as if the three steps followed each other.
        side = strength / 3
        centre = np.full(len(gains), 1 - 2 * side)
        centre[[0, -1]] += side
        self.centre = (centre * gains * scale).astype(np.float32)[np.newaxis]
        self.below = (side * gains[1:] * scale[:-1]).astype(np.float32)
        self.above = (side * gains[:-1] * scale[1:]).astype(np.float32)
        self.blurs = strength > 0

    def shape(self, spectra: Float32Array, out: Float32Array | None = None) -> Float32Array:
        """Return the shaped spectra, written to `out` where it is given; the input stays as it is."""
        shaped: Float32Array = np.multiply(spectra, self.centre, out=out)
        if self.blurs:
            shaped[:, 1:] += self.below * spectra[:, :-1]
            shaped[:, :-1] += self.above * spectra[:, 1:]
        return shaped


class TimeSmoother:
    """Blurs each spectrum with the blurred one before it: ``y[k] = strength y[k-1] + (1 - strength) x[k]``.

    The sound begins after silence, so the first y is ``(1 - strength) x``. A block is smoothed by doubling: every
    pass adds what lies 1, 2, 4, 8... frames back, until float32 cannot hold its weight: normalising shows even the
    faintest rest of a sound, so nothing may be left out earlier.
    """

    def __init__(self, strength: float) -> None:
        self._last: Float32Array | None = None
        self._strength = strength

    def smooth(self, spectra: Float32Array) -> Float32Array:
        """Smooth the next spectra; at strength 0 they are given back as they are."""
        if self._strength == 0:
            self._last = spectra[-1]
            return spectra
        # The recursive filter 1 / (1 - s/z) is the product of (1 + s/z), (1 + s²/z²), (1 + s⁴/z⁴) and so on, so a
        # block of n frames takes log2(n) passes over whole arrays instead of n steps in Python.
        out = spectra * np.float32(1 - self._strength)
        if self._last is not None and len(self._last) == spectra.shape[1]:
            # what the last block left behind enters as if it were part of the first frame; the passes carry it on
            out[0] += np.float32(self._strength) * self._last
        reach, weight = 1, self._strength
        while reach < len(out) and np.float32(weight) > 0:
            # the product is a new array, so the overlapping parts are read before they are written
            out[reach:] += np.float32(weight) * out[:-reach]
            reach, weight = 2 * reach, weight * weight
        self._last = out[-1]
        return out

    def resume(self, other: "TimeSmoother") -> None:
        """Go on from where another one stopped."""
        self._last = other._last


def _ramp(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    frequencies = np.arange(n_bins) * bin_width
    if end <= start:
        return np.asarray(frequencies >= start, np.float32)
    return np.asarray(np.clip((frequencies - start) / (end - start), 0, 1), np.float32)


def high_pass_gains(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    """Return a gain per bin, shape (n_bins,), that rises from 0 at `start` to 1 at `end` (Hz)."""
    return _ramp(n_bins, bin_width, start, end)


def low_pass_gains(n_bins: int, bin_width: float, start: float, end: float) -> Float32Array:
    """Return a gain per bin, shape (n_bins,), that falls from 1 at `start` to 0 at `end` (Hz)."""
    return 1 - _ramp(n_bins, bin_width, start, end)


def denoise(spectra: Float32Array, threshold: float | Float32Array) -> Float32Array:
    """Set amplitudes below `threshold` (0..1) to 0."""
    kept: Float32Array = spectra * (spectra >= threshold)
    return kept


def normalise(spectra: Float32Array, maximum: float = 1.0, *, peaks: Float32Array | None = None) -> Float32Array:
    """Scale each spectrum so that its largest amplitude becomes `maximum`; a silent one stays 0.

    Parameters
    ----------
    spectra : shape (n_frames, n_bins), or (n_bins,).
    maximum : above 0.
    peaks : the largest amplitudes, shape (n_frames, 1), where they are known already.

    Raises
    ------
    SettingsError : the maximum is no number above 0.
    """
    if not 0 < maximum < math.inf:
        raise SettingsError(f"the maximum of a normalised spectrum must be above 0, got {maximum:g}; choose another")
    if peaks is None:
        peaks = np.maximum.reduce(spectra, axis=-1, keepdims=True)
    divisors: Float32Array = np.maximum(peaks / np.float32(maximum), TINY)
    return spectra / divisors
