"""Runs of equal phonemes cover a sound from its beginning to its end."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.segments import Segment, SegmentBuilder, segments_of
from phonemeengine.settings import FRAME_PERIOD

CODES = st.lists(st.integers(0, 10), min_size=1, max_size=80)


def runs(codes: list[int], cuts: list[int], duration: float) -> list[Segment]:
    phonemes = np.array(codes, np.uint8)
    intensities = (np.arange(len(codes)) % 5 / 4).astype(np.float32)
    places = np.sort(np.minimum(cuts, len(codes))).astype(int)
    blocks = zip(np.split(phonemes, places), np.split(intensities, places), strict=True)
    return list(segments_of(blocks, duration))


@given(codes=CODES, cuts=st.lists(st.integers(0, 80), max_size=8), rest=st.floats(0.001, 1))
def test_runs_cover_the_whole_sound_without_gaps(codes: list[int], cuts: list[int], rest: float) -> None:
    duration = (len(codes) - 1 + rest) * FRAME_PERIOD
    found = runs(codes, cuts, duration)
    assert found[0].start == 0
    assert found[-1].end == duration
    assert [run.end for run in found[:-1]] == [run.start for run in found[1:]]
    assert all(run.start < run.end for run in found)


@given(codes=CODES, cuts=st.lists(st.integers(0, 80), max_size=8))
def test_runs_say_what_every_frame_is_and_are_as_long_as_they_can_be(codes: list[int], cuts: list[int]) -> None:
    found = runs(codes, cuts, len(codes) * FRAME_PERIOD)
    spread = [run.phoneme for run in found for _ in range(round((run.end - run.start) / FRAME_PERIOD))]
    assert spread == codes
    assert all(one.phoneme is not other.phoneme for one, other in pairwise(found))


@given(codes=CODES, cuts=st.lists(st.integers(0, 80), max_size=8))
def test_runs_do_not_depend_on_how_the_frames_came(codes: list[int], cuts: list[int]) -> None:
    assert runs(codes, cuts, 1.0) == runs(codes, [], 1.0)


def test_a_run_has_the_mean_intensity_of_its_frames() -> None:
    blocks = [(np.array([7, 7], np.uint8), np.array([0.2, 0.4], np.float32))]
    blocks.append((np.array([7, 9], np.uint8), np.array([0.6, 1.0], np.float32)))
    one, other = segments_of(blocks, 0.035)
    assert (one.phoneme, one.start, one.end) == (Phoneme.A, 0, pytest.approx(0.03))
    assert one.intensity == pytest.approx(0.4)
    assert (other.phoneme, other.end, other.intensity) == (Phoneme.U, 0.035, 1.0)


def test_no_frames_give_no_runs() -> None:
    assert list(segments_of([], 0.0)) == []


@given(codes=CODES, cuts=st.lists(st.integers(0, 80), max_size=8), rest=st.floats(0.001, 1))
def test_runs_that_are_joined_as_the_frames_come_are_those_of_the_whole_sound(
    codes: list[int], cuts: list[int], rest: float
) -> None:
    duration = (len(codes) - 1 + rest) * FRAME_PERIOD
    phonemes = np.array(codes, np.uint8)
    intensities = (np.arange(len(codes)) % 5 / 4).astype(np.float32)
    joiner, found, n_frames = SegmentBuilder(), [], 0
    places = np.sort(np.minimum(cuts, len(codes))).astype(int)
    for part, loud in zip(np.split(phonemes, places), np.split(intensities, places), strict=True):
        ended = joiner.extend(part, loud)
        n_frames += len(part)
        assert all(run.end < n_frames * FRAME_PERIOD for run in ended)  # a run has ended when another began
        found += ended
    assert found + joiner.finish(duration) == runs(codes, [], duration)
