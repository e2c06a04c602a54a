"""Action units of FACS, such as AU12, as names of what moves in a face, and ARKit's blend shapes for them."""

import re
from collections.abc import Sequence
from functools import cache

from phonemeengine.mouth.face_mapping import guess_mapping, shape_key

HIGHEST = 65
"""The number of the last action unit that moves eyes or face."""
_UNIT = re.compile(r"au\d+(?:left|right|lower|upper)?")


def is_unit(name: str) -> bool:
    """Return whether a name is that of an action unit, such as ``AU12``, ``au45L`` or ``AU28_Lower``."""
    return _UNIT.fullmatch(shape_key(name).stem) is not None


def shapes_moved_by(names: Sequence[str]) -> dict[str, tuple[int, ...]]:
    """Return the blend shapes of ARKit that action units move, each with the places of its units among the names.

    A shape's weight is the mean of theirs; names of other things are passed over.
    """
    places = {name: k for k, name in enumerate(names) if is_unit(name)}
    targets = guess_mapping([*places], "arkit").targets
    return {shape: tuple(places[name] for name in units) for shape, units in targets.items()}


@cache
def units_shown() -> dict[str, tuple[str, ...]]:
    """Return the action units that blend shapes of ARKit can show, each with these; its intensity is their mean."""
    names = [f"AU{number:02}" for number in range(1, HIGHEST + 1)]
    shapes = shapes_moved_by(names)
    found = {name: tuple(shape for shape, units in shapes.items() if k in units) for k, name in enumerate(names)}
    return {name: some for name, some in found.items() if some}
