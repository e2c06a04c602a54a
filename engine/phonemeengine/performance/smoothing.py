"""Smoothing a sentence that was joined of units, and what its sound does to it: loudness, and rest at its end."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import groupby

import numpy as np

from phonemeengine.arrays import BoolArray, Float32Array, Float64Array
from phonemeengine.performance.fit import crossed
from phonemeengine.performance.monotone_cubic import MonotoneCubics
from phonemeengine.performance.recording import SILENCE
from phonemeengine.performance.sentence import Sentence

SYLLABLE_CUTOFF, WORD_CUTOFF = 0.5, 0.7
"""Cut-off frequencies within syllables and words, beside the number of phones a second."""
LEAST_PHRASE_CUTOFF, ABOVE_WORD = 10.0, 1.1
"""Within the sentence: hertz at least, and beside the cut-off within words."""
OUTLIER, NEIGHBOURS = 0.3, 2
"""A weight that is so far from the median of itself and as many frames on each side is no movement of a face."""
TO_REST = 0.3
"""Seconds in which a face comes to rest after the last phone."""
ENERGY_CHANNELS = ("jawOpen",)
"""What opens farther in louder speech."""
GAIN, GAIN_STEP, LEAST_GAIN, MOST_GAIN = 0.5, 12.0, 0.7, 1.4
"""By how much for how many decibels, and the limits of it."""


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


def smoothed(weights: Float32Array, sentence: Sentence, times: Float64Array) -> Float32Array:
    """Filter syllables, then words, then the whole sentence, with a cut-off that rises from level to level.

    The filter is a Butterworth low-pass of second order, forwards and backwards, of the part continued point by point
    symmetrically beyond its ends, which therefore stay where they are: neighbours still meet.

    Parameters
    ----------
    weights : shape (n_frames, n_channels).
    sentence : its phones.
    times : of the frames, seconds, evenly spaced.
    """
    spoken = [phone.duration for phone in sentence if phone.name != SILENCE]
    if len(times) < 3 or not spoken:
        return weights
    rate = (len(times) - 1) / (times[-1] - times[0])
    pace = len(spoken) / sum(spoken)
    word = WORD_CUTOFF * pace
    result = weights.astype(np.float64)
    for numbers, cutoff in (
        ([phone.syllable for phone in sentence], SYLLABLE_CUTOFF * pace),
        ([phone.word for phone in sentence], word),
        ([0] * len(sentence), max(LEAST_PHRASE_CUTOFF, ABOVE_WORD * word)),
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


def gains_of(sentence: Sentence, times: Float64Array) -> Float32Array:
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
    gains = np.clip(1 + GAIN * (levels - levels.mean()) / GAIN_STEP, LEAST_GAIN, MOST_GAIN)
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
