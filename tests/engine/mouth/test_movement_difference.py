"""How much two movements differ, and where."""

import numpy as np
import pytest

from phonemeengine.errors import MouthError
from phonemeengine.mouth.animation import (
    Animation,
    DifferentPlace,
    ShapeDifference,
    difference_in_words,
    movement_difference,
)

NAMES = ("jawOpen", "mouthPucker", "tongueOut")


def movement(n: int = 200, names: tuple[str, ...] = NAMES, rate: float = 50.0) -> Animation:
    return Animation(rate, names, np.zeros((n, len(names)), np.float32), np.zeros((n, 3), np.float32))


def test_places_are_listed_by_how_much_they_differ_and_do_not_overlap():
    one, other = movement(), movement()
    other.weights[100:110, 1] = 0.5
    other.weights[20:30, 0] = 0.8
    other.weights[20:30, 1] = 0.2
    other.weights[150:160, 2] = 0.04  # too little to be seen
    found = movement_difference(one, other)
    assert [(place.start, place.end) for place in found.places] == [(0.4, 0.6), (2.0, 2.2)]
    first, second = found.places
    assert [shape.name for shape in first.shapes] == ["jawOpen", "mouthPucker"]
    assert first.shapes[0] == ShapeDifference("jawOpen", pytest.approx(0.8), pytest.approx(0.8))
    assert 0.4 <= first.time < 0.6
    assert second.shapes[0].greatest == pytest.approx(0.5)
    assert first.rms == pytest.approx(np.sqrt((0.8**2 + 0.2**2) / 3))
    squares = 10 * (0.8**2 + 0.2**2 + 0.5**2 + 0.04**2)
    assert found.rms == pytest.approx(np.sqrt(squares / (200 * 3)), rel=1e-5)
    assert [shape.name for shape in found.shapes] == ["jawOpen", "mouthPucker", "tongueOut"]
    assert found.shapes[0].mean == pytest.approx(0.8 * 10 / 200)
    assert difference_in_words(found).startswith("the heads differ by 0.125 (RMS of the weights), most at 0.4")
    assert len(movement_difference(one, other, most=1).places) == 1


def test_a_shorter_movement_stays_as_it_ends_and_only_shared_movestates_count():
    one, other = movement(), movement(50, ("mouthPucker", "jawOpen"))
    one.weights[:, 2] = 1.0
    other.weights[-1, 1] = 0.3
    found = movement_difference(one, other)
    assert [shape.name for shape in found.shapes] == ["jawOpen"]
    assert found.shapes[0].mean == pytest.approx(0.3 * 151 / 200)
    assert all(isinstance(place, DifferentPlace) and place.end <= one.times[-1] for place in found.places)


def test_equal_movements_have_no_places():
    found = movement_difference(movement(), movement())
    assert (found.rms, found.shapes, found.places) == (0.0, (), ())
    assert difference_in_words(found) == "both heads move alike (RMS of the weights 0.000)"


@pytest.mark.parametrize("other", [movement(rate=60.0), movement(names=("A", "B", "C")), movement(0)])
def test_movements_that_cannot_be_compared_are_refused(other):
    with pytest.raises(MouthError, match="make both with the same options"):
        movement_difference(movement(), other)
