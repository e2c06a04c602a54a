"""The ring between two threads: what goes in comes out, once and in order."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.audio.output import Ring

CAPACITY = 16

ACTS = st.lists(st.tuples(st.sampled_from(["write", "read", "skip"]), st.integers(0, 2 * CAPACITY)), max_size=60)


def numbered(first: int, n: int, n_channels: int = 2) -> np.ndarray:
    """Samples that say which one they are, from 1 on, so that none reads like silence."""
    return np.repeat(np.arange(first + 1, first + n + 1, dtype=np.float32)[:, np.newaxis], n_channels, axis=1)


@given(acts=ACTS)
def test_whatever_is_written_read_and_skipped_nothing_is_lost_and_nothing_comes_twice(
    acts: list[tuple[str, int]],
) -> None:
    ring = Ring(CAPACITY, 2)
    expected: list[int] = []
    n_written = 0
    for act, size in acts:
        if act == "write":
            n = min(size, ring.room)
            ring.write(numbered(n_written, n))
            expected += range(n_written, n_written + n)
            n_written += n
        elif act == "skip":
            ring.skip()
            expected.clear()
        else:
            out = np.full((size, 2), np.nan, np.float32)
            n = ring.read_into(out)
            assert n == min(size, len(expected))
            assert out[:n, 0].tolist() == [k + 1 for k in expected[:n]]
            np.testing.assert_array_equal(out[:, 0], out[:, 1])
            assert not out[n:].any()
            del expected[:n]
        assert ring.n_written == n_written
        assert ring.room == CAPACITY - len(expected)


def test_a_starved_reader_hears_silence() -> None:
    ring = Ring(CAPACITY, 1)
    ring.write(numbered(0, 3, 1))
    out = np.full((8, 1), 7, np.float32)
    assert ring.read_into(out) == 3
    assert out[:, 0].tolist() == [1, 2, 3, 0, 0, 0, 0, 0]
    assert ring.read_into(out) == 0
    assert not out.any()
    assert ring.n_read == 3


def test_what_is_skipped_counts_as_read_at_the_next_reading() -> None:
    ring = Ring(CAPACITY, 1)
    ring.write(numbered(0, 10, 1))
    ring.skip()
    assert ring.room == CAPACITY
    ring.write(numbered(10, 2, 1))
    out = np.zeros((4, 1), np.float32)
    assert ring.read_into(out) == 2
    assert out[:, 0].tolist() == [11, 12, 0, 0]
    assert ring.n_read == 12


@pytest.mark.parametrize("n", [1, 5, CAPACITY])
def test_the_ring_goes_round_for_ever(n: int) -> None:
    ring = Ring(CAPACITY, 1)
    out = np.zeros((n, 1), np.float32)
    for k in range(100):
        ring.write(numbered(k * n, n, 1))
        assert ring.read_into(out) == n
        np.testing.assert_array_equal(out, numbered(k * n, n, 1))
