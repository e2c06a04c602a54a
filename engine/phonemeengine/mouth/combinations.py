"""Combination shapes: they correct what other shapes of a face look like together, such as ``mouthSmile_jawOpen``."""

from collections.abc import Collection, Mapping

import numpy as np
from numpy.typing import ArrayLike

from phonemeengine.arrays import Float32Array

Parts = tuple[tuple[str, ...], ...]
"""The shapes that a combination is made of; one without a side is both of its sides."""


def combinations_of(names: Collection[str]) -> dict[str, Parts]:
    """Return the shapes whose names are those of two or more others, joined by underscores, each with these.

    ``mouthSmile_jawOpen`` is of both sides of ``mouthSmile`` and of ``jawOpen``, where the former has two sides.
    """
    known = {*names}
    found = {name: _parts_of(name.split("_"), known - {name}) for name in names if "_" in name}
    return {name: parts for name, parts in found.items() if len(parts) > 1}


def combined(parts: Parts, weights: Mapping[str, ArrayLike]) -> Float32Array:
    """Return how far a combination moves: the product of its parts, 0..1 each, of which both sides are the mean.

    Parameters
    ----------
    weights : of all shapes by name, 1 for the whole movement, in arrays of one form.
    """
    means = [np.array([weights[name] for name in shapes], np.float32).mean(axis=0) for shapes in parts]
    shares: Float32Array = np.prod(np.clip(means, 0, 1), axis=0)
    return shares


def _parts_of(words: list[str], known: Collection[str]) -> Parts:
    """Return the shapes of which words are made, the longest first; none where a word is left over."""
    for n in range(len(words), 0, -1):
        name = "_".join(words[:n])
        sides = (f"{name}Left", f"{name}Right")
        first = (name,) if name in known else sides if all(side in known for side in sides) else ()
        rest = _parts_of(words[n:], known) if first and n < len(words) else ()
        if first and (rest or n == len(words)):
            return (first, *rest)
    return ()
