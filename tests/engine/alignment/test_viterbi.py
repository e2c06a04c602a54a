"""The cheapest way through hand-made scores is known before it is looked for."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from phonemeengine.alignment.viterbi import (
    SILENT,
    SKIPPED,
    SOUND,
    STRANGE,
    Lattice,
    LeastFrames,
    Prices,
    Way,
    WayStep,
    cheapest_way,
    lattice_of,
)

QUIET, A, B, C = range(4)
FREE = Prices(silence=0.0)
LOOSE = Prices(silence=1.0, skip=5.0, skip_sound=1.0, strange=8.0, strange_frame=0.5)


def heard(said: str) -> np.ndarray:
    """Frames in which what is said, a letter for each, falls short of nothing, and all else of much."""
    scores = np.full((len(said), 4), -9.0)
    scores[np.arange(len(said)), ["-abc".index(letter) for letter in said]] = 0.0
    return scores


def way_of(said: str, words: list[list[list[int]]], prices: Prices = FREE, least: int = 2) -> Way:
    lattice = lattice_of(words)
    way = cheapest_way(heard(said), lattice, prices, least_of(lattice, least))
    assert way is not None
    return way


def least_of(lattice: Lattice, sound: int) -> LeastFrames:
    return LeastFrames(np.full(len(lattice.columns), sound), silence=2, strange=3)


def steps_of(way: Way) -> list[tuple[int, int, int, int]]:
    return [tuple(step) for step in way.steps]


def test_sounds_lie_where_they_are_heard():
    way = way_of("aaabbbbcc", [[[A, B]], [[C]]])
    assert steps_of(way) == [(0, 3, SOUND, 0), (3, 7, SOUND, 1), (7, 9, SOUND, 2)]
    assert way.cost == 0.0


def test_silence_may_stand_before_between_within_and_after_words():
    way = way_of("--aa--bb---cc--", [[[A, B]], [[C]]])
    kinds = [(step.first, step.last) for step in way.steps if step.kind == SILENT]
    assert kinds == [(0, 2), (4, 6), (8, 11), (13, 15)]
    assert way.cost == 0.0


def test_a_sound_lasts_its_least_time_whatever_is_heard():
    way = way_of("aaaabaaaa", [[[A]], [[B]], [[A]]], least=3)
    assert [step.last - step.first for step in way.steps] == [3, 3, 3]
    assert way.cost == pytest.approx(2 * 9.0)


def test_the_pronunciation_that_was_said_is_found():
    words = [[[A, B], [C], [B, A, C]], [[B]]]
    assert steps_of(way_of("ccccbb", words)) == [(0, 4, SOUND, 2), (4, 6, SOUND, 6)]
    assert [step.sound for step in way_of("bbaaccbb", words).steps] == [3, 4, 5, 6]


def test_a_word_that_nobody_says_is_skipped_at_its_price():
    way = way_of("aaaacccc", [[[A]], [[B, A]], [[C]]], LOOSE)
    assert steps_of(way) == [(0, 4, SOUND, 0), (4, 4, SKIPPED, 1), (4, 8, SOUND, 3)]
    assert way.cost == pytest.approx(5 + 2 * 1)


def test_several_words_in_a_row_are_skipped():
    way = way_of("aaaacccc", [[[B]], [[A]], [[B]], [[B]], [[C]], [[B]]], LOOSE)
    assert [step.sound for step in way.steps if step.kind == SKIPPED] == [0, 2, 3, 5]


def test_what_the_text_does_not_hold_is_strange_at_its_price():
    way = way_of("aaaabbbbbbcccc", [[[A]], [[C]]], LOOSE)
    assert steps_of(way) == [(0, 4, SOUND, 0), (4, 10, STRANGE, -1), (10, 14, SOUND, 1)]
    assert way.cost == pytest.approx(8 + 6 * 0.5)


def test_a_word_that_is_said_twice_is_there_once_and_strange_once():
    way = way_of("aaaaabbbbbaaaaabbbbbccccc", [[[A, B]], [[C]]], LOOSE)
    assert sorted(step.kind for step in way.steps) == [SOUND, SOUND, SOUND, STRANGE]
    assert way.cost == pytest.approx(8 + 10 * 0.5)


def test_without_prices_for_it_nothing_is_skipped_or_strange():
    way = way_of("aaaacccc", [[[A]], [[B]], [[C]]])
    assert [step.kind for step in way.steps] == [SOUND] * 3
    assert way.cost == pytest.approx(2 * 9.0)


def test_too_few_frames_have_no_way():
    for said in ("aab", ""):
        lattice = lattice_of([[[A, B]]])
        assert cheapest_way(heard(said), lattice, FREE, least_of(lattice, 2)) is None
    assert steps_of(way_of("", [[[A]]], LOOSE)) == [(0, 0, SKIPPED, 0)]


def test_a_part_of_a_text_ends_where_it_is_cheapest():
    lattice = lattice_of([[[A]], [[B]], [[C]], [[A]]])
    way = cheapest_way(heard("aaaabbbb"), lattice, FREE, least_of(lattice, 2), whole=False)
    assert way is not None
    assert steps_of(way) == [(0, 4, SOUND, 0), (4, 8, SOUND, 1)]


def naive_cost(scores: np.ndarray, columns: list[int], least: int) -> float:
    """The cost of sounds in order, without silence, by trying each end of each sound."""
    n = len(scores)
    best = {0: 0.0}
    for column in columns:
        sums = np.concatenate([[0.0], np.cumsum(-scores[:, column])])
        best = {
            end: min(cost + sums[end] - sums[first] for first, cost in best.items() if end - first >= least)
            for end in range(n + 1)
            if any(end - first >= least for first in best)
        }
    return best.get(n, np.inf)


@settings(max_examples=60, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.lists(st.sampled_from([A, B, C]), min_size=1, max_size=4),
    st.integers(1, 4),
    st.integers(1, 14),
)
def test_no_way_is_cheaper_than_the_one_that_is_found(seed: int, columns: list[int], least: int, n: int):
    scores = -np.random.default_rng(seed).random((n, 4))
    lattice = lattice_of([[columns]])
    way = cheapest_way(scores, lattice, Prices(silence=np.inf), least_of(lattice, least))
    cost = naive_cost(scores, columns, least)
    if way is None:
        assert cost == np.inf
        return
    assert way.cost == pytest.approx(cost)
    said = -sum(scores[step.first : step.last, lattice.columns[step.sound]].sum() for step in way.steps)
    assert said == pytest.approx(cost)
    assert all(isinstance(step, WayStep) and step.last - step.first >= least for step in way.steps)
