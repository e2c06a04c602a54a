"""Smoothing a sentence that was joined of units, and what its sound does to it: loudness, and rest at its end."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import groupby

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array, IndexArray
from phonemeengine.mouth.style_numbers import FilterNumbers
from phonemeengine.performance.choice import Chosen, PlacedUnit
from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.units import Sentence

# Monotone cubic interpolation of many curves at once.
#
# The slopes are those of F. Fritsch and J. Butland, A method for constructing local monotone piecewise cubic
# interpolants (1984), without their weights: the harmonic mean of both neighbouring secants, 0 where these differ in
# sign; at the ends, the secant. Beyond its ends a curve goes on straight.

FAR = 1e4
"""More than any curve is long."""


class MonotoneCubics:
    """Curves through points, evaluated together.

    Parameters
    ----------
    xs : float64, shape (n,): of the points of all curves one after the other; of each, increasing.
    ys : float64, shape (n,).
    starts : shape (n_curves,): the number of each curve's first point; every curve has two points or more.
    """

    def __init__(self, xs: Float64Array, ys: Float64Array, starts: IndexArray) -> None:
        ends = np.append(starts[1:], len(xs))
        curves = np.repeat(np.arange(len(starts)), ends - starts)
        self._first, self._last = starts, ends - 2  # the numbers of their first and last pieces
        self._xs, self._ys, self._shifted = xs, ys, xs + FAR * curves
        self._widths = np.diff(xs)
        self._widths[starts[1:] - 1] = 1.0  # from one curve to the next: of no piece
        secants = np.diff(ys) / self._widths
        before, after = secants[:-1], secants[1:]
        agree = before * after > 0
        total = np.where(agree, before + after, 1.0)
        self._slopes = np.empty(len(xs))
        self._slopes[1:-1] = np.where(agree, 2 * before * after / total, 0.0)
        self._slopes[starts], self._slopes[ends - 1] = secants[starts], secants[ends - 2]

    def at(self, xs: Float64Array, curves: IndexArray) -> Float64Array:
        """Return the values of some curves at some places, both of shape (n,)."""
        found = np.searchsorted(self._shifted, xs + FAR * curves, "right") - 1
        k = np.clip(found, self._first[curves], self._last[curves])
        width, rise = self._widths[k], self._ys[k + 1] - self._ys[k]
        share = (xs - self._xs[k]) / width
        beyond = np.where(
            share < 0, share * self._slopes[k], np.where(share > 1, (share - 1) * self._slopes[k + 1], 0.0)
        )
        s = np.clip(share, 0.0, 1.0)
        bent = s * (1 - s) * ((1 - s) * (self._slopes[k] * width - rise) + s * (rise - self._slopes[k + 1] * width))
        values: Float64Array = self._ys[k] + s * rise + bent + beyond * width
        return values


# Fitting examples to a sentence: each is stretched so that its phones fall onto the sentence's, then joined.


def fitted(
    placed: Sequence[PlacedUnit], chosen: Sequence[Chosen], bounds: Float64Array, times: Float64Array
) -> Float32Array:
    """Return the face of a sentence, float32, shape (n_times, n_channels).

    The bounds of an example's halves are moved onto those of the unit by a monotone cubic. Around a join,
    neighbours are cross-faded along half a cosine, over half of each half that meets there; beyond its own ends an
    example runs on as fast as there.

    Parameters
    ----------
    placed : the units, which cover all halves; in order.
    chosen : the example of each.
    bounds : of the sentence's halves, seconds, shape (n_halves + 1,).
    times : seconds, increasing; before and after the sentence the examples run on.
    """
    fades = [_fade_at(unit.unit.first, bounds) for unit in placed[1:]]
    spans = _spans_of(fades, times)
    curves = np.repeat(np.arange(len(placed)), [last - first for first, last in spans])
    shown = np.concatenate([times[first:last] for first, last in spans])
    read = _curves_of(placed, chosen, bounds).at(shown, curves)
    weights = np.zeros((len(times), chosen[0][0].weights.shape[1]), np.float32)
    at = 0
    for k, (first, last) in enumerate(spans):
        share = np.ones(last - first, np.float32)
        if k:
            share *= crossed(times[first:last], *fades[k - 1])
        if k < len(fades):
            share *= 1 - crossed(times[first:last], *fades[k])
        weights[first:last] += share[:, None] * chosen[k][0].at(read[at : at + last - first])
        at += last - first
    return weights


def _fade_at(half: int, bounds: Float64Array) -> tuple[float, float]:
    """Return from when to when, seconds, one unit goes over into the next at the join before a half."""
    before, join, after = bounds[half - 1 : half + 2].tolist()
    return (before + join) / 2, (join + after) / 2


def crossed(times: Float64Array, start: float, end: float) -> Float32Array:
    """Return half a cosine from 0 at one time to 1 at another one, float32, shape (n_times,)."""
    progress = np.clip((times - start) / max(end - start, 1e-9), 0.0, 1.0)
    return (0.5 - 0.5 * np.cos(np.pi * progress)).astype(np.float32)


def _spans_of(fades: Sequence[tuple[float, float]], times: Float64Array) -> list[tuple[int, int]]:
    """Return the numbers of the first time of each unit, and of the one after its last."""
    firsts = np.searchsorted(times, [start for start, _ in fades])
    lasts = np.searchsorted(times, [end for _, end in fades])
    return [*zip([0, *firsts.tolist()], [*lasts.tolist(), len(times)], strict=True)]


def _curves_of(placed: Sequence[PlacedUnit], chosen: Sequence[Chosen], bounds: Float64Array) -> MonotoneCubics:
    """Return the curves from the times of the sentence to those of the recordings, one a unit."""
    xs = [bounds[unit.unit.first : unit.unit.last + 1] for unit in placed]
    ys = [halves.bounds[example.first : example.last + 1] for halves, example in chosen]
    starts: IndexArray = np.cumsum([0, *map(len, xs[:-1])])
    return MonotoneCubics(np.concatenate(xs), np.concatenate(ys), starts)


USUAL_FILTERS: FilterNumbers = FilterNumbers()
OUTLIER, NEIGHBOURS = 0.3, 2
"""A weight that is so far from the median of itself and as many frames on each side is no movement of a face."""
TO_REST = 0.3
"""Seconds in which a face comes to rest after the last phone."""
ENERGY_CHANNELS = ("jawOpen",)
"""What opens farther in louder speech."""
GAIN_STEP, LEAST_GAIN, MOST_GAIN = 12.0, 0.7, 1.4
"""For how many decibels its gain is meant, and its limits."""


def without_outliers(weights: Float32Array) -> Float32Array:
    """Replace single frames that stick out, which trackers lose, by a monotone cubic through the others.

    This comes before the filters, which would spread them.

    Parameters
    ----------
    weights : shape (n_frames, n_channels).
    """
    if len(weights) <= 2 * NEIGHBOURS:
        return weights
    padded = np.pad(weights, ((NEIGHBOURS, NEIGHBOURS), (0, 0)), "edge")
    medians = np.median(np.lib.stride_tricks.sliding_window_view(padded, 2 * NEIGHBOURS + 1, axis=0), axis=-1)
    outlying = np.abs(weights - medians) > OUTLIER
    outlying[[0, -1]] = False
    mended = weights.copy()
    for channel in np.flatnonzero(outlying.any(axis=0)):
        mended[:, channel] = _bridged(weights[:, channel], outlying[:, channel])
    return mended


def smoothed(
    weights: Float32Array, sentence: Sentence, times: Float64Array, filters: FilterNumbers = USUAL_FILTERS
) -> Float32Array:
    """Filter syllables, then words, then the whole sentence, with a cut-off that rises from level to level.

    The filter is a Butterworth low-pass of second order, forwards and backwards, of the part continued point by point
    symmetrically beyond its ends, which therefore stay where they are: neighbours still meet.

    Parameters
    ----------
    weights : shape (n_frames, n_channels).
    sentence : its phones.
    times : of the frames, seconds, evenly spaced.
    filters : the cut-offs.
    """
    spoken = [phone.duration for phone in sentence if phone.name != SILENCE]
    if len(times) < 3 or not spoken:
        return weights
    rate = (len(times) - 1) / (times[-1] - times[0])
    pace = len(spoken) / sum(spoken)
    word = filters.word * pace
    result = weights.astype(np.float64)
    for numbers, cutoff in (
        ([phone.syllable for phone in sentence], filters.syllable * pace),
        ([phone.word for phone in sentence], word),
        ([0] * len(sentence), max(filters.phrase, filters.above_word * word)),
    ):
        for first, last in _parts_of(sentence, numbers, times):
            result[first:last] = low_passed(result[first:last], cutoff / rate)
    return result.astype(np.float32)


def bounded(weights: Float32Array) -> Float32Array:
    """Return weights within 0..1."""
    return np.clip(weights, 0.0, 1.0)


def brought_to_rest(weights: Float32Array, sentence: Sentence, times: Float64Array) -> Float32Array:
    """Lead a face to rest after the last phone, along half a cosine."""
    end = sentence[-1].start
    return weights * (1 - crossed(times, end, end + TO_REST))[:, None]


def gains_of(sentence: Sentence, times: Float64Array, gain: float = USUAL_FILTERS.gain) -> Float32Array:
    """Return by how much louder or quieter speech enlarges `ENERGY_CHANNELS` at some times, shape (n_times,).

    A syllable is as loud as its loudest phone, at the middle of that; between syllables it goes on straight.
    """
    syllables = [
        max(phones, key=lambda phone: phone.energy)
        for number, phones in groupby(sentence, lambda phone: phone.syllable)
        if number >= 0
    ]
    if not syllables:
        return np.ones(len(times), np.float32)
    levels = np.array([phone.energy for phone in syllables])
    gains = np.clip(1 + gain * (levels - levels.mean()) / GAIN_STEP, LEAST_GAIN, MOST_GAIN)
    found: Float32Array = np.interp(times, [phone.middle for phone in syllables], gains).astype(np.float32)
    return found


def _bridged(values: Float32Array, outlying: BoolArray) -> Float64Array:
    good, bad = np.flatnonzero(~outlying), np.flatnonzero(outlying)
    result = values.astype(np.float64)
    curve = MonotoneCubics(good.astype(float), result[good], np.zeros(1, np.intp))
    result[bad] = curve.at(bad.astype(float), np.zeros(len(bad), np.intp))
    return result


def _parts_of(sentence: Sentence, numbers: Sequence[int], times: Float64Array) -> Iterator[tuple[int, int]]:
    """Return the frames of each run of a number but -1; neighbours share the frame where they meet."""
    for number, run in groupby(range(len(numbers)), key=numbers.__getitem__):
        places = [*run]
        first, last = np.searchsorted(times, (sentence[places[0]].start, sentence[places[-1]].end))
        if number >= 0:
            yield int(first), min(int(last) + 1, len(times))


def low_passed(part: Float64Array, cutoff: float) -> Float64Array:
    """Return a part without what changes fast, neither early nor late; its ends stay where they are.

    Parameters
    ----------
    part : shape (n_frames, n_channels).
    cutoff : where the filter leaves a half, beside the rate of frames.
    """
    n = len(part)
    if n < 3:
        return part
    line = np.linspace(part[0], part[-1], n)
    bent = part[1:-1] - line[1:-1]
    line[1:-1] += _sines()(_sines()(bent) * _gains(n, round(cutoff, 4))[:, None]) / (2 * (n - 1))
    return line


def _sines() -> Callable[[Float64Array], Float64Array]:
    """Return the sine transform of the first kind along the frames; twice, it multiplies by 2 (n + 1)."""
    from scipy.fft import dst  # noqa: PLC0415 - half a second that a window should not wait for

    def transform(values: Float64Array) -> Float64Array:
        found: Float64Array = dst(values, 1, axis=0)
        return found

    return transform


@lru_cache(maxsize=1024)
def _gains(n: int, cutoff: float) -> Float64Array:
    """Return what a digital Butterworth filter leaves of each sine of n frames, forwards and backwards."""
    frequencies = np.arange(1, n - 1) / (2 * (n - 1))
    warped = np.tan(np.pi * frequencies) / math.tan(math.pi * min(cutoff, 0.49))
    return 1 / (1 + warped**4)
