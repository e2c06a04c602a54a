"""How much two movements of a face differ, and where most: two drivers, or two presets, that say the same sound."""

from dataclasses import dataclass

import numpy as np

from phonemeengine.arrays import Float32Array, Float64Array
from phonemeengine.errors import MouthError
from phonemeengine.mouth.animation import Animation

WINDOW = 0.2
"""Seconds of a place: about a syllable."""
LEAST = 0.05
"""Of a weight: a smaller difference is hardly seen, and makes no place."""
MOST_PLACES, MOST_SHAPES = 20, 3


@dataclass(frozen=True)
class ShapeDifference:
    """How much a movestate differs.

    Attributes
    ----------
    name : of the movestate.
    mean, greatest : absolute difference of its weights, 0..1.
    """

    name: str
    mean: float
    greatest: float


@dataclass(frozen=True)
class DifferentPlace:
    """A place in a sound where two movements differ.

    Attributes
    ----------
    start, end : of the place, seconds.
    time : of the frame in it that differs most, seconds.
    rms : of the differences of all movestates in it.
    shapes : those movestates that differ most there, at most `MOST_SHAPES`, the first one most.
    """

    start: float
    end: float
    time: float
    rms: float
    shapes: tuple[ShapeDifference, ...]


@dataclass(frozen=True)
class MovementDifference:
    """How much two movements differ.

    Attributes
    ----------
    rms : root of the mean squared difference of weights, over all frames and movestates.
    shapes : all movestates that differ at all, the first one most.
    places : where the movements differ most, the first one most; they do not overlap.
    """

    rms: float
    shapes: tuple[ShapeDifference, ...]
    places: tuple[DifferentPlace, ...]


def movement_difference(one: Animation, other: Animation, most: int = MOST_PLACES) -> MovementDifference:
    """Return how much two movements of the same sound differ in the movestates that both have.

    Parameters
    ----------
    one, other : at the same rate; the shorter one is taken to stay as it ends.
    most : places that are listed.

    Raises
    ------
    MouthError : they have different rates, no movestate in common, or no frames.
    """
    names = tuple(name for name in one.movestates if name in other.movestates)
    if one.rate != other.rate or not names or not (len(one.weights) and len(other.weights)):
        raise MouthError(
            "two movements can be compared if both have frames, the same frame rate and movestates in common; make "
            "both with the same options"
        )
    n = max(len(one.weights), len(other.weights))
    first, second = (made.held(n).of_movestates(names).weights for made in (one, other))
    apart = np.abs(first - second)
    shapes = _shapes_of(apart, names)
    rms = float(np.sqrt(np.mean(np.square(apart, dtype=np.float64))))
    return MovementDifference(rms, shapes, tuple(_places_of(apart, names, one.rate, most)))


def _shapes_of(apart: Float32Array, names: tuple[str, ...]) -> tuple[ShapeDifference, ...]:
    means, greatest = apart.mean(axis=0, dtype=np.float64), apart.max(axis=0)
    order = [k for k in np.argsort(-means, kind="stable").tolist() if greatest[k] > 0]
    return tuple(ShapeDifference(names[k], float(means[k]), float(greatest[k])) for k in order)


def _places_of(apart: Float32Array, names: tuple[str, ...], rate: float, most: int) -> list[DifferentPlace]:
    """Return windows that do not overlap, of which each differs most among what those before it left."""
    n, width = len(apart), max(1, min(len(apart), round(WINDOW * rate)))
    powers = np.mean(np.square(apart, dtype=np.float64), axis=1)
    sums = np.concatenate(([0.0], np.cumsum(powers)))
    left: Float64Array = np.maximum(sums[width:] - sums[:-width], 0.0) / width  # of the window from each frame on
    places: list[DifferentPlace] = []
    while len(places) < most and left.max(initial=0.0) > 0:
        first = int(np.argmax(left))
        window, power = apart[first : first + width], float(left[first])
        left[max(0, first - width + 1) : first + width] = 0.0
        if window.max() < LEAST:
            continue
        time = (first + int(np.argmax(powers[first : first + width]))) / rate
        end = min(first + width, n - 1) / rate
        shapes = _shapes_of(window, names)[:MOST_SHAPES]
        places.append(DifferentPlace(first / rate, end, time, power**0.5, shapes))
    return places


def difference_in_words(found: MovementDifference, most: int = 3) -> str:
    """Return in words how much two movements differ, and the places where they do most."""
    if not found.places:
        return f"both heads move alike (RMS of the weights {found.rms:.3f})"
    places = (
        f"{place.time:.2f} s ({', '.join(f'{shape.name} {shape.greatest:.2f}' for shape in place.shapes)})"
        for place in found.places[:most]
    )
    return f"the heads differ by {found.rms:.3f} (RMS of the weights), most at {', '.join(places)}"
