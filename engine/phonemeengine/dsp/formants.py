"""Formants: the resonances of the vocal tract, by linear prediction.

The coefficients are those of J. P. Burg ("Maximum entropy spectral analysis", Stanford, 1975), found by the recursion
of N. Andersen ("On the calculation of filter coefficients for maximum entropy spectral analysis", Geophysics 39(1),
1974). Windows, pre-emphasis and limits are those of Praat's ``To Formant (burg)``, so that the numbers compare.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.audio.resampling import resample_whole
from phonemeengine.errors import check_range
from phonemeengine.settings import FRAME_PERIOD, SAMPLE_RATE

CEILING = 5500.0
"""Hz below which the formants are looked for: usual for women; 5000 for men, and up to 8000 for children."""
LOWEST_CEILING, HIGHEST_CEILING = 3000.0, 10_000.0
N_FORMANTS = 5
"""Looked for below the ceiling."""
WINDOW_SECONDS = 0.05
"""Whole length of the Gaussian window; half of it is what counts."""
EMPHASIS_FROM = 50.0
"""Hz above which the sound is raised by 6 dB an octave."""
MARGIN = 50.0
"""Hz from 0 and from the ceiling within which a resonance is none of the vocal tract."""
AT_ONCE = 1000
"""Frames."""


class Formants(NamedTuple):
    """The formants of frames, from low to high; NaN where there are fewer.

    Attributes
    ----------
    frequencies : float32, shape (n_frames, 5), Hz.
    bandwidths : float32, shape (n_frames, 5), Hz at -3 dB.
    """

    frequencies: Float32Array
    bandwidths: Float32Array


def formants_of(
    samples: Float32Array, *, first_frame: int = 0, n_frames: int | None = None, ceiling: float = CEILING
) -> Formants:
    """Return the formants in the middle of consecutive frames of 10 ms.

    Where nothing sounds there are none. Outside of vowels they mean little.

    Parameters
    ----------
    samples : float32, shape (n,), 44.1 kHz.
    first_frame : the frame to begin with; its middle lies at ``(first_frame + 0.5) / 100`` s.
    n_frames : how many; None for all to the end.
    ceiling : Hz, 3000..10000; the speaker's vocal tract decides which one is right.

    Raises
    ------
    SettingsError : the ceiling lies outside its range.
    """
    check_range("the ceiling", ceiling, (LOWEST_CEILING, HIGHEST_CEILING, "Hz"))
    # Burg's method spends its poles on the whole band, so the band must end at the ceiling: then two poles, a
    # conjugate pair, are left for each of the five formants.
    rate = round(2 * ceiling)
    if n_frames is None:
        n_frames = max(0, round(len(samples) / SAMPLE_RATE / FRAME_PERIOD) - first_frame)
    sound = _emphasised(resample_whole(samples, SAMPLE_RATE, rate), rate)
    length = int(WINDOW_SECONDS * rate)
    padded = np.concatenate((np.zeros(length), sound, np.zeros(2 * length)))
    window = _gaussian(length)
    found = [np.full((0, 2, N_FORMANTS), np.nan)]
    for first in range(first_frame, first_frame + n_frames, AT_ONCE):
        frames = np.arange(first, min(first + AT_ONCE, first_frame + n_frames))
        starts = np.round((frames + 0.5) * FRAME_PERIOD * rate - length / 2).astype(int) + length
        inside = np.clip(starts, 0, len(padded) - length)
        found.append(_resonances(padded[inside[:, np.newaxis] + np.arange(length)] * window, rate))
    both = np.concatenate(found).astype(np.float32)
    return Formants(both[:, 0], both[:, 1])


def linear_prediction(frames: Float64Array, order: int) -> Float64Array:
    """Return the coefficients of the prediction error filter by Burg's method, shape (n_frames, order + 1).

    The first one is 1; silent frames have zeros behind it.
    """
    # Stage m filters the frame with prediction error filters of order m in both directions. The reflection
    # coefficient k = 2 Σ f b / Σ (f² + b²) makes the sum of both error powers least; |k| <= 1, so no pole lies
    # outside the unit circle, whatever the window.
    forward, backward = frames, frames
    filters = np.ones((len(frames), 1))
    for _ in range(order):
        ahead, behind = forward[:, 1:], backward[:, :-1]
        power = np.einsum("ij,ij->i", ahead, ahead) + np.einsum("ij,ij->i", behind, behind)
        shared = 2 * np.einsum("ij,ij->i", ahead, behind)
        reflection = np.divide(shared, power, out=np.zeros_like(power), where=power > 0)[:, np.newaxis]
        forward, backward = ahead - reflection * behind, behind - reflection * ahead
        # Levinson's recursion: a[m] = (a[m-1], 0) - k times the same backwards
        longer = np.pad(filters, ((0, 0), (0, 1)))
        filters = longer - reflection * longer[:, ::-1]
    return filters


def _resonances(frames: Float64Array, rate: int) -> Float64Array:
    """Return frequencies and bandwidths, shape (n_frames, 2, N_FORMANTS)."""
    # The roots of the polynomial are the eigenvalues of its companion matrix, all frames in one call. In float64, as
    # Praat has it: the poles of narrow formants lie close to the unit circle.
    order = 2 * N_FORMANTS
    filters = linear_prediction(frames, order)
    companions = np.zeros((len(frames), order, order))
    companions[:, np.arange(1, order), np.arange(order - 1)] = 1
    companions[:, 0] = -filters[:, 1:]
    roots = np.linalg.eigvals(companions)
    radii = np.abs(roots)
    inside = np.where(radii > 1, 1 / np.maximum(radii, 1e-12), radii)  # what would grow decays as fast
    # A pole r exp(i φ) rings at φ rate / 2π Hz and is 3 dB down at ± half of -ln(r) rate / π Hz.
    frequencies = np.angle(roots) * rate / (2 * np.pi)
    with np.errstate(divide="ignore"):
        bandwidths = -np.log(inside) * rate / np.pi
    kept = (frequencies >= MARGIN) & (frequencies <= rate / 2 - MARGIN) & np.any(frames, axis=1, keepdims=True)
    return _sorted(np.where(kept, frequencies, np.nan), bandwidths)


def _sorted(frequencies: Float64Array, bandwidths: Float64Array) -> Float64Array:
    order = np.argsort(frequencies, axis=1)[:, :N_FORMANTS]  # NaN goes last
    rising = np.take_along_axis(frequencies, order, axis=1)
    widths = np.where(np.isnan(rising), np.nan, np.take_along_axis(bandwidths, order, axis=1))
    return np.stack((rising, widths), axis=1)


def _emphasised(sound: Float32Array, rate: int) -> Float64Array:
    raised = sound.astype(np.float64)
    raised[1:] -= np.exp(-2 * np.pi * EMPHASIS_FROM / rate) * sound[:-1]
    return raised


def _gaussian(length: int) -> NDArray[np.float64]:
    # Praat's Gaussian, -48 (t / T)² in the exponent, lowered by its value at the ends so that it begins at 0
    places = (np.arange(1, length + 1) - 0.5 * (length + 1)) / (length + 1)
    edge = np.exp(-12.0)
    return np.asarray((np.exp(-48 * places**2) - edge) / (1 - edge))
