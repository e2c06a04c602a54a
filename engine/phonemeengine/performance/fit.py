"""Fitting examples to a sentence: each is stretched so that its phones fall onto the sentence's, then joined."""

from collections.abc import Sequence

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array, IndexArray
from phonemeengine.performance.choice import Chosen
from phonemeengine.performance.monotone_cubic import MonotoneCubics
from phonemeengine.performance.search import PlacedUnit


def fitted(
    placed: Sequence[PlacedUnit], chosen: Sequence[Chosen], bounds: Float64Array, times: Float64Array
) -> Float32Array:  # fmt: skip
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
