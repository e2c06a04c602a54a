"""The statistics over whole recordings at once: exactly what they say frame by frame."""

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.calibration.workbench.batch_smoother import BatchSmoother
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import PhonemeSmoother

A, E, M, SILENCE, UNKNOWN = Phoneme.A, Phoneme.E, Phoneme.M, Phoneme.SILENCE, Phoneme.UNIDENTIFIED
STAY = {p: p for p in Phoneme}

lengths = st.lists(
    st.one_of(st.integers(0, 25), st.integers(60, 300)), min_size=1, max_size=5
)  # some longer than leaps
successors = st.fixed_dictionaries({p: st.sampled_from(list(Phoneme)) for p in Phoneme})


def edges_of(lengths: list[int]) -> np.ndarray:
    return np.concatenate(([0], np.cumsum(lengths))).astype(np.intp)


def codes(*phonemes: Phoneme) -> np.ndarray:
    return np.array(phonemes, np.uint8)


@st.composite
def sequences(draw: st.DrawFn) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges of recordings, flickering codes, and where each phoneme may stay."""
    edges = edges_of(draw(lengths))
    n, seed = int(edges[-1]), draw(st.integers(0, 2**32 - 1))
    generator = np.random.default_rng(seed)
    n_codes, pace = draw(st.integers(2, 11)), draw(st.integers(1, 4))
    flicker = np.repeat(generator.integers(0, n_codes, n), pace)[:n].astype(np.uint8)
    stays = generator.random((len(Phoneme), n)) < draw(st.floats(0, 1))
    return edges, flicker, stays


@given(sequence=sequences(), successors=successors, hold=st.integers(0, 7))
def test_recordings_at_once_say_what_frame_by_frame_says(sequence, successors, hold):
    edges, flicker, _ = sequence
    calmer = BatchSmoother(edges)
    found = calmer.minimum_hold(calmer.fill_unidentified(flicker, successors), hold / 100)
    spans = pairwise(edges)
    expected = [PhonemeSmoother(hold / 100, successors).smooth(flicker[first:end]) for first, end in spans]
    assert found.tolist() == np.concatenate(expected).tolist()


@given(sequence=sequences(), successors=successors, hold=st.integers(0, 7))
def test_hysteresis_at_once_is_hysteresis_frame_by_frame(sequence, successors, hold):
    edges, flicker, stays = sequence
    calmer = BatchSmoother(edges)
    found = calmer.minimum_hold(calmer.fill_unidentified(calmer.hysteresis(flicker, stays), successors), hold / 100)
    deficits = np.where(stays, 0.1, 0.3).T.astype(np.float32)
    expected = [
        PhonemeSmoother(hold / 100, successors, 0.2).smooth(flicker[first:end], deficits[first:end])
        for first, end in pairwise(edges)
    ]
    assert found.tolist() == np.concatenate(expected).tolist()


def test_a_recording_remembers_nothing_of_the_one_before():
    calmer = BatchSmoother(edges_of([3, 3]))
    filled = calmer.fill_unidentified(codes(A, UNKNOWN, UNKNOWN, UNKNOWN, M, UNKNOWN), STAY | {A: E, SILENCE: M})
    assert filled.tolist() == [A, E, E, M, M, M]
    assert calmer.minimum_hold(codes(A, A, E, E, A, A), 0.03).tolist() == [A, A, A, E, E, E]
